// See html_tables.h.
#include "editor/session/compare/html_tables.h"

#include <algorithm>
#include <vector>

#include "editor/session/compare/svg_plot.h"
#include "editor/session/compare/words.h"

namespace relievo {
namespace {

std::string cell(const std::string& text, const std::string& kind = "") {
    return "<td" + (kind.empty() ? "" : " class=" + kind) + ">" + text + "</td>";
}

std::string head(const std::vector<std::string>& names) {
    std::string text = "<thead><tr>";
    for (const std::string& name : names) text += "<th>" + name + "</th>";
    return text + "</tr></thead>";
}

std::string table(const std::string& inside) {
    return "<div class=scroll><table>" + inside + "</table></div>\n";
}

// Depth errors and gaps by what they mean on screen.
std::string error_cell(double error) {
    return cell(error_text(error), error <= 1e-4 ? "e0" : error <= 1e-3 ? "e1" : error <= 1e-2 ? "e2" : "e3");
}

std::string count_cell(int away, int at_silhouettes) {
    std::string text = std::to_string(away);
    if (at_silhouettes > 0) text += " <small>+ " + std::to_string(at_silhouettes) + "</small>";
    return cell(text, away > 0 ? "e3" : at_silhouettes > 0 ? "e1" : "e0");
}

std::string point_cell(const Comparison& comparison, const ComparedPoint& point) {
    const auto place = std::find(comparison.methods.begin(), comparison.methods.end(), point.method);
    return "<td class=point><i style='background:" +
           plot_color(static_cast<int>(place - comparison.methods.begin())) + "'></i>" +
           escaped(point.label) + "</td>";
}

std::string error_cells(const PixelErrors& e) {
    return count_cell(e.missed, e.silhouette_missed) + count_cell(e.invented, e.silhouette_invented) +
           error_cell(e.depth.median) + error_cell(e.depth.p99) + error_cell(e.depth.p999) +
           error_cell(e.depth.most) + cell(error_text(e.normal_deg.median)) +
           cell(error_text(e.normal_deg.p99));
}

std::string rival_cell(const Rival& rival, const std::string& method) {
    const std::string kind = rival.label.empty() || rival.primary <= 0 ? ""
                             : rival.primary <= 1                      ? "e0"
                                                                       : "e2";
    return cell(escaped(rival_text(rival, method)), kind);
}

}  // namespace

std::vector<const ComparedPoint*> by_method(const Comparison& comparison, const ComparedScene& scene) {
    std::vector<const ComparedPoint*> points;
    for (const std::string& method : comparison.methods)
        for (const ComparedPoint& point : scene.points)
            if (point.method == method) points.push_back(&point);
    return points;
}

std::string overview_table(const TextTable& rows) {
    std::string html;
    for (const std::vector<std::string>& row : rows) {
        if (html.empty()) {
            std::vector<std::string> names;
            for (const std::string& name : row) names.push_back(escaped(name));
            html = head(names);
            continue;
        }
        html += "<tr><td class=point>" + escaped(row.front()) + "</td>";
        for (std::size_t i = 1; i < row.size(); ++i) html += cell(escaped(row[i]));
        html += "</tr>";
    }
    return table(html);
}

std::string speed_table(const Comparison& comparison) {
    std::string rows;
    for (const ComparedScene& scene : comparison.scenes)
        for (const SpeedAnswer& answer : scene.answers) {
            const ComparedPoint& subject = scene.points.front();
            rows += "<tr><td class=point><a href='#" + escaped(scene.name) + "'>" + escaped(scene.name) +
                    "</a></td>" + cell(subject.timed() ? ms_text(subject.primary_ms()) : "-") +
                    cell(subject.timed() ? ms_text(subject.preview_ms()) : "-") +
                    error_cell(subject.errors.depth.p999) + cell(escaped(answer.method)) +
                    rival_cell(answer.at_p999, answer.method) + rival_cell(answer.at_p99, answer.method) +
                    rival_cell(answer.best, answer.method) + "</tr>";
        }
    if (rows.empty()) return "";
    const std::string subject = escaped(comparison.methods.front());
    return table(head({"scene", subject + ", ms", "with shadows, ms", "its p99.9 depth error", "beside",
                       "coarsest with p99.9 &le; 10<sup>-3</sup>", "coarsest with p99 &le; 10<sup>-3</sup>",
                       "its best"}) +
                 rows);
}

std::string error_table(const Comparison& comparison, const ComparedScene& scene) {
    std::string rows;
    for (const ComparedPoint* p : by_method(comparison, scene)) {
        rows +=
            "<tr>" + point_cell(comparison, *p) + error_cells(p->errors) +
            cell(std::to_string(p->errors.unexplained), p->errors.unexplained > 0 ? "e3" : "e0") +
            error_cell(p->gap.gap.median) + error_cell(p->gap.gap.p99) + error_cell(p->gap.gap.most) +
            cell(percent_text(p->gap.wide)) +
            cell(std::to_string(p->gap.leaks) + " <small>of " + std::to_string(p->gap.rays) + "</small>") +
            cell(error_text(p->image.rmse)) + cell(error_text(p->image.dissimilarity)) + "</tr>";
    }
    return table(
        "<thead><tr><th rowspan=2>point<th colspan=2>pixels<th colspan=4>depth error / " +
        escaped(scene.error_unit) +
        "<th colspan=2>normal, deg<th rowspan=2>unex&shy;plained<th colspan=5>gap along edges<th "
        "colspan=2>beauty</tr><tr><th>missed<th>invented<th>median<th>p99<th>p99.9<th>max<th>median<th>p99"
        "<th>median<th>p99<th>max<th>&gt; 10<sup>-3</sup><th>leaks<th>RMSE<th>1 - SSIM</tr></thead>" +
        rows);
}

std::string cost_table(const Comparison& comparison, const ComparedScene& scene) {
    std::string rows;
    for (const ComparedPoint* p : by_method(comparison, scene)) {
        rows += "<tr>" + point_cell(comparison, *p);
        if (p->timed()) {
            rows += cell(spread_text(spread_of(p->primary.wall))) +
                    cell(ms_text(spread_of(p->primary.device).median)) +
                    cell(spread_text(spread_of(p->preview.wall))) +
                    cell(ms_text(spread_of(p->preview.device).median)) +
                    cell(std::to_string(p->primary.wall.size()));
        } else {
            rows += "<td colspan=5>not timed</td>";
        }
        rows += cell(count_text(p->cost.boxes)) + cell(count_text(p->cost.steps)) +
                cell(count_text(p->cost.fetches)) + cell(count_text(p->cost.cells)) +
                cell(bytes_text(p->bytes)) + cell(ms_text(p->build_ms)) + cell(ms_text(p->first_frame_ms));
        rows += p->edit ? cell(ms_text(p->edit->upload)) + cell(ms_text(p->edit->first_frame_extra))
                        : "<td>-<td>-";
        rows += "</tr>";
    }
    return table(
        "<thead><tr><th rowspan=2>point<th colspan=2>primary rays, ms<th colspan=2>with hard shadows, ms<th "
        "rowspan=2>rounds<th colspan=4>per primary ray<th rowspan=2>built<th colspan=2>to start, ms<th "
        "colspan=2>after an edit, ms</tr><tr><th>median (p10 to p90)<th>device<th>median (p10 to "
        "p90)<th>device"
        "<th>boxes<th>steps<th>fetches<th>cells<th>build<th>first frame<th>upload<th>frame's "
        "extra</tr></thead>" +
        rows);
}

std::string angle_table(const Comparison& comparison, const ComparedScene& scene) {
    std::string rows;
    for (const ComparedPoint* p : by_method(comparison, scene))
        for (std::size_t k = 0; k < kViewAngleNames.size(); ++k) {
            const PixelErrors& e = p->errors.by_angle[k];
            rows += "<tr>" + (k == 0 ? point_cell(comparison, *p) : "<td class=point></td>") +
                    cell(escaped(std::string(kViewAngleNames[k]))) + cell(std::to_string(e.both)) +
                    error_cells(e) + "</tr>";
        }
    return table(head({"point", "angle", "hits", "missed", "invented", "depth median", "p99", "p99.9", "max",
                       "normal median, deg", "p99"}) +
                 rows);
}

}  // namespace relievo
