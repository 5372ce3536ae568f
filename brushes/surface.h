// What a brush sees of the mesh: points and texels of the displaced surface in world space, and its seams.
// The editor's session implements it over the scene; tests implement it over a plane.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace relievo {

struct SurfacePoint {
    glm::vec3 position;  // on the displaced surface S, world units
    glm::vec3 normal;    // unit geometric normal of S, on the side of the base normal
    glm::vec3 base;      // on the base mesh, world units
    glm::vec3
        base_normal;  // unit interpolated normal of the base mesh: the direction that displaces the point
};

struct SurfaceTexel {
    std::int32_t x, y;   // texel of the map
    float distance;      // from the ball's centre to S at the texel's centre, world units
    glm::vec3 position;  // of S at the texel's centre
    glm::vec3 normal;    // unit interpolated base normal: the direction in which this texel displaces
    float bulge;         // of the base mesh as it is shaded, curved between its vertices, along the normal; world units

    // Where shading lets S appear.
    glm::vec3 shaded() const { return position + bulge * normal; }
};

// One texel that must hold the same value as another. At exact seams (both sides run along texel rows at one
// scale) the source is the same surface point in the island across the seam; beyond an open border it is the
// nearest texel inside. Where a seam runs through texel centres, the "gutter" may itself be a border texel of
// the other island.
struct SeamCopy {
    std::uint32_t gutter;  // texel index y * width + x
    std::uint32_t source;  // texel index, owned by a triangle
};

// One equation "height on side A = height on side B" at a point of a slanted or scaled seam (every pair of
// bilinear cells that the seam runs through needs one, and every half texel of the finer side): the sum of
// weight * texel over the terms must be 0 (four bilinear taps a side, B's weights negative).
struct SeamEquation {
    std::uint32_t texel[8];
    float weight[8];
};

// A column of texels across an exact seam at which the texel rows bend or change their scale. Both gutters
// hold their copy and one shift, so that the two sides still agree to the count, and the slope passes from
// one to the other: seam_bends.h.
struct SeamBend {
    static constexpr std::int32_t kOne = 65536;  // the unit of the weights

    std::uint32_t inside[2];            // texel index: each side's texel at the border
    std::uint32_t gutter[2];            // beyond inside[k]; among the copies, of inside[1 - k]
    std::uint32_t ahead[2], behind[2];  // the inside texels of the neighbouring columns
    // shift = lean * (inside[0] - inside[1]) + the sum over k of bend[k] * (ahead[k] - behind[k])
    std::int32_t lean, bend[2];
};

// Where three islands meet whose seams have such columns up to the end: the three texels past the ends.
struct SeamCorner {
    std::uint32_t gutter[3];  // among the copies, all of one texel
    std::uint32_t bend[3];    // into the bends: the last column of the seam between the other two islands
    std::uint32_t inside[3];  // of gutter[k]'s island: its texel in the corner
    std::int32_t weight[3];   // of inside[k], of their sum: how much it has of the height at the vertex
};

// A texel that no triangle owns beside a seam that copies cannot make exact: what it holds until the
// equations are solved, a mean of owned texels whose weights add up to 1 (some may be negative).
struct SeamExtension {
    struct Source {
        std::uint32_t texel;
        float weight;
    };
    std::uint32_t texel;
    std::vector<Source> sources;
};

struct SeamTable {
    std::vector<SeamCopy> copies;           // sorted by source; a gutter appears once, never as a source
    std::vector<SeamEquation> equations;    // along every seam that copies cannot make exact
    std::vector<SeamBend> bends;            // no equation reads their gutters, nor the corners'
    std::vector<SeamCorner> corners;        // a bend is of one corner at most
    std::vector<SeamExtension> extensions;  // sorted by texel; of texels that are not among the copies
};

class Surface {
  public:
    virtual ~Surface() = default;

    // The point of S at barycentrics (1-b1-b2, b1, b2) of a face. Requires face < face_count().
    virtual SurfacePoint at(std::uint32_t face, float b1, float b2) const = 0;
    virtual std::uint32_t face_count() const = 0;

    // Every texel whose centre lies in a triangle's texture footprint and whose point of S is nearer than
    // `radius` to `centre`, across islands, each once, sorted by (y, x): the same answer on every machine.
    // Appends nothing for a radius that is not positive and finite. `out` is cleared first.
    virtual void texels_in_ball(glm::vec3 centre, float radius, std::vector<SurfaceTexel>& out) const = 0;

    // The same with every place computed in double and rounded once: texels that mirror each other get places
    // that mirror each other. texels_in_ball is faster, and what journals without symmetry were recorded
    // with.
    virtual void precise_texels_in_ball(glm::vec3 centre, float radius,
                                        std::vector<SurfaceTexel>& out) const {
        texels_in_ball(centre, radius, out);
    }

    // The same texels without a list of all: calls visit(part) with one after the other, at most about
    // 100,000 in a part. As they stand here, all in one: for surfaces of few texels.
    using TexelVisitor = std::function<void(std::span<const SurfaceTexel>)>;
    virtual void visit_ball(glm::vec3 centre, float radius, const TexelVisitor& visit) const {
        std::vector<SurfaceTexel> all;
        texels_in_ball(centre, radius, all);
        visit(all);
    }
    virtual void visit_ball_precisely(glm::vec3 centre, float radius, const TexelVisitor& visit) const {
        std::vector<SurfaceTexel> all;
        precise_texels_in_ball(centre, radius, all);
        visit(all);
    }

    std::size_t count_in_ball(glm::vec3 centre, float radius) const {
        std::size_t texels = 0;
        visit_ball(centre, radius, [&](std::span<const SurfaceTexel> part) { texels += part.size(); });
        return texels;
    }

    // From the object's own space, in which symmetry has its planes and axes, to that of the positions.
    virtual glm::dmat4 world_from_object() const { return glm::dmat4(1.0); }

    // True where the texel's centre lies in a triangle's texture footprint, that is where texels_in_ball
    // could name it. As it stands: of a surface that covers its whole map.
    virtual bool owned(int /*x*/, int /*y*/) const { return true; }

    virtual const SeamTable& seams() const = 0;

    virtual float amplitude()
        const = 0;                       // world units from count 0 to count 65535; may be negative, may be 0
    virtual float midlevel() const = 0;  // of [0, 1]: the map value that does not displace
};

}  // namespace relievo
