// relievo explain SCENE: what the scene needs, what was left out, and why.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "editor/cli/verbs.h"
#include "editor/session/text.h"
#include "renderer/features.h"
#include "renderer/vulkan/context.h"

namespace relievo {
namespace {

using Json = nlohmann::ordered_json;

struct ExplainOptions {
    std::string scene;
    CommonOptions common;
    MethodOptions method;
};

// What the report is about.
struct Subject {
    const Session& session;
    const Method& method;
    std::map<std::string, double> parameters;
    const vulkan::DeviceInfo& device;
    const FeatureReport& report;
};

Json objects_json(const Subject& subject) {
    Json objects = Json::array();
    for (const SceneObject& object : subject.session.scene().objects) {
        Json one{{"mesh", object.mesh_path.string()}, {"triangles", object.mesh.faces.size()}};
        one["map"] = object.displacement.map.empty() ? Json(nullptr) : Json(object.displacement.map.string());
        one["opacity_map"] = object.opacity_map.empty() ? Json(nullptr) : Json(object.opacity_map.string());
        const std::filesystem::path& albedo = object.material.albedo_map;
        one["albedo_map"] = albedo.empty() ? Json(nullptr) : Json(albedo.string());
        objects.push_back(std::move(one));
    }
    return objects;
}

void print_json(const Subject& subject) {
    Json features = Json::array();
    for (const Feature& feature : subject.report.features)
        features.push_back({{"name", feature.name},
                            {"built", feature.built},
                            {"reason", feature.reason},
                            {"bytes", feature.bytes}});
    std::cout << Json{{"scene", subject.session.scene().path.string()},
                      {"method", subject.method.name},
                      {"parameters", subject.parameters},
                      {"device", subject.device.name},
                      {"path", std::string(trace_path_name(subject.report.path))},
                      {"objects", objects_json(subject)},
                      {"features", features},
                      {"bytes_total", subject.report.bytes_total}}
                     .dump(2)
              << "\n";
}

std::string method_line(const Subject& subject) {
    std::string line = std::string(subject.method.name) + " (" + std::string(subject.method.title) + ")";
    const char* before = ": ";
    for (const MethodParameter& parameter : subject.method.parameters) {
        const double value = subject.parameters.at(std::string(parameter.name));
        line += before + std::string(parameter.name) + " " +
                (parameter.is_switch        ? (value > 0.5 ? "on" : "off")
                 : parameter.names.empty() ? number_text(value)
                                           : std::string(parameter.names[static_cast<std::size_t>(value)]));
        before = ", ";
    }
    return line;
}

void print_line(int width, const std::string& name, std::uint64_t bytes, const std::string& reason) {
    std::printf("  %-*s %9s   %s\n", width, name.c_str(), bytes > 0 ? bytes_text(bytes).c_str() : "",
                reason.c_str());
}

void print_part(const FeatureReport& report, bool built, int width) {
    std::printf("\n%s\n", built ? "built" : "left out");
    for (const Feature& feature : report.features)
        if (feature.built == built) print_line(width, feature.name, feature.bytes, feature.reason);
}

void print_text(const Subject& subject) {
    const Scene& scene = subject.session.scene();
    const HeightMap& map = subject.session.map();
    std::printf("scene   %s\n", scene.path.string().c_str());
    std::printf("method  %s\n", method_line(subject).c_str());
    std::printf("device  %s\n", subject.device.name.c_str());
    for (const SceneObject& object : scene.objects) {
        const bool edited = &object == &scene.objects.front();
        const std::string size =
            edited ? ", map of " + std::to_string(map.width()) + " x " + std::to_string(map.height()) : "";
        std::printf("object  %s: %zu triangles%s\n", object.mesh_path.filename().string().c_str(),
                    object.mesh.faces.size(), size.c_str());
    }
    std::size_t width = 0;
    for (const Feature& feature : subject.report.features) width = std::max(width, feature.name.size());
    const int column = static_cast<int>(width);
    print_part(subject.report, true, column);
    print_line(column, "together", subject.report.bytes_total, "of device memory");
    print_part(subject.report, false, column);
}

int run_explain(const ExplainOptions& options) {
    Session session(options.scene, session_options(options.common, options.method));
    for (const std::string& warning : session.scene().warnings) std::cerr << "warning: " << warning << "\n";
    const MethodChoice& choice = session.scene().method;
    const Method& method = find_method(choice.name);
    const Subject subject{session, method, resolve_parameters(method, choice.parameters),
                          session.context().info(), session.renderer().features()};
    options.common.json ? print_json(subject) : print_text(subject);
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
