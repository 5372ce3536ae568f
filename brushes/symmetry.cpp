// Mirrors and turns about the object's axes, and a surface seen through one.
#include "brushes/symmetry.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace relievo {
namespace {

constexpr double kSame = 1e-6;

// Rounding in the product of transforms must not move a mirror plane: entries as good as whole are whole.
double cleaned(double value) {
    constexpr double kWhole = 1e-12;
    return std::abs(value - std::round(value)) < kWhole ? std::round(value) : value;
}

glm::dmat4 turn_about(Axis axis, double angle) {
    glm::dmat4 turn(1.0);
    const int i = (static_cast<int>(axis) + 1) % 3, j = (static_cast<int>(axis) + 2) % 3;
    turn[i][i] = turn[j][j] = std::cos(angle);
    turn[i][j] = std::sin(angle);
    turn[j][i] = -std::sin(angle);
    return turn;
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
    double sum = 0;
    for (int column = 0; column < 4; ++column) sum += glm::length(a[column] - b[column]);
    return sum;
}

void require_isometry(const glm::dmat4& m) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (std::abs(glm::dot(m[i], m[j]) - (i == j ? 1.0 : 0.0)) > kSame)
                throw std::invalid_argument(
                    "brush symmetry: the object's transform is sheared or unevenly scaled across its axes, "
                    "so "
                    "that it has no mirror image of itself; switch symmetry off");
}

}  // namespace

std::vector<glm::dmat4> symmetry_copies(const Brush& brush, const glm::dmat4& world_from_object) {
    const bool mirrors[3] = {brush.mirror_x, brush.mirror_y, brush.mirror_z};
    const int turns = static_cast<int>(brush.radial);
    std::vector<glm::dmat4> copies{glm::dmat4(1.0)};
    const glm::dmat4 object_from_world = inverse(world_from_object);
    for (int turn = 0; turn < turns; ++turn)
        for (int set = 0; set < 8; ++set) {
            glm::dmat4 mirror(1.0);
            bool wanted = turn + set > 0;
            for (int k = 0; k < 3; ++k) {
                if ((set >> k & 1) == 0) continue;
                mirror[k][k] = -1.0;
                wanted = wanted && mirrors[k];
            }
            if (!wanted) continue;
            constexpr double kCircle = 2 * 3.14159265358979323846;
            glm::dmat4 copy = world_from_object * turn_about(brush.radial_axis, kCircle * turn / turns) *
                              mirror * object_from_world;
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row) copy[column][row] = cleaned(copy[column][row]);
            require_isometry(copy);
            bool known = false;
            for (const glm::dmat4& other : copies) known = known || difference(copy, other) < kSame;
            if (!known) copies.push_back(copy);
        }
    return copies;
}

SurfacePoint TurnedSurface::at(std::uint32_t face, float b1, float b2) const {
    const SurfacePoint point = surface_.at(face, b1, b2);
    const auto seen = [&](glm::vec3 v, double w) { return glm::vec3(hand_from_world_ * glm::dvec4(v, w)); };
    return {seen(point.position, 1.0), seen(point.normal, 0.0), seen(point.base, 1.0),
            seen(point.base_normal, 0.0)};
}

void TurnedSurface::turn(std::span<SurfaceTexel> texels, glm::vec3 centre) const {
    for (SurfaceTexel& texel : texels) {
        texel.position = glm::vec3(hand_from_world_ * glm::dvec4(texel.position, 1.0));
        texel.normal = glm::vec3(hand_from_world_ * glm::dvec4(texel.normal, 0.0));
        texel.distance = glm::length(texel.position - centre);
    }
}

void TurnedSurface::texels_in_ball(glm::vec3 centre, float radius, std::vector<SurfaceTexel>& out) const {
    surface_.precise_texels_in_ball(in_world(centre), radius, out);
    turn(out, centre);
}

void TurnedSurface::visit_ball(glm::vec3 centre, float radius, const TexelVisitor& visit) const {
    std::vector<SurfaceTexel> seen;
    surface_.visit_ball_precisely(in_world(centre), radius, [&](std::span<const SurfaceTexel> part) {
        seen.assign(part.begin(), part.end());
        turn(seen, centre);
        visit(seen);
    });
}

}  // namespace relievo
