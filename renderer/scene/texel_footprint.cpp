// Footprints of triangles in texel space: see the header.
#include "renderer/scene/texel_footprint.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

namespace relievo {

namespace {

// Beyond the square [-1, 1]: half a step of the 8-bit weights that devices filter with, and four roundings of
// the coordinate to float.
constexpr double kGrowth = 1.0 / 64;
constexpr double kGrowthPerTexel = 4 * static_cast<double>(std::numeric_limits<float>::epsilon());
// Coordinates past this many texels are not told apart; they stand for the whole map.
constexpr double kFarthest = 1e9;

struct TexelTriangle {
    std::array<glm::dvec2, 3> t;
    glm::dvec2 low, high;
    double reach;  // half the square's side
};

TexelTriangle texel_triangle(const std::array<glm::vec2, 3>& uvs, int width, int height) {
    TexelTriangle triangle;
    const glm::dvec2 size(width, height);
    for (std::size_t k = 0; k < 3; ++k) triangle.t[k] = glm::dvec2(uvs[k]) * size - 0.5;
    triangle.low = glm::min(triangle.t[0], glm::min(triangle.t[1], triangle.t[2]));
    triangle.high = glm::max(triangle.t[0], glm::max(triangle.t[1], triangle.t[2]));
    const glm::dvec2 farthest = glm::max(glm::abs(triangle.low), glm::abs(triangle.high));
    triangle.reach = 1 + kGrowth + kGrowthPerTexel * std::max(farthest.x, farthest.y);
    return triangle;
}

bool is_told_apart(const TexelTriangle& triangle) {
    return triangle.reach < 1 + kGrowth + kGrowthPerTexel * kFarthest;
}

// Half planes of the sum, the triangle moved by -shift.
void set_half_planes(const TexelTriangle& triangle, glm::dvec2 shift, FootprintPiece& piece) {
    const auto& t = triangle.t;
    const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
    const double sign = area < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 from = t[k] - shift, edge = (t[(k + 1) % 3] - t[k]) * sign;
        piece.a[k] = -edge.y;
        piece.b[k] = edge.x;
        piece.c[k] =
            edge.y * from.x - edge.x * from.y + triangle.reach * (std::abs(edge.x) + std::abs(edge.y));
    }
}

// Texels within reach of [low, high] on one axis, clipped to [0, size).
void texel_span(double low, double high, double reach, int size, int& begin, int& end) {
    begin = static_cast<int>(std::clamp(std::ceil(low - reach), 0.0, static_cast<double>(size)));
    end = static_cast<int>(std::clamp(std::floor(high + reach) + 1, 0.0, static_cast<double>(size)));
}

// Under `clamp`, what hangs over a side of the map falls on its outermost row or column: the part of the
// triangle past `limit` (below it where `below`) on `axis` spans this much of the other axis. False when
// there is none.
bool overhang(const TexelTriangle& triangle, int axis, double limit, bool below, double& low, double& high) {
    low = std::numeric_limits<double>::max(), high = -low;
    const auto past = [&](const glm::dvec2& p) { return below ? p[axis] <= limit : p[axis] >= limit; };
    const auto include = [&](double value) { low = std::min(low, value), high = std::max(high, value); };
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 &p = triangle.t[k], &q = triangle.t[(k + 1) % 3];
        if (past(p)) include(p[1 - axis]);
        if (past(p) != past(q)) {
            const double s = (limit - p[axis]) / (q[axis] - p[axis]);
            include(p[1 - axis] + s * (q[1 - axis] - p[1 - axis]));
        }
    }
    return low <= high;
}

// As texel_span, but at least one texel: what lies outside is moved to the nearest border.
void clamped_span(double low, double high, double reach, int size, int& begin, int& end) {
    const double last = size - 1;
    begin = static_cast<int>(std::clamp(std::ceil(low - reach), 0.0, last));
    end = static_cast<int>(std::clamp(std::floor(high + reach), 0.0, last)) + 1;
}

std::size_t clamped_pieces(const TexelTriangle& triangle, int width, int height,
                           std::span<FootprintPiece> pieces) {
    std::size_t count = 0;
    FootprintPiece inside;
    texel_span(triangle.low.x, triangle.high.x, triangle.reach, width, inside.box.x0, inside.box.x1);
    texel_span(triangle.low.y, triangle.high.y, triangle.reach, height, inside.box.y0, inside.box.y1);
    if (inside.box.x0 < inside.box.x1 && inside.box.y0 < inside.box.y1) {
        set_half_planes(triangle, glm::dvec2(0), inside);
        pieces[count++] = inside;
    }
    const int size[2] = {width, height};
    for (int axis = 0; axis < 2; ++axis) {
        for (const bool below : {true, false}) {
            const int border = below ? 0 : size[axis] - 1;
            double low, high;
            const double limit = border + (below ? triangle.reach : -triangle.reach);
            const bool hangs_over = below ? triangle.low[axis] < border : triangle.high[axis] > border;
            if (!hangs_over || !overhang(triangle, axis, limit, below, low, high)) continue;
            FootprintPiece side;
            int begin, end;
            clamped_span(low, high, triangle.reach, size[1 - axis], begin, end);
            side.box = axis == 0 ? TexelBox{border, begin, border + 1, end}
                                 : TexelBox{begin, border, end, border + 1};
            pieces[count++] = side;
        }
    }
    return count;
}

}  // namespace

Cover FootprintPiece::cover(const TexelBox& other) const {
    if (other.x0 >= box.x1 || other.x1 <= box.x0 || other.y0 >= box.y1 || other.y1 <= box.y0)
        return Cover::none;
    bool all = other.x0 >= box.x0 && other.x1 <= box.x1 && other.y0 >= box.y0 && other.y1 <= box.y1;
    for (int k = 0; k < 3; ++k) {
        const double x0 = a[k] * other.x0, x1 = a[k] * (other.x1 - 1);
        const double y0 = b[k] * other.y0, y1 = b[k] * (other.y1 - 1);
        if (std::max(x0, x1) + std::max(y0, y1) + c[k] < 0) return Cover::none;
        all = all && std::min(x0, x1) + std::min(y0, y1) + c[k] >= 0;
    }
    return all ? Cover::all : Cover::some;
}

void FootprintPiece::row(int y, int& first, int& last) const {
    double low = box.x0, high = box.x1 - 1;
    for (int k = 0; k < 3; ++k) {
        const double rest = b[k] * y + c[k];
        if (a[k] > 0) {
            low = std::max(low, -rest / a[k]);
        } else if (a[k] < 0) {
            high = std::min(high, -rest / a[k]);
        } else if (rest < 0) {
            high = -1;
        }
    }
    // Rounded up and down without calls: both lie in [-1, 2^31 - 1] from here on.
    low = std::min(low, static_cast<double>(box.x1));
    high = std::max(high, -1.0);
    first = static_cast<int>(low);
    first += static_cast<double>(first) < low ? 1 : 0;
    last = static_cast<int>(high + 1);
}

std::size_t footprint_pieces(const std::array<glm::vec2, 3>& uvs, int width, int height, Wrap wrap,
                             std::span<FootprintPiece, kMostFootprintPieces> pieces) {
    const FootprintPiece whole{{0, 0, width, height}};
    const TexelTriangle triangle = texel_triangle(uvs, width, height);
    if (!is_told_apart(triangle)) {
        pieces[0] = whole;
        return 1;
    }
    if (wrap == Wrap::clamp) return clamped_pieces(triangle, width, height, pieces);

    // One copy of the triangle for each map period that its bounding box meets.
    const glm::dvec2 size(width, height);
    const glm::dvec2 first = glm::floor(glm::ceil(triangle.low - triangle.reach) / size);
    const glm::dvec2 last = glm::floor(glm::floor(triangle.high + triangle.reach) / size);
    if ((last.x - first.x + 1) * (last.y - first.y + 1) > static_cast<double>(kMostFootprintPieces)) {
        pieces[0] = whole;
        return 1;
    }
    std::size_t count = 0;
    for (double y = first.y; y <= last.y; ++y) {
        for (double x = first.x; x <= last.x; ++x) {
            const glm::dvec2 shift = glm::dvec2(x, y) * size;
            FootprintPiece piece;
            const glm::dvec2 low = triangle.low - shift, high = triangle.high - shift;
            texel_span(low.x, high.x, triangle.reach, width, piece.box.x0, piece.box.x1);
            texel_span(low.y, high.y, triangle.reach, height, piece.box.y0, piece.box.y1);
            set_half_planes(triangle, shift, piece);
            if (piece.cover(piece.box) != Cover::none) pieces[count++] = piece;
        }
    }
    return count;
}

std::optional<UnwrappedFootprint> unwrapped_footprint(const std::array<glm::vec2, 3>& uvs, int width, int height) {
    const TexelTriangle triangle = texel_triangle(uvs, width, height);
    if (!is_told_apart(triangle)) return std::nullopt;
    const glm::dvec2 first = glm::ceil(triangle.low - triangle.reach), last = glm::floor(triangle.high + triangle.reach);
    UnwrappedFootprint footprint;
    footprint.x = static_cast<int>(first.x);
    footprint.y = static_cast<int>(first.y);
    footprint.piece.box = {0, 0, static_cast<int>(last.x - first.x) + 1, static_cast<int>(last.y - first.y) + 1};
    set_half_planes(triangle, first, footprint.piece);
    TexelTriangle bare = triangle;
    bare.reach = 0;
    footprint.inside.box = footprint.piece.box;
    set_half_planes(bare, first, footprint.inside);
    for (std::size_t i = 0; i < 3; ++i) footprint.corners[i] = triangle.t[i] - first;
    return footprint;
}

}  // namespace relievo
