// See plots.h.
#include "editor/session/compare/plots.h"

#include <algorithm>
#include <cstdio>

#include "editor/session/compare/answers.h"
#include "editor/session/compare/points.h"

namespace relievo {
namespace {

constexpr double kAsked = 1e-3;       // the error that the speed questions ask about
constexpr double kWrongShare = 1e-3;  // of the hits: more make a point hollow

double error_of(const ComparedPoint& point, PlottedError error) {
    if (error == PlottedError::gap) return point.gap.gap.p99;
    return error == PlottedError::p99 ? point.errors.depth.p99 : point.errors.depth.p999;
}
const char* name_of(PlottedError error) {
    if (error == PlottedError::gap) return "p99 gap along edges / amplitude";
    return error == PlottedError::p99 ? "p99 depth error / amplitude" : "p99.9 depth error / amplitude";
}

// The swept values alone: the series' colour tells the method.
std::string short_label(const ComparedPoint& point) {
    std::string label;
    for (const auto& [name, value] : point.swept) label += (label.empty() ? "" : ", ") + swept_text(point.method, name, value);
    return label.empty() ? point.method : label;
}

bool hollow(const ComparedPoint& point) {
    return point.wrong() > kWrongShare * std::max(1, point.errors.both);
}

std::string tip_of(const ComparedPoint& point, double error) {
    char text[200];
    std::snprintf(text, sizeof text, ": %.1f ms, error %.1e, %d missed or invented", point.primary_ms(),
                  error, point.wrong());
    return point.label + text;
}

std::string device_note(const Comparison& comparison) {
    return comparison.machine.cpu + ", " + std::to_string(comparison.machine.cores) + " cores; " +
           comparison.device;
}

struct Median {
    std::string line;
    std::vector<double> times, errors;
    int hollow = 0;
};

}  // namespace

Plot scene_plot(const Comparison& comparison, const ComparedScene& scene, PlottedError error) {
    Plot plot;
    plot.title =
        scene.name + (error == PlottedError::gap ? ": gap along edges against time" : ": error against time");
    plot.x_label = "frame of primary rays, ms (" + std::to_string(scene.width) + " × " +
                   std::to_string(scene.height) + ")";
    plot.y_label = name_of(error);
    plot.notes = {device_note(comparison)};
    plot.y_guide = kAsked;
    for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
        PlotSeries series{comparison.methods[m], static_cast<int>(m), {}, false};
        for (const ComparedPoint& point : scene.points) {
            if (point.method != series.name || !point.timed()) continue;
            if (error == PlottedError::gap && point.gap.points == 0) continue;
            const Spread time = spread_of(point.primary.wall);
            const double e = error_of(point, error);
            series.points.push_back(
                {time.median, e, time.p10, time.p90, short_label(point), tip_of(point, e), hollow(point),
                 swept_line(point.method, point.swept)});
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

Plot overall_plot(const Comparison& comparison, PlottedError error) {
    Plot plot;
    plot.title = "All scenes: error against time";
    plot.x_label = "frame of primary rays, over that of " + comparison.methods.front() + " in the same scene";
    plot.y_label = name_of(error);
    plot.notes = {"thick: medians of the scenes (of at least half); thin: each scene",
                  device_note(comparison)};
    plot.y_guide = kAsked;
    plot.x_is_ratio = true;
    for (std::size_t m = 0; m < comparison.methods.size(); ++m) {
        const std::string& method = comparison.methods[m];
        std::vector<std::string> order;
        std::map<std::string, Median> medians;
        for (const ComparedScene& scene : comparison.scenes) {
            PlotSeries thin{"", static_cast<int>(m), {}, true};
            for (const ComparedPoint& point : scene.points) {
                const double ratio = time_ratio(point.primary, scene.points.front().primary);
                if (point.method != method || ratio <= 0) continue;
                const double e = error_of(point, error);
                thin.points.push_back(
                    {ratio, e, ratio, ratio, "", scene.name + ", " + tip_of(point, e), false,
                     swept_line(method, point.swept)});
                const std::string label = short_label(point);
                if (!medians.contains(label)) order.push_back(label);
                Median& median = medians[label];
                median.line = swept_line(method, point.swept);
                median.times.push_back(ratio);
                median.errors.push_back(e);
                median.hollow += hollow(point) ? 1 : 0;
            }
            plot.series.push_back(std::move(thin));
        }
        PlotSeries thick{method, static_cast<int>(m), {}, false};
        for (const std::string& label : order) {
            const Median& median = medians[label];
            if (2 * median.times.size() < comparison.scenes.size()) continue;  // too few to speak for all
            const double time = spread_of(median.times).median, e = spread_of(median.errors).median;
            thick.points.push_back({time, e, time, time, label,
                                    method + " " + label + ": median of the scenes",
                                    2 * median.hollow > static_cast<int>(median.times.size()), median.line});
        }
        plot.series.push_back(std::move(thick));
    }
    return plot;
}

}  // namespace relievo
