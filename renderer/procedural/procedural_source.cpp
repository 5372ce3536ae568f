// See procedural_source.h.
#include "renderer/procedural/procedural_source.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

#include "renderer/procedural/evaluate.h"
#include "renderer/procedural/gaussian.h"
#include "renderer/scene/cross2.h"

namespace relievo {
namespace {

using glm::dvec2;
using glm::ivec2;

constexpr double kMostTexels = 0x1p22;  // shaders keep them as floats, and their fractions apart
constexpr int kPiecesASide = 8;  // of a triangle's bounding rectangle, for its bounds
// Lattice coordinates, in single precision, tell places of a triangle apart down to this width, a thousandth of the finest
// part of the coarsest range, and up to this many times as long.
constexpr double kLeastWidth = 1e-3 / 8, kMostAspect = 4096;

glm::uvec2 fixed_point(double value) {
    const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::llround(value * 0x1p32)));
    return {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)};
}

// Thesis equations 4.6 and 4.7, with a row of the matrix for each lattice vector: of the triangle size times
// (1/2, sqrt(3)/2) and (1, 0). Texels stand at (texel + 1/2) / size.
gpu::ProceduralData make_data(const Procedural& p, int width, int height) {
    const double up = 2 / (std::numbers::sqrt3 * p.triangle_size * height),
                 across = 1 / (p.triangle_size * width);
    gpu::ProceduralData data{};
    data.start_x = fixed_point(0.5 * up);
    data.start_y = fixed_point(0.5 * across - 0.25 * up);
    data.step_xy = fixed_point(up);
    data.step_yx = fixed_point(across);
    data.step_yy = fixed_point(-0.5 * up);
    const dvec2 scale = 1.0 / (p.scale * dvec2(width, height));
    data.uv_scale = glm::vec2(scale);
    data.uv_start = glm::vec2(0.5 - p.offset / p.scale);
    data.seed = p.seed;
    data.used = gpu::kHeightsOfLattice;
    return data;
}

// Twice the signed area, over which of the triangle's sides a rectangle may lie wholly.
bool touches(const std::array<dvec2, 3>& t, const dvec2& low, const dvec2& high) {
    const dvec2 middle = 0.5 * (low + high), half = 0.5 * (high - low);
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec2 a = t[i], edge = t[(i + 1) % 3] - a, opposite = t[(i + 2) % 3] - a;
        const dvec2 across(-edge.y, edge.x);
        const double inside = across.x * opposite.x + across.y * opposite.y;
        const double at = across.x * (middle.x - a.x) + across.y * (middle.y - a.y);
        const double reach = std::abs(across.x) * half.x + std::abs(across.y) * half.y;
        if (inside >= 0 ? at + reach < 0 && inside > 0 : at - reach > 0) return false;
    }
    return true;
}

}  // namespace

struct ProceduralSource::State {
    Procedural settings;
    std::vector<std::uint16_t> gaussianised;
    std::vector<std::uint32_t> inverse;
    std::unique_ptr<ExemplarBounds> bounds;
    ExemplarView view;

    void make_tables(const std::uint16_t* exemplar, std::size_t count);
};

// T by rank (texels of one value share its middle rank) and T^-1 as the value at each rank: thesis
// equations 4.3 and 4.4.
void ProceduralSource::State::make_tables(const std::uint16_t* exemplar, std::size_t count) {
    std::vector<std::size_t> below(65537);  // texels under each value
    for (std::size_t i = 0; i < count; ++i) ++below[exemplar[i] + std::size_t{1}];
    for (std::size_t v = 0; v < 65536; ++v) below[v + 1] += below[v];
    const auto all = static_cast<double>(count);
    std::vector<std::uint16_t> forward(65536);
    for (std::size_t v = 0; v < 65536; ++v) {
        if (below[v + 1] == below[v]) continue;
        const double share = 0.5 * static_cast<double>(below[v] + below[v + 1]) / all;
        forward[v] = static_cast<std::uint16_t>(std::lround(gaussian_value(share) * 65535));
    }
    gaussianised.resize(count);
    for (std::size_t i = 0; i < count; ++i) gaussianised[i] = forward[exemplar[i]];
    inverse.resize(gpu::kInverseSize);
    std::uint32_t next = 0;
    for (std::size_t i = inverse.size(); i-- > 0;) {
        const double share = gaussian_share(static_cast<double>(i) / (gpu::kInverseSize - 1));
        const auto rank = std::min(static_cast<std::size_t>(share * all), count - 1);
        const auto value = static_cast<std::uint32_t>(std::upper_bound(below.begin(), below.end(), rank) -
                                                      below.begin() - 1);
        inverse[i] = value | next << 16;
        next = value;
    }
}

ProceduralSource::ProceduralSource(const Procedural& settings, int width, int height,
                                   const std::uint16_t* exemplar)
    : state_(std::make_unique<State>()) {
    if (exemplar == nullptr || width < 1 || height < 1)
        throw std::invalid_argument("a procedural source needs an exemplar of at least one texel");
    State& s = *state_;
    s.settings = settings;
    s.make_tables(exemplar, static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    s.bounds = std::make_unique<ExemplarBounds>(width, height, s.gaussianised.data());
    s.view = {make_data(settings, width, height),
              width,
              height,
              s.gaussianised.data(),
              s.inverse.data(),
              s.bounds.get()};
    // Thesis equations 5.1 and 5.2 (their errata in DESIGN.md section 1), with the soft clipping.
    const ExemplarBounds::Range all = s.bounds->range(0, 0, width, height);
    const double least = 1 / std::numbers::sqrt3;
    const auto extreme = [&](double g, double w) {
        return static_cast<float>(procedural_double::restored(s.view, procedural_double::soft_clip(g, w)));
    };
    const double low = all.low / 65535.0, high = all.high / 65535.0, slack = procedural_double::kBlendSlack;
    s.view.data.range = {extreme(low - slack, low < 0.5 ? least : 1),
                         extreme(high + slack, high > 0.5 ? least : 1)};
}

ProceduralSource::~ProceduralSource() = default;
ProceduralSource::ProceduralSource(ProceduralSource&&) noexcept = default;
ProceduralSource& ProceduralSource::operator=(ProceduralSource&&) noexcept = default;

int ProceduralSource::width() const {
    return state_->view.width;
}
int ProceduralSource::height() const {
    return state_->view.height;
}
std::span<const std::uint16_t> ProceduralSource::gaussianised() const {
    return state_->gaussianised;
}
std::span<const std::uint32_t> ProceduralSource::inverse() const {
    return state_->inverse;
}
const gpu::ProceduralData& ProceduralSource::data() const {
    return state_->view.data;
}
const ExemplarView& ProceduralSource::view() const {
    return state_->view;
}

dvec2 ProceduralSource::texel_at(const dvec2& uv) const {
    const Procedural& p = state_->settings;
    return (p.offset + (uv - 0.5) * p.scale) * dvec2(width(), height()) - 0.5;
}

std::array<dvec2, 3> ProceduralSource::texels_at(const std::array<dvec2, 3>& uv) const {
    std::array<dvec2, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
        t[i] = texel_at(uv[i]);
        if (!(std::max(std::abs(t[i].x), std::abs(t[i].y)) < kMostTexels))
            throw std::invalid_argument(
                "texture coordinates times scale reach beyond 2^22 texels of the exemplar");
    }
    return t;
}

bool ProceduralSource::thin_over_lattice(const std::array<dvec2, 3>& uv) const {
    const gpu::ProceduralData& data = state_->view.data;
    using procedural_double::fixed_real;
    const dvec2 up(fixed_real(data.step_xy), fixed_real(data.step_yy)), across(0, fixed_real(data.step_yx));
    const std::array<dvec2, 3> t = texels_at(uv);
    const auto edge = [&](const dvec2& texels) { return across * texels.x + up * texels.y; };
    const dvec2 a = edge(t[1] - t[0]), b = edge(t[2] - t[0]);
    const double area = std::abs(cross2(a, b)),
                 longest = std::max({glm::length(a), glm::length(b), glm::length(b - a)});
    return !(area >= kLeastWidth * longest && area * kMostAspect >= longest * longest && longest > 0);
}

dvec2 ProceduralSource::uv_at(const dvec2& texel) const {
    const Procedural& p = state_->settings;
    return ((texel + 0.5) / dvec2(width(), height()) - p.offset) / p.scale + 0.5;
}

double ProceduralSource::texel(const ivec2& at) const {
    const gpu::ProceduralData& data = state_->view.data;
    glm::uvec2 x, y;
    procedural_double::lattice_coordinates(data, at, x, y);
    return procedural_double::texel_height(state_->view, data, procedural_double::lattice_place(x, y),
                                           wrapped_texel(state_->view, at));
}

double ProceduralSource::value(const dvec2& texel) const {
    const dvec2 cell = glm::floor(texel), f = texel - cell;
    const glm::dvec4 q = procedural_double::procedural_quad(state_->view, ivec2(cell));
    return glm::mix(glm::mix(q.x, q.y, f.x), glm::mix(q.z, q.w, f.x), f.y);
}

ProceduralSource::Range ProceduralSource::range(const ivec2& first, const ivec2& last) const {
    const dvec2 bounds = procedural_double::procedural_bounds(state_->view, first, last - first);
    return {bounds.x, bounds.y};
}

ProceduralSource::Range ProceduralSource::whole() const {
    return {state_->view.data.range.x, state_->view.data.range.y};
}

ProceduralSource::Range ProceduralSource::range(const std::array<dvec2, 3>& uv) const {
    const std::array<dvec2, 3> t = texels_at(uv);
    // A little wider than the triangle: the device rounds its coordinates.
    const dvec2 low = glm::floor(glm::min(glm::min(t[0], t[1]), t[2]) - 0.01);
    const dvec2 high = glm::floor(glm::max(glm::max(t[0], t[1]), t[2]) + 0.01) + 1.0;
    const ivec2 from(low), extent = ivec2(high) - from;
    const ivec2 step = (extent + kPiecesASide - 1) / kPiecesASide;
    Range range{1, 0};
    for (int y = 0; y < extent.y; y += step.y) {
        for (int x = 0; x < extent.x; x += step.x) {
            const ivec2 first(x, y), last = glm::min(first + step, extent);
            if (!touches(t, low + dvec2(first) - 0.01, low + dvec2(last) + 0.01)) continue;
            const Range piece = this->range(from + first, from + last);
            range = {std::min(range.low, piece.low), std::max(range.high, piece.high)};
        }
    }
    return range.low <= range.high ? range : whole();
}

}  // namespace relievo
