// The statistics of a method's layers Z and N against the reference's.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

// Rank statistics of a set of errors; 0 for an empty set.
struct ErrorRanks {
    double median = 0, p99 = 0, p999 = 0, most = 0;
};

ErrorRanks rank_errors(std::vector<double> errors);

// |cos| of the angle between the ray and the surface's normal: the reference's, or the method's own where it
// alone hits.
enum class ViewAngle { grazing, slanted, facing };
constexpr std::array<std::string_view, 3> kViewAngleNames{"|cos| < 0.2", "0.2 to 0.8", "|cos| > 0.8"};
ViewAngle view_angle(double cosine);

// Depth errors are |Z - reference| over the unit of the object that the reference hits (error_units.h).
struct PixelErrors {
    int both = 0;                  // pixels that both hit
    int missed = 0, invented = 0;  // away from silhouettes
    int silhouette_missed = 0, silhouette_invented = 0;
    int off = 0;            // depth off by more than a hundredth of the unit, away from silhouettes
    ErrorRanks depth;       // over all pixels that both hit
    ErrorRanks depth_away;  // the same away from silhouettes
    ErrorRanks normal_deg;  // angle between N and the reference's
};

struct OffPixel {
    enum class Kind { missed, invented, depth } kind;
    int x, y;
    double reference, method;  // depths
};

struct ImageComparison : PixelErrors {
    std::array<PixelErrors, 3> by_angle;  // by ViewAngle
    int not_finite =
        0;  // pixels whose depth is NaN or -infinity, or whose normal or depth is not finite at a hit
    int unexplained = 0;  // see Judge::count_unexplained
    std::vector<OffPixel> unexplained_examples;
    std::vector<OffPixel> examples;  // away from silhouettes, the first of every kind

    std::string text() const;
};

}  // namespace relievo
