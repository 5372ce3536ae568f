// See footprint_heights.h.
//
// A bilinear map over a triangle is least and greatest at texels in it, or along its sides: there, in each cell, it is of the
// second degree, and lies between the stretch's ends and its middle Bezier point. Sides are moved out by what rounding may do.
#include "renderer/footprint_heights.h"

#include <glm/common.hpp>

#include "renderer/scene/cross2.h"

namespace relievo {
namespace {

constexpr int kMostParts = 64;     // texels or nodes along the longer side of a triangle's footprint, but for those that
constexpr int kRoomForParts = 136; // end at the map's borders
constexpr int kSmall = 16;         // texels along it: what lies beside a small triangle in the cells it touches would count
constexpr double kOnLine = 1e-9;   // texels

int floor_div(int a, int b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

// Texels [from, to] along one axis of the footprint, all in one node (or texel) of the map.
struct Part {
    int from, to, node;
};

struct Parts {
    std::array<Part, kRoomForParts> at;
    int count = 0;
    bool fits = true;
    void add(const Part& part) {
        fits = fits && count < kRoomForParts;
        if (fits) at[static_cast<std::size_t>(count++)] = part;
    }
    const Part& operator[](int i) const { return at[static_cast<std::size_t>(i)]; }
};

// The footprint's texels first, first + 1, ... along an axis of a map of `size`, in nodes of 2^level.
void divide(int first, int texels, int size, int nodes, int level, Wrap wrap, Parts& parts) {
    for (int from = 0; from < texels && parts.fits;) {
        const int texel = first + from;
        int node, after;  // the first texel after the node
        if (wrap == Wrap::repeat) {
            const int period = floor_div(texel, size) * size;
            node = std::min((texel - period) >> level, nodes - 1);
            after = period + (node + 1 == nodes ? size : (node + 1) << level);
        } else {
            node = std::clamp(texel >> level, 0, nodes - 1);
            after = node + 1 == nodes ? first + texels : (node + 1) << level;
        }
        if (level == 0) after = texel + 1;  // beyond a border, too
        const int to = std::min(after - first, texels) - 1;
        parts.add({from, to, node});
        from = to + 1;
    }
}

class Sampler {
  public:
    Sampler(const HeightView& map, const HeightPyramid& pyramid, const UnwrappedFootprint& footprint)
        : map_(map), pyramid_(pyramid), footprint_(footprint), width_(footprint.piece.box.x1),
          height_(footprint.piece.box.y1) {
        while (level_ < pyramid.levels() && std::max(width_, height_) >> level_ > kMostParts) ++level_;
        const bool texels = level_ == 0;
        const Wrap wrap = pyramid.wrap();
        divide(footprint.x, width_, map.width, texels ? map.width : pyramid.width(level_), level_, wrap, columns_);
        divide(footprint.y, height_, map.height, texels ? map.height : pyramid.height(level_), level_, wrap, rows_);
    }

    bool fits() const { return columns_.fits && rows_.fits; }

    std::vector<HeightSample> run() {
        if (level_ > 0) {
            add_nodes();
        } else if (std::max(width_, height_) > kSmall) {
            add_texels(footprint_.piece);
        } else {
            samples_.reserve(192);
            add_texels(footprint_.inside);
            add_sides();
        }
        return std::move(samples_);
    }

  private:
    void add(double x, double y, double height) { samples_.push_back({x, y, 0, 0, height, height}); }

    void add_texels(const FootprintPiece& piece) {
        for (int y = 0; y < height_; ++y) {
            int first, last;
            piece.row(y, first, last);
            for (int x = first; x < last; ++x) add(x, y, texel(x, y));
        }
    }

    void add_nodes() {
        for (int r = 0; r < rows_.count; ++r) {
            const Part& row = rows_[r];
            for (int c = 0; c < columns_.count; ++c) {
                const Part& column = columns_[c];
                if (footprint_.piece.cover({column.from, row.from, column.to + 1, row.to + 1}) == Cover::none) continue;
                const HeightPyramid::Node& node = pyramid_.plain(level_, column.node, row.node);
                samples_.push_back({static_cast<double>(column.from), static_cast<double>(row.from),
                                    static_cast<double>(column.to - column.from), static_cast<double>(row.to - row.from),
                                    static_cast<double>(node.low), static_cast<double>(node.high)});
            }
        }
    }

    // The triangle, grown by a square of kPlaces each way: its outermost sides, and at its corners the square.
    void add_sides() {
        const auto& t = footprint_.corners;
        const glm::dvec2 a = t[1] - t[0], b = t[2] - t[0];
        const double turn = cross2(a, b) < 0 ? -1 : 1, by = FootprintHeights::kPlaces;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 &from = t[i], &to = t[(i + 1) % 3], out = turn * glm::dvec2(to.y - from.y, from.x - to.x);
            const glm::dvec2 moved(out.x < 0 ? -by : by, out.y < 0 ? -by : by);
            add_line(from + moved, to + moved);
            add_end(to + moved);
            const glm::dvec2 low = from - by, high = from + by;
            add_line(low, {high.x, low.y});
            add_line({high.x, low.y}, high);
            add_line(high, {low.x, high.y});
            add_line({low.x, high.y}, low);
        }
    }

    // But its end.
    void add_line(const glm::dvec2& from, const glm::dvec2& to) {
        const glm::dvec2 way = to - from;
        const bool aligned = way.x == 0 || way.y == 0;  // linear between texels
        for (double s = 0; s < 1;) {
            const double next = std::min({next_line(from.x, way.x, s), next_line(from.y, way.y, s), 1.0});
            const glm::dvec2 start = from + s * way, middle = from + 0.5 * (s + next) * way, end = from + next * way;
            const Cell cell = cell_at(middle);
            const double first = cell.at(start);
            add(start.x, start.y, first);
            if (!aligned) add(middle.x, middle.y, 2 * cell.at(middle) - 0.5 * (first + cell.at(end)));
            if (!(next > s)) break;
            s = next;
        }
    }

    void add_end(const glm::dvec2& place) { add(place.x, place.y, cell_at(place).at(place)); }

    struct Cell {
        glm::dvec2 corner;
        double height, across, up, twist;
        double at(const glm::dvec2& place) const {
            const glm::dvec2 f = place - corner;
            return height + across * f.x + up * f.y + twist * f.x * f.y;
        }
    };
    Cell cell_at(const glm::dvec2& place) const {
        const int x = static_cast<int>(place.x), y = static_cast<int>(place.y);  // places in the footprint are not negative
        const double height = texel(x, y), across = texel(x + 1, y) - height, up = texel(x, y + 1) - height;
        return {glm::dvec2(x, y), height, across, up, texel(x + 1, y + 1) - height - across - up};
    }

    // Where along the way the next line between texels lies.
    static double next_line(double from, double way, double s) {
        if (way == 0) return 1;
        const double at = from + s * way;
        const double beside = way > 0 ? at + kOnLine : at - kOnLine;
        const auto below = static_cast<double>(static_cast<int>(beside));  // std::floor is a call on plain x86-64
        const double line = way > 0 ? below + 1 : below < beside ? below : below - 1;
        return (line - from) / way;
    }

    // There are texels.
    double texel(int x, int y) const {
        return map_.texels[static_cast<std::size_t>(rows_[y].node) * static_cast<std::size_t>(map_.width) +
                           static_cast<std::size_t>(columns_[x].node)];
    }

    const HeightView& map_;
    const HeightPyramid& pyramid_;
    const UnwrappedFootprint& footprint_;
    int width_, height_, level_ = 0;
    Parts columns_, rows_;
    std::vector<HeightSample> samples_;
};

}  // namespace

std::optional<FootprintHeights> footprint_heights(const HeightView& map, const HeightPyramid& pyramid,
                                                  const std::array<glm::vec2, 3>& uvs) {
    const auto footprint = unwrapped_footprint(uvs, map.width, map.height);
    if (!footprint) return std::nullopt;
    Sampler sampler(map, pyramid, *footprint);
    if (!sampler.fits()) return std::nullopt;
    return FootprintHeights{footprint->corners, sampler.run()};
}

MapLinear linear_through(const std::array<double, 3>& values, const std::array<glm::dvec2, 3>& corners) {
    const glm::dvec2 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const double area = cross2(a, b), v1 = values[1] - values[0], v2 = values[2] - values[0];
    MapLinear f;
    f.rise_x = (v1 * b.y - v2 * a.y) / area;
    f.rise_y = (v2 * a.x - v1 * b.x) / area;
    f.at0 = values[0] - f.rise_x * corners[0].x - f.rise_y * corners[0].y;
    return f;
}

}  // namespace relievo
