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
        object.range.clear();
        const auto add = [&](double low, double high) {  // counts
            const double a = displacement_of(d, low), b = displacement_of(d, high);
            object.range.emplace_back(std::min(a, b), std::max(a, b));
        };
        if (const auto source = session.procedural(i)) {
            for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
                const auto range = source->range(mesh, face);
                add(65535 * range.low, 65535 * range.high);
            }
            continue;
        }
        const HeightMap& map = session.map_of(i);
        const HeightBounds bounds(map.width(), map.height(), map.texels().data(), d.wrap);
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
            const HeightRange counts = bounds.range(mesh, face);
            add(counts.low, counts.high);
        }
    }
}

std::vector<std::uint32_t> PrismLines::facing(const Object& object, const Mesh& mesh, Shown& shown) const {
    std::vector<std::uint32_t> faces;
    shown.nearest = 1e300;
    shown.farthest = 0;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const glm::dvec3 to_eye = shown.eye - centre(mesh, mesh.faces[face]);
        if (object.closed && !(glm::dot(base_normal(mesh, mesh.faces[face]), to_eye) > 0)) continue;
        shown.nearest = std::min(shown.nearest, glm::length(to_eye));
        shown.farthest = std::max(shown.farthest, glm::length(to_eye));
        faces.push_back(face);
    }
    return faces;
}

PrismView PrismLines::view(const Scene& scene, PixelSize picture, const std::optional<glm::dvec2>& pointer,
                           const PrismLimits& limits) const {
    PrismView result;
    Shown shown{scene, picture, scene.camera.eye - scene.origin, 0, 1, result.lines};
    std::size_t triangles = 0;
    bool prisms_cut = false, edges_cut = false;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        const Object& object = objects_[i];
        const Mesh& mesh = scene.objects[i].mesh;
        // Too many are cut to those near the pointer; true then.
        const auto cut = [&](auto& items, std::size_t limit, const auto& middle_of) {
            if (items.size() <= limit) return false;
            std::erase_if(items, [&](const auto& item) {
                const auto at = shown.on_screen(middle_of(item));
                return !pointer || !at || glm::length(*at - *pointer) > limits.near_px;
            });
            if (items.size() > limit) items.resize(limit);
            return true;
        };
        std::vector<std::uint32_t> faces = facing(object, mesh, shown);
        triangles += faces.size();
        std::vector<bool> faces_us(mesh.faces.size());
        for (const std::uint32_t face : faces) faces_us[face] = true;
        std::vector<MeshEdge> edges;
        for (const MeshEdge& edge : object.topology.edges) {
            const auto sides = object.topology.sides_of(edge);
            if (std::any_of(sides.begin(), sides.end(), [&](const EdgeSide& s) { return faces_us[s.face]; }))
                edges.push_back(edge);
        }
        const auto end = [&](std::uint32_t position) { return glm::dvec3(mesh.positions[position]); };
        edges_cut |=
            cut(edges, limits.edges, [&](const MeshEdge& e) { return (end(e.p0) + end(e.p1)) * 0.5; });
        prisms_cut |=
            cut(faces, limits.prisms, [&](std::uint32_t face) { return centre(mesh, mesh.faces[face]); });
        for (const MeshEdge& edge : edges) shown.add(OverlayLine::Kind::base, end(edge.p0), end(edge.p1));
        for (const std::uint32_t face : faces) shown.add_prism(mesh, mesh.faces[face], object.range[face]);
    }
    if (prisms_cut)
        result.note = grouped(triangles) +
                      " triangles in view: " + (edges_cut ? "edges and prisms" : "prisms") +
                      " near the pointer only";
    return result;
}

}  // namespace relievo::gui
