// relievo bake SCENE -o MAP: procedural heights into a map, to be sculpted.
#include "editor/session/bake.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "brushes/map_file.h"
#include "editor/cli/progress.h"
#include "editor/cli/verbs.h"
#include "editor/session/image_file.h"
#include "editor/session/scene_input.h"

namespace relievo {
namespace {

struct BakeOptions {
    std::string scene, out, size;
    bool json = false;
};

const SceneObject& procedural_object(const Scene& scene) {
    const auto found = std::find_if(scene.objects.begin(), scene.objects.end(),
                                    [](const SceneObject& o) { return o.displacement.procedural.has_value(); });
    if (found == scene.objects.end())
        throw std::invalid_argument(scene.path.string() +
                                    ": no object has procedural heights; there is nothing to bake");
    return *found;
}

void print_result(const BakeOptions& options, const SceneObject& object, const HeightMap& map) {
    const Displacement& d = object.displacement;
    const nlohmann::ordered_json scene{
        {"map", options.out}, {"amplitude", d.amplitude}, {"midlevel", d.midlevel}, {"wrap", "clamp"}};
    if (options.json) {
        std::cout << nlohmann::ordered_json{{"map", options.out},
                                            {"object", object.name},
                                            {"width", map.width()},
                                            {"height", map.height()},
                                            {"displacement", scene}}
                         .dump(2)
                  << "\n";
    } else {
        std::cout << options.out << ": " << map.width() << "x" << map.height() << ", the heights of " << object.name
                  << "\nto sculpt it, a scene says \"displacement\": " << scene.dump() << "\n";
    }
}

int run_bake(const BakeOptions& options) {
    const MapFormat format = format_of(options.out);
    check_writable(options.out);
    const Scene scene = open_scene(options.scene);
    const SceneObject& object = procedural_object(scene);
    check_bakeable(object);
    const LoadedMap exemplar = open_map(object.displacement, {});
    const Procedural& settings = *object.displacement.procedural;
    const ImageSize size = options.size.empty() ? bake_size(settings, exemplar.map.width(), exemplar.map.height())
                                                : parse_size(options.size);
    const ProceduralSource source(settings, exemplar.map.width(), exemplar.map.height(),
                                  exemplar.map.texels().data());
    ProgressBar bar("baking");
    const HeightMap map = bake(source, size, [&](double part) {
        bar.update(static_cast<std::size_t>(part * size.height), static_cast<std::size_t>(size.height));
        return true;
    });
    bar.clear();
    save_map(map, options.out, format);
    print_result(options, object, map);
    return 0;
}

}  // namespace

void add_bake(CLI::App& app, Command& command) {
    CLI::App& verb = *app.add_subcommand("bake", "Write procedural heights as a 16-bit map, to be sculpted");
    const auto options = std::make_shared<BakeOptions>();
    verb.add_option("SCENE", options->scene, "Scene file (JSON)")->required();
    verb.add_option("-o,--output", options->out, "The map: .png, .tif or .exr")->type_name("MAP")->required();
    verb.add_option("--size", options->size, "Texels; the source's own over texture coordinates 0 to 1 when not given")
        ->type_name("WxH");
    verb.add_flag("--json", options->json, "Print the result as JSON");
    verb.callback([options, &command] { command = [options] { return run_bake(*options); }; });
}

}  // namespace relievo
