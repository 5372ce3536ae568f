// relievo replay JOURNAL: sculpt as recorded, headless; save the map, render, check what the journal expects.
#include "editor/session/replay.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "brushes/colour_file.h"
#include "editor/cli/progress.h"
#include "editor/cli/verbs.h"
#include "editor/session/image_file.h"
#include "editor/session/render_output.h"

namespace relievo {
namespace {

struct ReplayVerb {
    std::string journal, map_out, colour_out, render, render_before, scene, map, colour_map, mask;
    bool force = false, timings = false, live = false;
    CommonOptions common;
    MethodOptions method;
    PictureOptions picture;
};

// Of two outputs in one file only the last would be left.
void check_apart(const ReplayVerb& verb) {
    using Output = std::pair<const char*, const std::string&>;
    const Output outputs[] = {{"--render-before", verb.render_before},
                              {"--output", verb.map_out},
                              {"--colour-output", verb.colour_out},
                              {"--render", verb.render}};
    const auto file = [](const std::string& path) {
        std::error_code error;
        const std::filesystem::path real = std::filesystem::weakly_canonical(path, error);
        return error ? std::filesystem::path(path) : real;
    };
    for (const Output* a = std::begin(outputs); a != std::end(outputs); ++a)
        for (const Output* b = std::begin(outputs); b != a; ++b)
            if (!a->second.empty() && !b->second.empty() && file(a->second) == file(b->second))
                throw std::invalid_argument(std::string(a->first) + ": " + a->second + " is what " +
                                            b->first + " writes; give each a file of its own");
}

// Everything that can be refused is refused before the work starts.
void check_outputs(const ReplayVerb& verb) {
    check_apart(verb);
    if (!verb.map_out.empty()) {
        format_of(verb.map_out);
        check_writable(verb.map_out);
    }
    if (!verb.colour_out.empty()) {
        check_colour_path(verb.colour_out);
        check_writable(verb.colour_out);
    }
    if (!verb.render.empty()) check_render_output(verb.render, {});
    if (!verb.render_before.empty()) check_render_output(verb.render_before, {});
}

std::filesystem::path scene_of(const ReplayVerb& verb, const Journal& journal) {
    if (!verb.scene.empty()) return verb.scene;
    if (journal.header.scene.empty())
        throw std::invalid_argument(verb.journal + ":1: scene: is missing; add it, or give --scene SCENE");
    return journal.resolve(journal.header.scene);
}

SessionOptions options_of(const ReplayVerb& verb, const Journal& journal) {
    SessionOptions options = session_options(verb.common, verb.method, verb.picture);
    options.with_renderer =
        verb.live || !verb.render.empty() || !verb.render_before.empty() || needs_renderer(journal);
    options.map = verb.map;
    options.colour_map = verb.colour_map;
    options.mask = verb.mask;
    if (verb.mask.empty() && !journal.header.mask.empty()) options.mask = journal.resolve(journal.header.mask);
    if (journal.header.undo_budget)
        options.undo_budget = static_cast<std::size_t>(*journal.header.undo_budget);
    return options;
}

void render_to(Session& session, const ReplayVerb& verb, const std::string& out) {
    ProgressBar bar("rendering");
    render_samples(session.renderer(), samples_of(verb.picture, session.scene()), [&](int done, int total) {
        bar.update(static_cast<std::size_t>(done), static_cast<std::size_t>(total));
    });
    write_render(session.renderer(), out, {});
}

ReplayReport run_operations(const Journal& journal, Session& session, const ReplayVerb& verb) {
    ProgressBar bar("replaying");
    ReplayOptions options;
    options.force = verb.force;
    options.live = verb.live;
    options.spp = verb.picture.spp;
    const std::string& beside = !verb.render.empty() ? verb.render : verb.map_out;
    if (!beside.empty()) options.failed_pictures = std::filesystem::absolute(beside).parent_path();
    options.progress = [&](std::size_t done, std::size_t total) { bar.update(done, total); };
    return replay(journal, session, options);
}

void print_json(const ReplayVerb& verb, const Session& session, const ReplayReport& report, double seconds) {
    nlohmann::ordered_json result{{"journal", verb.journal},
                                  {"strokes", report.strokes},
                                  {"dabs", report.dabs},
                                  {"map_hash", hash_text(session.map().hash())},
                                  {"expectations", report.expectations},
                                  {"failures", report.failures},
                                  {"seconds", seconds}};
    if (session.colours()) result["colour_hash"] = hash_text(session.colours()->hash());
    if (!verb.colour_out.empty()) result["colour_map"] = verb.colour_out;
    if (!verb.map_out.empty()) result["map"] = verb.map_out;
    if (!verb.render.empty()) result["render"] = verb.render;
    if (!verb.render_before.empty()) result["render_before"] = verb.render_before;
    if (verb.timings)
        for (const StageSummary& stage : summarize(report.dab_times))
            result["timings"].push_back({{"stage", stage.stage},
                                         {"median_ms", stage.median_ms},
                                         {"p95_ms", stage.p95_ms},
                                         {"max_ms", stage.max_ms},
                                         {"dabs", stage.count}});
    std::cout << result.dump(2) << "\n";
}

void print_text(const ReplayVerb& verb, const Session& session, const ReplayReport& report, double seconds) {
    std::printf("%s: %zu strokes, %zu dabs in %.2f s; map %s\n", verb.journal.c_str(), report.strokes,
                report.dabs, seconds, hash_text(session.map().hash()).c_str());
    if (report.expectations > 0)
        std::printf("%zu of %zu expectations met\n", report.expectations - report.failures.size(),
                    report.expectations);
    for (const std::string& out : {verb.render_before, verb.map_out, verb.colour_out, verb.render})
        if (!out.empty()) std::printf("wrote %s\n", out.c_str());
    if (!verb.timings) return;
    std::printf("%-8s %12s %12s %12s %8s\n", "stage", "median ms", "p95 ms", "max ms", "dabs");
    for (const StageSummary& stage : summarize(report.dab_times))
        std::printf("%-8s %12.3f %12.3f %12.3f %8zu\n", stage.stage.c_str(), stage.median_ms, stage.p95_ms,
                    stage.max_ms, stage.count);
}

int run_replay(const ReplayVerb& verb) {
    check_outputs(verb);
    const Journal journal = read_journal(verb.journal);
    for (const std::string& warning : journal.warnings) std::cerr << "warning: " << warning << "\n";
    Session session(scene_of(verb, journal), options_of(verb, journal));
    for (const std::string& warning : session.scene().warnings) std::cerr << "warning: " << warning << "\n";
    if (!verb.render_before.empty()) render_to(session, verb, verb.render_before);
    const auto start = std::chrono::steady_clock::now();
    const ReplayReport report = run_operations(journal, session, verb);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!verb.colour_out.empty()) session.export_colours(verb.colour_out);
    if (!verb.map_out.empty()) session.save(verb.map_out, {});
    if (!verb.render.empty()) render_to(session, verb, verb.render);
    verb.common.json ? print_json(verb, session, report, seconds)
                     : print_text(verb, session, report, seconds);
    for (const std::string& failure : report.failures) std::cerr << "relievo: " << failure << "\n";
    return report.failures.empty() ? 0 : 1;
}

}  // namespace

void add_replay(CLI::App& app, Command& command) {
    CLI::App& verb = *app.add_subcommand("replay", "Replay a journal of strokes without a window");
    const auto options = std::make_shared<ReplayVerb>();
    verb.add_option("JOURNAL", options->journal, "Journal file (JSON Lines)")->required();
    verb.add_option("-o,--output", options->map_out, "Write the edited map: .png, .tif or .exr")
        ->type_name("MAP");
    verb.add_option("--colour-output", options->colour_out, "Write the painted colour map: .png or .tif")
        ->type_name("MAP");
    verb.add_option("--render", options->render, "Render the result to a .png or .exr")->type_name("OUT");
    verb.add_option("--render-before", options->render_before, "Render what was there before the strokes")
        ->type_name("OUT");
    verb.add_option("--scene", options->scene, "Scene file in place of the one that the journal names")
        ->type_name("SCENE");
    verb.add_option("--map", options->map, "Start from this map in place of the scene's")->type_name("MAP");
    verb.add_option("--colour-map", options->colour_map, "Start from this colour map in place of the scene's")
        ->type_name("MAP");
    verb.add_option("--mask", options->mask, "Start with this mask in place of the one that the journal names")
        ->type_name("MASK");
    verb.add_flag("--force", options->force,
                  "Go on though mesh, map or stamped images are not the recorded ones");
    verb.add_flag("--timings", options->timings, "Print a table of milliseconds by stage over all dabs");
    verb.add_flag("--live", options->live,
                  "Trace the 256 x 256 window around the brush, as the editor does, at up to 200 dabs");
    add_picture(verb, options->picture);
    add_method(verb, options->method);
    add_common(verb, options->common);
    verb.callback([options, &command] { command = [options] { return run_replay(*options); }; });
}

}  // namespace relievo
