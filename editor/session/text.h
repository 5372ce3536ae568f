// Small wordings that messages share.
#pragma once

#include <cstdint>
#include <string>

namespace relievo {

// The shortest digits that give the value back, as a float where it is one.
std::string number_text(double value);

// "in [0, 1]", or "at least 1" where the upper bound is beyond any sensible value.
std::string range_text(double low, double high);

// As printf, cut at 255 letters.
std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));

std::string bytes_text(std::uint64_t bytes);  // "640 bytes", "383 kB", "9.8 MB", "1.2 GB"

}  // namespace relievo
