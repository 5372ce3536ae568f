// Every asset's mesh, displacement map and, where it has one, opacity map; images for the stamp.
#include "assets/generator/samples.h"

#include <OpenImageIO/imageio.h>

#include <memory>
#include <stdexcept>

#include "assets/generator/atlas.h"
#include "assets/generator/bent_gutters.h"
#include "assets/generator/builders.h"
#include "assets/generator/portable_math.h"
#include "assets/generator/sample_alphas.h"
#include "assets/generator/strokes.h"

namespace relievo::assets {
namespace {

namespace fs = std::filesystem;

struct Entry {
    const char* name;
    Sculpture (*make)();
};
constexpr Entry kEntries[] = {{"plane", make_plane},
                              {"asteroid", make_asteroid},
                              {"chainmail", make_chainmail},
                              {"leather", make_leather},
                              {"orb", make_orb},
                              {"stump", make_stump},
                              {"knot", make_knot},
                              {"fur", make_fur},
                              {"scree", make_scree},
                              {"procedural_plane", make_procedural_plane},
                              {"procedural_sphere", make_procedural_sphere}};

// Single-channel PNG of 16 or 8 bits. `map` has row 0 at the bottom, the file has it last.
void write_png(const fs::path& path, const std::vector<std::uint16_t>& map, int size, int bits) {
    const auto side = static_cast<std::size_t>(size);
    std::vector<std::uint16_t> wide(map.size());
    for (std::size_t y = 0; y < side; ++y)
        std::copy_n(map.begin() + static_cast<std::ptrdiff_t>((side - 1 - y) * side), side,
                    wide.begin() + static_cast<std::ptrdiff_t>(y * side));
    const OIIO::TypeDesc type = bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(size, size, 1, type);
    spec.attribute("png:compressionLevel", 4);
    const std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create(path.string());
    bool done = file && file->open(path.string(), spec);
    if (bits == 16) {
        done = done && file->write_image(OIIO::TypeDesc::UINT16, wide.data());
    } else {
        const std::vector<std::uint8_t> narrow(wide.begin(), wide.end());
        done = done && file->write_image(OIIO::TypeDesc::UINT8, narrow.data());
    }
    done = done && file->close();
    if (!done) throw std::runtime_error(path.string() + ": cannot be written");
}

std::vector<std::uint16_t> paint(int size, const std::function<double(double, double)>& value) {
    std::vector<std::uint16_t> map;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            map.push_back(static_cast<std::uint16_t>(
                65535 * clamp01(value((x + 0.5) / size, (y + 0.5) / size)) + 0.5));
    return map;
}

void make_sample(const Entry& entry, const Options& options) {
    const Sculpture sculpture = entry.make();
    const std::string name = entry.name;
    const fs::path mesh = options.output / "meshes" / (name + ".obj");
    write_obj(sculpture.shape, mesh);
    write_sample_strokes(name, sculpture.shape, options.output / "strokes");
    if (!sculpture.exemplar && !sculpture.height) return;
    const Atlas atlas(sculpture.shape);
    const fs::path maps = options.output / "maps";
    std::vector<std::uint16_t> heights;
    if (sculpture.exemplar) {
        heights = paint(options.size, sculpture.exemplar);
    } else {
        heights = atlas.paint(options.size, 65535, sculpture.height, sculpture.free_height);
        bend_gutters(mesh, options.size, heights);
    }
    write_png(maps / (name + ".png"), heights, options.size, 16);
    if (sculpture.opacity)
        write_png(maps / (name + "_opacity.png"), atlas.paint(options.size, 255, sculpture.opacity, {}),
                  options.size, 8);
}

void make_alpha(const SampleAlpha& alpha, const fs::path& folder) {
    const auto value = [&](double u, double v) { return alpha.value(2 * u - 1, 2 * v - 1); };
    write_png(folder / (std::string(alpha.name) + ".png"), paint(kAlphaSize, value), kAlphaSize, 16);
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw std::runtime_error(folder.string() + ": cannot be made: " + error.message());
}

void copy_scenes(const fs::path& from, const fs::path& to) {
    if (!fs::is_directory(from))
        throw std::invalid_argument("--scenes: " + from.string() + " is not a folder");
    make_folder(to);
    for (const fs::directory_entry& file : fs::directory_iterator(from))
        if (file.path().extension() == ".json")
            fs::copy_file(file.path(), to / file.path().filename(), fs::copy_options::overwrite_existing);
}

}  // namespace

void make_samples(const Options& options, const std::function<void(const std::string&)>& progress) {
    bool any = false;
    std::string names;
    for (const Entry& entry : kEntries) {
        names += std::string(names.empty() ? "" : ", ") + entry.name;
        any = any || options.only.empty() || options.only == entry.name;
    }
    if (!any) throw std::invalid_argument("--only: no asset '" + options.only + "'; there are " + names);

    make_folder(options.output / "meshes");
    make_folder(options.output / "maps");
    make_folder(options.output / "strokes");
    for (const Entry& entry : kEntries) {
        if (!options.only.empty() && options.only != entry.name) continue;
        progress(entry.name);
        make_sample(entry, options);
    }
    if (options.only.empty()) {
        make_folder(options.output / "alphas");
        progress("alphas");
        for (const SampleAlpha& alpha : sample_alphas()) make_alpha(alpha, options.output / "alphas");
    }
    if (!options.scenes.empty()) copy_scenes(options.scenes, options.output / "scenes");
}

}  // namespace relievo::assets
