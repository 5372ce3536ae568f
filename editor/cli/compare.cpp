// relievo compare SCENE... -o FOLDER: errors beside times, of every method and quality setting.
#include "editor/session/compare/compare.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "editor/cli/progress.h"
#include "editor/cli/verbs.h"
#include "editor/session/compare/report.h"

namespace relievo {
namespace {

struct CompareVerb {
    std::vector<std::string> scenes;
    std::string folder, methods;
    double budget_s = 0;
    CommonOptions common;
    MethodOptions method;  // its --path
    PictureOptions picture;
};

std::string time_text(double seconds) {
    char text[40];
    if (seconds < 90)
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    else
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    return text;
}

int run_compare(const CompareVerb& verb) {
    const SessionOptions session = session_options(verb.common, verb.method, verb.picture);
    CompareOptions options;
    for (const std::string& scene : verb.scenes) options.scenes.emplace_back(scene);
    options.folder = verb.folder;
    options.methods = parse_methods(verb.methods);
    options.budget_s = verb.budget_s;
    options.width = session.width;
    options.height = session.height;
    options.device = session.device;
    options.path = session.path;
    ProgressBar bar("comparing");
    CompareListener listener;
    listener.progress = [&](const CompareProgress& p) {
        constexpr double kParts = 1000;
        bar.update(static_cast<std::size_t>(p.done * kParts), static_cast<std::size_t>(kParts),
                   p.what + ", about " + time_text(p.seconds_left) + " left");
    };
    listener.scene_done = [&](const ComparedScene& scene) {
        bar.say(scene.name + ": " + std::to_string(scene.points.size()) + " points, " +
                std::to_string(scene.rounds) + " rounds" +
                (scene.cut.empty() ? "" : ", " + std::to_string(scene.cut.size()) + " things left out"));
    };
    const Comparison comparison = compare_methods(options, listener);
    bar.clear();
    if (verb.common.json)
        std::cout << json_text(comparison);
    else
        std::cout << markdown_text(comparison) << "\n" << (options.folder / "index.html").string() << "\n";
    return 0;
}

}  // namespace

void add_compare(CLI::App& app, Command& command) {
    CLI::App& verb =
        *app.add_subcommand("compare", "Measure every method's errors beside its times; write a report");
    const auto options = std::make_shared<CompareVerb>();
    verb.add_option("SCENE", options->scenes, "Scene files (JSON)")->required();
    verb.add_option("-o,--output", options->folder,
                    "Folder for the report: index.html, results.csv, results.json")
        ->type_name("FOLDER")
        ->required();
    verb.add_option("--methods", options->methods,
                    "Methods with commas between, the one to judge first; all when not given")
        ->type_name("LIST");
    verb.add_option("--budget", options->budget_s,
                    "Seconds that it may take: fewer rounds and points when short; as long as it needs when "
                    "not given")
        ->type_name("SECONDS")
        ->check(CLI::PositiveNumber);
    verb.add_option("--size", options->picture.size, "Size of the frames; the scene's when not given")
        ->type_name("WxH");
    verb.add_option("--path", options->method.path, "Way of tracing: ray-query or pipeline")
        ->type_name("PATH");
    add_common(verb, options->common);
    verb.callback([options, &command] { command = [options] { return run_compare(*options); }; });
}

}  // namespace relievo
