// The comparison as comma-separated values: one line a point, the first names the columns.
#include <functional>
#include <sstream>

#include "editor/session/compare/report.h"
#include "editor/session/text.h"

namespace relievo {
namespace {

struct Column {
    std::string name;
    std::function<std::string(const ComparedScene&, const ComparedPoint&)> text;
};

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char letter : text) result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return result + "\"";
}

void add_number(std::vector<Column>& columns, const std::string& name,
                const std::function<double(const ComparedPoint&)>& of) {
    columns.push_back(
        {name, [of](const ComparedScene&, const ComparedPoint& p) { return number_text(of(p)); }});
}

void add_ranks(std::vector<Column>& columns, const std::string& name,
               const std::function<const ErrorRanks&(const ComparedPoint&)>& of) {
    add_number(columns, name + "_median", [of](const ComparedPoint& p) { return of(p).median; });
    add_number(columns, name + "_p99", [of](const ComparedPoint& p) { return of(p).p99; });
    add_number(columns, name + "_p999", [of](const ComparedPoint& p) { return of(p).p999; });
    add_number(columns, name + "_max", [of](const ComparedPoint& p) { return of(p).most; });
}

void add_errors(std::vector<Column>& columns, const std::string& prefix,
                const std::function<const PixelErrors&(const ComparedPoint&)>& of) {
    add_number(columns, prefix + "both", [of](const ComparedPoint& p) { return of(p).both; });
    add_number(columns, prefix + "missed", [of](const ComparedPoint& p) { return of(p).missed; });
    add_number(columns, prefix + "invented", [of](const ComparedPoint& p) { return of(p).invented; });
    add_number(columns, prefix + "silhouette_missed",
               [of](const ComparedPoint& p) { return of(p).silhouette_missed; });
    add_number(columns, prefix + "silhouette_invented",
               [of](const ComparedPoint& p) { return of(p).silhouette_invented; });
    add_number(columns, prefix + "off", [of](const ComparedPoint& p) { return of(p).off; });
    add_ranks(columns, prefix + "depth",
              [of](const ComparedPoint& p) -> const ErrorRanks& { return of(p).depth; });
    add_ranks(columns, prefix + "depth_away",
              [of](const ComparedPoint& p) -> const ErrorRanks& { return of(p).depth_away; });
    add_ranks(columns, prefix + "normal_deg",
              [of](const ComparedPoint& p) -> const ErrorRanks& { return of(p).normal_deg; });
}

void add_times(std::vector<Column>& columns, const std::string& name,
               const std::function<const std::vector<double>&(const ComparedPoint&)>& of) {
    add_number(columns, name + "_ms", [of](const ComparedPoint& p) { return spread_of(of(p)).median; });
    add_number(columns, name + "_ms_p10", [of](const ComparedPoint& p) { return spread_of(of(p)).p10; });
    add_number(columns, name + "_ms_p90", [of](const ComparedPoint& p) { return spread_of(of(p)).p90; });
}

void add_costs(std::vector<Column>& columns) {
    using P = const ComparedPoint&;
    add_number(columns, "boxes_per_ray", [](P p) { return p.cost.boxes; });
    add_number(columns, "steps_per_ray", [](P p) { return p.cost.steps; });
    add_number(columns, "fetches_per_ray", [](P p) { return p.cost.fetches; });
    add_number(columns, "cells_per_ray", [](P p) { return p.cost.cells; });
    add_number(columns, "rounds", [](P p) { return static_cast<double>(p.primary.wall.size()); });
    using Times = const std::vector<double>&;
    add_times(columns, "primary", [](P p) -> Times { return p.primary.wall; });
    add_times(columns, "primary_device", [](P p) -> Times { return p.primary.device; });
    add_times(columns, "preview", [](P p) -> Times { return p.preview.wall; });
    add_times(columns, "preview_device", [](P p) -> Times { return p.preview.device; });
    add_number(columns, "build_ms", [](P p) { return p.build_ms; });
    add_number(columns, "first_frame_ms", [](P p) { return p.first_frame_ms; });
    add_number(columns, "bytes", [](P p) { return static_cast<double>(p.bytes); });
    add_number(columns, "edit_upload_ms", [](P p) { return p.edit.value_or(EditTimes{}).upload; });
    add_number(columns, "edit_first_frame_extra_ms",
               [](P p) { return p.edit.value_or(EditTimes{}).first_frame_extra; });
}

std::vector<Column> columns() {
    using S = const ComparedScene&;
    using P = const ComparedPoint&;
    std::vector<Column> result{{"scene", [](S s, P) { return quoted(s.name); }},
                               {"method", [](S, P p) { return quoted(p.method); }},
                               {"point", [](S, P p) { return quoted(p.label); }}};
    add_errors(result, "", [](P p) -> const PixelErrors& { return p.errors; });
    add_number(result, "unexplained", [](P p) { return p.errors.unexplained; });
    add_number(result, "not_finite", [](P p) { return p.errors.not_finite; });
    add_number(result, "gap_points", [](P p) { return p.gap.points; });
    add_ranks(result, "gap", [](P p) -> const ErrorRanks& { return p.gap.gap; });
    add_number(result, "gap_above_0.001", [](P p) { return p.gap.wide; });
    add_number(result, "edge_rays", [](P p) { return p.gap.rays; });
    add_number(result, "edge_leaks", [](P p) { return p.gap.leaks; });
    add_number(result, "image_rmse", [](P p) { return p.image.rmse; });
    add_number(result, "image_dissimilarity", [](P p) { return p.image.dissimilarity; });
    add_costs(result);
    const char* const angles[] = {"grazing_", "slanted_", "facing_"};
    for (std::size_t k = 0; k < 3; ++k)
        add_errors(result, angles[k], [k](P p) -> const PixelErrors& { return p.errors.by_angle[k]; });
    return result;
}

}  // namespace

std::string csv_text(const Comparison& comparison) {
    const std::vector<Column> all = columns();
    std::string text;
    for (const Column& column : all) text += (text.empty() ? "" : ",") + column.name;
    text += "\n";
    for (const ComparedScene& scene : comparison.scenes)
        for (const ComparedPoint& point : scene.points) {
            bool first = true;
            for (const Column& column : all) {
                if (!first) text += ",";
                first = false;
                text += column.text(scene, point);
            }
            text += "\n";
        }
    return text;
}

}  // namespace relievo
