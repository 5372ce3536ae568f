// See image_comparison.h.
#include "renderer/judge/image_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace relievo {

ErrorRanks rank_errors(std::vector<double> errors) {
    if (errors.empty()) return {};
    std::sort(errors.begin(), errors.end());
    const auto at = [&](double part) {
        return errors[static_cast<std::size_t>(part * static_cast<double>(errors.size() - 1))];
    };
    return {at(0.5), at(0.99), at(0.999), errors.back()};
}

ViewAngle view_angle(double cosine) {
    const double size = std::abs(cosine);
    return size < 0.2 ? ViewAngle::grazing : size <= 0.8 ? ViewAngle::slanted : ViewAngle::facing;
}

std::string ImageComparison::text() const {
    char line[512];
    std::snprintf(
        line, sizeof line,
        "%d hit; away from silhouettes %d missed, %d invented, %d off; at them %d missed, %d invented; %d "
        "unexplained; %d not finite; depth median %.1e p99 %.1e p99.9 %.1e, away p99 %.1e p99.9 %.1e max "
        "%.1e; normal median %.3f p99 %.2f deg",
        both, missed, invented, off, silhouette_missed, silhouette_invented, unexplained, not_finite,
        depth.median, depth.p99, depth.p999, depth_away.p99, depth_away.p999, depth_away.most,
        normal_deg.median, normal_deg.p99);
    std::string result = line;
    const auto list = [&](const std::vector<OffPixel>& pixels, const char* which) {
        for (const OffPixel& pixel : pixels) {
            const char* const kinds[] = {"missed", "invented", "off"};
            std::snprintf(line, sizeof line, "\n    %s%s at (%d, %d): reference %.7g, method %.7g", which,
                          kinds[static_cast<int>(pixel.kind)], pixel.x, pixel.y, pixel.reference,
                          pixel.method);
            result += line;
        }
    };
    list(examples, "");
    list(unexplained_examples, "unexplained: ");
    return result;
}

}  // namespace relievo
