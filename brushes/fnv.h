// The 64-bit FNV-1a hash (Fowler, Noll, Vo), by which journals recognise maps.
#pragma once

#include <cstddef>
#include <cstdint>

namespace relievo {

class Fnv1a64 {
  public:
    template <typename Unsigned>
    void add_little_endian(Unsigned value) {
        for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
            state_ ^= static_cast<std::uint8_t>(value >> (8 * i));
            state_ *= 0x100000001b3ull;
        }
    }
    std::uint64_t value() const { return state_; }

  private:
    std::uint64_t state_ = 0xcbf29ce484222325ull;
};

}  // namespace relievo
