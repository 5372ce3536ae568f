// Small wordings that messages share.
#pragma once

#include <string>

namespace relievo {

// The shortest digits that give the value back, as a float where it is one.
std::string number_text(double value);

// "in [0, 1]", or "at least 1" where the upper bound is beyond any sensible value.
std::string range_text(double low, double high);

}  // namespace relievo
