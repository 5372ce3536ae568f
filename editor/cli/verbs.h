// One function a verb: declares its options and, when the verb is given, sets the command to run.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "editor/cli/cli.h"
#include "editor/session/journal.h"

namespace CLI {
class App;
}

namespace relievo {

using Command = std::function<int()>;  // returns the exit status; throws as everything here does

void add_edit(CLI::App& app, Command& command, const EditorEntry& editor);
void add_render(CLI::App& app, Command& command);
void add_replay(CLI::App& app, Command& command);
void add_compare(CLI::App& app, Command& command);
void add_bake(CLI::App& app, Command& command);
void add_explain(CLI::App& app, Command& command);
void add_devices(CLI::App& app, Command& command);

// Options that verbs share, as given.
struct CommonOptions {
    std::string device;
    bool json = false;
};
struct MethodOptions {
    std::string method;
    std::vector<std::string> set;  // PARAM=VALUE
    std::string path;              // as parse_trace_path() takes it; empty: automatic
};
struct PictureOptions {
    std::string size;  // WxH; empty: the scene's
    int spp = 0;       // 0: the scene's
};
void add_common(CLI::App& verb, CommonOptions& options);
void add_method(CLI::App& verb, MethodOptions& options);
void add_picture(CLI::App& verb, PictureOptions& options);

// Checks and converts. Throws std::invalid_argument naming the option.
SessionOptions session_options(const CommonOptions& common, const MethodOptions& method,
                               const PictureOptions& picture = {});
ImageSize parse_size(const std::string& text);  // WxH, both from 1 to 16384, of --size
ImageSize size_of(const PictureOptions& picture, const Scene& scene);
int samples_of(const PictureOptions& picture, const Scene& scene);

}  // namespace relievo
