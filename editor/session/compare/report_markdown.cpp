// The comparison's summary as Markdown tables, for a README.
#include <algorithm>
#include <cstdio>

#include "editor/session/compare/answers.h"
#include "editor/session/compare/overview.h"
#include "editor/session/compare/report.h"
#include "editor/session/compare/words.h"

namespace relievo {
namespace {

std::string line(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
}

std::string rule(std::size_t columns) {
    std::string text = "|";
    for (std::size_t i = 0; i < columns; ++i) text += " --- |";
    return text + "\n";
}

std::string table_text(const TextTable& table) {
    std::string text;
    for (std::size_t i = 0; i < table.size(); ++i)
        text += line(table[i]) + (i == 0 ? rule(table[0].size()) : "");
    return text + "\n";
}

std::string setting_line(const Comparison& c) {
    char text[400];
    std::snprintf(text, sizeof text, "%s, %d cores; %s (%s), %s.", c.machine.cpu.c_str(), c.machine.cores,
                  c.device.c_str(), c.driver.c_str(), c.path.c_str());
    return text;
}

// The subject's own numbers, and the other methods' times beside them at equal error.
std::string speed_lines(const Comparison& c) {
    if (c.scenes.empty() || c.scenes.front().points.empty()) return "";
    const std::string subject = c.methods.front();
    std::string text;
    for (std::size_t m = 0; m < c.scenes.front().answers.size(); ++m) {
        const std::string other = c.scenes.front().answers[m].method;
        text += line({"scene", subject + ": ms, primary (preview)", subject + ": depth p99, p99.9",
                      "missed, invented", subject + " / " + other + " at p99.9 ≤ 1e-3", "at p99 ≤ 1e-3",
                      "at its best"});
        text += rule(7);
        for (const ComparedScene& s : c.scenes) {
            if (s.answers.size() <= m) continue;
            const ComparedPoint& p = s.points.front();
            const SpeedAnswer& a = s.answers[m];
            text +=
                line({s.name, ms_text(p.primary_ms()) + " (" + ms_text(p.preview_ms()) + ")",
                      error_text(p.errors.depth.p99) + ", " + error_text(p.errors.depth.p999),
                      std::to_string(p.errors.missed + p.errors.silhouette_missed) + ", " +
                          std::to_string(p.errors.invented + p.errors.silhouette_invented),
                      rival_text(a.at_p999, other), rival_text(a.at_p99, other), rival_text(a.best, other)});
        }
        text += "\n";
    }
    return text;
}

// Every method at its least error.
std::string error_table(const Comparison& c) {
    std::string text = line({"scene", "method at its best", "missed, invented", "depth median, p99, p99.9",
                             "normal median, deg", "edge gap median, max", "image RMSE", "1 - SSIM"}) +
                       rule(8);
    for (const ComparedScene& s : c.scenes)
        for (const std::string& method : c.methods) {
            const ComparedPoint* best = best_point(s.points, method);
            if (!best) continue;
            const ImageComparison& e = best->errors;
            text += line({s.name, best->label,
                          std::to_string(e.missed + e.silhouette_missed) + ", " +
                              std::to_string(e.invented + e.silhouette_invented),
                          error_text(e.depth.median) + ", " + error_text(e.depth.p99) + ", " +
                              error_text(e.depth.p999),
                          error_text(e.normal_deg.median),
                          error_text(best->gap.gap.median) + ", " + error_text(best->gap.gap.most),
                          error_text(best->image.rmse), error_text(best->image.dissimilarity)});
        }
    return text;
}

}  // namespace

std::string markdown_text(const Comparison& c) {
    std::string text = "# Error against run time\n\n" + setting_line(c) + "\n\n";
    text +=
        "Times are medians of interleaved rounds, in milliseconds: primary rays only, and (in brackets) the "
        "beauty with "
        "hard shadows. Depth errors and edge gaps are over the amplitude (of an object without any: over a "
        "hundredth of its radius). A ratio is " +
        (c.methods.empty() ? "" : c.methods.front()) +
        "'s time over the other's: below 1 it is the quicker one.\n\n";
    text +=
        "Over every other method, at its coarsest setting with p99.9 to 1e-3:\n\n" +
        table_text(methods_table(c)) +
        "What each method builds at its best: bytes; ms to build; ms after an edit of 256 x 256 texels:\n\n" +
        table_text(built_table(c)) + "Every setting: frame of primary rays; p99.9; missed, invented:\n\n" +
        table_text(settings_table(c)) + "Speed and errors in full:\n\n" + speed_lines(c) + error_table(c);
    std::string cut;
    for (const ComparedScene& s : c.scenes)
        for (const std::string& sentence : s.cut) cut += "- " + s.name + ": " + sentence + "\n";
    if (!cut.empty()) text += "\nLeft out for the budget:\n\n" + cut;
    return text;
}

}  // namespace relievo
