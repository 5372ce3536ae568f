// The base mesh and its prisms as lines on screen: each triangle's edges, and the shell over it between the
// least and the greatest height of its part of the map.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "editor/gui/window.h"
#include "editor/session/session.h"
#include "renderer/scene/mesh_topology.h"

namespace relievo::gui {

struct OverlayLine {
    enum class Kind { base, cap, side } kind;  // cap: the prism's lower or upper triangle
    glm::dvec2 a, b;                           // pixels of the picture
    float nearness;                            // 1 at the nearest of what is shown, 0 at the farthest
};

struct PrismView {
    std::vector<OverlayLine> lines;
    std::string note;  // what was left out; empty: nothing
};

// What is drawn of a large mesh.
struct PrismLimits {
    std::size_t edges = 24000, prisms = 600;  // an object
    double near_px = 130;                     // beyond a limit, what is so close to the pointer
};

class PrismLines {
  public:
    // Reads bounds and edges where the map or the displacement has changed; not in a stroke.
    void follow(const Session& session);
    // Triangles of closed meshes that face away are left out. `pointer`: pixels of the picture.
    PrismView view(const Scene& scene, PixelSize picture, const std::optional<glm::dvec2>& pointer,
                   const PrismLimits& limits) const;

  private:
    struct Object {
        MeshTopology topology;
        bool closed = true;
        std::vector<glm::vec2> range;  // of each face: displacement low, high
    };
    struct Shown;
    // The faces that are shown; measures how near and far they are.
    std::vector<std::uint32_t> facing(const Object& object, const Mesh& mesh, Shown& shown) const;

    std::vector<Object> objects_;
    std::optional<std::uint64_t> revision_;
    double amplitude_ = 0, midlevel_ = 0;
};

}  // namespace relievo::gui
