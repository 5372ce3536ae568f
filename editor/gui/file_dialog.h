// A file browser inside the window: choose a scene to open, or name a map to save.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace relievo::gui {

class FileDialog {
  public:
    struct Purpose {
        const char* title = "";
        const char* accept = "";              // the button's word
        std::vector<std::string> extensions;  // shown and accepted, lower case with the dot
        bool saving = false;                  // a new name may be given; an existing one must be confirmed
        std::vector<std::filesystem::path> recent{};  // offered at once
    };

    // Opens with the next draw(), in the folder of `start` and with its name.
    void open(const Purpose& purpose, const std::filesystem::path& start);
    bool is_open() const { return open_; }

    // Call every frame. The chosen path, once.
    std::optional<std::filesystem::path> draw();

  private:
    struct Entry {
        std::string name;
        bool folder = false;
    };
    void go_to(const std::filesystem::path& folder);
    void draw_places();
    std::optional<std::filesystem::path> draw_recent();
    void draw_entries(bool& accepted);
    std::optional<std::filesystem::path> accept();
    std::filesystem::path named() const;

    Purpose purpose_;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    std::string name_, trouble_;
    bool open_ = false, just_opened_ = false, confirm_ = false;
};

}  // namespace relievo::gui
