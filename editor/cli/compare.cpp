// relievo compare SCENE... -o FOLDER: errors beside times, of every method and quality setting.
#include "editor/cli/compare.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "editor/cli/progress.h"
#include "editor/session/compare/compare.h"
#include "editor/session/compare/report.h"

namespace relievo {
namespace {

std::string time_text(double seconds) {
    char text[40];
    if (seconds < 90)
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    else
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    return text;
}

int run_compare(const CompareVerb& verb) {
    if (verb.stability) return run_compare_stability(verb);
    if (!verb.cases.empty()) throw std::invalid_argument("--cases: goes with --stability only");
    if (verb.scenes.empty()) throw std::invalid_argument("SCENE: is required, or --stability");
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
    if (const double least = least_seconds(options); options.budget_s > 0 && options.budget_s < least)
        std::cerr << "relievo: --budget: the first method is measured once on every scene, which takes about "
                  << time_text(least) << "\n";
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
    verb.add_option("SCENE", options->scenes, "Scene files (JSON)");
    verb.add_option("-o,--output", options->folder,
                    "Folder for the report: index.html, results.csv, results.json")
        ->type_name("FOLDER")
        ->required();
    verb.add_flag(
        "--stability", options->stability,
        "Judge the methods on the stiff and extreme cases instead of scenes: index.html, stability.csv, "
        "stability.json; exit status 1 when a method breaks a promise");
    verb.add_option("--cases", options->cases,
                    "With --stability: some of its cases, with commas between; all when not given")
        ->type_name("LIST");
    verb.add_option("--methods", options->methods,
                    "Methods with commas between, the one to judge first; all when not given")
        ->type_name("LIST");
    verb.add_option("--budget", options->budget_s,
                    "Seconds that it may take: fewer rounds, points and methods when short; as long as it "
                    "needs when not given")
        ->type_name("SECONDS")
        ->check(CLI::PositiveNumber);
    verb.add_option("--size", options->picture.size, "Size of the frames; the scene's when not given")
        ->type_name("WxH");
    verb.add_option("--path", options->method.path, "Way of tracing: " + std::string(kTracePathNames))
        ->type_name("PATH");
    add_common(verb, options->common);
    verb.callback([options, &command] { command = [options] { return run_compare(*options); }; });
}

}  // namespace relievo
