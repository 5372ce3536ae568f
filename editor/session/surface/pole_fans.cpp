// See pole_fans.h.
#include "editor/session/surface/pole_fans.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "editor/session/surface/height_fit.h"
#include "editor/session/surface/texel_classes.h"
#include "editor/session/surface/texel_triangle.h"
#include "renderer/scene/cross2.h"

namespace relievo {
namespace {

constexpr std::size_t kGoesOn = 2;  // seams at a vertex that one passes
constexpr double kReach = 3;        // texels from the vertex that are extended so
constexpr double kSites = 7;        // texels from the vertex that tell what lies there
constexpr double kNearest = 3;      // spacings from a place beyond which texels do not count
constexpr double kCircle = 2 * 3.14159265358979323846;

}  // namespace

PoleFans::PoleFans(const Mesh& mesh, const MapGrid& grid, const UvBorders& borders,
                   const TexelClasses& classes)
    : mesh_(mesh), grid_(grid), classes_(classes) {
    std::map<std::uint32_t, std::size_t> seams_at;
    for (const UvSeam& seam : borders.seams)
        if (!seam.aligned)
            for (const std::uint32_t vertex : seam.position) ++seams_at[vertex];
    std::erase_if(seams_at, [](const auto& vertex) { return vertex.second == kGoesOn; });
    if (seams_at.empty()) return;
    std::map<std::uint32_t, std::vector<std::uint32_t>> faces_at;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
        for (const std::uint32_t vertex : mesh.faces[face].position)
            if (seams_at.count(vertex)) faces_at[vertex].push_back(face);
    for (const auto& [vertex, faces] : faces_at) {
        std::optional<Fan> fan = fan_about(vertex, faces);
        if (!fan) continue;
        find_sites(*fan);
        for (std::size_t i = 0; i < fan->sectors.size(); ++i)
            of_face_.emplace(fan->sectors[i].face, std::pair(fans_.size(), i));
        fans_.push_back(std::move(*fan));
    }
}

glm::dvec2 PoleFans::Sector::barycentric(glm::dvec2 step) const {
    return glm::dvec2(cross2(step, previous), cross2(next, step)) / cross2(next, previous);
}

glm::dvec2 PoleFans::Fan::place(const Sector& sector, glm::dvec2 step) const {
    const glm::dvec2 b = sector.barycentric(step), flat = b.x * sector.along + b.y * sector.out;
    const double angle = sector.start + std::atan2(flat.y, flat.x) * turn;
    return glm::length(flat) * glm::dvec2(std::cos(angle), std::sin(angle));
}

// The corner of a face at the vertex.
std::size_t PoleFans::corner_at(std::uint32_t face, std::uint32_t vertex) const {
    const auto& corners = mesh_.faces[face].position;
    return static_cast<std::size_t>(std::find(std::begin(corners), std::end(corners), vertex) -
                                    std::begin(corners));
}

// The face's corner after the one at the vertex, and the one before.
std::uint32_t PoleFans::next_of(std::uint32_t face, std::uint32_t vertex) const {
    return mesh_.faces[face].position[(corner_at(face, vertex) + 1) % 3];
}
std::uint32_t PoleFans::previous_of(std::uint32_t face, std::uint32_t vertex) const {
    return mesh_.faces[face].position[(corner_at(face, vertex) + 2) % 3];
}

// The faces in their order around the vertex, from the border on where they do not close; empty where they
// are not one fan.
std::vector<std::uint32_t> PoleFans::in_order(std::uint32_t vertex,
                                              const std::vector<std::uint32_t>& faces) const {
    std::map<std::uint32_t, std::uint32_t> face_from;  // by the vertex after this one
    std::set<std::uint32_t> reached;                   // the vertices before this one
    for (const std::uint32_t face : faces)
        if (!face_from.emplace(next_of(face, vertex), face).second ||
            !reached.insert(previous_of(face, vertex)).second)
            return {};
    const auto border = std::find_if(face_from.begin(), face_from.end(),
                                     [&](const auto& from) { return !reached.count(from.first); });
    std::vector<std::uint32_t> order;
    for (auto at = border == face_from.end() ? face_from.begin() : border;
         at != face_from.end() && order.size() < faces.size();
         at = face_from.find(previous_of(order.back(), vertex)))
        order.push_back(at->second);
    return order.size() == faces.size() ? order : std::vector<std::uint32_t>();
}

// None where the faces are not one fan, or have no area.
std::optional<PoleFans::Fan> PoleFans::fan_about(std::uint32_t vertex,
                                                 const std::vector<std::uint32_t>& faces) const {
    const std::vector<std::uint32_t> order = in_order(vertex, faces);
    if (order.empty()) return {};
    Fan fan;
    double angle = 0;
    for (const std::uint32_t face : order) {
        const auto& corners = mesh_.faces[face].position;
        const std::size_t c = corner_at(face, vertex);
        const TexelTriangle triangle = texel_triangle(mesh_, face, grid_);
        if (!can_rasterise(triangle, grid_)) return {};
        const glm::dvec3 origin(mesh_.positions[vertex]);
        const glm::dvec3 next = glm::dvec3(mesh_.positions[corners[(c + 1) % 3]]) - origin,
                         previous = glm::dvec3(mesh_.positions[corners[(c + 2) % 3]]) - origin;
        const double length = glm::length(next), along = glm::dot(previous, next) / length,
                     out = glm::length(glm::cross(next, previous)) / length;
        if (!(length > 0) || !(out > 0) || !std::isfinite(out)) return {};
        Sector sector{face,
                      triangle.p[c],
                      triangle.p[(c + 1) % 3] - triangle.p[c],
                      triangle.p[(c + 2) % 3] - triangle.p[c],
                      {length, 0},
                      {along, out},
                      angle};
        for (const glm::dvec2 step : {glm::dvec2(1, 0), glm::dvec2(0, 1)}) {
            const glm::dvec2 b = sector.barycentric(step);
            fan.spacing = std::max(fan.spacing, glm::length(b.x * sector.along + b.y * sector.out));
        }
        angle += std::atan2(out, along);
        fan.sectors.push_back(sector);
    }
    const bool closed = next_of(order.front(), vertex) == previous_of(order.back(), vertex);
    fan.turn = closed || angle > kCircle ? kCircle / angle : 1;
    for (Sector& sector : fan.sectors) sector.start *= fan.turn;
    return fan;
}

void PoleFans::find_sites(Fan& fan) const {
    for (const Sector& sector : fan.sectors) {
        const auto x0 = static_cast<std::int64_t>(std::floor(sector.corner.x - kSites)),
                   y0 = static_cast<std::int64_t>(std::floor(sector.corner.y - kSites));
        constexpr auto kSide = static_cast<std::int64_t>(2 * kSites) + 2;
        for (std::int64_t y = y0; y < y0 + kSide; ++y)
            for (std::int64_t x = x0; x < x0 + kSide; ++x) {
                const glm::dvec2 step =
                    glm::dvec2(static_cast<double>(x), static_cast<double>(y)) - sector.corner;
                const glm::dvec2 b = sector.barycentric(step);
                const std::uint32_t texel = grid_.index(x, y);
                if (b.x < 0 || b.y < 0 || b.x + b.y > 1 || !classes_.owned(texel)) continue;
                fan.sites.push_back({texel, fan.place(sector, step)});
            }
    }
}

std::vector<SeamExtension::Source> PoleFans::sources(std::uint32_t face, glm::dvec2 at) const {
    const auto [first, last] = of_face_.equal_range(face);
    for (auto it = first; it != last; ++it) {
        const Fan& fan = fans_[it->second.first];
        const Sector& sector = fan.sectors[it->second.second];
        if (glm::distance(at, sector.corner) < kReach)
            return height_at(fan, fan.place(sector, at - sector.corner));
    }
    return {};
}

std::vector<SeamExtension::Source> PoleFans::height_at(const Fan& fan, glm::dvec2 place) {
    std::vector<FitSite> around;
    for (const Site& site : fan.sites) {
        const glm::dvec2 way = (site.at - place) / fan.spacing;
        if (glm::length(way) < kNearest) around.push_back({site.texel, way});
    }
    return fitted_height(around);
}

}  // namespace relievo
