// The tools that carry the relief along the surface: pinch, crease, smear, grab. Each texel asks where its
// relief comes from, in its own tangent plane, and reads it there (brushes/relief.h).
//
// Displaced positions say which texels a dab reaches and how far it moves them; places on the base mesh say
// what lies where, so that steep relief does not tear what is read.
#include <cmath>
#include <glm/geometric.hpp>

#include "brushes/dab_work.h"
#include "brushes/relief.h"

namespace relievo {
namespace {

glm::vec3 along_surface(glm::vec3 v, glm::vec3 normal) {
    return v - normal * glm::dot(v, normal);
}

// How much the texel's value changes when the relief at `from` comes to it.
float carried(const Relief& relief, glm::vec3 base, glm::vec3 from, const SurfaceTexel& texel, float value) {
    const auto found = relief.at(base + from, texel.normal);
    return found ? static_cast<float>(*found) - value : 0.0f;
}

// The fraction of its distance to the centre from further out that a texel's relief comes from.
float pinch_part(const Work& work, const SurfaceTexel& texel, float much) {
    return much * work.sign() * kPinch * work.weight_of_step(texel);
}

}  // namespace

void pinch(const Work& work) {
    const Relief relief(work, (1.0f + kPinch) * work.place.radius);
    in_ball(work, [&](const Work& part, const SurfaceTexel& texel) {
        const float inwards = pinch_part(part, texel, 1.0f);
        if (inwards == 0.0f || part.is_back(texel)) return;
        const glm::vec3 out = along_surface(texel.position - part.place.centre.position, texel.normal);
        const float step = carried(relief, base_of(part, texel), inwards * out, texel, part.value(texel));
        part.change_to(texel, part.change(texel) + step);
    });
}

void crease(const Work& work) {
    constexpr float kPinchPart = 0.5f;
    const Relief relief(work, (1.0f + kPinch) * work.place.radius);
    const float depth =
        work.counts(double{kDrawRise} * double{work.place.radius} * double{work.brush.spacing}) *
        -work.sign();
    in_ball(work, [&](const Work& part, const SurfaceTexel& texel) {
        const float weight = part.weight(texel), falloff = part.falloff(texel);
        if (weight == 0.0f || part.is_back(texel)) return;
        const glm::vec3 out = along_surface(texel.position - part.place.centre.position, texel.normal);
        // Either way the banks come in.
        const float inwards = std::abs(pinch_part(part, texel, kPinchPart));
        const float step = carried(relief, base_of(part, texel), inwards * out, texel, part.value(texel));
        part.change_to(texel, part.change(texel) + step + depth * weight * falloff * falloff);
    });
}

void smear(const Work& work) {
    const glm::vec3 motion = work.place.motion;
    const float way = glm::length(motion);
    if (!(way > 0.0f)) return;
    const Relief relief(work, work.place.radius + way);
    in_ball(work, [&](const Work& part, const SurfaceTexel& texel) {
        const float weight = part.weight(texel);
        if (weight == 0.0f || part.is_back(texel)) return;
        const glm::vec3 back = -weight * along_surface(motion, texel.normal);
        const float step = carried(relief, base_of(part, texel), back, texel, part.value(texel));
        part.change_to(texel, part.change(texel) + step);
    });
}

// What the hand holds: the footprint and its relief as they were when it took hold. The surface stays a
// height over the base mesh and cannot fold, so a texel's relief comes from where x + w(x) * drag is the
// texel. Beyond half a radius the hand takes hold anew.
struct Hold {
    struct Texel {
        SurfaceTexel texel;
        float change;
    };
    Hold(const Work& work, glm::vec3 at, glm::vec3 the_drag)
        : centre(at), drag(the_drag), relief(work, at, 2.2f * work.place.radius) {
        const float reach = 1.6f * work.place.radius;
        texels.reserve(work.surface.count_in_ball(at, reach));
        work.surface.visit_ball(at, reach, [&](std::span<const SurfaceTexel> found) {
            for (const SurfaceTexel& t : found)
                if (!work.is_back(t)) texels.push_back({t, work.change(t)});
        });
    }

    glm::vec3 centre, drag, last_drag{0};  // the hand's when it took hold
    bool spent = false;                    // the next dab takes hold anew, of the surface as this one left it
    Relief relief;
    std::vector<Texel> texels;
};

namespace {

// The part w of the drag that came to a texel: w is that of the held point at x - w * drag. Halving finds an
// answer whatever the falloff, also where hardness makes it steep and several points come to one place.
float followed(const Work& work, const Hold& hold, const SurfaceTexel& texel, glm::vec3 tangent) {
    constexpr int kHalvings = 20;
    const auto weight_at = [&](float part) {
        SurfaceTexel there = texel;
        there.distance = glm::length(texel.position - part * tangent - hold.centre);
        return there.distance < work.place.radius ? work.weight(there) : 0.0f;
    };
    float low = 0.0f, high = work.brush.strength * work.place.pressure * work.place.share;
    if (weight_at(0.0f) == 0.0f && weight_at(high) == 0.0f) return 0.0f;
    for (int i = 0; i < kHalvings; ++i) {
        const float middle = 0.5f * (low + high);
        (weight_at(middle) > middle ? low : high) = middle;
    }
    return weight_at(0.5f * (low + high));
}

}  // namespace

void grab(const Work& work) {
    constexpr float kNewHold = 0.5f;  // of the radius
    std::shared_ptr<Hold>& hold = work.place.hold;
    if (!hold) hold = std::make_shared<Hold>(work, work.place.centre.position, work.place.drag);
    if (hold->spent) {
        const glm::vec3 way = hold->last_drag - hold->drag;
        const glm::vec3 centre = hold->centre + work.brush.strength * work.place.pressure * way;
        hold = std::make_shared<Hold>(work, centre, hold->last_drag);
    }
    const glm::vec3 drag = work.place.drag - hold->drag;
    in_blocks(work, hold->texels.size(), [&](const Work& part, std::size_t i) {
        const Hold::Texel& held = hold->texels[i];
        const glm::vec3 tangent = along_surface(drag, held.texel.normal);
        const float weight = followed(part, *hold, held.texel, tangent);
        float to = held.change;
        if (weight > 0.0f) {
            const float lift = part.counts(double{weight} * double{glm::dot(drag, held.texel.normal)});
            const float before = static_cast<float>(part.stroke.before(held.texel.x, held.texel.y));
            const float value = before + held.change;
            const glm::vec3 base = base_of(part, held.texel, value);
            to += lift + carried(hold->relief, base, -weight * tangent, held.texel, value);
        }
        if (to != part.change(held.texel))
            part.changes.push_back({held.texel.x, held.texel.y, held.change, to});
    });
    hold->last_drag = work.place.drag;
    hold->spent = glm::length(drag) >= kNewHold * work.place.radius;
}

}  // namespace relievo
