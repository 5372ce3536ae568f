// MeshSurface's texels in a ball. Faces near the ball come from the tree; each one's footprint is walked row
// by row, and of a row only the columns whose point can be in the ball: the base point moves linearly along a
// row, and displacement moves it sideways by at most the height times the sine of the normals' spread, so
// that the columns solve one quadratic. Runs of columns are sorted before they are evaluated, so that the
// texels come out in order.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <tuple>

#include "editor/session/surface/curved_base.h"
#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/texel_triangle.h"

namespace relievo {
namespace {

// A linear function of texel space: value + dx * (x - x0) + dy * (y - y0).
struct Gradient {
    glm::dvec3 value, dx, dy;

    glm::dvec3 at(double x, double y) const { return value + dx * x + dy * y; }
};

Gradient gradient(const TexelTriangle& t, const std::array<glm::dvec3, 3>& v, glm::dvec2 origin) {
    const double scale = 1 / t.doubled_area();
    const glm::dvec2 e1 = t.p[1] - t.p[0], e2 = t.p[2] - t.p[0];
    const glm::dvec3 d1 = v[1] - v[0], d2 = v[2] - v[0];
    const glm::dvec3 dx = (d1 * e2.y - d2 * e1.y) * scale, dy = (d2 * e1.x - d1 * e2.x) * scale;
    const glm::dvec2 back = origin - t.p[0];
    return {v[0] + dx * back.x + dy * back.y, dx, dy};
}

// A square function of texel space, as Gradient.
struct Square {
    double value, dx, dy, dxx, dxy, dyy;

    double at(double x, double y) const { return value + x * (dx + x * dxx + y * dxy) + y * (dy + y * dyy); }
    double slope_x(double x, double y) const { return dx + 2 * x * dxx + y * dxy; }
};

Square square(const Bulge& bulge, const Gradient& b) {
    return {bulge.at(b.value), bulge.mixed(b.value, b.dx), bulge.mixed(b.value, b.dy),
            bulge.at(b.dx),    bulge.mixed(b.dx, b.dy),    bulge.at(b.dy)};
}

struct NearFace {
    std::uint32_t face;
    std::int64_t x0, y0;        // the integer point that the gradients start at
    Gradient position, normal;  // of the base triangle, per texel
    Square bulge;
};

// Texels of one face in one row of the map, side by side.
struct Run {
    std::int32_t y, x;  // of the map
    std::int32_t count;
    std::uint32_t slot;        // of NearFace
    std::int64_t column, row;  // before the wrap

    bool operator<(const Run& r) const {
        return std::tie(y, x, slot, column, row) < std::tie(r.y, r.x, r.slot, r.column, r.row);
    }
};

bool before(const SurfaceTexel& a, const SurfaceTexel& b) {
    return std::tie(a.y, a.x, a.distance) < std::tie(b.y, b.x, b.distance);
}

}  // namespace

class BallQuery {
  public:
    BallQuery(const MeshSurface& surface, glm::vec3 centre, float radius, bool precise)
        : s_(surface), centre_(centre), radius_(radius), precise_(precise) {
        const double a = static_cast<double>(s_.amplitude_), middle = a * static_cast<double>(s_.midlevel_);
        lowest_ = std::min(-middle, a - middle);
        highest_ = std::max(-middle, a - middle);
        reach_ = std::max(std::abs(lowest_), std::abs(highest_));
    }

    void run(std::vector<SurfaceTexel>& out) {
        find_runs();
        out.reserve(most_texels());
        for (std::size_t i = 0; i < runs_.size();) i = evaluate_row(i, out);
    }

    void run(const Surface::TexelVisitor& visit) {
        constexpr std::size_t kPart = 65536;  // texels, and up to a row more
        find_runs();
        std::vector<SurfaceTexel> part;
        part.reserve(std::min(most_texels(), kPart));
        for (std::size_t i = 0; i < runs_.size();) {
            i = evaluate_row(i, part);
            if (part.size() < kPart && i < runs_.size()) continue;
            visit(part);
            part.clear();
        }
    }

  private:
    using Texels = std::vector<SurfaceTexel>::iterator;

    void find_runs() {
        std::vector<std::uint32_t> faces;
        s_.tree_.near(centre_, static_cast<float>((static_cast<double>(radius_) + reach_) * 1.00001), faces);
        std::sort(faces.begin(), faces.end());
        for (const std::uint32_t face : faces) add_face(face);
        std::sort(runs_.begin(), runs_.end());
    }

    std::size_t most_texels() const {
        std::size_t texels = 0;
        for (const Run& r : runs_) texels += static_cast<std::size_t>(r.count);
        return texels;
    }

    bool out_of_slab(std::uint32_t face, const std::array<glm::dvec3, 3>& p) const {
        const MeshSurface::NormalCone& cone = s_.cones_[face];
        if (cone.cosine <= 0) return false;
        const glm::dvec3 axis(cone.axis), c(centre_);
        const double a = glm::dot(axis, p[0] - c), b = glm::dot(axis, p[1] - c), d = glm::dot(axis, p[2] - c);
        const auto [low, high] = std::minmax({a, b, d});
        const double cosine = static_cast<double>(cone.cosine), r = static_cast<double>(radius_);
        const double sink = std::min(lowest_, lowest_ * cosine), rise = std::max(highest_, highest_ * cosine);
        const double slack = 1e-5 * (r + reach_ + std::abs(low) + std::abs(high));
        return low + sink > r + slack || high + rise < -r - slack;
    }

    void add_face(std::uint32_t face) {
        const TexelTriangle triangle = texel_triangle(s_.mesh_, face, s_.grid_);
        if (!can_rasterise(triangle, s_.grid_)) return;
        std::array<glm::dvec3, 3> p, n;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = glm::dvec3(s_.mesh_.positions[s_.mesh_.faces[face].position[i]]);
            n[i] = glm::dvec3(s_.mesh_.normals[s_.mesh_.faces[face].position[i]]);
        }
        if (out_of_slab(face, p)) return;
        const auto x0 = static_cast<std::int64_t>(std::floor(triangle.p[0].x));
        const auto y0 = static_cast<std::int64_t>(std::floor(triangle.p[0].y));
        const glm::dvec2 origin(static_cast<double>(x0), static_cast<double>(y0));
        constexpr std::array kCorners{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
        const NearFace near{face,
                            x0,
                            y0,
                            gradient(triangle, p, origin),
                            gradient(triangle, n, origin),
                            square(Bulge(p, n), gradient(triangle, kCorners, origin))};
        const auto slot = static_cast<std::uint32_t>(faces_.size());
        const std::size_t runs_before = runs_.size();
        const TexelSpan rows = rows_in_reach(near, clipped(triangle.rows(), s_.grid_.height, s_.grid_.wrap));
        for (std::int64_t y = rows.first; y <= rows.last; ++y) {
            const std::optional<TexelSpan> reached = columns_in_reach(near, y);
            if (!reached) continue;
            TexelSpan span = clipped(triangle.columns(y), s_.grid_.width, s_.grid_.wrap);
            span = {std::max(span.first, reached->first), std::min(span.last, reached->last)};
            if (span.first <= span.last) add_runs(slot, y, span);
        }
        if (runs_.size() > runs_before) faces_.push_back(near);
    }

    // A row of a face's footprint: its base points from the ball's centre on, along the row; seen along the
    // face's cone, which normals lean from by at most its spread, where it has an axis.
    struct RowLine {
        glm::dvec3 start, step;
        double reach;  // of the ball about such a base point: beyond, displacement cannot bring it in
    };
    RowLine row_line(const NearFace& near, std::int64_t y) const {
        const MeshSurface::NormalCone& cone = s_.cones_[near.face];
        const glm::dvec3 axis(cone.axis);
        RowLine line{near.position.at(0, static_cast<double>(y - near.y0)) - glm::dvec3(centre_),
                     near.position.dx, 0};
        line.reach = static_cast<double>(radius_) + reach_ * static_cast<double>(cone.spread) +
                     1e-5 * (reach_ + glm::length(line.start));
        if (cone.cosine > 0) {
            line.start -= axis * glm::dot(axis, line.start);
            line.step -= axis * glm::dot(axis, line.step);
        }
        return line;
    }

    // Those of `rows` that come near enough anywhere: where q(y) = min over x |start(y) + x step|^2 is at
    // most reach^2. `start` moves linearly with y, so that q is a square function of it.
    TexelSpan rows_in_reach(const NearFace& near, TexelSpan rows) const {
        if (rows.last - rows.first < 4) return rows;
        const RowLine first = row_line(near, rows.first), last = row_line(near, rows.last);
        const glm::dvec3 s = first.start, dx = first.step,
                         dy = (last.start - s) / static_cast<double>(rows.last - rows.first);
        const double reach = std::max(first.reach, last.reach), a = glm::dot(dx, dx);
        const double p = a * glm::dot(dy, dy) - glm::dot(dx, dy) * glm::dot(dx, dy),
                     q = a * glm::dot(s, dy) - glm::dot(s, dx) * glm::dot(dx, dy),
                     r = a * (glm::dot(s, s) - reach * reach) - glm::dot(s, dx) * glm::dot(s, dx);
        const double root = q * q - p * r;
        // Seen edge-on, degenerate, or too large for squares.
        if (!(p > 1e-8 * a * glm::dot(dy, dy)) || !std::isfinite(root)) return rows;
        const double middle = -q / p, half = std::sqrt(std::max(0.0, root)) / p;
        const auto count = static_cast<double>(rows.last - rows.first);
        const auto row = [&](double y) {
            return rows.first + static_cast<std::int64_t>(std::clamp(y, -1.0, count + 1));
        };
        return {std::max(rows.first, row(std::floor(middle - half) - 1)),
                std::min(rows.last, row(std::ceil(middle + half) + 1))};
    }

    // The columns of a row whose base point is near enough.
    std::optional<TexelSpan> columns_in_reach(const NearFace& near, std::int64_t y) const {
        const auto [start, step, reach] = row_line(near, y);
        const double a = glm::dot(step, step), b = glm::dot(start, step),
                     c = glm::dot(start, start) - reach * reach;
        const double root = b * b - a * c;
        constexpr double kFar = 1e15;
        if (!(a > 0)) return c > 0 ? std::nullopt : std::optional(TexelSpan{-(1LL << 60), 1LL << 60});
        if (root < 0) return std::nullopt;
        const double low = std::clamp((-b - std::sqrt(root)) / a, -kFar, kFar);
        const double high = std::clamp((-b + std::sqrt(root)) / a, -kFar, kFar);
        return TexelSpan{near.x0 + static_cast<std::int64_t>(std::floor(low)),
                         near.x0 + static_cast<std::int64_t>(std::ceil(high))};
    }

    void add_runs(std::uint32_t slot, std::int64_t row, TexelSpan span) {
        const std::int64_t width = s_.grid_.width;
        const auto y = static_cast<std::int32_t>(MapGrid::wrapped(row, s_.grid_.height));
        while (span.first <= span.last) {
            const std::int64_t x = MapGrid::wrapped(span.first, width);
            const std::int64_t count = std::min(span.last - span.first + 1, width - x);
            runs_.push_back(
                {y, static_cast<std::int32_t>(x), static_cast<std::int32_t>(count), slot, span.first, row});
            span.first += count;
        }
    }

    // Evaluates the runs of one row of the map, from run `first` on; returns the next row's first run.
    std::size_t evaluate_row(std::size_t first, std::vector<SurfaceTexel>& out) const {
        const auto begin = static_cast<std::ptrdiff_t>(out.size());
        const std::int32_t y = runs_[first].y;
        std::int32_t end_x = -1;
        bool overlap = false;
        std::size_t i = first;
        for (; i < runs_.size() && runs_[i].y == y; ++i) {
            const Run& run = runs_[i];
            const auto own = static_cast<std::ptrdiff_t>(out.size());
            evaluate(run, out);
            if (run.x < end_x) {
                overlap = true;
                merge_run(out.begin() + begin, out.begin() + own, out.end(), run.x, end_x);
            }
            end_x = std::max(end_x, run.x + run.count);
        }
        if (overlap) {  // a texel centre on a shared edge, or footprints that overlap: the nearest point stays
            const auto same = [](const SurfaceTexel& a, const SurfaceTexel& b) { return a.x == b.x; };
            out.erase(std::unique(out.begin() + begin, out.end(), same), out.end());
        }
        return i;
    }

    // A row's texels [row, run) in order and those of a run behind them, [run, end): only the columns [x, end_x) are in
    // both, most often one texel on the edge between two faces.
    static void merge_run(Texels row, Texels run, Texels end, std::int32_t x, std::int32_t end_x) {
        const auto left_of = [](const SurfaceTexel& texel, std::int32_t column) { return texel.x < column; };
        std::inplace_merge(std::lower_bound(row, run, x, left_of), run, std::lower_bound(run, end, end_x, left_of), before);
    }

    // In blocks: the points of a block first, in loops that a compiler turns into vector instructions.
    void evaluate(const Run& run, std::vector<SurfaceTexel>& out) const {
        if (precise_) return evaluate_precisely(run, out);
        const NearFace& near = faces_[run.slot];
        const auto x = static_cast<double>(run.column - near.x0), y = static_cast<double>(run.row - near.y0);
        const glm::vec3 p0(near.position.at(x, y)), dp(near.position.dx), n0(near.normal.at(x, y)),
            dn(near.normal.dx);
        const auto b0 = static_cast<float>(near.bulge.at(x, y)),
                   b1 = static_cast<float>(near.bulge.slope_x(x, y)), b2 = static_cast<float>(near.bulge.dxx);
        const std::uint16_t* counts = &s_.map_.texels()[s_.map_.index(run.x, run.y)];
        const float limit = radius_ * radius_;
        Block block;
        for (std::int32_t first = 0; first < run.count; first += kBlock) {
            const std::int32_t count = std::min(kBlock, run.count - first);
            fill(block, {p0, dp}, {n0, dn}, first, count, counts, near.face);
            for (std::int32_t k = 0; k < count; ++k) {
                const auto i = static_cast<std::size_t>(k);
                if (!(block.distance[i] < limit)) continue;
                const auto step = static_cast<float>(first + k);
                out.push_back({run.x + first + k,
                               run.y,
                               std::sqrt(block.distance[i]),
                               {block.px[i], block.py[i], block.pz[i]},
                               {block.nx[i], block.ny[i], block.nz[i]},
                               b0 + step * (b1 + step * b2)});
            }
        }
    }

    void evaluate_precisely(const Run& run, std::vector<SurfaceTexel>& out) const {
        const NearFace& near = faces_[run.slot];
        const double y = static_cast<double>(run.row - near.y0);
        const double scale = static_cast<double>(s_.amplitude_) / 65535.0,
                     middle = static_cast<double>(s_.amplitude_) * static_cast<double>(s_.midlevel_);
        for (std::int32_t k = 0; k < run.count; ++k) {
            const double x = static_cast<double>(run.column + k - near.x0);
            const glm::dvec3 sum = near.normal.at(x, y);
            const double length = glm::length(sum);
            const glm::dvec3 n = length > 1e-6 ? sum / length : glm::dvec3(s_.fallback_normal(near.face));
            const double height = scale * static_cast<double>(s_.map_.at(run.x + k, run.y)) - middle;
            const glm::vec3 position(near.position.at(x, y) + height * n);
            const float distance = glm::length(position - centre_);
            if (distance >= radius_) continue;
            const auto bulge = static_cast<float>(near.bulge.at(x, y));
            out.push_back({run.x + k, run.y, distance, position, glm::vec3(n), bulge});
        }
    }

    static constexpr std::int32_t kBlock = 32;
    struct Block {
        std::array<float, kBlock> px, py, pz, nx, ny, nz, distance;  // squared
    };
    struct Line {
        glm::vec3 start, step;
    };

    void fill(Block& block, const Line& position, const Line& normal, std::int32_t first, std::int32_t count,
              const std::uint16_t* counts, std::uint32_t face) const {
        const float scale = s_.amplitude_ / 65535.0f, middle = s_.amplitude_ * s_.midlevel_;
        float least = 1;
        for (std::int32_t k = 0; k < count; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const auto step = static_cast<float>(first + k);
            const float nx = normal.start.x + step * normal.step.x,
                        ny = normal.start.y + step * normal.step.y,
                        nz = normal.start.z + step * normal.step.z;
            const float square = nx * nx + ny * ny + nz * nz;
            least = square < least ? square : least;
            const float unit = 1 / std::sqrt(square);
            block.nx[i] = nx * unit, block.ny[i] = ny * unit, block.nz[i] = nz * unit;
        }
        if (!(least > 1e-12f)) mend_normals(block, normal, first, count, face);
        for (std::int32_t k = 0; k < count; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const auto step = static_cast<float>(first + k);
            const float height = scale * static_cast<float>(counts[first + k]) - middle;
            block.px[i] = position.start.x + step * position.step.x + height * block.nx[i];
            block.py[i] = position.start.y + step * position.step.y + height * block.ny[i];
            block.pz[i] = position.start.z + step * position.step.z + height * block.nz[i];
            const float ax = block.px[i] - centre_.x, ay = block.py[i] - centre_.y,
                        az = block.pz[i] - centre_.z;
            block.distance[i] = ax * ax + ay * ay + az * az;
        }
    }

    // Where the corners' normals cancel, none is left to interpolate.
    void mend_normals(Block& block, const Line& normal, std::int32_t first, std::int32_t count,
                      std::uint32_t face) const {
        const glm::vec3 fallback = s_.fallback_normal(face);
        for (std::int32_t k = 0; k < count; ++k) {
            const glm::vec3 n = normal.start + static_cast<float>(first + k) * normal.step;
            if (glm::dot(n, n) > 1e-12f) continue;
            const auto i = static_cast<std::size_t>(k);
            block.nx[i] = fallback.x, block.ny[i] = fallback.y, block.nz[i] = fallback.z;
        }
    }

    const MeshSurface& s_;
    glm::vec3 centre_;
    float radius_;
    bool precise_;
    double lowest_, highest_, reach_;  // of the displacement, world units
    std::vector<NearFace> faces_;
    std::vector<Run> runs_;
};

namespace {

bool is_ball(glm::vec3 centre, float radius) {
    return std::isfinite(centre.x + centre.y + centre.z) && std::isfinite(radius) && radius > 0;
}

}  // namespace

void MeshSurface::texels_in_ball(glm::vec3 centre, float radius, std::vector<SurfaceTexel>& out) const {
    out.clear();
    if (is_ball(centre, radius)) BallQuery(*this, centre, radius, false).run(out);
}

void MeshSurface::precise_texels_in_ball(glm::vec3 centre, float radius,
                                         std::vector<SurfaceTexel>& out) const {
    out.clear();
    if (is_ball(centre, radius)) BallQuery(*this, centre, radius, true).run(out);
}

void MeshSurface::visit_ball(glm::vec3 centre, float radius, const TexelVisitor& visit) const {
    if (is_ball(centre, radius)) BallQuery(*this, centre, radius, false).run(visit);
}

void MeshSurface::visit_ball_precisely(glm::vec3 centre, float radius, const TexelVisitor& visit) const {
    if (is_ball(centre, radius)) BallQuery(*this, centre, radius, true).run(visit);
}

}  // namespace relievo
