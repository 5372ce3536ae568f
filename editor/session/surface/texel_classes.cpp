#include "editor/session/surface/texel_classes.h"

#include <utility>

#include "editor/session/surface/owned_texels.h"

namespace relievo {
namespace {

constexpr std::uint32_t kFree = ~std::uint32_t{0};  // no texel: the largest map has 2^28

}  // namespace

TexelClasses::TexelClasses(const OwnedTexels& owned) : owned_(owned), slots_(1024, {kFree, kFree}) {}

bool TexelClasses::owned(std::uint32_t texel) const {
    return owned_(texel);
}

std::size_t TexelClasses::find(std::uint32_t texel) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = (texel * std::uint64_t{0x9E3779B97F4A7C15} >> 32) & mask;
    while (slots_[at].texel != kFree && slots_[at].texel != texel) at = (at + 1) & mask;
    return at;
}

std::uint32_t TexelClasses::root(std::uint32_t texel) const {
    for (;;) {
        const Slot& slot = slots_[find(texel)];
        if (slot.texel == kFree || slot.parent == texel) return texel;
        texel = slot.parent;
    }
}

void TexelClasses::grow() {
    std::vector<Slot> old(slots_.size() * 2, {kFree, kFree});
    old.swap(slots_);
    for (const Slot& slot : old) {
        if (slot.texel != kFree) slots_[find(slot.texel)] = slot;
    }
}

void TexelClasses::set_parent(std::uint32_t texel, std::uint32_t parent) {
    if (used_ * 2 >= slots_.size()) grow();
    Slot& slot = slots_[find(texel)];
    if (slot.texel == kFree) ++used_;
    slot = {texel, parent};
}

void TexelClasses::join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    const bool a_stays = owned(a) == owned(b) ? a < b : owned(a);
    if (!a_stays) std::swap(a, b);
    set_parent(b, a);
    trail_.push_back(b);
}

void TexelClasses::roll_back(std::size_t mark) {
    for (; trail_.size() > mark; trail_.pop_back()) set_parent(trail_.back(), trail_.back());
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> TexelClasses::members() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> members;
    members.reserve(trail_.size());
    for (const std::uint32_t texel : trail_) members.emplace_back(texel, root(texel));
    return members;
}

}  // namespace relievo
