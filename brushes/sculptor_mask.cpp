// The mask and its commands, each one undo step.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "brushes/mask_blur.h"
#include "brushes/sculptor_state.h"

namespace relievo {

void Sculptor::State::change_mask(const MaskChange& change, const Advance& advance) {
    constexpr double kChanged = 0.5;  // part of the time, about
    HeightMap changed = need_mask();
    change(changed, within(advance, 0, kChanged));
    seams.copy_all(changed);
    undo.push(*mask, changed, Layer::mask, within(advance, kChanged, 1));
    mask = std::move(changed);
    ++mask_revision;
}

void Sculptor::set_mask(HeightMap mask) {
    state_->require_stroke(false, "set_mask");
    if (mask.width() != state_->map.width() || mask.height() != state_->map.height())
        throw std::invalid_argument("the mask must have as many texels as the displacement map");
    state_->seams.copy_all(mask);
    state_->mask = std::move(mask);
    ++state_->mask_revision;
}

void Sculptor::clear_mask(const Advance& advance) {
    state_->require_stroke(false, "clear_mask");
    if (!state_->mask) return;
    state_->change_mask([](HeightMap& mask, const Advance&) { std::ranges::fill(mask.texels(), std::uint16_t{0}); }, advance);
}

void Sculptor::invert_mask(const Advance& advance) {
    state_->require_stroke(false, "invert_mask");
    const auto invert = [](HeightMap& mask, const Advance&) {
        for (std::uint16_t& texel : mask.texels()) texel = static_cast<std::uint16_t>(65535 - texel);
    };
    state_->change_mask(invert, advance);
}

void Sculptor::blur_mask(const Advance& advance) {
    state_->require_stroke(false, "blur_mask");
    if (!state_->mask) return;
    constexpr int kRounds = 4;
    const auto blur = [this](HeightMap& mask, const Advance& all) {
        for (int round = 0; round < kRounds; ++round) {
            blur_once(mask, state_->surface, state_->seams, within(all, round / double{kRounds}, (round + 1) / double{kRounds}));
            state_->seams.copy_all(mask);
        }
    };
    state_->change_mask(blur, advance);
}

const HeightMap* Sculptor::mask() const {
    return state_->mask ? &*state_->mask : nullptr;
}
std::uint64_t Sculptor::mask_revision() const {
    return state_->mask_revision;
}

}  // namespace relievo
