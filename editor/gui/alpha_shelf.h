// The images that the stamp can choose from: the samples beside the program, and those that the user opened.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "brushes/alpha.h"

namespace relievo::gui {

class AlphaShelf {
  public:
    static constexpr int kThumbnail = 20;  // cells a side, of kThumbnail + 1 corners

    struct Entry {
        std::shared_ptr<const Alpha> alpha;
        std::string name;                                                  // of the file, without its ending
        std::array<float, (kThumbnail + 1) * (kThumbnail + 1)> thumbnail;  // [0, 1], row 0 at the bottom
    };

    // The samples are read at the first call; one that cannot be read is left out.
    const std::vector<Entry>& entries();
    // Reads an image, or reads it anew. Throws std::invalid_argument as load_alpha().
    const Entry& add(const std::filesystem::path& path);

  private:
    std::vector<Entry> entries_;
    bool filled_ = false;
};

}  // namespace relievo::gui
