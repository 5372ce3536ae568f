// From a renderer to picture files: so many samples, then the layers that were asked for.
#include "editor/session/render_output.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

namespace relievo {
namespace {

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& letter : extension)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return extension;
}

// The wanted layers' names, in the order of the file's channels.
std::vector<AovName> chosen(const std::vector<Layer>& aovs) {
    std::vector<AovName> names;
    for (const AovName& aov : aov_names())
        if (std::find(aovs.begin(), aovs.end(), aov.layer) != aovs.end()) names.push_back(aov);
    return names;
}

// R G B A and the layers' channels; the rows are still to come.
FloatPicture empty_picture(int width, int height, const std::vector<AovName>& layers) {
    FloatPicture picture{width, height, {"R", "G", "B", "A"}, {}};
    for (const AovName& aov : layers)
        picture.channels.insert(picture.channels.end(), aov.channels.begin(), aov.channels.end());
    picture.values.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * picture.channels.size());
    return picture;
}

void add_rows_to(FloatPicture& picture, int end) {
    picture.values.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(end) * picture.channels.size());
}

// `values`: of so many channels from `channel` on, which is moved behind them, of the pixels of `window`.
void put(FloatPicture& picture, const PixelRect& window, std::size_t& channel, std::size_t channels,
         const std::vector<float>& values) {
    const std::size_t stride = picture.channels.size();
    const float* from = values.data();
    for (int y = window.y0; y < window.y1; ++y) {
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                           static_cast<std::size_t>(window.x0);
        float* to = picture.values.data() + pixel * stride + channel;
        for (int x = window.x0; x < window.x1; ++x, from += channels, to += stride) std::copy_n(from, channels, to);
    }
    channel += channels;
}

DisplayPicture display_picture(std::span<const RenderPart> parts) {
    DisplayPicture picture = display_picture(*parts.front().renderer);
    for (const RenderPart& part : parts.subspan(1))
        put_columns(picture, part.renderer->read_back_display(), part.x0, part.x1);
    return picture;
}

// Bands that each take some hundredths of a second.
void by_bands(std::span<const RenderPart> parts, const std::function<void(int begin, int end)>& before_band,
              const std::function<void(Renderer& renderer, const PixelRect& band)>& trace) {
    constexpr int kBandPixels = 1 << 16, kTile = 8;  // rows of the device's work groups
    const int height = parts.front().renderer->height();
    const int rows = std::max(1, kBandPixels / parts.front().renderer->width() / kTile) * kTile;
    for (int y = 0; y < height; y += rows) {
        const int end = std::min(y + rows, height);
        before_band(y, end);
        for (const RenderPart& part : parts) trace(*part.renderer, {part.x0, y, part.x1, end});
    }
}

}  // namespace

const std::vector<AovName>& aov_names() {
    static const std::vector<AovName> names = {{"Z", Layer::depth, {"Z"}},
                                               {"N", Layer::normal, {"N.X", "N.Y", "N.Z"}},
                                               {"Ns", Layer::shading_normal, {"Ns.X", "Ns.Y", "Ns.Z"}},
                                               {"uv", Layer::uv, {"uv.U", "uv.V"}},
                                               {"id", Layer::id, {"id"}}};
    return names;
}

std::vector<Layer> parse_aovs(const std::string& list) {
    std::vector<Layer> layers;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        const auto& names = aov_names();
        const auto found =
            std::find_if(names.begin(), names.end(), [&](const AovName& n) { return n.name == word; });
        if (found == names.end())
            throw std::invalid_argument("--aov: \"" + word + "\" is not a layer; known are Z, N, Ns, uv, id");
        if (std::find(layers.begin(), layers.end(), found->layer) == layers.end())
            layers.push_back(found->layer);
    }
    return layers;
}

void check_render_output(const std::filesystem::path& path, const std::vector<Layer>& aovs) {
    if (!is_png(path) && extension_of(path) != ".exr")
        throw std::invalid_argument(path.string() + ": a render must end in .png or .exr");
    if (is_png(path) && !aovs.empty())
        throw std::invalid_argument(path.string() +
                                    ": a PNG holds no layers; --aov needs a file that ends in .exr");
    check_writable(path);
}

double render_samples(Renderer& renderer, int spp, const Progress& progress) {
    renderer.render({0, 0, 1, 1}, Quality::preview);  // compiles, which is no sample's time
    renderer.restart();
    double spent_ms = 0;
    for (int done = 0; done < spp; ++done) {
        if (progress) progress(done, spp);
        spent_ms += renderer.render();
    }
    if (progress) progress(spp, spp);
    return spent_ms;
}

DisplayPicture display_picture(Renderer& renderer) {
    return {renderer.width(), renderer.height(), renderer.read_back_display()};
}

bool is_png(const std::filesystem::path& path) {
    return extension_of(path) == ".png";
}

void write_layers(const std::filesystem::path& path, int width, int height, const std::vector<float>& beauty,
                  const std::vector<Layer>& aovs, const std::function<std::vector<float>(Layer)>& layer) {
    check_render_output(path, aovs);
    const std::vector<AovName> layers = chosen(aovs);
    FloatPicture picture = empty_picture(width, height, layers);
    std::size_t channel = 0;
    const PixelRect whole{0, 0, width, height};
    add_rows_to(picture, height);
    put(picture, whole, channel, 4, beauty);
    for (const AovName& aov : layers) put(picture, whole, channel, aov.channels.size(), layer(aov.layer));
    write_exr(path, picture);
}

void render_afresh(std::span<const RenderPart> parts, const Advance& advance) {
    for (const RenderPart& part : parts) part.renderer->restart();
    const double height = parts.front().renderer->height();
    by_bands(parts, [&](int row, int) { tell(advance, row / height, "Tracing was stopped"); },
             [](Renderer& renderer, const PixelRect& band) { renderer.render(band); });
}

void write_render(Renderer& renderer, const std::filesystem::path& path, const std::vector<Layer>& aovs,
                  const Advance& advance) {
    const RenderPart whole{&renderer, 0, renderer.width()};
    write_render(std::span(&whole, 1), path, aovs, advance);
}

void write_render(std::span<const RenderPart> parts, const std::filesystem::path& path, const std::vector<Layer>& aovs,
                  const Advance& advance) {
    check_render_output(path, aovs);
    const int width = parts.front().renderer->width(), height = parts.front().renderer->height();
    for (const RenderPart& part : parts)
        if (part.renderer->width() != width || part.renderer->height() != height)
            throw std::invalid_argument(path.string() + ": the picture's parts differ in size");
    const std::string stopped = not_written(path.string());
    tell(advance, 0, stopped);
    if (is_png(path)) return write_png(path, display_picture(parts), advance);
    const std::vector<AovName> layers = chosen(aovs);
    FloatPicture picture = empty_picture(width, height, layers);
    const double share = layers.empty() ? 0.1 : 0.5;  // of the time, about
    // The light, too: even to take so much memory at once can take a second.
    by_bands(
        parts,
        [&](int row, int end) {
            tell(advance, share * row / height, stopped);
            add_rows_to(picture, end);
        },
        [&](Renderer& renderer, const PixelRect& band) {
            std::size_t channel = 0;
            put(picture, band, channel, 4, renderer.traced_layer(Layer::beauty, band));
            if (!layers.empty()) renderer.trace_layers(band);
            for (const AovName& aov : layers)
                put(picture, band, channel, aov.channels.size(), renderer.traced_layer(aov.layer, band));
        });
    write_exr(path, picture, within(advance, share, 1));
}

}  // namespace relievo
