// How far a piece of work is that may take long, and whether it is to go on.
#pragma once

#include <functional>
#include <stdexcept>

namespace relievo {

// Told now and then which part is done, [0, 1], on the thread that asked for the work. False stops it: it throws Stopped,
// and what was there before it stays as it was.
using Advance = std::function<bool(double part)>;

struct Stopped : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace relievo
