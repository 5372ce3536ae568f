// See rounds.h.
#include "editor/session/compare/rounds.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "renderer/stopwatch.h"

namespace relievo {
namespace {

constexpr int kMostRounds = 15, kFewRounds = 3, kEditRounds = 3;
constexpr double kWarmUpSeconds = 0.5;
constexpr int kEditSize = 256;          // texels a side
constexpr std::uint16_t kRaise = 2000;  // of the counts in it

double seconds_a_round(const std::vector<TimedPoint>& points) {
    double ms = 0;
    for (const TimedPoint& point : points) ms += point.frame_ms;
    return ms * 1e-3;
}

PixelRect whole(const Renderer& renderer) {
    return {0, 0, renderer.width(), renderer.height()};
}

// There and back in turns, from another point each time: no point always follows the same one.
std::vector<std::size_t> order_of(std::size_t count, int round) {
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = (i + static_cast<std::size_t>(round) / 2) % count;
    if (round % 2 == 1) std::reverse(order.begin(), order.end());
    return order;
}

void time_round(MethodRenderers& renderers, const std::vector<TimedPoint>& points, int round, bool keep) {
    for (const std::size_t i : order_of(points.size(), round)) {
        Renderer& renderer = renderers.select(*points[i].choice);
        ComparedPoint& result = *points[i].result;
        const double primary = renderer.trace_layers(), primary_device = renderer.last_device_ms();
        const double preview = renderer.render(whole(renderer), Quality::preview),
                     preview_device = renderer.last_device_ms();
        if (!keep) continue;
        result.primary.wall.push_back(primary);
        result.primary.device.push_back(primary_device);
        result.preview.wall.push_back(preview);
        result.preview.device.push_back(preview_device);
    }
}

struct Edit {
    TexelRegion region;
    std::vector<std::uint16_t> texels;  // of the whole map, edited
};

Edit make_edit(const HeightMap& map, const glm::dvec2& uv) {
    const auto low = [](double place, int texels) {
        const int centre = static_cast<int>((place - std::floor(place)) * texels);
        return std::clamp(centre - kEditSize / 2, 0, std::max(0, texels - kEditSize));
    };
    Edit edit{{low(uv.x, map.width()), low(uv.y, map.height()), 0, 0}, {}};
    edit.region.x1 = std::min(edit.region.x0 + kEditSize, map.width());
    edit.region.y1 = std::min(edit.region.y0 + kEditSize, map.height());
    edit.texels.assign(map.texels().begin(), map.texels().end());
    for (int y = edit.region.y0; y < edit.region.y1; ++y)
        for (int x = edit.region.x0; x < edit.region.x1; ++x) {
            std::uint16_t& texel =
                edit.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width()) +
                            static_cast<std::size_t>(x)];
            texel = static_cast<std::uint16_t>(std::min<int>(texel + kRaise, 65535));
        }
    return edit;
}

struct EditSamples {
    std::vector<double> upload, bounds, refit, extra;
};

void time_edit(Renderer& renderer, const HeightMap& map, const Edit& edit, EditSamples& samples) {
    const std::span<const TexelRegion> regions(&edit.region, 1);
    const double before_ms = renderer.trace_layers();
    Stopwatch watch;
    const UploadStats stats = renderer.upload(0, {map.width(), map.height(), edit.texels.data()}, regions);
    samples.upload.push_back(watch.lap_ms());
    samples.bounds.push_back(stats.bounds_ms);
    samples.refit.push_back(stats.refit_ms);
    samples.extra.push_back(renderer.trace_layers() - before_ms);
    renderer.upload(0, {map.width(), map.height(), map.texels().data()}, regions);
}

}  // namespace

void fit_points(std::vector<TimedPoint>& points, double seconds, std::vector<std::string>& cut) {
    while (points.size() > 1 && (kFewRounds + 1) * seconds_a_round(points) > seconds) {
        const auto slowest = std::max_element(
            points.begin() + 1, points.end(),
            [](const TimedPoint& a, const TimedPoint& b) { return a.frame_ms < b.frame_ms; });
        char text[160];
        std::snprintf(text, sizeof text, "%s was not timed: its frames take %.1f s",
                      slowest->result->label.c_str(), slowest->frame_ms * 1e-3);
        cut.emplace_back(text);
        points.erase(slowest);
    }
}

int time_frames(MethodRenderers& renderers, const std::vector<TimedPoint>& points, const Budget& budget,
                double kept_seconds, const TellRound& tell) {
    const auto rounds_left = [&](double round_seconds) {
        if (budget.endless()) return kMostRounds;
        return static_cast<int>(std::clamp((budget.left() - kept_seconds) / std::max(round_seconds, 1e-6),
                                           0.0, double(kMostRounds)));
    };
    double round_seconds = seconds_a_round(points);
    if (rounds_left(round_seconds) > 1) {
        tell(0, std::min(rounds_left(round_seconds), kMostRounds));
        for (double warmed = 0; warmed < kWarmUpSeconds && rounds_left(round_seconds) > 1; warmed += round_seconds) {
            Stopwatch watch;
            time_round(renderers, points, 0, false);
            round_seconds = watch.lap_ms() * 1e-3;
        }
    }
    int done = 0;
    while (done < kMostRounds && (done == 0 || rounds_left(round_seconds) > 0)) {
        tell(done + 1, std::min(done + std::max(rounds_left(round_seconds), 1), kMostRounds));
        Stopwatch watch;
        time_round(renderers, points, done, true);
        round_seconds = watch.lap_ms() * 1e-3;
        ++done;
    }
    return done;
}

void time_edits(MethodRenderers& renderers, const std::vector<TimedPoint>& points, const HeightMap& map,
                const glm::dvec2& uv, const Budget& budget, const TellRound& tell) {
    const Edit edit = make_edit(map, uv);
    std::vector<EditSamples> samples(points.size());
    for (int round = 0; round < kEditRounds; ++round) {
        tell(round + 1, kEditRounds);
        for (const std::size_t i : order_of(points.size(), round)) {
            if (budget.left() < 2e-3 * points[i].result->primary_ms()) continue;
            time_edit(renderers.select(*points[i].choice), map, edit, samples[i]);
        }
    }
    const auto median = [](const std::vector<double>& values) { return spread_of(values).median; };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const EditSamples& s = samples[i];
        if (s.upload.empty()) continue;
        points[i].result->edit =
            EditTimes{median(s.upload), median(s.bounds), median(s.refit), median(s.extra),
                      (edit.region.x1 - edit.region.x0) * (edit.region.y1 - edit.region.y0)};
    }
}

}  // namespace relievo
