// The edited object's mask on disk: a 16-bit grey PNG beside the displacement map, NAME.EXT.mask.png for NAME.EXT.
#pragma once

#include <filesystem>

#include "brushes/advance.h"
#include "brushes/height_map.h"

namespace relievo {

std::filesystem::path mask_path_beside(const std::filesystem::path& height_map);

// Of `width` x `height` texels, white protects. Throws as load_map (8 bits and colours do, too), and
// std::invalid_argument on another size or when memory would not do.
HeightMap load_mask(const std::filesystem::path& path, int width, int height, const Advance& advance = {});

bool protects_anything(const HeightMap& mask);

// A mask that protects nothing has no file: one that is there goes. Throws as save_map.
void save_mask(const HeightMap* mask, const std::filesystem::path& path, const Advance& advance = {});

}  // namespace relievo
