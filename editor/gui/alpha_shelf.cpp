// The images that the stamp can choose from.
#include "editor/gui/alpha_shelf.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace relievo::gui {
namespace fs = std::filesystem;

namespace {

fs::path sample_folder() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path() / "assets" / "alphas";
}

AlphaShelf::Entry entry_of(const fs::path& path) {
    AlphaShelf::Entry entry{load_alpha(path), path.stem().string(), {}};
    constexpr int kCorners = AlphaShelf::kThumbnail + 1;
    constexpr double kStep = 2.0 / AlphaShelf::kThumbnail;
    for (int y = 0; y < kCorners; ++y)
        for (int x = 0; x < kCorners; ++x) {
            const float value = entry.alpha->at(kStep * x - 1, kStep * y - 1, 0.5 * kStep);
            entry.thumbnail[static_cast<std::size_t>(y * kCorners + x)] = std::abs(value);
        }
    return entry;
}

}  // namespace

const std::vector<AlphaShelf::Entry>& AlphaShelf::entries() {
    if (filled_) return entries_;
    filled_ = true;
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& file : fs::directory_iterator(sample_folder(), error)) files.push_back(file.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        try {
            entries_.push_back(entry_of(file));
        } catch (const std::invalid_argument&) {
            // A damaged sample must not keep the program from working.
        }
    }
    return entries_;
}

const AlphaShelf::Entry& AlphaShelf::add(const fs::path& path) {
    entries();
    Entry fresh = entry_of(fs::absolute(path).lexically_normal());
    const auto known = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return entry.alpha->path() == fresh.alpha->path();
    });
    if (known != entries_.end()) return *known = std::move(fresh);
    return entries_.emplace_back(std::move(fresh));
}

}  // namespace relievo::gui
