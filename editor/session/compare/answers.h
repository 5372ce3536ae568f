// What the points of a scene say together: which is the most exact, how methods' times compare at equal
// error, and which points no other beats in both.
#pragma once

#include <vector>

#include "editor/session/compare/result.h"

namespace relievo {

// Fewest wrong or far-off pixels, in thousandths of all, then the least p99.9 and p99 depth error. At least
// one point.
std::size_t most_exact_point(const std::vector<ComparedPoint>& points);

// The coarsest of a method's points whose p99.9 depth error is within a hundredth of its least; null: it has
// none.
const ComparedPoint* best_point(const std::vector<ComparedPoint>& points, const std::string& method);

// Fills `answers`: the method of the first point, which stands first in the registry, beside every other one.
void answer_speed(ComparedScene& scene);

// Median over the rounds of a's time over b's; 0 where one was not timed.
double time_ratio(const RoundTimes& a, const RoundTimes& b);

struct FrontPoint {
    double time, error;
};
// The indices of the points that no other beats in both, quickest first; errors within a hundredth are equal.
std::vector<std::size_t> best_front(const std::vector<FrontPoint>& points);

}  // namespace relievo
