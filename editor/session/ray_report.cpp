// "Why this pixel": what a method did along one ray.
#include "editor/session/ray_report.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "editor/session/text.h"

namespace relievo {
namespace {

std::string counted(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string triangle_name(std::uint32_t object, std::uint32_t face, const Scene& scene) {
    std::string name = "triangle " + std::to_string(face);
    if (scene.objects.size() > 1) name += " of object " + std::to_string(object);
    return name;
}

const char* kind_name(const TraceNote& note) {
    switch (note.kind) {
        case TraceNote::Kind::box:
            return "box";
        case TraceNote::Kind::step:
            return note.extent > 0 ? "stretch" : "sample";
        case TraceNote::Kind::cell:
            return "cell";
        case TraceNote::Kind::root:
            return "root";
        case TraceNote::Kind::hit:
            return "hit";
    }
    return "";
}

void add_note(RayReport& report, const TraceNote& note) {
    if (note.kind == TraceNote::Kind::box || report.visits.empty()) {
        report.visits.push_back({note.object, note.face, {}, 0, 0, 0, std::nullopt});
        if (note.kind == TraceNote::Kind::box) return;
    }
    RayReport::Visit& visit = report.visits.back();
    visit.notes.push_back(note);
    const auto add = [](std::size_t& of_visit, std::size_t& of_ray) {
        ++of_visit;
        ++of_ray;
    };
    if (note.kind == TraceNote::Kind::step) add(visit.steps, report.steps);
    if (note.kind == TraceNote::Kind::cell) add(visit.cells, report.cells);
    if (note.kind == TraceNote::Kind::root) add(visit.roots, report.roots);
    if (note.kind == TraceNote::Kind::hit) visit.hit = note;
}

}  // namespace

RayReport report_ray(Renderer& renderer, const std::string& method, const glm::ivec2& pixel) {
    RayReport report;
    report.method = method;
    report.pixel = pixel;
    report.ray = renderer.camera_ray(pixel.x + 0.5, pixel.y + 0.5);
    const TraceLog log = renderer.trace_notes(report.ray);
    for (const TraceNote& note : log.notes) add_note(report, note);
    report.left_out = log.left_out;
    report.hit = log.hit;
    report.distance = static_cast<double>(log.distance);
    for (std::size_t i = 0; i < report.visits.size(); ++i)
        if (report.hit && report.visits[i].hit && report.visits[i].hit->t == log.distance)
            report.hit_visit = i;
    return report;
}

std::string describe(const RayReport::Visit& visit, const Scene& scene) {
    if (visit.notes.empty()) return triangle_name(visit.object, visit.face, scene) + ": its box only";
    std::string text = triangle_name(visit.object, visit.face, scene) + ": " + counted(visit.steps, "step") +
                       ", " + counted(visit.cells, "cell") + ", " + counted(visit.roots, "root");
    if (visit.hit) text += formatted(", hit at t %.7g", static_cast<double>(visit.hit->t));
    return text;
}

std::string describe(const TraceNote& note) {
    std::string text =
        formatted("%-8s t %.7g   texel %.3f, %.3f", kind_name(note), static_cast<double>(note.t),
                  static_cast<double>(note.texel.x), static_cast<double>(note.texel.y));
    const auto extent = static_cast<double>(note.extent);
    if (note.kind != TraceNote::Kind::root)
        text += formatted("   height %.6g", static_cast<double>(note.height));
    if (note.kind == TraceNote::Kind::step && extent > 0) text += formatted("   reaches %.4g texels", extent);
    if (note.kind == TraceNote::Kind::cell) text += formatted("   left at t %.7g", extent);
    return text;
}

std::vector<std::string> summary(const RayReport& report, const Scene& scene) {
    const glm::vec3 &o = report.ray.origin, &d = report.ray.direction;
    std::vector<std::string> lines;
    lines.push_back(formatted("pixel %d, %d by method ", report.pixel.x, report.pixel.y) + report.method);
    lines.push_back(formatted("from (%.7g, %.7g, %.7g) along (%.7g, %.7g, %.7g)", static_cast<double>(o.x),
                              static_cast<double>(o.y), static_cast<double>(o.z), static_cast<double>(d.x),
                              static_cast<double>(d.y), static_cast<double>(d.z)));
    lines.push_back(counted(report.visits.size(), "triangle") + " met, " + counted(report.steps, "step") +
                    ", " + counted(report.cells, "cell") + ", " + counted(report.roots, "root"));
    if (report.left_out > 0) lines.push_back(counted(report.left_out, "note") + " more than the log holds");
    if (!report.hit) {
        lines.push_back("hits nothing");
        return lines;
    }
    std::string outcome = formatted("hits at t %.9g", report.distance);
    if (!report.hit_visit) {
        lines.push_back(outcome);
        return lines;
    }
    const RayReport::Visit& visit = report.visits[*report.hit_visit];
    lines.push_back(outcome + ", " + triangle_name(visit.object, visit.face, scene));
    lines.push_back(formatted("at texel %.3f, %.3f, height %.6g", static_cast<double>(visit.hit->texel.x),
                              static_cast<double>(visit.hit->texel.y),
                              static_cast<double>(visit.hit->height)));
    return lines;
}

std::vector<std::string> describe(const RayReport& report, const ReferenceVerdict& verdict,
                                  const Scene& scene) {
    std::vector<std::string> lines;
    if (!verdict.hit) {
        lines.push_back("reference: hits nothing");
        if (report.hit) lines.push_back("the method's hit is invented");
    } else {
        const ReferenceHit& hit = *verdict.hit;
        lines.push_back(formatted("reference: hits at t %.12g, ", hit.t) +
                        triangle_name(hit.object, hit.face, scene) +
                        formatted(", height %.9g", verdict.point.displacement));
        if (!report.hit) lines.push_back("the method misses it");
        const double amplitude = std::abs(scene.objects[hit.object].displacement.amplitude);
        if (report.hit && amplitude > 0)
            lines.push_back(formatted("depth error %.3g of the amplitude (%+.3g world units)",
                                      std::abs(report.distance - hit.t) / amplitude,
                                      report.distance - hit.t));
    }
    if (verdict.undecided) lines.push_back("(the reference gave up at its limit: not decided)");
    return lines;
}

std::string full_text(const RayReport& report, const std::optional<ReferenceVerdict>& verdict,
                      const Scene& scene) {
    std::string text;
    for (const std::string& line : summary(report, scene)) text += line + "\n";
    if (verdict)
        for (const std::string& line : describe(report, *verdict, scene)) text += line + "\n";
    for (std::size_t i = 0; i < report.visits.size(); ++i) {
        text += "\n" + std::to_string(i + 1) + ". " + describe(report.visits[i], scene) + "\n";
        for (const TraceNote& note : report.visits[i].notes) text += "   " + describe(note) + "\n";
    }
    return text;
}

}  // namespace relievo
