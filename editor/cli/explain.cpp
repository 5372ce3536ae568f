// relievo explain SCENE: what the scene needs, what was left out, and why.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "editor/cli/verbs.h"
#include "renderer/features.h"

namespace relievo {
namespace {

struct ExplainOptions {
    std::string scene;
    CommonOptions common;
    MethodOptions method;
};

void print_json(const FeatureReport& report) {
    nlohmann::ordered_json features = nlohmann::ordered_json::array();
    for (const Feature& feature : report.features)
        features.push_back({{"name", feature.name},
                            {"built", feature.built},
                            {"reason", feature.reason},
                            {"bytes", feature.bytes}});
    std::cout << nlohmann::ordered_json{{"features", features}, {"bytes_total", report.bytes_total}}.dump(2)
              << "\n";
}

void print_text(const FeatureReport& report) {
    for (const Feature& feature : report.features)
        std::printf("%-9s %-28s %12llu bytes  %s\n", feature.built ? "built" : "left out",
                    feature.name.c_str(), static_cast<unsigned long long>(feature.bytes),
                    feature.reason.c_str());
    std::printf("%-9s %-28s %12llu bytes\n", "total", "",
                static_cast<unsigned long long>(report.bytes_total));
}

int run_explain(const ExplainOptions& options) {
    Session session(options.scene, session_options(options.common, options.method));
    const FeatureReport& report = session.renderer().features();
    options.common.json ? print_json(report) : print_text(report);
    return 0;
}

}  // namespace

void add_explain(CLI::App& app, Command& command) {
    CLI::App& verb = *app.add_subcommand("explain", "List what a scene needs, what was left out, and why");
    const auto options = std::make_shared<ExplainOptions>();
    verb.add_option("SCENE", options->scene, "Scene file (JSON)")->required();
    add_method(verb, options->method);
    add_common(verb, options->common);
    verb.callback([options, &command] { command = [options] { return run_explain(*options); }; });
}

}  // namespace relievo
