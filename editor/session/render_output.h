// From a renderer to picture files: so many samples, then the layers that were asked for.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "editor/session/image_file.h"
#include "renderer/renderer.h"

namespace relievo {

// The words of `--aov`: Z, N, Ns, uv, id, in this order.
struct AovName {
    std::string name;
    Layer layer;
    std::vector<std::string> channels;  // as the EXR names them
};
const std::vector<AovName>& aov_names();

// "Z,N" to layers. Throws std::invalid_argument naming the unknown word and the known ones.
std::vector<Layer> parse_aovs(const std::string& list);

// What can be said before anything is rendered: that the extension is .png or .exr, that layers go with .exr
// only, that the file can be written. Throws std::invalid_argument.
void check_render_output(const std::filesystem::path& path, const std::vector<Layer>& aovs);

using Progress = std::function<void(int done, int total)>;

// Accumulates from nothing to `spp` samples a pixel. Returns milliseconds of tracing.
double render_samples(Renderer& renderer, int spp, const Progress& progress = {});

DisplayPicture display_picture(Renderer& renderer);

bool is_png(const std::filesystem::path& path);

// An EXR with R G B A (`beauty`) and the layers, each as `layer` gives it: floats of the pixels in turn.
// Throws std::invalid_argument as check_render_output does.
void write_layers(const std::filesystem::path& path, int width, int height, const std::vector<float>& beauty,
                  const std::vector<Layer>& aovs, const std::function<std::vector<float>(Layer)>& layer);

// Tone-mapped PNG, or EXR with R G B A and the layers. Throws std::invalid_argument as check_render_output
// does, Stopped where `advance` says so: an older file then stays whole. Meanwhile the renderer must keep its size.
void write_render(Renderer& renderer, const std::filesystem::path& path, const std::vector<Layer>& aovs,
                  const Advance& advance = {});

// Columns [x0, x1) of a picture.
struct RenderPart {
    Renderer* renderer;
    int x0, x1;
};

// One sample a pixel in the place of those that were gathered, which may be of an older surface.
void render_afresh(std::span<const RenderPart> parts, const Advance& advance = {});

// As write_render, of one picture whose columns are several renderers', side by side: all of one size, which std::invalid_argument
// says where they are not.
void write_render(std::span<const RenderPart> parts, const std::filesystem::path& path, const std::vector<Layer>& aovs,
                  const Advance& advance = {});

}  // namespace relievo
