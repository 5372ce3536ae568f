// relievo render SCENE -o OUT: one picture, with layers where they are asked for.
#include "editor/cli/render.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "editor/cli/progress.h"
#include "editor/session/render_output.h"
#include "renderer/vulkan/context.h"

namespace relievo {
namespace {

int run_render(const RenderOptions& options) {
    if (options.method.method == kReferenceMethod) return run_reference_render(options);
    SessionOptions session_with = session_options(options.common, options.method, options.picture);
    const std::vector<Layer> aovs = parse_aovs(options.aov);
    check_render_output(options.out, aovs);
    Session session(options.scene, session_with);
    for (const std::string& warning : session.scene().warnings) std::cerr << "warning: " << warning << "\n";
    Renderer& renderer = session.renderer();
    const int spp = samples_of(options.picture, session.scene());
    double trace_ms = 0;
    {
        ProgressBar bar("rendering");
        trace_ms = render_samples(renderer, spp, [&](int done, int total) {
            bar.update(static_cast<std::size_t>(done), static_cast<std::size_t>(total));
        });
    }
    write_render(renderer, options.out, aovs);
    if (options.common.json) {
        std::cout << nlohmann::ordered_json{{"output", options.out},
                                            {"width", renderer.width()},
                                            {"height", renderer.height()},
                                            {"spp", spp},
                                            {"device", session.context().info().name},
                                            {"trace_ms", trace_ms},
                                            {"ms_per_sample", trace_ms / spp}}
                         .dump(2)
                  << "\n";
    } else {
        std::cout << options.out << ": " << renderer.width() << "x" << renderer.height() << ", " << spp
                  << " samples a pixel, " << trace_ms / spp << " ms a sample on "
                  << session.context().info().name << "\n";
    }
    return 0;
}

}  // namespace

void add_render(CLI::App& app, Command& command) {
    CLI::App& verb = *app.add_subcommand("render", "Render a scene to a .png or .exr");
    const auto options = std::make_shared<RenderOptions>();
    verb.add_option("SCENE", options->scene, "Scene file (JSON)")->required();
    verb.add_option("-o,--output", options->out,
                    "Picture to write: .png (tone mapped) or .exr (float layers)")
        ->type_name("OUT")
        ->required();
    verb.add_option("--aov", options->aov,
                    "Layers beside R G B A in an .exr, with commas between: Z, N, Ns, uv, id")
        ->type_name("LIST");
    add_picture(verb, options->picture);
    add_method(verb, options->method);
    CLI::Option& method = *verb.get_option("--method");
    method.description(
        method.get_description() +
        "; or reference: the layers Z, N, uv and id in double precision on the processor, under a "
        "head light (no device needed, no --set)");
    add_common(verb, options->common);
    verb.callback([options, &command] { command = [options] { return run_render(*options); }; });
}

}  // namespace relievo
