// A brush's falloff drawn by hand: its weight at a few points from the brush's middle to its rim, and in
// between the monotone cubic of F. N. Fritsch and J. Butland, "A method for constructing local monotone
// piecewise cubic interpolants", SIAM J. Sci. Stat. Comput. 5(2), 1984. It never leaves the range of the two
// points that it lies between, so that a curve of weights is one of weights. Slopes at both ends are the
// three-point estimate, limited so that this holds there too (as PCHIP does it).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace relievo {

struct CurvePoint {
    float part;    // of the radius beyond the hardness, [0, 1]: 0 is the middle, 1 the rim
    float weight;  // [0, 1]
    bool operator==(const CurvePoint&) const = default;
};

class FalloffCurve {
  public:
    static constexpr std::size_t kFewest = 2, kMost = 8;  // points
    static constexpr float kLeastStep = 1.0f / 128;       // from point to point

    FalloffCurve();  // as the smooth falloff, but for less than 0.02

    // Points from the middle (part 0) to the rim (part 1). Throws std::invalid_argument where check() finds
    // anything.
    explicit FalloffCurve(std::span<const CurvePoint> points);

    // What is wrong with `points`, and of which: empty where they make a curve.
    struct Fault {
        std::size_t point;
        std::string what;  // "must ..."
    };
    static std::optional<Fault> check(std::span<const CurvePoint> points);

    std::span<const CurvePoint> points() const { return {points_.data(), count_}; }
    float weight(float part) const;  // part in [0, 1]

    // For drawing it by hand, on a grid of kLeastStep, so that journals stay short. Moves a point as near to
    // `wanted` as its neighbours allow; the first and the last keep their part. Requires point <
    // points().size().
    void move(std::size_t point, CurvePoint wanted);
    // A new point beside the curve's own weight at `part`; which it is. Empty where there is no room for one,
    // or where there are kMost.
    std::optional<std::size_t> add(float part);
    // Does nothing to the first and the last.
    void remove(std::size_t point);

    bool operator==(const FalloffCurve&) const = default;

  private:
    float slope(std::size_t point) const;

    std::array<CurvePoint, kMost> points_{};  // those beyond count_ are all 0
    std::size_t count_ = 0;
};

}  // namespace relievo
