// See paint_stroke.h.
#include "brushes/paint_stroke.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

#include "brushes/copy_changes.h"
#include "brushes/dab_trail.h"
#include "brushes/dab_work.h"
#include "brushes/pressed_image.h"
#include "brushes/shared_work.h"
#include "brushes/tile_rects.h"

namespace relievo {

PaintStroke::PaintStroke(const Brush& brush, const Alpha* alpha, ColourMap& map, const Seams& seams)
    : brush_(brush),
      alpha_(alpha),
      seams_(seams),
      piles_up_(holds(tool_set({Tool::clay, Tool::crease}), brush.tool) ||
                (brush.accumulate && brush.tool != Tool::level)),
      part_of_pass_(brush.tool == Tool::stamp ? 1.0f : brush.spacing / kUnitSpacing),
      colour_{brush.red * kTop, brush.green * kTop, brush.blue * kTop} {
    for (std::size_t k = 0; k < planes_.size(); ++k)
        planes_[k] = std::make_unique<StrokeTiles>(map.plane(k), map.step());
}

// Of two lists, each sorted by (y, x) and with each texel once, one such list with each texel's larger
// weight.
std::vector<PaintStroke::Weight> PaintStroke::merged(const std::vector<Weight>& a,
                                                     const std::vector<Weight>& b) {
    const auto before = [](const Weight& p, const Weight& q) {
        return p.y != q.y ? p.y < q.y : p.x != q.x ? p.x < q.x : p.of_way > q.of_way;
    };
    const auto same_texel = [](const Weight& p, const Weight& q) { return p.x == q.x && p.y == q.y; };
    std::vector<Weight> both;
    both.reserve(a.size() + b.size());
    std::merge(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both), before);
    both.erase(std::unique(both.begin(), both.end(), same_texel), both.end());
    return both;
}

// Sorted by (y, x), each texel once.
std::vector<PaintStroke::Weight> PaintStroke::weights(std::span<const Place> places, float pressure,
                                                      const HeightMap* mask, std::size_t at_once) const {
    std::mutex mutex;
    std::vector<std::vector<Weight>> lists;  // each more than twice as long as the next
    const auto merge_last_two = [&lists] {
        std::vector<Weight> last = std::move(lists.back());
        lists.pop_back();
        lists.back() = merged(lists.back(), last);
    };
    const auto of_place = [&](std::size_t i) {
        const Place& place = places[i];
        const glm::vec3 centre = place.centre.position;
        std::optional<PressedImage> image;
        std::vector<Weight> own;
        const DabTrail trail(centre, piles_up_ || alpha_ ? glm::vec3(0) : place.motion, place.radius);
        const auto weigh = [&](std::span<const SurfaceTexel> texels) {
            for (const SurfaceTexel& t : texels) {
                const float distance = trail.is_point() ? t.distance : trail.distance(t.position);
                if (!(distance < place.radius)) continue;
                const float falloff = falloff_weight(brush_, std::min(distance / place.radius, 1.0f));
                const float free = mask ? 1.0f - static_cast<float>(mask->at(t.x, t.y)) / kTop : 1.0f;
                const float shown = image ? std::clamp(image->at(t), 0.0f, 1.0f) : 1.0f;
                const float weight = brush_.strength * pressure * falloff * free * shown;
                if (weight > 0.0f) own.push_back({t.x, t.y, weight});
            }
        };
        if (alpha_) {  // the image wants to know first how many there are
            std::vector<SurfaceTexel> texels;
            place.surface.texels_in_ball(centre, place.radius, texels);
            image.emplace(*alpha_, place.centre, place.radius, place.right, brush_.rotation, texels.size());
            weigh(texels);
        } else {
            place.surface.visit_ball(trail.middle(), trail.reach(place.radius), weigh);
        }
        const std::lock_guard lock(mutex);
        lists.push_back(std::move(own));
        while (lists.size() > 1 && lists[lists.size() - 2].size() <= 2 * lists.back().size())
            merge_last_two();
    };
    share_work(places.size(), of_place, at_once);
    while (lists.size() > 1) merge_last_two();
    return std::move(lists.front());
}

void PaintStroke::smooth_planes(std::span<const Place> places, float pressure, const HeightMap* mask,
                                std::size_t at_once) {
    // The texels of a place are looked for once for the three channels, which do not move the surface.
    std::array<std::optional<CopyChanges>, 3> wanted;
    for (std::size_t k = 0; k < planes_.size(); ++k)
        wanted[k].emplace(places.size(), false, *planes_[k], CopyChanges::kWaiting / planes_.size());
    const auto work_out = [&](std::size_t i) {
        const Place& place = places[i];
        std::shared_ptr<Hold> nothing_held;
        const DabPlace at{place.centre, pressure, place.radius, glm::vec3(0),
                          glm::vec3(0), 1.0f,     nothing_held};
        const SmoothedBall ball = smoothed_ball(place.surface, place.centre.position, place.radius);
        for (std::size_t k = 0; k < planes_.size(); ++k) {
            std::vector<TexelChange> changes;
            smooth({brush_, at, place.surface, seams_, *planes_[k], mask, 1.0, changes}, ball);
            wanted[k]->add(i, std::move(changes));
        }
    };
    share_work(places.size(), work_out, at_once);
    for (std::size_t k = 0; k < planes_.size(); ++k) {
        wanted[k]->apply();
        seams_.follow(*planes_[k], Across::values);
    }
}

void PaintStroke::dab(std::span<const Place> places, float pressure, const HeightMap* mask,
                      std::size_t at_once) {
    if (brush_.tool == Tool::smooth) return smooth_planes(places, pressure, mask, at_once);
    const std::vector<Weight> weights = this->weights(places, pressure, mask, at_once);
    for (std::size_t k = 0; k < planes_.size(); ++k) {
        StrokeTiles& plane = *planes_[k];
        for (const Weight& w : weights) {
            const float before = static_cast<float>(plane.before(w.x, w.y)), change = plane.change(w.x, w.y);
            if (piles_up_) {
                const float part = std::min(w.of_way * part_of_pass_, 1.0f);
                const float step = (colour_[k] - (before + change)) * part;
                if (step != 0.0f) plane.set_change(w.x, w.y, change + step);
            } else {
                const float wanted = (colour_[k] - before) * w.of_way;
                if (std::abs(wanted) > std::abs(change)) plane.set_change(w.x, w.y, wanted);
            }
        }
        seams_.follow(plane, Across::values);
    }
}

void PaintStroke::settle(const HeightMap* mask) {
    for (auto& plane : planes_) seams_.settle(*plane, Across::values, mask);
}

std::vector<TexelRect> PaintStroke::take_dirty() {
    std::vector<TexelRect> rects;
    for (auto& plane : planes_)
        for (const TexelRect& rect : plane->take_dirty()) rects.push_back(rect);
    return joined_by_tile(rects, planes_[0]->grid());
}

std::vector<TexelRect> PaintStroke::restore() {
    std::vector<TexelRect> rects;
    for (auto& plane : planes_)
        for (const TexelRect& rect : plane->restore())
            if (!rect.empty()) rects.push_back(rect);
    return joined_by_tile(rects, planes_[0]->grid());
}

}  // namespace relievo
