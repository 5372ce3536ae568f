// The bevel of sharp creases: see the header.
#include "renderer/scene/creases.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <map>

#include "renderer/scene/mesh_soup.h"
#include "renderer/scene/mesh_topology.h"

namespace relievo {

namespace {

using Corner = EdgeSide;  // a face's corner: the one that its edge starts at

// A corner of a face in the result: position and uv.
struct Point {
    std::uint32_t position, uv;
};

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

class CreaseMender {
  public:
    CreaseMender(const Mesh& mesh, double threshold_deg) : in_(mesh), topology_(find_edges(mesh)) {
        out_.mesh = mesh;
        is_crease_.resize(topology_.edges.size());
        for (std::size_t i = 0; i < topology_.edges.size(); ++i) {
            is_crease_[i] = is_sharp(topology_.edges[i], glm::radians(threshold_deg));
        }
    }

    MendedMesh mend() {
        out_.original_face.resize(in_.faces.size());
        for (std::uint32_t f = 0; f < in_.faces.size(); ++f) out_.original_face[f] = f;
        if (std::find(is_crease_.begin(), is_crease_.end(), true) == is_crease_.end()) return std::move(out_);
        start_polygons();
        split_ends();
        make_strips();
        finish_normals();
        emit_faces();
        return std::move(out_);
    }

  private:
    // The faces of one side of the creases around a position: they follow one copy of it.
    struct Sector {
        std::uint32_t copy;
        std::vector<Corner> corners;
        glm::dvec3 offset{0};  // of the copy from the position
        glm::dvec3 face_normals{0}, strip_normals{0};
    };

    glm::dvec3 position(std::uint32_t p) const { return glm::dvec3(in_.positions[p]); }
    const Mesh::Face& face(const Corner& c) const { return in_.faces[c.face]; }
    std::uint32_t apex(const Corner& edge) const { return (edge.corner + 2) % 3; }

    glm::dvec3 area_normal(std::uint32_t f) const {
        const auto& [a, b, c] = in_.faces[f].position;
        return glm::cross(position(b) - position(a), position(c) - position(a));
    }

    bool is_sharp(const MeshEdge& edge, double threshold) const {
        if (!edge.is_manifold()) return false;
        const EdgeSide s0 = topology_.sides_of(edge)[0], s1 = topology_.sides_of(edge)[1];
        if (has_no_area(in_, face(s0)) || has_no_area(in_, face(s1))) return false;
        const std::uint32_t apex0 = face(s0).position[apex(s0)], apex1 = face(s1).position[apex(s1)];
        if (apex0 == apex1) return false;  // one triangle seen from both sides
        const glm::dvec3 n0 = glm::normalize(area_normal(s0.face)), n1 = glm::normalize(area_normal(s1.face));
        const glm::dvec3 across = position(apex1) - position(edge.p0);
        const bool is_convex = glm::dot(n0, across) <= 1e-9 * glm::length(across);
        return is_convex && std::atan2(glm::length(glm::cross(n0, n1)), -glm::dot(n0, n1)) < threshold;
    }

    bool crease_at(std::uint32_t f, std::uint32_t corner) const {
        const std::uint32_t edge = topology_.face_edges[3 * f + corner];
        return edge != MeshTopology::kNoEdge && is_crease_[edge];
    }

    void start_polygons() {
        polygons_.resize(in_.faces.size());
        for (std::size_t f = 0; f < in_.faces.size(); ++f) {
            for (std::size_t k = 0; k < 3; ++k) {
                polygons_[f][k] = {{in_.faces[f].position[k], in_.faces[f].uv[k]}};
            }
        }
    }

    // Doubles the ends of all creases.
    void split_ends() {
        std::map<std::uint32_t, std::vector<Corner>> ends;
        std::map<std::uint32_t, bool> is_tangled;
        for (std::size_t i = 0; i < topology_.edges.size(); ++i) {
            const MeshEdge& edge = topology_.edges[i];
            if (is_crease_[i]) ends[edge.p0], ends[edge.p1];
            if (!edge.is_border() && !edge.is_manifold()) is_tangled[edge.p0] = is_tangled[edge.p1] = true;
        }
        for (std::uint32_t f = 0; f < in_.faces.size(); ++f) {
            const auto& p = in_.faces[f].position;
            for (std::uint32_t k = 0; k < 3; ++k) {
                if (const auto end = ends.find(p[k]); end != ends.end()) end->second.push_back({f, k});
                if (p[k] == p[(k + 1) % 3]) is_tangled[p[k]] = true;
            }
        }
        for (const auto& [p, corners] : ends) {
            if (is_tangled.contains(p)) continue;
            std::vector<bool> done(corners.size());
            for (std::size_t i = 0; i < corners.size(); ++i) {
                if (!done[i]) split_fan(p, fan_from(corners, i, done));
            }
        }
    }

    // The corner across the edge that ends at (`forward`) or starts at this corner; false at a border.
    bool step(Corner& corner, bool forward) const {
        const std::uint32_t across = forward ? (corner.corner + 2) % 3 : corner.corner;
        const MeshEdge& edge = topology_.edges[topology_.face_edges[3 * corner.face + across]];
        if (edge.is_border()) return false;
        const auto sides = topology_.sides_of(edge);
        const EdgeSide other =
            sides[0].face == corner.face && sides[0].corner == across ? sides[1] : sides[0];
        corner = {other.face, forward ? other.corner : (other.corner + 1) % 3};
        return true;
    }

    struct Fan {
        std::vector<Corner> corners;  // counter-clockwise
        bool is_closed = false;
    };

    Fan fan_from(const std::vector<Corner>& corners, std::size_t start, std::vector<bool>& done) const {
        Fan fan;
        Corner corner = corners[start];
        for (std::size_t steps = 0; steps <= corners.size() && step(corner, false); ++steps) {
            fan.is_closed = fan.is_closed ||
                            (corner.face == corners[start].face && corner.corner == corners[start].corner);
            if (fan.is_closed) break;
        }
        for (std::size_t n = 0; n < corners.size(); ++n) {
            fan.corners.push_back(corner);
            const auto at = std::find_if(corners.begin(), corners.end(), [&](const Corner& c) {
                return c.face == corner.face && c.corner == corner.corner;
            });
            done[static_cast<std::size_t>(at - corners.begin())] = true;
            if (!step(corner, true)) break;
            if (corner.face == fan.corners[0].face && corner.corner == fan.corners[0].corner) break;
        }
        return fan;
    }

    // Cuts a fan at its creases and gives each part its copy of the position.
    void split_fan(std::uint32_t p, Fan fan) {
        auto& corners = fan.corners;
        const auto starts_at_crease = [&](const Corner& c) { return crease_at(c.face, c.corner); };
        const auto first = std::find_if(corners.begin(), corners.end(), starts_at_crease);
        if (first == corners.end()) return;
        if (fan.is_closed) std::rotate(corners.begin(), first, corners.end());
        std::vector<std::vector<Corner>> parts;
        for (const Corner& corner : corners) {
            if (parts.empty() || starts_at_crease(corner)) parts.emplace_back();
            parts.back().push_back(corner);
        }
        double inset = std::numeric_limits<double>::max();
        each_crease_corner(corners, [&](const Corner& c, std::uint32_t third) {
            const std::uint32_t along = 3 - c.corner - third;  // the other end of the crease
            const glm::dvec3 edge = position(face(c).position[along]) - position(p);
            inset = std::min(inset, kCreaseInset * glm::length(area_normal(c.face)) / glm::length(edge));
        });
        if (parts.size() > 1) {
            for (std::vector<Corner>& part : parts) add_sector(p, std::move(part), inset);
        } else if (corners.size() >= 3) {
            split_between(p, corners, inset);
        }
    }

    // Unit vector in the face's plane, at right angles to its crease at the corner, into the face.
    glm::dvec3 inward(const Corner& c, std::uint32_t third) const {
        const glm::dvec3 p = position(face(c).position[c.corner]);
        const glm::dvec3 along = glm::normalize(position(face(c).position[3 - c.corner - third]) - p);
        const glm::dvec3 across = position(face(c).position[third]) - p;
        return unit_or_zero(across - along * glm::dot(across, along));
    }

    // One crease ends here: the face that lies most between its two faces gets both copies.
    void split_between(std::uint32_t p, const std::vector<Corner>& corners, double inset) {
        const glm::dvec3 span =
            unit_or_zero(area_normal(corners.front().face)) - unit_or_zero(area_normal(corners.back().face));
        std::size_t middle = 1;
        double least = 2;
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            const double leaning = std::abs(glm::dot(unit_or_zero(area_normal(corners[i].face)), span));
            if (leaning < least) least = leaning, middle = i;
        }
        const auto at = corners.begin() + static_cast<std::ptrdiff_t>(middle);
        const Corner both = *at;
        const Point before = polygons_[both.face][both.corner][0];
        const std::size_t a = add_sector(p, {corners.begin(), at}, inset);
        const std::size_t b = add_sector(p, {at + 1, corners.end()}, inset);
        polygons_[both.face][both.corner] = {moved(sectors_[b], before.uv), moved(sectors_[a], before.uv)};
    }

    std::size_t add_sector(std::uint32_t p, std::vector<Corner> corners, double inset) {
        Sector sector;
        sector.copy = static_cast<std::uint32_t>(out_.mesh.positions.size());
        sector.corners = std::move(corners);
        glm::dvec3 offset(0);
        each_crease_corner(sector.corners,
                           [&](const Corner& c, std::uint32_t third) { offset += inward(c, third); });
        sector.offset = unit_or_zero(offset) * inset;
        out_.mesh.positions.emplace_back(position(p) + sector.offset);
        out_.mesh.normals.push_back(in_.normals[p]);
        for (const Corner& c : sector.corners) {
            sector.face_normals += area_normal(c.face);
            polygons_[c.face][c.corner] = {moved(sector, face(c).uv[c.corner])};
        }
        sectors_.push_back(std::move(sector));
        sector_of_copy_[sectors_.back().copy] = sectors_.size() - 1;
        return sectors_.size() - 1;
    }

    // Visits (corner, third corner of its face) for each crease that the corners have at their position.
    template <class Visit>
    void each_crease_corner(const std::vector<Corner>& corners, Visit&& visit) const {
        for (const Corner& c : corners) {
            if (crease_at(c.face, c.corner)) visit(c, (c.corner + 2) % 3);
            if (crease_at(c.face, (c.corner + 2) % 3)) visit(c, (c.corner + 1) % 3);
        }
    }

    // The sector's copy with the texture coordinate that belongs to it: moved by the same offset as the copy,
    // in the plane of the crease faces that share it (their mean).
    Point moved(const Sector& sector, std::uint32_t uv) {
        const auto [place, is_new] = moved_uvs_.try_emplace({sector.copy, uv}, uv);
        if (!is_new) return {sector.copy, place->second};
        glm::dvec2 offset(0);
        int creases = 0;
        each_crease_corner(sector.corners, [&](const Corner& c, std::uint32_t) {
            if (face(c).uv[c.corner] != uv) return;
            offset += uv_offset(c, sector.offset);
            ++creases;
        });
        if (creases > 0) {
            place->second = static_cast<std::uint32_t>(out_.mesh.uvs.size());
            out_.mesh.uvs.emplace_back(glm::dvec2(in_.uvs[uv]) + offset / static_cast<double>(creases));
        }
        return {sector.copy, place->second};
    }

    // How far the texture coordinate moves when the face's corner moves by `offset` in the face's plane.
    glm::dvec2 uv_offset(const Corner& c, const glm::dvec3& offset) const {
        const std::uint32_t next = (c.corner + 1) % 3, last = (c.corner + 2) % 3;
        const glm::dvec3 p = position(face(c).position[c.corner]);
        const glm::dvec3 e1 = position(face(c).position[next]) - p, e2 = position(face(c).position[last]) - p;
        const glm::dvec3 normal = glm::cross(e1, e2);
        const double area = glm::dot(normal, normal);
        const double b1 = glm::dot(glm::cross(offset, e2), normal) / area;
        const double b2 = glm::dot(glm::cross(e1, offset), normal) / area;
        const glm::dvec2 uv(in_.uvs[face(c).uv[c.corner]]);
        return (glm::dvec2(in_.uvs[face(c).uv[next]]) - uv) * b1 +
               (glm::dvec2(in_.uvs[face(c).uv[last]]) - uv) * b2;
    }

    void make_strips() {
        for (std::size_t i = 0; i < topology_.edges.size(); ++i) {
            if (is_crease_[i])
                make_strip(topology_.sides_of(topology_.edges[i])[0],
                           topology_.sides_of(topology_.edges[i])[1]);
        }
    }

    // `s` runs along the edge, `t` against it.
    void make_strip(const EdgeSide& s, const EdgeSide& t) {
        const std::uint32_t s1 = (s.corner + 1) % 3, t1 = (t.corner + 1) % 3;
        const Point a0 = polygons_[s.face][s.corner][0], a1 = polygons_[s.face][s1][0];
        Point b0 = polygons_[t.face][t1][0], b1 = polygons_[t.face][t.corner][0];
        if (a0.position == b0.position && a1.position == b1.position) return;
        ++out_.mended_edges;
        const bool is_seam = face(s).uv[s.corner] != face(t).uv[t1] || face(s).uv[s1] != face(t).uv[t.corner];
        if (is_seam) b0.uv = face(s).uv[s.corner], b1.uv = face(s).uv[s1];

        const auto at = [&](const Point& p) { return glm::dvec3(out_.mesh.positions[p.position]); };
        glm::dvec3 normal = unit_or_zero(glm::cross(at(b0) - at(a1), at(b1) - at(a0)));
        if (normal == glm::dvec3(0)) {
            const glm::dvec3 thirds =
                position(face(s).position[apex(s)]) + position(face(t).position[apex(t)]);
            normal = unit_or_zero(at(a0) + at(a1) - thirds);
        }
        for (const Point& p : {a0, a1, b0, b1}) {
            if (const auto found = sector_of_copy_.find(p.position); found != sector_of_copy_.end()) {
                sectors_[found->second].strip_normals += normal;
            }
        }
        if (a0.position != b0.position) strips_.push_back({{a1, a0, b0}, s.face});
        if (a1.position != b1.position) strips_.push_back({{a1, b0, b1}, s.face});
    }

    void finish_normals() {
        for (const Sector& sector : sectors_) {
            const glm::dvec3 sum = unit_or_zero(sector.face_normals) + unit_or_zero(sector.strip_normals);
            if (glm::length(sum) > 0) out_.mesh.normals[sector.copy] = glm::vec3(glm::normalize(sum));
        }
    }

    void emit_faces() {
        std::vector<Mesh::Face> faces;
        std::vector<std::uint32_t> original;
        const auto add = [&](const Point& a, const Point& b, const Point& c, std::uint32_t f) {
            faces.push_back({{a.position, b.position, c.position}, {a.uv, b.uv, c.uv}});
            original.push_back(f);
        };
        for (std::uint32_t f = 0; f < in_.faces.size(); ++f) {
            std::vector<Point> points;
            std::vector<glm::dvec3> positions;
            for (const std::vector<Point>& corner : polygons_[f])
                points.insert(points.end(), corner.begin(), corner.end());
            for (const Point& p : points) positions.emplace_back(out_.mesh.positions[p.position]);
            for (const auto& [a, b, c] : triangulate(positions)) add(points[a], points[b], points[c], f);
        }
        for (const auto& [points, f] : strips_) add(points[0], points[1], points[2], f);
        out_.mesh.faces = std::move(faces);
        out_.original_face = std::move(original);
    }

    struct Strip {
        std::array<Point, 3> points;
        std::uint32_t face;
    };

    const Mesh& in_;
    const MeshTopology topology_;
    MendedMesh out_;
    std::vector<bool> is_crease_;                              // one an edge
    std::vector<std::array<std::vector<Point>, 3>> polygons_;  // one a face: what each corner became
    std::vector<Sector> sectors_;
    std::map<std::uint32_t, std::size_t> sector_of_copy_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> moved_uvs_;  // by copy and old uv
    std::vector<Strip> strips_;
};

}  // namespace

MendedMesh mend_creases(const Mesh& mesh, double threshold_deg) {
    return CreaseMender(mesh, threshold_deg).mend();
}

}  // namespace relievo
