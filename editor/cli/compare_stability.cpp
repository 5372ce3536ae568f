// relievo compare --stability -o FOLDER: every method on the extreme cases, as a page.
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "editor/cli/compare.h"
#include "editor/cli/progress.h"
#include "editor/session/compare/compare.h"
#include "editor/session/stability/stability_report.h"

namespace relievo {
namespace {

// What only scenes have.
void check_options(const CompareVerb& verb) {
    const auto refuse = [](const std::string& option) {
        throw std::invalid_argument(option + ": does not go with --stability, which has scenes of its own");
    };
    if (!verb.scenes.empty()) refuse(verb.scenes.front());
    if (verb.budget_s > 0) refuse("--budget");
}

}  // namespace

int run_compare_stability(const CompareVerb& verb) {
    check_options(verb);
    StabilityOptions options;
    options.methods = parse_methods(verb.methods);
    options.cases = parse_cases(verb.cases);
    const SessionOptions session = session_options(verb.common, verb.method, verb.picture);
    if (session.width != session.height)
        throw std::invalid_argument("--size: with --stability images are square, like 128x128");
    if (session.width > 0) options.size = session.width;
    options.device = session.device;
    options.path = session.path;
    const std::filesystem::path folder = verb.folder;
    prepare_stability_folder(folder);
    StabilityMatrix matrix;
    {
        ProgressBar bar("extreme cases");
        matrix = run_stability(options, [&](int done, int total, const std::string& name) {
            bar.update(static_cast<std::size_t>(done), static_cast<std::size_t>(total),
                       std::to_string(done) + " of " + std::to_string(total) + ", " + name);
        });
    }
    write_stability(matrix, folder);
    if (verb.common.json)
        std::cout << json_text(matrix);
    else
        std::cout << summary_text(matrix) << (folder / "index.html").string() << "\n";
    return matrix.kept() ? 0 : 1;
}

}  // namespace relievo
