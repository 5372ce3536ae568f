// Which texels must hold one value: disjoint sets with a trail, so that a guess can be taken back.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace relievo {

class OwnedTexels;

class TexelClasses {
  public:
    explicit TexelClasses(const OwnedTexels& owned);

    // The texel that stands for the class of `texel`: an owned one where the class has one.
    std::uint32_t root(std::uint32_t texel) const;
    bool owned(std::uint32_t texel) const;

    // Makes one class of two. The root that is owned stays the root; of two alike, the lower one.
    void join(std::uint32_t a, std::uint32_t b);

    std::size_t mark() const { return trail_.size(); }
    void roll_back(std::size_t mark);  // takes back every join since mark()

    // Every texel that is not its class's root, with the root; unsorted.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> members() const;

  private:
    struct Slot {
        std::uint32_t texel, parent;
    };
    std::size_t find(std::uint32_t texel) const;  // its slot, or the free one where it would go
    void set_parent(std::uint32_t texel, std::uint32_t parent);
    void grow();

    const OwnedTexels& owned_;
    std::vector<Slot> slots_;  // open addressing, a power of two; a texel that is absent is its own parent
    std::size_t used_ = 0;
    std::vector<std::uint32_t> trail_;  // texels that got a parent, in order
};

}  // namespace relievo
