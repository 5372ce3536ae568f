// Writing a file so that a reader, a crash or a full disk never meets half of it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "brushes/advance.h"

namespace relievo {

// Writes a temporary file beside `path`, syncs it, renames it over `path` and syncs the folder. A symbolic
// link is followed and stays; an existing file's permissions are kept. On any failure (unwritable, disk full,
// a folder in the way) throws std::invalid_argument that names the path, the old file stays whole, the
// temporary one is removed. Where the file system lets it have no name until it is whole, a program that is killed
// leaves nothing of it either. `advance` is told how much has reached the disk, and may stop it: Stopped.
void write_file_atomically(const std::filesystem::path& path, std::span<const std::byte> content,
                           const Advance& advance = {});

}  // namespace relievo
