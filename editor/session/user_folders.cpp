// See user_folders.h.
#include "editor/session/user_folders.h"

#include <unistd.h>

#include <cstdlib>
#include <string>

namespace relievo {
namespace fs = std::filesystem;

namespace {

// The standard asks to pass over values that are not absolute.
fs::path absolute_of(const char* name) {
    const char* value = std::getenv(name);
    return value && *value == '/' ? fs::path(value) : fs::path();
}

fs::path user_folder(const char* variable, const fs::path& below_home) {
    if (const fs::path given = absolute_of(variable); !given.empty()) return given / "relievo";
    if (const fs::path home = absolute_of("HOME"); !home.empty()) return home / below_home / "relievo";
    return fs::temp_directory_path() / ("relievo-" + std::to_string(getuid()));
}

}  // namespace

fs::path config_folder() {
    return user_folder("XDG_CONFIG_HOME", ".config");
}

fs::path state_folder() {
    return user_folder("XDG_STATE_HOME", fs::path(".local") / "state");
}

}  // namespace relievo
