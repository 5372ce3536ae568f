// From a renderer to picture files: so many samples, then the layers that were asked for.
#include "editor/session/render_output.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace relievo {
namespace {

std::string extension_of(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& letter : extension)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return extension;
}

void add_layer(FloatPicture& picture, const std::vector<std::string>& channels,
               const std::vector<float>& layer) {
    const std::size_t before = picture.channels.size(), added = channels.size(), after = before + added;
    const std::size_t pixels = layer.size() / added;
    std::vector<float> values(pixels * after);
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto pixel = values.begin() + static_cast<std::ptrdiff_t>(i * after);
        std::copy_n(picture.values.begin() + static_cast<std::ptrdiff_t>(i * before), before, pixel);
        std::copy_n(layer.begin() + static_cast<std::ptrdiff_t>(i * added), added,
                    pixel + static_cast<std::ptrdiff_t>(before));
    }
    picture.values = std::move(values);
    picture.channels.insert(picture.channels.end(), channels.begin(), channels.end());
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

void write_layers(const std::filesystem::path& path, int width, int height, std::vector<float> beauty,
                  const std::vector<Layer>& aovs, const std::function<std::vector<float>(Layer)>& layer) {
    check_render_output(path, aovs);
    FloatPicture picture{width, height, {"R", "G", "B", "A"}, std::move(beauty)};
    for (const AovName& aov : aov_names())
        if (std::find(aovs.begin(), aovs.end(), aov.layer) != aovs.end())
            add_layer(picture, aov.channels, layer(aov.layer));
    write_exr(path, picture);
}

void write_render(Renderer& renderer, const std::filesystem::path& path, const std::vector<Layer>& aovs) {
    if (is_png(path)) {
        check_render_output(path, aovs);
        return write_png(path, display_picture(renderer));
    }
    write_layers(path, renderer.width(), renderer.height(), renderer.read_back(Layer::beauty), aovs,
                 [&](Layer layer) { return renderer.read_back(layer); });
}

}  // namespace relievo
