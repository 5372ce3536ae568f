// Runs a method on a case and judges it. One table of cases, every registered method: a method that is added
// later is met by all of them without a new line.
#pragma once

#include <string>
#include <vector>

#include "renderer/judge/judge.h"
#include "renderer/methods/registry.h"
#include "renderer/stability/promises.h"
#include "renderer/stability/ray_judge.h"
#include "renderer/stability/stability_case.h"
#include "renderer/vulkan/context.h"

namespace relievo::stability {

enum class Verdict {
    right,     // within the limits of `exact`, whether the method promises it or not
    rough,     // sound; wrong by more than those limits, which the method does not promise
    unjudged,  // sound; float cannot represent the answer (Case::beyond_float)
    known,     // wrong, as promises.h lists it
    wrong,     // breaks its promise
    broken,    // not sound: a crash, a NaN, too many steps, too long
};
std::string_view verdict_name(Verdict verdict);

struct ViewResult {
    std::string view;  // or set of rays
    ImageComparison errors;
    double most_steps = 0;  // of a primary ray
    double slowest_s = 0;   // of the images of the view, wall clock
};

struct Cell {
    std::string name, method;  // of the case
    Verdict verdict = Verdict::broken;
    std::vector<ViewResult> views;
    std::vector<std::string> failures;  // broken promises and unsoundness, one sentence each with its view
    std::string note;                   // the known limit's reason, or why it is not judged
    bool stale = false;                 // a known limit is listed, and the case passes

    bool kept() const { return verdict != Verdict::wrong && verdict != Verdict::broken; }
    // Over all views: sums of counts, the worst of ranks, the most steps.
    ViewResult worst() const;
    std::string text() const;  // a line, and one for each failure
};

class JudgedCase {
  public:
    // Traces the reference for all views and rays of the case. `size`: pixels a side of an ordinary case's
    // images; cases that are slow have smaller ones, in proportion.
    explicit JudgedCase(const CaseEntry& entry, int size = kCaseSize);
    JudgedCase(const JudgedCase&) = delete;  // the judges point to its surface
    JudgedCase& operator=(const JudgedCase&) = delete;

    // Any exception of the renderer is a broken cell.
    Cell run(vulkan::Context& context, const Method& method, TracePath path = TracePath::automatic) const;

    // What is wrong with the case itself, one sentence each: the reference could not decide, nothing is seen.
    const std::vector<std::string>& complaints() const { return complaints_; }

  private:
    void trace_views();
    void check_soundness(const Method& method, Renderer& renderer, ViewResult& result, Cell& cell) const;
    void run_view(const Method& method, Renderer& renderer, std::size_t view, Cell& cell) const;
    void run_rays(Renderer& renderer, const RayJudge& judge, const std::string& name, Cell& cell) const;
    void decide(const Method& method, Cell& cell) const;

    CaseEntry entry_;
    Case case_;
    double pixels_ = 1;  // of an image, over the usual number
    ReferenceSurface surface_;
    std::vector<Judge> judges_;  // one a view
    std::vector<RayJudge> ray_judges_;
    std::vector<std::string> complaints_;
};

}  // namespace relievo::stability
