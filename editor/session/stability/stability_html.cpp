// The matrix as a page: rows cases, columns methods, all of it open to the eye.
#include <cstdio>

#include "editor/session/compare/page_style.h"
#include "editor/session/compare/svg_plot.h"
#include "editor/session/compare/words.h"
#include "editor/session/stability/stability_report.h"

namespace relievo {
namespace {

using stability::Cell;
using stability::Verdict;
using stability::ViewResult;

constexpr const char* kStyle = R"(<style>
section{overflow-x:auto}
table{width:100%}
th.method{text-align:center;border-left:2px solid #fff;border-right:2px solid #fff;background:#eceff4}
td.case{text-align:left;white-space:normal;min-width:260px}
td.case b{display:inline-block;margin-right:8px}
td.case span{color:#7a808a}
td.verdict{text-align:center;font-weight:600;border-left:2px solid #fff;min-width:84px}
td.zero{color:#b4b9c1}
.right{background:#dff3e5;color:#17613a}
.rough{background:#fdf3d3;color:#6b5300}
.unjudged{background:#e9ebef;color:#4a4f57}
.known{background:#fde3c8;color:#7a3f00}
.wrong,.broken{background:#f7c9c4;color:#8a130a}
.key span{font-weight:600;font-size:13px}
ul{margin:4px 0 14px;padding-left:22px;font-size:13px}
</style>
)";

std::string class_of(Verdict verdict) {
    constexpr const char* kClasses[] = {"right", "rough", "unjudged", "known", "wrong", "broken"};
    return kClasses[static_cast<std::size_t>(verdict)];
}

std::string count_cell(int count) {
    return std::string("<td") + (count == 0 ? " class=zero>" : ">") + std::to_string(count) + "</td>";
}

// What stands in the tip of a verdict: every view for itself.
std::string tip(const Cell& cell) {
    std::string text = cell.note;
    for (const std::string& failure : cell.failures) text += (text.empty() ? "" : "\n") + failure;
    for (const ViewResult& view : cell.views) {
        const ImageComparison& e = view.errors;
        text += (text.empty() ? "" : "\n") + view.view + ": " + std::to_string(e.missed) + " missed, " +
                std::to_string(e.invented) + " invented, " + std::to_string(e.unexplained) +
                " unexplained, p99 " + error_text(e.depth_away.p99);
    }
    return escaped(text);
}

std::string method_cells(const Cell& cell) {
    const ViewResult w = cell.worst();
    const ImageComparison& e = w.errors;
    char steps[32];
    std::snprintf(steps, sizeof steps, "%.0f", w.most_steps);
    return "<td class='verdict " + class_of(cell.verdict) + "' title='" + tip(cell) + "'>" +
           std::string(stability::verdict_name(cell.verdict)) + "</td>" + count_cell(e.missed) +
           count_cell(e.invented) + count_cell(e.unexplained) + "<td>" + error_text(e.depth_away.p99) +
           "</td><td>" + error_text(e.depth.most) + "</td><td>" + error_text(e.normal_deg.median) +
           "</td><td>" + steps + "</td>";
}

std::string table_head(const StabilityMatrix& matrix) {
    std::string names = "<tr><th rowspan=2 style='text-align:left'>case</th>", columns = "<tr>";
    for (const std::string& method : matrix.methods) {
        names += "<th class=method colspan=8>" + escaped(method) + "</th>";
        columns +=
            "<th>verdict</th><th>missed</th><th>invented</th><th>unexplained</th><th>p99</th><th>max</th>"
            "<th>normal °</th><th>steps</th>";
    }
    return "<thead>" + names + "</tr>" + columns + "</tr></thead>";
}

std::string groups(const StabilityMatrix& matrix) {
    std::string html, group;
    for (const StabilityRow& row : matrix.rows) {
        if (row.group != group) {
            if (!group.empty()) html += "</table></section>\n";
            group = row.group;
            html += "<section><h2>" + escaped(group) + "</h2><table>" + table_head(matrix);
        }
        html +=
            "<tr><td class=case><b>" + escaped(row.name) + "</b><span>" + escaped(row.what) + "</span></td>";
        for (const Cell& cell : row.cells) html += method_cells(cell);
        html += "</tr>\n";
    }
    return html + (group.empty() ? "" : "</table></section>\n");
}

std::string overview(const StabilityMatrix& matrix) {
    std::string html =
        "<section><h2>By method</h2><table style='width:auto'><tr><th style='text-align:left'>method</th>";
    constexpr Verdict kVerdicts[] = {Verdict::right, Verdict::rough, Verdict::unjudged,
                                     Verdict::known, Verdict::wrong, Verdict::broken};
    for (const Verdict v : kVerdicts) html += "<th>" + std::string(stability::verdict_name(v)) + "</th>";
    html += "</tr>";
    for (std::size_t m = 0; m < matrix.methods.size(); ++m) {
        html += "<tr><td style='text-align:left'><b>" + escaped(matrix.methods[m]) + "</b></td>";
        for (const Verdict v : kVerdicts) {
            const int count = matrix.count(m, v);
            html += count == 0 ? "<td class=zero>0</td>"
                               : "<td class=" + class_of(v) + ">" + std::to_string(count) + "</td>";
        }
        html += "</tr>";
    }
    return html + "</table></section>\n";
}

// Every broken promise and every known limit, in words.
std::string failures(const StabilityMatrix& matrix) {
    std::string html;
    const auto list = [&](const std::string& head, const std::vector<std::string>& sentences) {
        html += "<h3>" + escaped(head) + "</h3><ul>";
        for (const std::string& sentence : sentences) html += "<li>" + escaped(sentence) + "</li>";
        html += "</ul>";
    };
    for (const StabilityRow& row : matrix.rows) {
        if (!row.complaints.empty()) list(row.name + ": the case itself", row.complaints);
        for (const Cell& cell : row.cells) {
            std::vector<std::string> sentences = cell.failures;
            if (!cell.note.empty()) sentences.insert(sentences.begin(), cell.note);
            if (cell.stale) sentences.emplace_back("the known limit is stale: the case passes");
            if (!sentences.empty()) list(row.name + ", " + cell.method, sentences);
        }
    }
    return html.empty() ? "" : "<section><h2>What is not as promised</h2>" + html + "</section>\n";
}

constexpr const char* kReading = R"(<section><h2>How to read this</h2>
<p>The judge is a double-precision reference that bounds and never samples. <b>Missed</b> and <b>invented</b> are
pixels or rays, away from silhouettes, where only the reference, or only the method, hits. <b>Unexplained</b> are
those, silhouettes included, that are off by more than 1% of the amplitude and whose answer no neighbouring ray of the
reference gives either. <b>p99</b> (away from silhouettes) and <b>max</b> are depth errors over the amplitude, or, where
that is longer, over the length whose 1e-5th part is what float can tell of the coordinates met. <b>Steps</b> are the
most that a primary ray took. Numbers are the worst of the case's views.</p>
<p class=key><span class=right>right</span> within the limits of the exact method: none missed, invented or
unexplained, median 1e-5, p99 1e-4, normals within 0.2°. <span class=rough>rough</span> sound, but not within them, and
not promised to be. <span class=unjudged>unjudged</span> sound; float cannot represent the answer.
<span class=known>known limit</span> listed as not kept. <span class=wrong>WRONG</span> breaks its promise.
<span class=broken>BROKEN</span> crashed, gave numbers that are not finite, took too many steps or too long.</p></section>
)";

}  // namespace

std::string html_text(const StabilityMatrix& m) {
    char setting[300];
    std::snprintf(setting, sizeof setting,
                  "%zu cases, %zu methods. Device: %s, driver %s. Relievo %s. %.0f s.", m.rows.size(),
                  m.methods.size(), m.device.c_str(), m.driver.c_str(), m.version.c_str(), m.spent_s);
    std::string html =
        "<!doctype html><html lang=en><head><meta charset=utf-8><meta name=viewport "
        "content='width=device-width'><title>Relievo: stiff and extreme cases</title>";
    html += std::string(kPageStyle) + kStyle;
    html += "</head><body><header><h1>Stiff and extreme cases</h1><p class=sub>" + escaped(setting) +
            "</p></header><main>";
    html += overview(m);
    html += kReading;
    return html + groups(m) + failures(m) +
           "</main><footer>All numbers, every view: <a href='stability.csv'>stability.csv</a>, <a "
           "href='stability.json'>stability.json</a></footer></body></html>\n";
}

}  // namespace relievo
