#include "editor/session/surface/seam_slopes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "editor/session/surface/texel_triangle.h"

namespace relievo {
namespace {

// Rows that turn less than this share of a texel at the border go straight on: positions are floats.
constexpr double kStraight = 1e-4;
// Rows steeper to the border than this many texels along it for one across belong to slivers, whose
// continuation leads nowhere.
constexpr double kSteepest = 4;

// One texel's step across the border: so far from it, and so many texels along it.
struct Row {
    double away, along;
};

Row row_of(glm::dvec3 across, glm::dvec3 along) {
    const double length = glm::dot(along, along);
    const double k = glm::dot(across, along) / length;
    return {std::sqrt(std::max(glm::dot(across, across) - k * k * length, 0.0)), k};
}

bool usable(const Row& row) {
    return row.away > 0 && std::isfinite(row.away) && std::abs(row.along) < kSteepest;
}

std::int32_t quantised(double weight) {
    return static_cast<std::int32_t>(std::lround(weight * SeamBend::kOne));
}

}  // namespace

SlopeWeights slope_weights(const Mesh& mesh, const MapGrid& grid, const UvSeam& seam) {
    const SlopeWeights none{0, {0, 0}};
    const TexelTriangle a = texel_triangle(mesh, seam.a.face, grid),
                        b = texel_triangle(mesh, seam.b.face, grid);
    if (!can_rasterise(a, grid) || !can_rasterise(b, grid)) return none;
    const glm::length_t axis = std::abs(seam.a.to.x - seam.a.from.x) < kTexelSlack ? 1 : 0;
    glm::dvec2 along(0), outward(0);
    along[axis] = 1;
    outward[1 - axis] = seam.a.inner[1 - axis] > seam.a.from[1 - axis] ? -1 : 1;
    const TexelIsometry turn = across(seam);
    const auto turned = [&](glm::dvec2 d) {
        return glm::dvec2(static_cast<double>(turn.xx) * d.x + static_cast<double>(turn.xy) * d.y,
                          static_cast<double>(turn.yx) * d.x + static_cast<double>(turn.yy) * d.y);
    };
    const glm::dmat2x3 space_a = space_from_texels(mesh, seam.a.face, a),
                       space_b = space_from_texels(mesh, seam.b.face, b);
    const Row row_a = row_of(space_a * outward, space_a * along);
    const Row row_b = row_of(space_b * turned(outward), space_b * turned(along));
    if (!usable(row_a) || !usable(row_b)) return none;

    const double sum = row_a.away + row_b.away;
    const double lean = (row_b.away - row_a.away) / sum;
    const double bend = (row_b.away * row_a.along - row_a.away * row_b.along) / sum;
    if (std::abs(lean) < kStraight && std::abs(bend) < kStraight) return none;
    // h is the mean of the sides' texels, the nearer one counting more; h' half of what it gains over two
    // columns.
    return {quantised(lean),
            {quantised(bend * (row_b.away / sum) / 2), quantised(bend * (row_a.away / sum) / 2)}};
}

std::array<std::int32_t, 3> vertex_weights(const Mesh& mesh, const std::array<const UvSeam*, 3>& seams) {
    constexpr std::array<std::int32_t, 3> kEqual{SeamBend::kOne, SeamBend::kOne, SeamBend::kOne};
    const auto& first = seams[0]->position;
    const auto ends_at = [](std::uint32_t vertex) {
        return [vertex](const UvSeam* s) { return s->position[0] == vertex || s->position[1] == vertex; };
    };
    const auto vertex = std::find_if(std::begin(first), std::end(first), [&](std::uint32_t v) {
        return std::all_of(seams.begin(), seams.end(), ends_at(v));
    });
    if (vertex == std::end(first)) return kEqual;

    // The corner texel between two spokes stands at half the sum of their texels' steps. With the areas
    // between the spokes as their weights the spokes cancel out; so do the texels with 1 - 2 * the share of
    // the other.
    const glm::dvec3 centre(mesh.positions[*vertex]), normal(mesh.normals[*vertex]);
    std::array<glm::dvec3, 3> spoke;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& ends = seams[k]->position;
        const std::uint32_t far = ends[0] == *vertex ? ends[1] : ends[0];
        spoke[k] = (glm::dvec3(mesh.positions[far]) - centre) / seams[k]->a.length();
    }
    std::array<double, 3> area;
    for (std::size_t k = 0; k < 3; ++k)
        area[k] = glm::dot(normal, glm::cross(spoke[(k + 1) % 3], spoke[(k + 2) % 3]));
    const double sum = area[0] + area[1] + area[2];
    std::array<std::int32_t, 3> weights;
    for (std::size_t k = 0; k < 3; ++k) {
        const double weight = 1 - 2 * area[k] / sum;
        if (!(area[k] / sum > 0) || !(weight >= 0)) return kEqual;
        weights[k] = quantised(weight);
    }
    return weights;
}

}  // namespace relievo
