// How far a piece of work is that may take long, and whether it is to go on.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace relievo {

// Told now and then which part is done, [0, 1], on the thread that asked for the work. False stops it: it throws Stopped,
// and what was there before it stays as it was.
using Advance = std::function<bool(double part)>;

struct Stopped : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// What Stopped says of a file that was being written.
inline std::string not_written(const std::string& path) {
    return "Stopped: nothing was written to '" + path + "'";
}

// Tells it, if there is anyone to tell. `stopped`: what Stopped says.
inline void tell(const Advance& advance, double part, const std::string& stopped) {
    if (advance && !advance(part)) throw Stopped(stopped);
}

// For a piece that makes up [begin, end] of the whole.
inline Advance within(const Advance& advance, double begin, double end) {
    if (!advance) return {};
    return [advance, begin, end](double part) { return advance(begin + (end - begin) * part); };
}

}  // namespace relievo
