// The dispatcher: reads the command line, runs one verb, turns exceptions into one line and an exit status.
#include "editor/cli/cli.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <new>
#include <stdexcept>

#include "editor/cli/verbs.h"

namespace relievo {
namespace {

constexpr int kFailed = 1, kBadInput = 2;

// Libraries put several lines into their messages; ours is one.
int report(const std::string& message, int status) {
    std::string line;
    for (char letter : message) line += letter == '\n' ? ' ' : letter;
    line.erase(line.find_last_not_of(' ') + 1);
    std::cerr << "relievo: " << line << "\n";
    return status;
}

// `relievo` and `relievo SCENE` mean `relievo edit`. A word that is neither a verb nor looks like a file is a
// slip.
std::vector<std::string> with_verb(std::vector<std::string> words, const CLI::App& app) {
    if (words.empty()) return {"edit"};
    const std::string first = words.front();
    const std::vector<const CLI::App*> verbs = app.get_subcommands(std::function<bool(const CLI::App*)>());
    const bool known =
        std::any_of(verbs.begin(), verbs.end(), [&](auto* verb) { return verb->get_name() == first; });
    if (known || first == "-h" || first == "--help" || first == "--version") return words;
    const bool file = first.find_first_of("./") != std::string::npos || std::filesystem::exists(first);
    if (first.front() != '-' && !file) {
        std::string names;
        for (const CLI::App* verb : verbs) names += (names.empty() ? "" : ", ") + verb->get_name();
        throw std::invalid_argument("\"" + first + "\" is not a verb; known are " + names);
    }
    words.insert(words.begin(), "edit");
    return words;
}

int parse_and_run(const std::vector<std::string>& given, const EditorEntry& editor) {
    CLI::App app("Sculpt a displacement map while its surface is ray traced.", "relievo");
    app.set_version_flag("--version", std::string("relievo ") + RELIEVO_VERSION);
    app.require_subcommand(0, 1);
    Command command;
    add_edit(app, command, editor);
    add_render(app, command);
    add_replay(app, command);
    add_compare(app, command);
    add_bake(app, command);
    add_explain(app, command);
    add_devices(app, command);
    std::vector<std::string> words = with_verb(given, app);
    try {
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes them last first
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        throw std::invalid_argument(std::string(error.what()) + "; relievo " + words.front() +
                                    " --help tells more");
    }
    return command();
}

}  // namespace

int run_cli(int argc, const char* const* argv, const EditorEntry& editor) {
    try {
        return parse_and_run({argv + 1, argv + argc}, editor);
    } catch (const std::invalid_argument& error) {
        return report(error.what(), kBadInput);
    } catch (const std::bad_alloc&) {
        return report("out of memory", kFailed);
    } catch (const std::exception& error) {
        return report(error.what(), kFailed);
    }
}

}  // namespace relievo
