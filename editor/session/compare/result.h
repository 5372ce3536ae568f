// What a comparison of methods found: scenes, points (a method with its parameters), and the answers drawn
// from them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/features.h"
#include "renderer/judge/edge_gap.h"
#include "renderer/judge/image_comparison.h"

namespace relievo {

// Times of interleaved rounds, milliseconds, in the order of the rounds.
struct RoundTimes {
    std::vector<double> wall, device;  // device: the device's own clock; zeros where it has none
};
struct Spread {
    double median = 0, p10 = 0, p90 = 0;
};
Spread spread_of(std::vector<double> values);  // zeros for none

struct RayCost {  // means over all pixels' primary rays
    double boxes = 0, steps = 0, fetches = 0, cells = 0;
};

// Against the beauty of the scene's most exact point.
struct ImageError {
    double rmse = 0;           // of linear RGB
    double dissimilarity = 0;  // 1 - SSIM, see image_error.h
};

struct EditTimes {                             // milliseconds, medians
    double upload = 0, bounds = 0, refit = 0;  // `upload` is the whole call, the others are parts of it
    double first_frame_extra = 0;              // of the first primary frame after it, over the one before it
    int texels = 0;                            // of the edited rectangle
};

struct ComparedPoint {
    std::string method;
    std::map<std::string, double> swept;  // the parameters that are swept, with the values tried
    std::string label;                    // "pdm dt 0.002"

    ImageComparison errors;
    EdgeGap gap;
    RayCost cost;
    ImageError image;
    RoundTimes primary;  // the layers: one ray through each pixel's centre, and its normals
    RoundTimes preview;  // beauty as the window shows it: primary rays and one hard shadow ray a light
    std::optional<EditTimes> edit;
    double build_ms = 0;        // scene to device: buffers, bounds, structures
    double first_frame_ms = 0;  // with what the driver compiles at first use
    std::uint64_t bytes = 0;    // built before anything is traced
    FeatureReport features;
    std::string picture, error_map;  // files, relative to the folder

    bool timed() const { return !primary.wall.empty(); }
    double primary_ms() const { return spread_of(primary.wall).median; }
    double preview_ms() const { return spread_of(preview.wall).median; }
    int wrong() const {  // hits that are missed or invented, at silhouettes too
        return errors.missed + errors.invented + errors.silhouette_missed + errors.silhouette_invented;
    }
};

// Coarsest setting of a method that keeps an error, and the subject's time beside its.
struct Rival {
    std::string label;  // empty: none keeps it
    double primary = 0,
           preview = 0;  // subject's time over the rival's: medians of the rounds' ratios; 0 not timed
};
struct SpeedAnswer {
    std::string subject, method;
    Rival at_p999, at_p99;  // the coarsest whose p99.9 (p99) depth error is at most 1e-3
    Rival best;             // the coarsest whose p99.9 depth error is within a hundredth of the least
};

struct ComparedScene {
    std::string name, file;
    int triangles = 0, map_width = 0, map_height = 0, objects = 0;
    std::string error_unit;                   // of the first object
    double unit_length = 0;                   // world units
    int width = 0, height = 0;                // of the timed frames
    int judged_width = 0, judged_height = 0;  // of the images that are judged
    double reference_ms = 0;
    std::uint64_t undecided = 0;  // pixels that the reference could not decide
    int rounds = 0;
    std::vector<ComparedPoint> points;
    std::size_t most_exact = 0;  // the point whose beauty is the measure of the others
    std::vector<SpeedAnswer> answers;
    std::vector<std::string> cut;  // what the budget left out, one sentence each
    std::vector<std::string> warnings;
};

struct MachineInfo {
    std::string cpu, system;
    int cores = 0;
    double load = 0;  // of the last minute, before the start
};

struct Comparison {
    std::string version;
    MachineInfo machine;
    std::string device, driver, path;  // path: trace_path_words()
    double budget_s = 0;               // 0: none
    double spent_s = 0;
    std::vector<std::string> methods;
    std::vector<ComparedScene> scenes;
};

}  // namespace relievo
