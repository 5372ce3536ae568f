// Least and greatest values over rectangles of an image that repeats: a min-max pyramid.
#pragma once

#include <cstdint>
#include <vector>

namespace relievo {

class ExemplarBounds {
  public:
    struct Range {
        std::uint16_t low = 65535, high = 0;
    };

    // Row-major texels, at least 1 x 1, which are not kept.
    ExemplarBounds(int width, int height, const std::uint16_t* texels);

    // Over the texels from (x, y), inside the image, to (x + columns - 1, y + rows - 1), wrapped. Columns and
    // rows at least 1. Conservative: as tight as nodes of a quarter of the rectangle's side allow.
    Range range(int x, int y, int columns, int rows) const;

  private:
    struct Level {
        int width, height;
        std::vector<Range> nodes;
    };
    void include(Range& range, int x0, int y0, int x1, int y1) const;  // inside the image, both ends included

    std::vector<Level> levels_;  // level k: nodes of 2^k texels a side
};

}  // namespace relievo
