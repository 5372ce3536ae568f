// The surface under the pointer, and the brush's circle lying on it.
#include "editor/gui/brush_cursor.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "editor/gui/map_value.h"
#include "editor/gui/theme.h"
#include "editor/session/view_window.h"

namespace relievo::gui {
namespace {

constexpr std::size_t kRingPoints = 64;
constexpr int kEvenRounds = 6;
constexpr float kMostHeight = 0.6f;  // of the radius: what lies further is another part of the relief

// The circle's radius where the surface stands `height` over its plane; never so small that the ring folds.
float shrunk(float radius, float height) {
    return radius * std::sqrt(std::max(0.25f, 1 - height * height / (radius * radius)));
}

// Over cracks and cliffs the ring follows the surface's broad shape: jagged, it would hide what it marks.
void even_out(std::array<float, kRingPoints>& height) {
    for (int round = 0; round < kEvenRounds; ++round) {
        const auto before = height;
        for (std::size_t i = 0; i < kRingPoints; ++i)
            height[i] = 0.5f * before[i] +
                        0.25f * (before[(i + 1) % kRingPoints] + before[(i + kRingPoints - 1) % kRingPoints]);
    }
}

glm::vec3 ring_point(glm::vec3 centre, glm::vec3 u, glm::vec3 v, std::size_t index, float radius) {
    const double angle = 2 * 3.14159265358979323846 * static_cast<double>(index) / kRingPoints;
    return centre +
           radius * (u * static_cast<float>(std::cos(angle)) + v * static_cast<float>(std::sin(angle)));
}

// Where the ball of the brush meets the surface, nearly: points of a circle in the tangent plane are dropped
// onto the surface along the normal, then again from a smaller circle where the surface lies lower or higher,
// so that their distance to the centre is the radius. Where nothing is near (past a silhouette), they stay in
// the plane.
// The plane is across the direction in which the surface is displaced there: its own normal would tip over in
// every groove.
std::vector<glm::vec3> ring_around(Renderer& renderer, const PickHit& centre, glm::vec3 n, float radius) {
    const glm::vec3 other = std::abs(n.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = glm::normalize(glm::cross(n, other)), v = glm::cross(n, u);
    std::array<float, kRingPoints> height{};  // over the tangent plane
    for (int round = 0; round < 2; ++round) {
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < height.size(); ++i)
            rays.push_back(
                {ring_point(centre.position, u, v, i, shrunk(radius, height[i])) + n * radius, -n});
        const std::vector<PickHit> hits = renderer.pick(rays);
        for (std::size_t i = 0; i < height.size(); ++i) {
            const float fresh = hits[i].hit ? radius - hits[i].distance : 0;
            height[i] = std::clamp(fresh, -kMostHeight * radius, kMostHeight * radius);
        }
        even_out(height);
    }
    std::vector<glm::vec3> ring;
    for (std::size_t i = 0; i < height.size(); ++i)
        ring.push_back(ring_point(centre.position, u, v, i, shrunk(radius, height[i])) + n * height[i]);
    return ring;
}

glm::vec3 displacing_normal(const Mesh& mesh, const PickHit& hit) {
    const auto& corner = mesh.faces[hit.face].position;
    const glm::vec3 n = mesh.normals[corner[0]] * (1 - hit.b1 - hit.b2) + mesh.normals[corner[1]] * hit.b1 +
                        mesh.normals[corner[2]] * hit.b2;
    const float length = glm::length(n);
    return length > 0 ? n / length : hit.normal;  // opposite normals cancel on a folded mesh
}

// The map's value at a point of the base mesh, in counts.
double counts_at(const Session& session, const PickHit& hit) {
    const SceneObject& object = session.scene().objects.front();
    const HeightMap& map = session.map();
    const Mesh::Face& face = object.mesh.faces[hit.face];
    const glm::dvec2 uv = glm::dvec2(object.mesh.uvs[face.uv[0]]) * (1.0 - hit.b1 - hit.b2) +
                          glm::dvec2(object.mesh.uvs[face.uv[1]]) * static_cast<double>(hit.b1) +
                          glm::dvec2(object.mesh.uvs[face.uv[2]]) * static_cast<double>(hit.b2);
    if (const auto source = session.procedural(0)) return 65535 * source->value(source->texel_at(uv));
    return map_value(map, object.displacement.wrap, uv);
}

}  // namespace

void BrushCursor::follow(Session& session, const LivePicture& live, double x, double y) {
    Renderer& renderer = session.renderer();
    ray_ = renderer.camera_ray(live.to_renderer_x(x), live.to_renderer_y(y));
    next_ray_ = renderer.camera_ray(live.to_renderer_x(x) + 1, live.to_renderer_y(y));
    const PickHit hit = renderer.pick(std::span(&ray_, 1)).front();
    centre_.reset();
    if (!hit.hit || hit.object != 0) return;
    centre_ = hit;
    normal_ = displacing_normal(session.scene().objects.front().mesh, hit);
    resize(session);
    const Displacement& d = session.scene().objects.front().displacement;
    spot_.counts = counts_at(session, hit);
    spot_.height = displacement_of(d, spot_.counts);
}

void BrushCursor::resize(Session& session) {
    if (!centre_) return;
    radius_ = session.world_radius(*centre_, ray_, next_ray_);
    ring_ = ring_around(session.renderer(), *centre_, normal_, radius_);
}

std::optional<BrushCursor::Look> BrushCursor::look() const {
    if (!centre_) return std::nullopt;
    return Look{*centre_, normal_, radius_, ray_, next_ray_};
}

std::optional<BrushCursor::Spot> BrushCursor::spot() const {
    return centre_ ? std::optional(spot_) : std::nullopt;
}

void BrushCursor::draw(ImDrawList& list, Session& session, PixelSize picture, double x, double y,
                       bool lit) const {
    if (!centre_) return;
    const Scene& scene = session.scene();
    const auto on_screen = [&](const glm::vec3& point) -> std::optional<ImVec2> {
        const auto px = project(scene.camera, scene.origin, picture.width, picture.height, point);
        if (!px) return std::nullopt;
        return ImVec2(static_cast<float>(px->x + x), static_cast<float>(px->y + y));
    };
    std::vector<ImVec2> line;
    for (const glm::vec3& point : ring_)
        if (const auto px = on_screen(point)) line.push_back(*px);
    const int count = static_cast<int>(line.size());
    list.AddPolyline(line.data(), count, kRingShadow, ImDrawFlags_Closed, points(3.5f));
    list.AddPolyline(line.data(), count, lit ? kAccent : kRing, ImDrawFlags_Closed, points(1.6f));
    if (const auto px = on_screen(centre_->position)) {
        list.AddCircleFilled(*px, points(3), kRingShadow);
        list.AddCircleFilled(*px, points(1.8f), lit ? kAccent : kRing);
    }
    // The normal shows how the surface lies where the ring is seen edge on.
    const auto foot = on_screen(centre_->position);
    const auto tip = on_screen(centre_->position + normal_ * (0.35f * radius_));
    if (foot && tip) list.AddLine(*foot, *tip, lit ? kAccent : kRing, points(1.2f));
}

}  // namespace relievo::gui
