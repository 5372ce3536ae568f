// See compare.h.
#include "editor/session/compare/compare.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>
#include <stdexcept>

#include "editor/session/compare/budget.h"
#include "editor/session/compare/machine.h"
#include "editor/session/compare/points.h"
#include "editor/session/compare/report.h"
#include "editor/session/compare/scene_run.h"
#include "editor/session/image_file.h"
#include "editor/session/scene_input.h"
#include "renderer/vulkan/context.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

void prepare_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder / "pictures", error);
    if (error || !fs::is_directory(folder / "pictures"))
        throw std::invalid_argument(folder.string() + ": cannot make the folder: " +
                                    (error ? error.message() : "there is a file of that name"));
    check_writable(folder / "results.json");
    check_writable(folder / "pictures" / "picture.jpg");
}

std::vector<std::string> every_method() {
    std::vector<std::string> names;
    for (const Method* method : methods()) names.emplace_back(method->name);
    return names;
}

// What goes into the names of files and links.
std::string file_name(std::string name) {
    for (char& letter : name)
        if (!std::isalnum(static_cast<unsigned char>(letter)) && letter != '-') letter = '_';
    return name;
}

std::vector<SceneTask> make_tasks(const CompareOptions& options, const std::vector<std::string>& names) {
    std::vector<SceneTask> tasks;
    std::map<std::string, int> seen;
    for (const fs::path& file : options.scenes) {
        // What is wrong with any of them is told before an hour is spent on the others.
        const Scene scene = open_scene(file);
        const bool procedural = std::any_of(scene.objects.begin(), scene.objects.end(), [](const auto& object) {
            return object.displacement.procedural.has_value();
        });
        std::string name = file_name(file.stem().string());
        if (const int count = ++seen[name]; count > 1) name.append("-").append(std::to_string(count));
        tasks.push_back({file, name, comparison_points(names, procedural), options.width, options.height, options.path, options.folder});
    }
    return tasks;
}

Comparison describe(const CompareOptions& options, const vulkan::Context& context,
                    const std::vector<std::string>& names) {
    Comparison comparison;
    comparison.version = RELIEVO_VERSION;
    comparison.machine = machine_info();
    comparison.device = context.info().name;
    comparison.driver = context.info().driver;
    comparison.path = trace_path_words(resolve_trace_path(options.path, context.info()));
    comparison.budget_s = options.budget_s;
    comparison.methods = names;
    return comparison;
}

}  // namespace

std::vector<std::string> parse_methods(const std::string& list) {
    std::vector<std::string> names;
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) {
        try {
            if (word.empty()) throw std::invalid_argument("an empty name");
            const std::string name(find_method(word).name);
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(std::string("--methods: ") + error.what());
        }
    }
    return names;
}

double least_seconds(const CompareOptions& options) {
    constexpr double kScene = 1, kMethod = 4;  // reading and reference; shaders, layers and pictures
    return static_cast<double>(options.scenes.size()) * (kScene + kMethod);
}

Comparison compare_methods(const CompareOptions& options, const CompareListener& listener) {
    const Budget budget(options.budget_s);
    const std::vector<std::string> names = options.methods.empty() ? every_method() : options.methods;
    const std::vector<SceneTask> tasks = make_tasks(options, names);
    prepare_folder(options.folder);
    vulkan::Context context({options.device, false, false});
    Comparison comparison = describe(options, context, names);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const TellPart tell = [&](const std::string& what, double part) {
            if (!listener.progress) return;
            const double scenes = static_cast<double>(tasks.size());
            const double by_work = (static_cast<double>(i) + part) / scenes;
            const double done = budget.endless() ? by_work : std::min(budget.spent() / budget.limit(), 1.0);
            const double left = budget.endless() ? budget.spent() * (1 - done) / std::max(done, 0.01)
                                                 : std::max(budget.left(), 0.0);
            listener.progress({tasks[i].name + " (" + std::to_string(i + 1) + " of " +
                                   std::to_string(tasks.size()) + "): " + what,
                               done, left});
        };
        comparison.scenes.push_back(
            compare_on_scene(context, tasks[i], budget.share(static_cast<int>(tasks.size() - i)), tell));
        comparison.spent_s = budget.spent();
        write_report(comparison, options.folder);
        if (listener.scene_done) listener.scene_done(comparison.scenes.back());
    }
    return comparison;
}

}  // namespace relievo
