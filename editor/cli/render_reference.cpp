// relievo render SCENE -o OUT --method reference: the layers of the double-precision reference, on the
// processor.
#include <chrono>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "editor/cli/progress.h"
#include "editor/cli/render.h"
#include "editor/session/reference_output.h"
#include "editor/session/reference_scene.h"
#include "editor/session/scene_input.h"

namespace relievo {
namespace {

// What only a device's method can be told.
void check_options(const RenderOptions& options) {
    const auto refuse = [](const char* option, const char* why) {
        throw std::invalid_argument(std::string(option) + ": does not go with --method reference, which " +
                                    why);
    };
    if (!options.method.set.empty()) refuse("--set", "has no parameters");
    if (!options.method.path.empty()) refuse("--path", "traces on the processor");
    if (options.picture.spp > 1) refuse("--spp", "traces one ray through each pixel's centre");
}

void print_result(const RenderOptions& options, const ReferenceImage& image, double trace_ms) {
    if (options.common.json) {
        std::cout << nlohmann::ordered_json{{"output", options.out},
                                            {"width", image.width},
                                            {"height", image.height},
                                            {"method", "reference"},
                                            {"spp", 1},
                                            {"undecided", image.undecided},
                                            {"trace_ms", trace_ms}}
                         .dump(2)
                  << "\n";
    } else {
        std::cout << options.out << ": " << image.width << "x" << image.height
                  << ", the double-precision reference, " << trace_ms << " ms\n";
    }
}

}  // namespace

int run_reference_render(const RenderOptions& options) {
    check_options(options);
    const std::vector<Layer> aovs = parse_aovs(options.aov);
    check_reference_output(options.out, aovs);
    const ReferenceScene reference(open_scene(options.scene));
    const Scene& scene = reference.scene();
    for (const std::string& warning : scene.warnings) std::cerr << "warning: " << warning << "\n";
    const ImageSize size = size_of(options.picture, scene);
    const auto start = std::chrono::steady_clock::now();
    ReferenceImage image;
    {
        ProgressBar bar("tracing the reference");
        image = trace_image(
            reference.surface(), scene.camera, scene.origin, size.width, size.height, 0, [&](int rows) {
                bar.update(static_cast<std::size_t>(rows), static_cast<std::size_t>(size.height));
            });
    }
    const double trace_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    write_reference(image, scene.camera, options.out, aovs);
    if (image.undecided > 0)
        std::cerr << "warning: " << image.undecided
                  << " pixels are undecided: their rays met the limit of parts to be searched\n";
    print_result(options, image, trace_ms);
    return 0;
}

}  // namespace relievo
