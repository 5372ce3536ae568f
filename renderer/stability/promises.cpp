// See promises.h.
#include "renderer/stability/promises.h"

#include <algorithm>
#include <cstdio>

namespace relievo::stability {
namespace {

// DESIGN.md section 8, and the limits of the method `exact`.
constexpr double kMedian = 1e-5, kP99 = 1e-4, kNormalDeg = 0.2;

std::string sentence(const char* what, double value, double limit) {
    char line[160];
    std::snprintf(line, sizeof line, "%s %.3g, at most %.3g is promised", what, value, limit);
    return line;
}

void hold(std::vector<std::string>& failures, const char* what, double value, double limit) {
    if (!(value <= limit)) failures.push_back(sentence(what, value, limit));
}

}  // namespace

Promise promise_of(std::string_view method) {
    if (method == "exact") return {method, {}, true, false};
    if (method == "pdm") return {method, {{"dt", 0.001}, {"jitter", 0}}, false, true};
    return {method, {}, false, false};
}

std::vector<std::string> right_failures(const ImageComparison& errors) {
    std::vector<std::string> failures;
    hold(failures, "missed away from silhouettes:", errors.missed, 0);
    hold(failures, "invented away from silhouettes:", errors.invented, 0);
    hold(failures, "pixels that no neighbouring ray explains:", errors.unexplained, 0);
    hold(failures, "median of the depth error", errors.depth.median, kMedian);
    hold(failures, "p99 of the depth error away from silhouettes", errors.depth_away.p99, kP99);
    hold(failures, "median of the normal's angle in degrees", errors.normal_deg.median, kNormalDeg);
    return failures;
}

std::vector<std::string> sampled_failures(const ImageComparison& errors, Sampled held_to) {
    std::vector<std::string> failures;
    if (held_to == Sampled::known_flaw) hold(failures, "median of the depth error", errors.depth.median, 0.1);
    if (held_to != Sampled::within_limits) return failures;
    hold(failures, "missed away from silhouettes:", errors.missed, 3);
    hold(failures, "invented away from silhouettes:", errors.invented, 3);
    hold(failures, "median of the depth error", errors.depth.median, 1e-3);
    return failures;
}

std::span<const KnownLimit> known_limits() {
    static constexpr std::string_view kFolded = "one sheet of several inside the triangle is followed",
                                      kSteep = "normals are held to a least cosine to the triangle's own",
                                      kSingle = "single pixels or rays, cause not known";
    static constexpr KnownLimit kLimits[] = {
        {"exact", "folded_shell", 276, kFolded},
        {"exact", "folded_shell_flat", 16, kFolded},
        {"exact", "folded_shell_cliffs", 165, kFolded},
        {"exact", "ten_edges_on_lump", 242, kFolded},
        {"exact", "minus_ten_edges_on_lump", 302, kFolded},
        {"exact", "lump_carved", 16, kFolded},
        {"exact", "crease_4_degrees", 60, kSteep},
        {"exact", "crease_half_degree", 378, kSteep},
        {"exact", "blade_2_degrees", 748, kSteep},
        {"exact", "blade_high", 3058, kSteep},
        {"exact", "non_manifold_edge", 1274, kSteep},
        {"exact", "normal_at_85_degrees", 90, kSteep},
        {"exact", "normal_at_right_angle", 186, kSteep},
        {"exact", "normals_near_right_angle", 852, kSteep},
        {"exact", "normal_backwards", 774, kSteep},
        {"exact", "normals_backwards", 10364, kSteep},
        {"exact", "leaning_on_ball", 63, kSteep},
        {"exact", "cliffs_on_lump", 5, kSingle},
        {"exact", "noise_on_lump", 4, kSingle},
        {"exact", "fur_on_lump", 3, kSingle},
        {"exact", "flat_low_on_lump", 3, kSingle},
        {"exact", "flat_high_on_lump", 3, kSingle},
        {"exact", "open_borders_on_lump", 4, kSingle},
        {"exact", "zero_area_faces", 20, kSingle},
        {"exact", "flat_high_on_ball", 3, kSingle},
        {"exact", "minus_ten_edges_on_ball", 3, kSingle},
        {"exact", "one_by_4096", 3, kSingle},
        {"exact", "8192_by_one", 5, kSingle},
        {"exact", "rays_at_plane", 3, kSingle},
        {"exact", "rays_at_ball", 5, kSingle},
        {"exact", "rays_at_lump", 8, kSingle},
        {"exact", "rays_at_cliffs", 3, kSingle},
        {"exact", "rays_at_spikes", 3, kSingle},
    };
    return kLimits;
}

const KnownLimit* find_known_limit(std::string_view method, std::string_view name) {
    const auto limits = known_limits();
    const auto found = std::find_if(limits.begin(), limits.end(), [&](const KnownLimit& l) {
        return l.method == method && l.name == name;
    });
    return found == limits.end() ? nullptr : &*found;
}

}  // namespace relievo::stability
