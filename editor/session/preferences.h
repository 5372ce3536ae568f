// What the window keeps between runs, in the platform's place for settings. Nothing in a scene, a map or a
// journal depends on it.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace relievo {

struct Preferences {
    static constexpr std::size_t kMostRecent = 12;

    std::vector<std::filesystem::path> recent;  // scenes, absolute, the newest first
    int window_width = 0, window_height = 0;    // pixels; 0: the program's own choice
    double interface_scale = 0;                 // [0.5, 4]; 0: the display's
    double side_width = 0;                      // of the side panel, pixels; 0: the program's own choice
    bool first_hint_seen = false;
    // Kept views: a number and the scene's absolute path, as camera_key() joins them; ten numbers each, as
    // the setting `camera` (settings.h).
    std::map<std::string, std::vector<double>> cameras;
    bool operator==(const Preferences&) const = default;
};

// $XDG_CONFIG_HOME/relievo/preferences.json, else in ~/.config, else in a folder of the temporary directory.
std::filesystem::path preferences_file();

// Never throws: settings must not keep the program from starting. A file that cannot be read or does not say
// what it should leaves the defaults in the place of what is wrong, and `warning` gets one sentence that
// names file and key.
Preferences load_preferences(std::string* warning = nullptr);

// Reads the file again, changes it, and writes it whole (atomic_file.h); two programs take turns. Keys that
// this version does not know are kept; a file that is no JSON is kept beside it as preferences.json.damaged.
// Throws std::invalid_argument when the file cannot be written.
void change_preferences(const std::function<void(Preferences&)>& change);

std::string camera_key(const std::filesystem::path& scene, int number);

// Puts the scene first among the recent ones.
void add_recent(Preferences& preferences, const std::filesystem::path& scene);

}  // namespace relievo
