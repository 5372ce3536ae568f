// What each method is held to, and where it is known not to hold it.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/judge/image_comparison.h"
#include "renderer/stability/stability_case.h"

namespace relievo::stability {

// Every method, also one that is not named here, is held to be sound: no crash, nothing that is not finite,
// no more steps than it states, every answer within a time.
struct Promise {
    std::string_view method;
    std::map<std::string, double> parameters{};  // that it is run with; the rest are the registry's defaults
    bool right = false;                        // on every case that float can represent (right_failures)
    bool near = false;                         // on the same cases (near_failures)
    bool may_refuse = false;                   // in words, what would take too much memory
    bool sampled = false;                      // on smooth cases (sampled_failures)
};
Promise promise_of(std::string_view method);

// One sentence for each limit that is broken; empty: all are kept. Depth errors are told in the unit that
// they were compared in (float_floor.h).
std::vector<std::string> right_failures(const ImageComparison& errors);
std::vector<std::string> near_failures(const ImageComparison& errors);
std::vector<std::string> sampled_failures(const ImageComparison& errors, Sampled held_to);

// A case that a method is known to get wrong, although it promises otherwise. To be removed when it no longer
// does: a listed case that passes is reported as stale.
struct KnownLimit {
    std::string_view method, name;  // of the case
    int most_wrong;  // unexplained pixels and rays over all views: with more, it is wrong all the same
    std::string_view reason;
};
std::span<const KnownLimit> known_limits();
const KnownLimit* find_known_limit(std::string_view method, std::string_view name);  // nullptr: none

}  // namespace relievo::stability
