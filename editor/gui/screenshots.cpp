// See screenshots.h.
#include "editor/gui/screenshots.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace relievo::gui {
namespace fs = std::filesystem;

void Screenshots::take(DisplayPicture picture, const fs::path& folder) {
    constexpr std::size_t kMost = 4;  // each holds its pixels
    if (pending_.size() >= kMost) pending_[pending_.size() - kMost].trouble.wait();
    fs::path path;
    const auto taken = [&] {
        return fs::exists(path) || std::ranges::any_of(pending_, [&](const Pending& p) { return p.path == path; });
    };
    for (int number = 1; path.empty() || taken(); ++number)
        path = folder / ("relievo-screenshot-" + std::to_string(number) + ".png");
    auto work = [write = write_, finished = finished_, path, picture = std::move(picture)] {
        std::string trouble;
        try {
            write(path, picture);
        } catch (const std::exception& error) {
            trouble = error.what();
        }
        finished();
        return trouble;
    };
    pending_.push_back({path, std::async(std::launch::async, std::move(work))});
}

std::vector<Screenshots::Done> Screenshots::take_done() {
    std::vector<Done> done;
    while (!pending_.empty() && pending_.front().trouble.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        done.push_back({pending_.front().path, pending_.front().trouble.get()});
        pending_.pop_front();
    }
    return done;
}

}  // namespace relievo::gui
