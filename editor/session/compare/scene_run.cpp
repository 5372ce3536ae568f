// See scene_run.h.
#include "editor/session/compare/scene_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "editor/session/compare/answers.h"
#include "editor/session/compare/image_error.h"
#include "editor/session/compare/method_renderers.h"
#include "editor/session/compare/quality.h"
#include "editor/session/compare/rounds.h"
#include "editor/session/scene_input.h"
#include "renderer/judge/error_units.h"
#include "renderer/stopwatch.h"

namespace relievo {
namespace {

// What the reference may take of a scene's time, and what is kept for edits; where the errors end in the
// progress.
constexpr double kReferencePart = 0.2, kEditsPart = 0.12, kErrorsPart = 0.5;
// What the errors of a point cost beside its frames, of which they take about as many as kErrorFrames; how
// much longer the frames of the next finer point of a sweep may take; rounds that all points shall have: a
// warm-up, three, and edits.
constexpr double kErrorSeconds = 0.5, kErrorFrames = 6, kSlowerStep = 2, kLeastRounds = 5;

class SceneRun {
  public:
    SceneRun(vulkan::Context& context, const SceneTask& task, const Budget& budget, const TellPart& tell)
        : task_(task), budget_(budget), tell_(tell), scene_(open_scene(task.file)) {
        describe();
        tell_("tracing the reference", 0);
        choose_judged_size();
        Stopwatch watch;
        judge_ = std::make_unique<QualityJudge>(scene_, result_.judged_width, result_.judged_height);
        result_.reference_ms = watch.lap_ms();
        result_.undecided = judge_->image().undecided;
        renderers_ = std::make_unique<MethodRenderers>(context, scene_, result_.judged_width,
                                                       result_.judged_height, task.path);
    }

    ComparedScene run() {
        measure_errors();
        compare_images();
        measure_times();
        answer_speed(result_);
        return std::move(result_);
    }

  private:
    const Scene& scene() const { return scene_.scene(); }
    void describe();
    void choose_judged_size();
    double pixels() const;
    bool may_measure(std::size_t point) const;
    void measure_errors();
    void measure(std::size_t point);
    void compare_images();
    void measure_times();
    glm::dvec2 edited_place() const;

    const SceneTask& task_;
    const Budget& budget_;
    const TellPart& tell_;
    ReferenceScene scene_;
    ComparedScene result_;
    std::unique_ptr<QualityJudge> judge_;
    std::unique_ptr<MethodRenderers> renderers_;
    std::vector<const PointChoice*> choices_;  // of the points that were measured, like what follows
    std::vector<QualityJudge::Measured> measured_;
    std::map<const Method*, double> last_frame_;  // milliseconds, of the method's last point
    double longest_first_ = 0;                    // seconds that a method's first point took, with its shaders
};

void SceneRun::describe() {
    const Scene& s = scene();
    result_.name = task_.name;
    result_.file = task_.file.string();
    result_.warnings = s.warnings;
    result_.objects = static_cast<int>(s.objects.size());
    for (const SceneObject& object : s.objects)
        result_.triangles += static_cast<int>(object.mesh.faces.size());
    result_.map_width = scene_.map(0).width();
    result_.map_height = scene_.map(0).height();
    const ErrorUnit unit = error_units(s).front();
    result_.error_unit = unit.name();
    result_.unit_length = unit.length;
    result_.width = task_.width > 0 ? task_.width : s.image.width;
    result_.height = task_.height > 0 ? task_.height : s.image.height;
}

// The frames' own size, or a smaller one where the reference would eat the budget.
void SceneRun::choose_judged_size() {
    result_.judged_width = result_.width;
    result_.judged_height = result_.height;
    if (budget_.endless()) return;
    const double seconds = QualityJudge::estimate_seconds(scene_, result_.width, result_.height),
                 allowed = kReferencePart * budget_.limit();
    if (seconds <= allowed) return;
    const double scale = std::sqrt(std::max(allowed, 1e-6) / seconds);
    result_.judged_width = std::max(16, static_cast<int>(result_.width * scale));
    result_.judged_height = std::max(16, static_cast<int>(result_.height * scale));
    result_.cut.push_back("errors are those of " + std::to_string(result_.judged_width) + " x " +
                          std::to_string(result_.judged_height) +
                          " images: the reference would have taken too long");
}

// How many times a primary and a preview frame cost in the rounds than in the judged image.
double SceneRun::pixels() const {
    return static_cast<double>(result_.width) * result_.height /
           (static_cast<double>(result_.judged_width) * result_.judged_height);
}

// The first point of the first method is always measured; another one where it leaves time for a few rounds of
// all.
bool SceneRun::may_measure(std::size_t point) const {
    if (budget_.endless() || measured_.empty()) return true;
    double slowest = 0, round = 0;  // of the frames so far
    for (const QualityJudge::Measured& measured : measured_) {
        slowest = std::max(slowest, measured.frame_ms * 1e-3);
        round += measured.frame_ms * 1e-3;
    }
    const auto last = last_frame_.find(task_.points[point].method);
    const bool is_new = last == last_frame_.end();
    const double frame = is_new ? slowest : kSlowerStep * last->second * 1e-3;
    const double errors = is_new ? longest_first_ : kErrorSeconds + kErrorFrames * frame;
    return budget_.spent() + errors + kLeastRounds * pixels() * (round + frame) < budget_.limit();
}

void SceneRun::measure_errors() {
    for (std::size_t i = 0; i < task_.points.size(); ++i) {
        const PointChoice& choice = task_.points[i];
        const double part = static_cast<double>(i) / static_cast<double>(task_.points.size());
        tell_("errors of " + choice.label, kReferencePart / 2 + part * (kErrorsPart - kReferencePart / 2));
        if (!may_measure(i)) {
            result_.cut.push_back(choice.label + " was not measured");
            continue;
        }
        try {
            measure(i);
        } catch (const std::invalid_argument& refusal) {
            result_.cut.push_back(choice.label + ": " + refusal.what());
        }
    }
    if (result_.points.empty()) throw std::invalid_argument(task_.name + ": " + result_.cut.front());
}

void SceneRun::measure(std::size_t index) {
    const PointChoice& choice = task_.points[index];
    const double start = budget_.spent();
    Renderer& renderer = renderers_->select(choice);
    ComparedPoint point;
    point.method = std::string(choice.method->name);
    point.swept = choice.swept;
    point.label = choice.label;
    std::string name = task_.name + "_" + choice.label;
    std::replace(name.begin(), name.end(), ' ', '_');
    point.picture = "pictures/" + name + ".jpg";
    point.error_map = "pictures/" + name + "_error.png";
    const auto& build = renderers_->build_of(choice);
    point.build_ms = build.ms;
    point.features = build.features;
    point.bytes = build.features.bytes_total;
    measured_.push_back(
        judge_->measure(renderer, point, task_.folder / point.picture, task_.folder / point.error_map));
    choices_.push_back(&choice);
    result_.points.push_back(std::move(point));
    if (!last_frame_.contains(choice.method)) longest_first_ = std::max(longest_first_, budget_.spent() - start);
    last_frame_[choice.method] = measured_.back().frame_ms;
}

void SceneRun::compare_images() {
    tell_("comparing images", kErrorsPart);
    result_.most_exact = most_exact_point(result_.points);
    const std::vector<float>& truth = measured_[result_.most_exact].beauty;
    for (std::size_t i = 0; i < result_.points.size(); ++i)
        result_.points[i].image =
            image_error(result_.judged_width, result_.judged_height, measured_[i].beauty, truth);
}

// Where the reference hits nearest to the middle of the image: what one would sculpt on.
glm::dvec2 SceneRun::edited_place() const {
    const ReferenceImage& image = judge_->image();
    glm::dvec2 uv(0.5);
    double nearest = 1e300;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x);
            const double distance = std::hypot(x - image.width / 2, y - image.height / 2);
            if (image.object[i] != 1 || distance >= nearest) continue;
            nearest = distance;
            uv = image.uv[i];
        }
    return uv;
}

void SceneRun::measure_times() {
    renderers_->resize(result_.width, result_.height);
    std::vector<TimedPoint> points;
    for (std::size_t i = 0; i < result_.points.size(); ++i)
        points.push_back({choices_[i], &result_.points[i], measured_[i].frame_ms * pixels()});
    const bool edited = !scene().objects.front().displacement.procedural;
    const double kept = budget_.endless() || !edited ? 0 : kEditsPart * budget_.limit();
    if (!budget_.endless()) fit_points(points, budget_.left() - kept, result_.cut);
    const auto telling = [&](const char* what, double from, double to) {
        return [this, what, from, to](int round, int rounds) {
            tell_(what + std::to_string(round) + " of " + std::to_string(rounds),
                  from + (to - from) * round / (rounds + 1));
        };
    };
    result_.rounds = time_frames(*renderers_, points, budget_, kept,
                                 telling("frames, round ", kErrorsPart, 1 - kEditsPart));
    if (edited)
        time_edits(*renderers_, points, scene_.map(0), edited_place(), budget_,
                   telling("edits, round ", 1 - kEditsPart, 1));
    if (!budget_.endless() && result_.rounds < 3)
        result_.cut.push_back("frames were timed in only " + std::to_string(result_.rounds) +
                              (result_.rounds == 1 ? " round" : " rounds"));
}

}  // namespace

ComparedScene compare_on_scene(vulkan::Context& context, const SceneTask& task, const Budget& budget,
                               const TellPart& tell) {
    return SceneRun(context, task, budget, tell).run();
}

}  // namespace relievo
