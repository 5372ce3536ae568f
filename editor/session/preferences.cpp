// See preferences.h.
#include "editor/session/preferences.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "brushes/atomic_file.h"
#include "editor/session/text.h"
#include "editor/session/user_folders.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

using nlohmann::json;

// Reads key by key; what is not what it should be is left as it was, and the first such key is told.
class Reader {
  public:
    Reader(const json& root, std::string* warning) : root_(root), warning_(warning) {}

    void warn(const std::string& what) {
        if (warning_ && warning_->empty()) *warning_ = preferences_file().string() + ": " + what;
    }

    void number(const char* key, double low, double high, double& value) {
        const auto found = root_.find(key);
        if (found == root_.end()) return;
        const bool fits = found->is_number() && found->get<double>() >= low && found->get<double>() <= high;
        if (fits)
            value = found->get<double>();
        else
            warn(std::string(key) + ": must be a number " + range_text(low, high));
    }

    void number(const char* key, int low, int high, int& value) {
        double wide = value;
        number(key, double(low), double(high), wide);
        value = static_cast<int>(wide);
    }

    void boolean(const char* key, bool& value) {
        const auto found = root_.find(key);
        if (found == root_.end()) return;
        if (found->is_boolean())
            value = found->get<bool>();
        else
            warn(std::string(key) + ": must be true or false");
    }

    void paths(const char* key, std::size_t most, std::vector<fs::path>& value) {
        const auto found = root_.find(key);
        if (found == root_.end()) return;
        if (!found->is_array()) return warn(std::string(key) + ": must be a list of paths");
        for (const json& item : *found) {
            if (!item.is_string())
                warn(std::string(key) + ": must be a list of paths");
            else if (value.size() < most)
                value.emplace_back(item.get<std::string>());
        }
    }

    void number_lists(const char* key, std::size_t length,
                      std::map<std::string, std::vector<double>>& value) {
        const auto found = root_.find(key);
        if (found == root_.end()) return;
        if (!found->is_object()) return warn(std::string(key) + ": must be an object");
        for (const auto& [name, list] : found->items()) {
            const bool fits =
                list.is_array() && list.size() == length &&
                std::all_of(list.begin(), list.end(), [](const json& item) { return item.is_number(); });
            if (fits)
                value[name] = list.get<std::vector<double>>();
            else
                warn(std::string(key) + "." + name + ": must be a list of " + std::to_string(length) +
                     " numbers");
        }
    }

  private:
    const json& root_;
    std::string* warning_;
};

constexpr int kMostPixels = 32768;
constexpr std::size_t kCameraNumbers = 10;

Preferences read_from(const json& root, std::string* warning) {
    Preferences p;
    Reader reader(root, warning);
    reader.paths("recent", Preferences::kMostRecent, p.recent);
    reader.number("window_width", 0, kMostPixels, p.window_width);
    reader.number("window_height", 0, kMostPixels, p.window_height);
    reader.number("interface_scale", 0.0, 4.0, p.interface_scale);
    reader.number("side_width", 0.0, double(kMostPixels), p.side_width);
    reader.boolean("first_hint_seen", p.first_hint_seen);
    reader.number_lists("cameras", kCameraNumbers, p.cameras);
    return p;
}

void write_to(const Preferences& p, json& root) {
    root["recent"] = json::array();
    for (const fs::path& scene : p.recent) root["recent"].push_back(scene.string());
    root["window_width"] = p.window_width;
    root["window_height"] = p.window_height;
    root["interface_scale"] = p.interface_scale;
    root["side_width"] = p.side_width;
    root["first_hint_seen"] = p.first_hint_seen;
    root["cameras"] = p.cameras;
}

// An object, or null where the file is none.
json parse_file(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return json::object();
    std::ifstream in(path);
    json root = json::parse(in, nullptr, false);
    return root.is_object() ? root : json();
}

// Held while the file is read, changed and written.
class Turn {
  public:
    explicit Turn(const fs::path& file)
        : lock_(open((file.string() + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
        if (lock_ >= 0) flock(lock_, LOCK_EX);
    }
    ~Turn() {
        if (lock_ >= 0) close(lock_);
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

  private:
    int lock_;
};

}  // namespace

fs::path preferences_file() {
    return config_folder() / "preferences.json";
}

Preferences load_preferences(std::string* warning) {
    if (warning) warning->clear();
    const json root = parse_file(preferences_file());
    if (!root.is_null()) return read_from(root, warning);
    if (warning)
        *warning = preferences_file().string() + ": is not a JSON object; all settings have their defaults";
    return {};
}

void change_preferences(const std::function<void(Preferences&)>& change) {
    const fs::path file = preferences_file();
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error)
        throw std::invalid_argument(file.parent_path().string() +
                                    ": cannot create the folder: " + error.message());
    const Turn turn(file);
    json root = parse_file(file);
    if (root.is_null()) {
        fs::rename(file, file.string() + ".damaged", error);
        root = json::object();
    }
    Preferences preferences = read_from(root, nullptr);
    change(preferences);
    write_to(preferences, root);
    const std::string text = root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
    write_file_atomically(file, std::as_bytes(std::span(text)));
}

std::string camera_key(const fs::path& scene, int number) {
    return std::to_string(number) + " " + fs::absolute(scene).lexically_normal().string();
}

void add_recent(Preferences& preferences, const fs::path& scene) {
    const fs::path path = fs::absolute(scene).lexically_normal();
    auto& recent = preferences.recent;
    recent.erase(std::remove(recent.begin(), recent.end(), path), recent.end());
    recent.insert(recent.begin(), path);
    if (recent.size() > Preferences::kMostRecent) recent.resize(Preferences::kMostRecent);
}

}  // namespace relievo
