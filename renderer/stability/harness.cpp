// See harness.h.
#include "renderer/stability/harness.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <stdexcept>

#include "renderer/stability/float_floor.h"
#include "renderer/stopwatch.h"

namespace relievo::stability {
namespace {

constexpr double kMostSeconds = 30;  // an image of some thousand pixels, on a busy machine
constexpr int kSeen = 100;           // pixels: what the reference sees as well as this, a method sees some of

std::string count_text(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what;
}

// Depth may be infinite (nothing is hit), all else must be finite.
std::size_t count_unsound(const std::vector<float>& values, Layer layer) {
    return static_cast<std::size_t>(std::count_if(values.begin(), values.end(), [&](float v) {
        if (layer == Layer::depth) return !(v >= 0);
        return !std::isfinite(v) || (layer == Layer::counts && v < 0);
    }));
}

void add_failures(Cell& cell, const std::string& view, const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) cell.failures.push_back(view + ": " + sentence);
}

void worse(ErrorRanks& a, const ErrorRanks& b) {
    a = {std::max(a.median, b.median), std::max(a.p99, b.p99), std::max(a.p999, b.p999),
         std::max(a.most, b.most)};
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
    constexpr std::string_view kNames[] = {"right", "rough", "unjudged", "known limit", "WRONG", "BROKEN"};
    return kNames[static_cast<std::size_t>(verdict)];
}

ViewResult Cell::worst() const {
    ViewResult all;
    for (const ViewResult& view : views) {
        ImageComparison& sum = all.errors;
        const ImageComparison& e = view.errors;
        sum.both += e.both;
        sum.missed += e.missed;
        sum.invented += e.invented;
        sum.silhouette_missed += e.silhouette_missed;
        sum.silhouette_invented += e.silhouette_invented;
        sum.off += e.off;
        sum.unexplained += e.unexplained;
        sum.not_finite += e.not_finite;
        worse(sum.depth, e.depth);
        worse(sum.depth_away, e.depth_away);
        worse(sum.normal_deg, e.normal_deg);
        all.most_steps = std::max(all.most_steps, view.most_steps);
        all.slowest_s = std::max(all.slowest_s, view.slowest_s);
    }
    return all;
}

std::string Cell::text() const {
    const ViewResult w = worst();
    const ImageComparison& e = w.errors;
    char line[400];
    std::snprintf(
        line, sizeof line,
        "%-30s %-8s %-11s missed %4d invented %4d off %4d unexplained %4d  median %.0e p99 %.0e max %.0e  "
        "normal %.2g deg  steps %.0f",
        name.c_str(), method.c_str(), std::string(verdict_name(verdict)).c_str(), e.missed, e.invented, e.off,
        e.unexplained, e.depth.median, e.depth_away.p99, e.depth_away.most, e.normal_deg.median,
        w.most_steps);
    std::string result = line;
    if (!note.empty()) result += "\n    " + note;
    if (stale) result += "\n    the known limit is stale: the case passes";
    for (const std::string& failure : failures) result += "\n    " + failure;
    if (!kept())
        for (const ViewResult& view : views)
            if (!right_failures(view.errors).empty())
                result += "\n    " + view.view + ": " + view.errors.text();
    return result;
}

JudgedCase::JudgedCase(const CaseEntry& entry, int size)
    : entry_(entry), case_(entry.make()), surface_(case_.reference()) {
    case_.size = std::max(case_.size * size / kCaseSize, 1);
    pixels_ = static_cast<double>(size) * size / (kCaseSize * kCaseSize);
    trace_views();
    for (const RaySet& set : case_.rays) {
        ray_judges_.emplace_back(case_, surface_, set);
        if (ray_judges_.back().undecided() > 0)
            complaints_.push_back(set.name + ": the reference is undecided");
    }
}

void JudgedCase::trace_views() {
    std::size_t seen = 0;
    for (const NamedView& view : case_.views) {
        const Scene scene = case_.scene(view);
        ReferenceImage image = trace_image(surface_, scene.camera, scene.origin, case_.size, case_.size);
        if (image.undecided > 0 && case_.beyond_float.empty())
            complaints_.push_back(view.name + ": " +
                                  count_text(image.undecided, "undecided pixels of the reference"));
        double reach = 0;
        for (const double z : image.depth)
            if (std::isfinite(z)) reach = std::max(reach, z), ++seen;
        judges_.emplace_back(std::move(image), scene.camera, scene.origin,
                             float_units(case_, view.eye, reach));
    }
    if (!case_.views.empty() && seen < kSeen) complaints_.push_back("nothing is seen of the case");
}

Cell JudgedCase::run(vulkan::Context& context, const Method& method, TracePath path) const {
    Cell cell;
    cell.name = entry_.name;
    cell.method = method.name;
    const int messages = vulkan::Context::validation_messages();
    try {
        RenderSettings settings;
        settings.width = settings.height = case_.size;
        settings.method = method.name;
        settings.path = path;
        settings.parameters = promise_of(method.name).parameters;
        const NamedView away{"", {10, 10, 10}, {0, 0, 0}};
        const std::vector<HeightView> maps = case_.maps();
        Renderer renderer(context, case_.scene(case_.views.empty() ? away : case_.views[0]), maps, settings);
        for (std::size_t i = 0; i < case_.views.size(); ++i) run_view(method, renderer, i, cell);
        for (std::size_t i = 0; i < ray_judges_.size(); ++i)
            run_rays(renderer, ray_judges_[i], case_.rays[i].name, cell);
    } catch (const std::invalid_argument& refusal) {
        if (promise_of(method.name).may_refuse) {
            cell.verdict = Verdict::unjudged;
            cell.note = refusal.what();
        } else {
            cell.failures.emplace_back(refusal.what());
        }
        return cell;
    } catch (const std::exception& error) {
        cell.failures.push_back(error.what());
        return cell;
    }
    if (vulkan::Context::validation_messages() != messages)
        cell.failures.emplace_back("the validation layers spoke");
    if (cell.failures.empty()) decide(method, cell);
    return cell;
}

void JudgedCase::run_view(const Method& method, Renderer& renderer, std::size_t view, Cell& cell) const {
    const NamedView& seen = case_.views[view];
    renderer.set_camera(case_.scene(seen).camera);
    ViewResult result;
    result.view = seen.name;
    check_soundness(method, renderer, result, cell);
    const Judge& judge = judges_[view];
    const std::vector<float> depth = renderer.read_back(Layer::depth);
    ImageComparison errors = judge.compare(depth, renderer.read_back(Layer::normal));
    // Looking for excuses takes the reference's time: many only where they decide, none where it cannot
    // decide.
    if (case_.beyond_float.empty())
        judge.count_unexplained(surface_, depth, errors, promise_of(method.name).right ? 200 : 20);
    const int expected = errors.both + errors.missed + errors.silhouette_missed;
    if (expected >= kSeen && errors.both * 20 < expected)
        cell.failures.push_back(seen.name + ": next to nothing is hit, " + std::to_string(errors.both) +
                                " of " + std::to_string(expected) + " pixels");
    result.errors = errors;
    cell.views.push_back(std::move(result));
}

void JudgedCase::check_soundness(const Method& method, Renderer& renderer, ViewResult& result,
                                 Cell& cell) const {
    const struct {
        Layer layer;
        const char* name;
    } layers[] = {{Layer::beauty, "beauty"},     {Layer::depth, "Z"}, {Layer::normal, "N"},
                  {Layer::shading_normal, "Ns"}, {Layer::uv, "uv"},   {Layer::id, "id"},
                  {Layer::counts, "counts"}};
    for (const auto& [layer, name] : layers) {
        Stopwatch watch;
        if (layer == Layer::beauty) renderer.render();
        const std::vector<float> values = renderer.read_back(layer);
        result.slowest_s = std::max(result.slowest_s, watch.lap_ms() / 1000);
        const std::size_t unsound = count_unsound(values, layer);
        if (unsound > 0)
            cell.failures.push_back(result.view + ": " + count_text(unsound, "values of the layer ") + name +
                                    " are not finite");
        if (layer != Layer::counts) continue;
        for (std::size_t i = 0; i < values.size(); i += 4) {
            const double boxes = static_cast<double>(values[i]), steps = static_cast<double>(values[i + 1]);
            result.most_steps = std::max(result.most_steps, steps);
            if (steps <= boxes * method.most_steps) continue;
            cell.failures.push_back(result.view + ": " + std::to_string(steps) + " steps in " +
                                    std::to_string(boxes) + " triangles, more than the method states");
            break;
        }
    }
    if (result.slowest_s > kMostSeconds)
        cell.failures.push_back(result.view + ": an image took " + std::to_string(result.slowest_s) + " s");
}

void JudgedCase::run_rays(Renderer& renderer, const RayJudge& judge, const std::string& name,
                          Cell& cell) const {
    ViewResult result;
    result.view = name;
    Stopwatch watch;
    const std::vector<PickHit> picks = renderer.pick(judge.rays());
    result.slowest_s = watch.lap_ms() / 1000;
    result.errors = judge.compare(picks);
    if (result.errors.not_finite > 0)
        cell.failures.push_back(name + ": " + std::to_string(result.errors.not_finite) +
                                " picks are not finite");
    if (result.slowest_s > kMostSeconds)
        cell.failures.push_back(name + ": the picks took " + std::to_string(result.slowest_s) + " s");
    cell.views.push_back(std::move(result));
}

void JudgedCase::decide(const Method& method, Cell& cell) const {
    const Promise promise = promise_of(method.name);
    std::size_t off = 0;  // views that are not right
    std::vector<std::string> failures;
    for (const ViewResult& view : cell.views) {
        const auto right = right_failures(view.errors);
        off += right.empty() ? 0 : 1;
        if (promise.right) add_failures(cell, view.view, right);
        if (promise.near) add_failures(cell, view.view, near_failures(view.errors));
        if (promise.sampled) add_failures(cell, view.view, sampled_failures(view.errors, case_.sampled));
    }
    const KnownLimit* limit = find_known_limit(method.name, entry_.name);
    if (!case_.beyond_float.empty()) {
        cell.verdict = Verdict::unjudged;
        cell.note = "not judged: " + case_.beyond_float;
        cell.failures.clear();
    } else if (cell.failures.empty()) {
        cell.verdict = off == 0 ? Verdict::right : Verdict::rough;
        cell.stale = limit != nullptr;
    } else {
        const bool known =
            limit != nullptr && cell.worst().errors.unexplained <= limit->most_wrong * std::max(pixels_, 1.0);
        cell.verdict = known ? Verdict::known : Verdict::wrong;
        if (limit != nullptr)
            cell.note = "known limit: " + std::string(limit->reason) + "; at most " +
                        std::to_string(limit->most_wrong) + " pixels";
    }
}

}  // namespace relievo::stability
