// Brute-force answers of a flat surface: what the brushes are tested against.
#include "chart_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace relievo {

glm::dvec2 Chart::texel_of(glm::dvec2 point) const {
    return origin + (point.x - low.x) * along_x + (point.y - low.y) * along_y;
}

glm::dvec2 Chart::point_of(glm::dvec2 texel) const {
    const glm::dvec2 d = texel - origin;
    const double determinant = along_x.x * along_y.y - along_x.y * along_y.x;
    return low +
           glm::dvec2(d.x * along_y.y - d.y * along_y.x, along_x.x * d.y - along_x.y * d.x) / determinant;
}

bool Chart::holds(glm::dvec2 p) const {
    constexpr double kMargin = 1e-9;
    return p.x >= low.x - kMargin && p.y >= low.y - kMargin && p.x <= high.x + kMargin &&
           p.y <= high.y + kMargin;
}

SurfacePoint ChartSurface::at(std::uint32_t face, float b1, float b2) const {
    const Chart& chart = charts_.at(face / 2);
    const glm::dvec2 size = chart.high - chart.low;
    // Even faces: corners (0, 0), (1, 0), (1, 1). Odd ones: (0, 0), (0, 1), (1, 1).
    const double sum = double{b1} + double{b2};
    const double u = face % 2 == 0 ? sum : double{b2}, v = face % 2 == 0 ? double{b2} : sum;
    const glm::dvec2 point = chart.low + glm::dvec2(u, v) * size;
    return {{point.x, point.y, height(counts(face / 2, point))}, {0, 0, 1}, {point.x, point.y, 0}, {0, 0, 1}};
}

void ChartSurface::texels_in_ball(glm::vec3 centre, float radius, std::vector<SurfaceTexel>& out) const {
    out.clear();
    if (!(radius > 0.0f) || !std::isfinite(radius)) return;
    for (const Chart& chart : charts_) {
        glm::dvec2 low(1e30), high(-1e30);  // texel bounds of the ball's square within the chart
        for (int corner = 0; corner < 4; ++corner) {
            const glm::dvec2 side(corner & 1 ? radius : -radius, corner & 2 ? radius : -radius);
            const glm::dvec2 texel =
                chart.texel_of(glm::clamp(glm::dvec2(centre.x, centre.y) + side, chart.low, chart.high));
            low = glm::min(low, texel), high = glm::max(high, texel);
        }
        for (int y = std::max(0, int(low.y) - 1); y <= std::min(map_.height() - 1, int(high.y) + 1); ++y)
            for (int x = std::max(0, int(low.x) - 1); x <= std::min(map_.width() - 1, int(high.x) + 1); ++x) {
                const glm::dvec2 point = chart.point_of({x + 0.5, y + 0.5});
                if (!chart.holds(point)) continue;
                const glm::vec3 position(point.x, point.y, height(map_.at(x, y)));
                const float distance = glm::length(position - centre);
                if (distance < radius) out.push_back({x, y, distance, position, {0, 0, 1}, 0});
            }
    }
    std::sort(out.begin(), out.end(), [](const SurfaceTexel& a, const SurfaceTexel& b) {
        return a.y != b.y ? a.y < b.y : a.x < b.x;
    });
    out.erase(
        std::unique(out.begin(), out.end(),
                    [](const SurfaceTexel& a, const SurfaceTexel& b) { return a.x == b.x && a.y == b.y; }),
        out.end());
}

bool ChartSurface::owned(int x, int y) const {
    return std::any_of(charts_.begin(), charts_.end(), [&](const Chart& chart) {
        return chart.holds(chart.point_of({x + 0.5, y + 0.5}));
    });
}

Dab ChartSurface::dab(double x, double y, double pressure) const {
    for (std::size_t i = 0; i < charts_.size(); ++i) {
        const Chart& chart = charts_[i];
        if (!chart.holds({x, y})) continue;
        const double u = std::clamp((x - chart.low.x) / (chart.high.x - chart.low.x), 0.0, 1.0);
        const double v = std::clamp((y - chart.low.y) / (chart.high.y - chart.low.y), 0.0, 1.0);
        const double one = Dab::kBarycentricOne;
        Dab dab;
        dab.face = static_cast<std::uint32_t>(2 * i + (u >= v ? 0 : 1));
        dab.b1 = static_cast<std::uint32_t>(std::abs(u - v) * one);
        dab.b2 = static_cast<std::uint32_t>(std::min(u, v) * one);
        dab.pressure = static_cast<std::uint32_t>(std::lround(pressure * Dab::kPressureOne));
        return dab;
    }
    throw std::out_of_range("no chart at the dab");
}

namespace {

struct Taps {
    std::uint32_t texel[4];
    double weight[4];
};

Taps taps_at(const HeightMap& map, glm::dvec2 texel) {
    const double x = std::clamp(texel.x - 0.5, 0.0, map.width() - 1.0);
    const double y = std::clamp(texel.y - 0.5, 0.0, map.height() - 1.0);
    const int x0 = int(x), y0 = int(y), x1 = std::min(x0 + 1, map.width() - 1),
              y1 = std::min(y0 + 1, map.height() - 1);
    const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(map.index(i, j)); };
    const double fx = x - x0, fy = y - y0;
    return {{index(x0, y0), index(x1, y0), index(x0, y1), index(x1, y1)},
            {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}

}  // namespace

double ChartSurface::counts(std::size_t chart, glm::dvec2 point) const {
    const Taps taps = taps_at(map_, charts_[chart].texel_of(point));
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) sum += taps.weight[k] * map_.texels()[taps.texel[k]];
    return sum;
}

void ChartSurface::add_equations(std::size_t chart_a, std::size_t chart_b, glm::dvec2 from, glm::dvec2 to) {
    const double length =
        std::max(glm::length(charts_[chart_a].texel_of(to) - charts_[chart_a].texel_of(from)),
                 glm::length(charts_[chart_b].texel_of(to) - charts_[chart_b].texel_of(from)));
    const int count = static_cast<int>(std::ceil(6.0 * length));
    for (int i = 0; i <= count; ++i) {
        const glm::dvec2 point = from + (to - from) * (i / double(count));
        const Taps a = taps_at(map_, charts_[chart_a].texel_of(point));
        const Taps b = taps_at(map_, charts_[chart_b].texel_of(point));
        SeamEquation equation;
        for (int k = 0; k < 4; ++k) {
            equation.texel[k] = a.texel[k], equation.weight[k] = static_cast<float>(a.weight[k]);
            equation.texel[k + 4] = b.texel[k], equation.weight[k + 4] = static_cast<float>(-b.weight[k]);
        }
        table.equations.push_back(equation);
    }
}

double ChartSurface::gap(std::size_t chart_a, std::size_t chart_b, glm::dvec2 from, glm::dvec2 to) const {
    constexpr int kSamples = 4000;
    double largest = 0.0;
    for (int i = 0; i <= kSamples; ++i) {
        const glm::dvec2 point = from + (to - from) * (i / double(kSamples));
        largest = std::max(largest, std::abs(counts(chart_a, point) - counts(chart_b, point)));
    }
    return largest;
}

Chart unit_chart(const HeightMap& map) {
    return {{0, 0}, {1, 1}, {0, 0}, {map.width(), 0}, {0, map.height()}};
}

std::shared_ptr<const Alpha> sloping_alpha() {
    return std::make_shared<const Alpha>("slope", 2, 2, std::vector<float>{0.25f, 1.0f, 0.5f, 0.75f});
}

std::vector<FacePoint> sources_of(const Brush& brush, const ChartSurface& surface, glm::dvec2 at) {
    if (brush.tool != Tool::clone) return {};
    const Dab dab = surface.dab(std::min(at.x + 0.3, 1.0), std::max(at.y - 0.1, 0.0));
    return {{dab.face, dab.b1, dab.b2}};
}

void drag(Sculptor& sculptor, const ChartSurface& surface, const Brush& brush, glm::dvec2 from,
          glm::dvec2 to) {
    const double step = double{brush.radius} * double{brush.spacing};
    const int count = std::max(1, static_cast<int>(std::lround(glm::length(to - from) / step)));
    for (int i = 0; i <= count; ++i) {
        const glm::dvec2 point = from + (to - from) * (i / double(count));
        sculptor.dab(surface.dab(point.x, point.y), {}, sources_of(brush, surface, point));
    }
}

void stroke(Sculptor& sculptor, const ChartSurface& surface, const Brush& brush, glm::dvec2 from,
            glm::dvec2 to) {
    sculptor.begin(brush, sloping_alpha());
    drag(sculptor, surface, brush, from, to);
    sculptor.end();
}

void tap(Sculptor& sculptor, const ChartSurface& surface, const Brush& brush, glm::dvec2 at) {
    sculptor.begin(brush, sloping_alpha());
    sculptor.dab(surface.dab(at.x, at.y), {}, sources_of(brush, surface, at));
    sculptor.end();
}

void fill(HeightMap& map, const std::function<double(int x, int y)>& count) {
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x)
            map.set(x, y, static_cast<std::uint16_t>(std::lround(std::clamp(count(x, y), 0.0, 65535.0))));
}

}  // namespace relievo
