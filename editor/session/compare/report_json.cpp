// The comparison as JSON.
#include <cmath>
#include <nlohmann/json.hpp>

#include "editor/session/compare/ranks_json.h"
#include "editor/session/compare/report.h"

namespace relievo {
namespace {

using Json = nlohmann::ordered_json;

Json pixel_errors(const PixelErrors& e) {
    return {{"both", e.both},
            {"missed", e.missed},
            {"invented", e.invented},
            {"silhouette_missed", e.silhouette_missed},
            {"silhouette_invented", e.silhouette_invented},
            {"off", e.off},
            {"depth", ranks(e.depth)},
            {"depth_away", ranks(e.depth_away)},
            {"normal_deg", ranks(e.normal_deg)}};
}

Json examples(const std::vector<OffPixel>& pixels) {
    const char* const kinds[] = {"missed", "invented", "depth"};
    Json list = Json::array();
    for (const OffPixel& p : pixels)
        list.push_back({{"kind", kinds[static_cast<int>(p.kind)]},
                        {"pixel", {p.x, p.y}},
                        {"reference", std::isfinite(p.reference) ? Json(p.reference) : Json(nullptr)},
                        {"method", std::isfinite(p.method) ? Json(p.method) : Json(nullptr)}});
    return list;
}

Json errors(const ImageComparison& e) {
    Json json = pixel_errors(e);
    json["unexplained"] = e.unexplained;
    json["not_finite"] = e.not_finite;
    json["unexplained_examples"] = examples(e.unexplained_examples);
    json["by_angle"] = {{"below_0.2", pixel_errors(e.by_angle[0])},
                        {"to_0.8", pixel_errors(e.by_angle[1])},
                        {"above_0.8", pixel_errors(e.by_angle[2])}};
    return json;
}

Json spread(const std::vector<double>& values) {
    const Spread s = spread_of(values);
    return {{"median", s.median}, {"p10", s.p10}, {"p90", s.p90}};
}

Json times(const RoundTimes& t) {
    if (t.wall.empty()) return nullptr;
    return {{"rounds", t.wall.size()}, {"wall", spread(t.wall)}, {"device", spread(t.device)}};
}

Json edit(const std::optional<EditTimes>& e) {
    if (!e) return nullptr;
    return {{"texels", e->texels},
            {"upload", e->upload},
            {"bounds", e->bounds},
            {"refit", e->refit},
            {"first_frame_extra", e->first_frame_extra}};
}

Json features(const FeatureReport& report) {
    Json list = Json::array();
    for (const Feature& f : report.features)
        if (f.built) list.push_back({{"name", f.name}, {"bytes", f.bytes}});
    return list;
}

Json point(const ComparedPoint& p) {
    return {{"method", p.method},
            {"parameters", p.swept},
            {"label", p.label},
            {"errors", errors(p.errors)},
            {"edge_gap",
             {{"points", p.gap.points},
              {"unreached", p.gap.unreached},
              {"gap", ranks(p.gap.gap)},
              {"above_0.001", p.gap.wide},
              {"rays", p.gap.rays},
              {"leaks", p.gap.leaks}}},
            {"image", {{"rmse", p.image.rmse}, {"dissimilarity", p.image.dissimilarity}}},
            {"per_ray",
             {{"boxes", p.cost.boxes},
              {"steps", p.cost.steps},
              {"fetches", p.cost.fetches},
              {"cells", p.cost.cells}}},
            {"primary_ms", times(p.primary)},
            {"preview_ms", times(p.preview)},
            {"build_ms", p.build_ms},
            {"first_frame_ms", p.first_frame_ms},
            {"edit_ms", edit(p.edit)},
            {"bytes", p.bytes},
            {"built", features(p.features)},
            {"picture", p.picture},
            {"error_map", p.error_map}};
}

Json rival(const Rival& r) {
    if (r.label.empty()) return nullptr;
    return {{"point", r.label}, {"primary_ratio", r.primary}, {"preview_ratio", r.preview}};
}

Json scene(const ComparedScene& s) {
    Json points = Json::array(), answers = Json::array();
    for (const ComparedPoint& p : s.points) points.push_back(point(p));
    for (const SpeedAnswer& a : s.answers)
        answers.push_back({{"subject", a.subject},
                           {"method", a.method},
                           {"coarsest_p999_below_0.001", rival(a.at_p999)},
                           {"coarsest_p99_below_0.001", rival(a.at_p99)},
                           {"best", rival(a.best)}});
    return {{"name", s.name},
            {"file", s.file},
            {"objects", s.objects},
            {"triangles", s.triangles},
            {"map", {s.map_width, s.map_height}},
            {"error_unit", {{"name", s.error_unit}, {"length", s.unit_length}}},
            {"frame", {s.width, s.height}},
            {"judged", {s.judged_width, s.judged_height}},
            {"reference_ms", s.reference_ms},
            {"undecided", s.undecided},
            {"rounds", s.rounds},
            {"most_exact", s.points.empty() ? Json(nullptr) : Json(s.points[s.most_exact].label)},
            {"points", points},
            {"speed", answers},
            {"cut", s.cut},
            {"warnings", s.warnings}};
}

}  // namespace

std::string json_text(const Comparison& c) {
    Json scenes = Json::array();
    for (const ComparedScene& s : c.scenes) scenes.push_back(scene(s));
    const Json json{{"relievo_compare", 1},
                    {"version", c.version},
                    {"machine",
                     {{"cpu", c.machine.cpu},
                      {"cores", c.machine.cores},
                      {"system", c.machine.system},
                      {"load_before", c.machine.load}}},
                    {"device", {{"name", c.device}, {"driver", c.driver}, {"path", c.path}}},
                    {"budget_s", c.budget_s},
                    {"spent_s", c.spent_s},
                    {"methods", c.methods},
                    {"scenes", scenes}};
    return json.dump(2) + "\n";
}

}  // namespace relievo
