// Images of faces under mirrors and turns.
#include "editor/session/surface/symmetric_dabs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace relievo {
namespace {

constexpr double kTolerance = 1e-5;  // of the mesh's radius

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
    hash ^= value + 0x9e3779b97f4a7c15u + (hash << 6) + (hash >> 2);
    return hash * 0xff51afd7ed558ccdu;
}

std::uint64_t cell_key(const std::array<std::int64_t, 3>& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t part : cell) hash = mixed(hash, static_cast<std::uint64_t>(part));
    return hash;
}

std::array<std::int64_t, 3> cell_of(glm::dvec3 p, double size) {
    return {std::llround(p.x / size), std::llround(p.y / size), std::llround(p.z / size)};
}

std::uint64_t face_key(std::array<std::uint32_t, 3> position) {
    std::sort(position.begin(), position.end());
    std::uint64_t hash = 0;
    for (const std::uint32_t p : position) hash = mixed(hash, p);
    return hash;
}

}  // namespace

SymmetricDabs::SymmetricDabs(const Mesh& mesh, const MeshSurface& surface, std::vector<glm::dmat4> copies)
    : mesh_(mesh), surface_(surface), copies_(std::move(copies)), matched_(copies_.size()) {
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
        faces_.emplace(face_key(mesh.faces[face].position), face);
    for (std::size_t i = 1; i < copies_.size(); ++i) match_positions(copies_[i], matched_[i]);
}

void SymmetricDabs::match_positions(const glm::dmat4& copy, std::vector<std::uint32_t>& matched) const {
    const double near = kTolerance * static_cast<double>(mesh_.sphere_radius), cell = 4 * near;
    matched.assign(mesh_.positions.size(), kNone);
    if (!(near > 0)) return;
    std::unordered_multimap<std::uint64_t, std::uint32_t> cells;
    for (std::uint32_t i = 0; i < mesh_.positions.size(); ++i)
        cells.emplace(cell_key(cell_of(glm::dvec3(mesh_.positions[i]), cell)), i);
    for (std::size_t i = 0; i < matched.size(); ++i) {
        const glm::dvec3 image(copy * glm::dvec4(mesh_.positions[i], 1.0));
        const auto centre = cell_of(image, cell);
        double best = near;
        for (int k = 0; k < 27; ++k) {
            const auto [first, last] = cells.equal_range(
                cell_key({centre[0] + k % 3 - 1, centre[1] + k / 3 % 3 - 1, centre[2] + k / 9 - 1}));
            for (auto it = first; it != last; ++it) {
                const double way = glm::length(glm::dvec3(mesh_.positions[it->second]) - image);
                if (way > best || (way == best && it->second >= matched[i])) continue;
                best = way;
                matched[i] = it->second;
            }
        }
    }
}

std::vector<FacePoint> SymmetricDabs::copies_of(const FacePoint& point) const {
    const auto& corners = mesh_.faces[point.face].position;
    const std::array<std::uint32_t, 3> parts{Dab::kBarycentricOne - point.b1 - point.b2, point.b1, point.b2};
    std::vector<FacePoint> places;
    for (std::size_t i = 1; i < copies_.size(); ++i) {
        std::array<std::uint32_t, 3> images{};
        bool all = true;
        for (std::size_t k = 0; k < 3; ++k) {
            images[k] = matched_[i][corners[k]];
            all = all && images[k] != kNone;
        }
        FacePoint place{kNone, 0, 0};
        if (all) {
            const auto [first, last] = faces_.equal_range(face_key(images));
            for (auto it = first; it != last; ++it) {
                std::array<std::uint32_t, 3> there{};
                bool same = it->second < place.face;
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto& own = mesh_.faces[it->second].position;
                    const auto at = std::find(own.begin(), own.end(), images[k]);
                    if (at == own.end())
                        same = false;
                    else
                        there[static_cast<std::size_t>(at - own.begin())] = parts[k];
                }
                if (same) place = {it->second, there[1], there[2]};
            }
        }
        if (place.face == kNone) {
            glm::dvec3 base(0);
            for (std::size_t k = 0; k < 3; ++k)
                base += static_cast<double>(parts[k]) / Dab::kBarycentricOne *
                        glm::dvec3(mesh_.positions[corners[k]]);
            place = surface_.nearest_on_base(glm::dvec3(copies_[i] * glm::dvec4(base, 1.0)));
        }
        places.push_back(place);
    }
    return places;
}

}  // namespace relievo
