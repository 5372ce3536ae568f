// Pictures of the window itself, written while it goes on: that of a large one takes a third of a second and more.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <string>
#include <vector>

#include "editor/session/image_file.h"

namespace relievo::gui {

class Screenshots {
  public:
    using Write = std::function<void(const std::filesystem::path&, const DisplayPicture&)>;

    // Both are called on threads of the screenshots' own, `finished` after each.
    Screenshots(Write write, std::function<void()> finished) : write_(std::move(write)), finished_(std::move(finished)) {}

    // Into `folder`, under a name that is free. Waits for the oldest where many are under way.
    void take(DisplayPicture picture, const std::filesystem::path& folder);

    struct Done {
        std::filesystem::path path;
        std::string trouble;  // why it was not written; empty: it was
    };
    std::vector<Done> take_done();  // since the last call, in the order in which they were taken

  private:
    struct Pending {
        std::filesystem::path path;
        std::future<std::string> trouble;  // waits for its thread when it goes
    };

    Write write_;
    std::function<void()> finished_;
    std::deque<Pending> pending_;
};

}  // namespace relievo::gui
