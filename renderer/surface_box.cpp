// See surface_box.h. Along each axis S is a position linear in the map, plus height times a normal linear in it (and a part
// that |N| leaves): g = p + h q. Over a cell that is bilinear but for what q changes there, which is added to the bounds.
#include "renderer/surface_box.h"

#include <cmath>

#include "renderer/surface_hull.h"

namespace relievo {
namespace {

struct Along {
    MapLinear p, q;  // q: a count of height
    double at(double x, double y, double height) const { return p.at(x, y) + height * q.at(x, y); }
};

// Axes side by side, so that one does not wait for the other.
void include(const std::array<Along, 3>& axes, double x, double y, double height, std::array<Span, 3>& spans) {
    for (std::size_t k = 0; k < 3; ++k) spans[k].include(axes[k].at(x, y, height));
}

std::array<Span, 3> spans_of(const std::array<Along, 3>& axes, const std::vector<HeightSample>& samples) {
    std::array<Span, 3> spans;
    for (const HeightSample& s : samples) {
        include(axes, s.x, s.y, s.low, spans);
        if (s.low == s.high && s.wide == 0 && s.tall == 0) continue;
        include(axes, s.x, s.y, s.high, spans);
        for (const double height : {s.low, s.high}) {
            include(axes, s.x + s.wide, s.y, height, spans);
            include(axes, s.x, s.y + s.tall, height, spans);
            include(axes, s.x + s.wide, s.y + s.tall, height, spans);
        }
    }
    return spans;
}

}  // namespace

std::optional<Box> map_surface_box(const gpu::Primitive& p, const gpu::PrimitiveNormals& n, const FootprintHeights& heights,
                                   double amplitude, double midlevel) {
    const UnitNormal unit = unit_normal(n);
    const std::array<glm::dvec3, 3> corners = corners_of(p), normals{n.n0, n.n1, n.n2};
    const double count = amplitude / 65535 * unit.scale, zero = -amplitude * midlevel * unit.scale;
    Span counts;
    for (const HeightSample& s : heights.samples) {
        counts.include(s.low);
        counts.include(s.high);
    }
    const double most = std::abs(amplitude) *
                        std::max(std::abs(counts.low / 65535 - midlevel), std::abs(counts.high / 65535 - midlevel));
    std::array<Along, 3> axes;
    for (int k = 0; k < 3; ++k) {
        std::array<double, 3> position, normal;
        for (std::size_t i = 0; i < 3; ++i) {
            position[i] = corners[i][k] + zero * normals[i][k];
            normal[i] = count * normals[i][k];
        }
        Along& axis = axes[static_cast<std::size_t>(k)];
        axis = {linear_through(position, heights.corners), linear_through(normal, heights.corners)};
        if (!std::isfinite(axis.p.steepness()) || !std::isfinite(axis.q.steepness())) return std::nullopt;
    }
    const std::array<Span, 3> spans = spans_of(axes, heights.samples);
    Box box;
    for (int k = 0; k < 3; ++k) {
        const Along& axis = axes[static_cast<std::size_t>(k)];
        const Span& span = spans[static_cast<std::size_t>(k)];
        // |N| varies; q changes within a cell; and places are rounded.
        const double beyond = most * unit.off + 1.5 * (counts.high - counts.low) * axis.q.steepness() +
                              FootprintHeights::kPlaces * (axis.p.steepness() + 65535 * axis.q.steepness());
        box.low[k] = static_cast<float>(span.low - beyond);
        box.high[k] = static_cast<float>(span.high + beyond);
    }
    return with_rounding(box);
}

}  // namespace relievo
