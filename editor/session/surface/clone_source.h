// Where the clone tool takes its relief from: a point that the user sets, and that moves along with the
// stroke.
#pragma once

#include <array>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "brushes/brush.h"
#include "editor/session/surface/mesh_surface.h"

namespace relievo {

class CloneSource {
  public:
    struct Place {
        FacePoint point;
        std::array<std::int32_t, 3> turn;  // as Dab::drag has it
    };

    void set(const FacePoint& source);
    bool is_set() const { return source_.has_value(); }

    // `aligned`: a later stroke goes on with the offset of the first one after set(); else every stroke
    // begins at the point that was set. cancel() forgets what begin() to now has settled.
    void begin(bool aligned);
    void cancel() { start_ = start_before_; }

    // Of a dab at `target`: the stroke's first settles the offset. From there on the source is the point of
    // the base mesh nearest to where the rigid movement from the first target to the first source takes the
    // dab's base point. Requires is_set().
    Place at(const MeshSurface& surface, const FacePoint& target);
    // The same, without settling anything: what a dab there would take.
    Place foreseen(const MeshSurface& surface, const FacePoint& target) const;

  private:
    struct Start {  // of the movement; places on the base mesh
        glm::dvec3 target, source;
        glm::dquat turn;
    };
    Start start_at(const MeshSurface& surface, const FacePoint& target) const;

    std::optional<FacePoint> source_;
    std::optional<Start> start_, start_before_;
};

}  // namespace relievo
