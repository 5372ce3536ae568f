// See overview.h.
#include "editor/session/compare/overview.h"

#include <algorithm>

#include "editor/session/compare/answers.h"
#include "editor/session/compare/words.h"
#include "editor/session/text.h"

namespace relievo {
namespace {

std::string wrong_text(const ComparedPoint& p) {
    return std::to_string(p.errors.missed + p.errors.silhouette_missed) + ", " +
           std::to_string(p.errors.invented + p.errors.silhouette_invented);
}

std::string time_text(const ComparedPoint& p) {
    return p.timed() ? ms_text(p.primary_ms()) : "-";
}

}  // namespace

TextTable methods_table(const Comparison& c) {
    if (c.methods.empty()) return {};
    const std::string& subject = c.methods.front();
    TextTable table{{"scene", subject + ": ms", "p99, p99.9", "missed, invented"}};
    for (std::size_t m = 1; m < c.methods.size(); ++m) table[0].push_back("over " + c.methods[m]);
    for (const ComparedScene& s : c.scenes) {
        if (s.points.empty() || s.points.front().method != subject) continue;
        const ComparedPoint& p = s.points.front();
        table.push_back({s.name, time_text(p) + " (" + ms_text(p.preview_ms()) + ")",
                         error_text(p.errors.depth.p99) + ", " + error_text(p.errors.depth.p999),
                         wrong_text(p)});
        for (std::size_t m = 1; m < c.methods.size(); ++m) {
            const auto answer = std::find_if(s.answers.begin(), s.answers.end(),
                                             [&](const SpeedAnswer& a) { return a.method == c.methods[m]; });
            table.back().push_back(answer == s.answers.end() ? "-"
                                                             : rival_text(answer->at_p999, c.methods[m]));
        }
    }
    return table;
}

TextTable built_table(const Comparison& c) {
    TextTable table{{"scene"}};
    for (const std::string& method : c.methods) table[0].push_back(method);
    for (const ComparedScene& s : c.scenes) {
        table.push_back({s.name});
        for (const std::string& method : c.methods) {
            const ComparedPoint* best = best_point(s.points, method);
            table.back().push_back(!best ? "-"
                                         : bytes_text(best->bytes) + "; " + ms_text(best->build_ms) + "; " +
                                               (best->edit ? ms_text(best->edit->upload) : "-"));
        }
    }
    return table;
}

TextTable settings_table(const Comparison& c) {
    TextTable table{{"setting"}};
    std::vector<std::string> labels;
    for (const ComparedScene& s : c.scenes) table[0].push_back(s.name);
    for (const std::string& method : c.methods)
        for (const ComparedScene& s : c.scenes)
            for (const ComparedPoint& p : s.points)
                if (p.method == method && std::find(labels.begin(), labels.end(), p.label) == labels.end())
                    labels.push_back(p.label);
    for (const std::string& label : labels) {
        table.push_back({label});
        for (const ComparedScene& s : c.scenes) {
            const auto p = std::find_if(s.points.begin(), s.points.end(),
                                        [&](const ComparedPoint& point) { return point.label == label; });
            table.back().push_back(p == s.points.end()
                                       ? "-"
                                       : time_text(*p) + " ms; " + error_text(p->errors.depth.p999) + "; " +
                                             wrong_text(*p));
        }
    }
    return table;
}

}  // namespace relievo
