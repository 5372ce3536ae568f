// The matrix as CSV, JSON and a summary for the terminal.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "editor/session/compare/ranks_json.h"
#include "editor/session/compare/words.h"
#include "editor/session/stability/stability_report.h"
#include "editor/session/text.h"

namespace relievo {
namespace {

using Json = nlohmann::ordered_json;
using stability::Cell;
using stability::Verdict;
using stability::ViewResult;

constexpr Verdict kVerdicts[] = {Verdict::right, Verdict::rough, Verdict::unjudged,
                                 Verdict::known, Verdict::wrong, Verdict::broken};

Json errors(const ViewResult& view) {
    const ImageComparison& e = view.errors;
    return {{"both", e.both},
            {"missed", e.missed},
            {"invented", e.invented},
            {"off", e.off},
            {"silhouette_missed", e.silhouette_missed},
            {"silhouette_invented", e.silhouette_invented},
            {"unexplained", e.unexplained},
            {"not_finite", e.not_finite},
            {"depth", ranks(e.depth)},
            {"depth_away", ranks(e.depth_away)},
            {"normal_deg", ranks(e.normal_deg)},
            {"most_steps", view.most_steps},
            {"slowest_s", view.slowest_s}};
}

Json cell_json(const Cell& cell) {
    Json json{{"method", cell.method}, {"verdict", stability::verdict_name(cell.verdict)}};
    if (!cell.note.empty()) json["note"] = cell.note;
    if (cell.stale) json["stale"] = true;
    json["failures"] = cell.failures;
    json["worst"] = errors(cell.worst());
    json["views"] = Json::array();
    for (const ViewResult& view : cell.views) {
        Json one{{"view", view.view}};
        one.update(errors(view));
        json["views"].push_back(std::move(one));
    }
    return json;
}

std::string csv_line(const StabilityRow& row, const Cell& cell) {
    const ViewResult w = cell.worst();
    const ImageComparison& e = w.errors;
    std::string line = row.group + "," + row.name + "," + cell.method + "," +
                       std::string(stability::verdict_name(cell.verdict));
    for (const double value :
         {double(e.both), double(e.missed), double(e.invented), double(e.off), double(e.unexplained),
          double(e.not_finite), e.depth.median, e.depth_away.p99, e.depth_away.p999, e.depth_away.most,
          e.depth.most, e.normal_deg.median, e.normal_deg.p99, w.most_steps, w.slowest_s})
        line += "," + number_text(value);
    return line + "\n";
}

}  // namespace

std::string csv_text(const StabilityMatrix& matrix) {
    std::string text =
        "group,case,method,verdict,both,missed,invented,off,unexplained,not_finite,depth_median,depth_away_"
        "p99,"
        "depth_away_p999,depth_away_max,depth_max,normal_deg_median,normal_deg_p99,most_steps,slowest_s\n";
    for (const StabilityRow& row : matrix.rows)
        for (const Cell& cell : row.cells) text += csv_line(row, cell);
    return text;
}

std::string json_text(const StabilityMatrix& matrix) {
    Json rows = Json::array();
    for (const StabilityRow& row : matrix.rows) {
        Json cells = Json::array();
        for (const Cell& cell : row.cells) cells.push_back(cell_json(cell));
        rows.push_back({{"group", row.group},
                        {"case", row.name},
                        {"what", row.what},
                        {"complaints", row.complaints},
                        {"methods", std::move(cells)}});
    }
    return Json{{"relievo", matrix.version}, {"device", matrix.device},        {"driver", matrix.driver},
                {"seconds", matrix.spent_s}, {"promises_kept", matrix.kept()}, {"cases", std::move(rows)}}
               .dump(2) +
           "\n";
}

namespace {

// Rows cases, columns methods: the verdict, what is missed, invented or unexplained, and p99 of the depth
// error.
std::string table_text(const StabilityMatrix& matrix) {
    char part[120];
    std::snprintf(part, sizeof part, "%-30s", "case");
    std::string text = part;
    for (const std::string& method : matrix.methods) {
        std::snprintf(part, sizeof part, "  %-32s", (method + ": verdict, wrong, p99").c_str());
        text += part;
    }
    text += "\n";
    for (const StabilityRow& row : matrix.rows) {
        std::snprintf(part, sizeof part, "%-30s", row.name.c_str());
        text += part;
        for (const Cell& cell : row.cells) {
            const ImageComparison e = cell.worst().errors;
            std::snprintf(part, sizeof part, "  %-11s %8d %-11s",
                          std::string(stability::verdict_name(cell.verdict)).c_str(),
                          std::max(e.missed + e.invented, e.unexplained),
                          error_text(e.depth_away.p99).c_str());
            text += part;
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += "\n";
    }
    return text;
}

}  // namespace

std::string summary_text(const StabilityMatrix& matrix) {
    std::string text = table_text(matrix);
    text += "\n" + std::to_string(matrix.rows.size()) + " cases on " + matrix.device + "\n";
    for (std::size_t m = 0; m < matrix.methods.size(); ++m) {
        char line[120];
        std::snprintf(line, sizeof line, "%-14s", matrix.methods[m].c_str());
        text += line;
        for (const Verdict verdict : kVerdicts) {
            const int count = matrix.count(m, verdict);
            if (count > 0)
                text += "  " + std::to_string(count) + " " + std::string(stability::verdict_name(verdict));
        }
        text += "\n";
    }
    for (const StabilityRow& row : matrix.rows) {
        for (const Cell& cell : row.cells) {
            const std::string all = cell.text();
            if (!cell.kept() || cell.stale)
                text += all + "\n";
            else if (cell.verdict == Verdict::known)
                text += all.substr(0, all.find('\n')) + "\n";
        }
    }
    return text;
}

}  // namespace relievo
