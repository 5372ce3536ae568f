// The base mesh and its prisms as lines on screen.
#include "editor/gui/prism_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "editor/gui/map_value.h"
#include "editor/session/view_window.h"
#include "renderer/scene/triangle_bounds.h"

namespace relievo::gui {
namespace {

std::string grouped(std::size_t number) {
    std::string text = std::to_string(number);
    for (auto place = static_cast<std::ptrdiff_t>(text.size()) - 3; place > 0; place -= 3)
        text.insert(static_cast<std::size_t>(place), ",");
    return text;
}

glm::dvec3 base_normal(const Mesh& mesh, const Mesh::Face& face) {
    const glm::dvec3 p0 = mesh.positions[face.position[0]];
    return glm::cross(glm::dvec3(mesh.positions[face.position[1]]) - p0,
                      glm::dvec3(mesh.positions[face.position[2]]) - p0);
}

glm::dvec3 centre(const Mesh& mesh, const Mesh::Face& face) {
    return (glm::dvec3(mesh.positions[face.position[0]]) + glm::dvec3(mesh.positions[face.position[1]]) +
            glm::dvec3(mesh.positions[face.position[2]])) /
           3.0;
}

}  // namespace

// What one frame shows of an object, and how it gets to the screen.
struct PrismLines::Shown {
    const Scene& scene;
    PixelSize picture;
    glm::dvec3 eye;  // rebased space
    double nearest = 0, farthest = 1;
    std::vector<OverlayLine>& lines;

    std::optional<glm::dvec2> on_screen(const glm::dvec3& point) const {
        return project(scene.camera, scene.origin, picture.width, picture.height, glm::vec3(point));
    }
    void add(OverlayLine::Kind kind, const glm::dvec3& a, const glm::dvec3& b) const {
        const auto pa = on_screen(a), pb = on_screen(b);
        if (!pa || !pb) return;
        const glm::dvec2 low = glm::min(*pa, *pb), high = glm::max(*pa, *pb);
        if (high.x < 0 || high.y < 0 || low.x > picture.width || low.y > picture.height) return;
        const double distance = glm::length((a + b) * 0.5 - eye);
        const double share = (farthest - distance) / std::max(1e-30, farthest - nearest);
        lines.push_back({kind, *pa, *pb, static_cast<float>(std::clamp(share, 0.0, 1.0))});
    }
    void add_prism(const Mesh& mesh, const Mesh::Face& face, const glm::vec2& range) const {
        glm::dvec3 low[3], high[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 p = mesh.positions[face.position[i]], n = mesh.normals[face.position[i]];
            low[i] = p + n * static_cast<double>(range.x);
            high[i] = p + n * static_cast<double>(range.y);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            add(OverlayLine::Kind::cap, low[i], low[next]);
            add(OverlayLine::Kind::cap, high[i], high[next]);
            add(OverlayLine::Kind::side, low[i], high[i]);
        }
    }
};

void PrismLines::follow(const Session& session) {
    const Scene& scene = session.scene();
    const Displacement& edited = scene.objects.front().displacement;
    const bool same =
        revision_ == session.map_revision() && amplitude_ == edited.amplitude && midlevel_ == edited.midlevel;
    if (same || session.in_stroke()) return;
    revision_ = session.map_revision();
    amplitude_ = edited.amplitude;
    midlevel_ = edited.midlevel;
    objects_.resize(scene.objects.size());
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        const Mesh& mesh = scene.objects[i].mesh;
        const Displacement& d = scene.objects[i].displacement;
        Object& object = objects_[i];
        if (object.topology.edges.empty()) {
            object.topology = find_edges(mesh);
            const auto& edges = object.topology.edges;
            object.closed =
                std::none_of(edges.begin(), edges.end(), [](const MeshEdge& e) { return e.is_border(); });
        }
        const HeightMap& map = session.map_of(i);
        const HeightBounds bounds(map.width(), map.height(), map.texels().data(), d.wrap);
        object.range.clear();
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
            const HeightRange counts = bounds.range(mesh, face);
            const double a = displacement_of(d, counts.low), b = displacement_of(d, counts.high);
            object.range.emplace_back(std::min(a, b), std::max(a, b));
        }
    }
}

PrismView PrismLines::view(const Scene& scene, PixelSize picture, const std::optional<glm::dvec2>& pointer,
                           const PrismLimits& limits) const {
    PrismView result;
    Shown shown{scene, picture, scene.camera.eye - scene.origin, 0, 1, result.lines};
    std::size_t edges_shown = 0, facing_count = 0;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        const Object& object = objects_[i];
        const Mesh& mesh = scene.objects[i].mesh;
        std::vector<bool> facing(mesh.faces.size());
        std::vector<std::uint32_t> prisms;
        shown.nearest = 1e300;
        shown.farthest = 0;
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
            const glm::dvec3 middle = centre(mesh, mesh.faces[face]), to_eye = shown.eye - middle;
            facing[face] = !object.closed || glm::dot(base_normal(mesh, mesh.faces[face]), to_eye) > 0;
            if (!facing[face]) continue;
            shown.nearest = std::min(shown.nearest, glm::length(to_eye));
            shown.farthest = std::max(shown.farthest, glm::length(to_eye));
            prisms.push_back(face);
        }
        for (const MeshEdge& edge : object.topology.edges) {
            const auto sides = object.topology.sides_of(edge);
            const bool seen =
                std::any_of(sides.begin(), sides.end(), [&](const EdgeSide& s) { return facing[s.face]; });
            if (!seen || edges_shown >= limits.edges) continue;
            shown.add(OverlayLine::Kind::base, mesh.positions[edge.p0], mesh.positions[edge.p1]);
            ++edges_shown;
        }
        facing_count += prisms.size();
        if (prisms.size() > limits.prisms) {
            std::erase_if(prisms, [&](std::uint32_t face) {
                const auto at = shown.on_screen(centre(mesh, mesh.faces[face]));
                return !pointer || !at || glm::length(*at - *pointer) > limits.near_px;
            });
            if (prisms.size() > limits.prisms) prisms.resize(limits.prisms);
            result.note = grouped(facing_count) + " triangles in view: prisms near the pointer only";
        }
        for (const std::uint32_t face : prisms) shown.add_prism(mesh, mesh.faces[face], object.range[face]);
    }
    if (edges_shown >= limits.edges)
        result.note += (result.note.empty() ? "" : "; ") + std::string("not all edges");
    return result;
}

}  // namespace relievo::gui
