// The matrix of the stability suite as files.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "editor/session/stability/stability_report.h"

namespace relievo::report_test {
namespace {

using stability::Cell;
using stability::Verdict;

// Two methods on one case: one is right, the other is as said.
StabilityMatrix matrix_with(Verdict verdict, const std::string& failure) {
    Cell good{"pits", "good", Verdict::right, {}, {}, "", false}, bad = good;
    good.views.push_back({"from <above>", {}, 12, 0.5});
    bad.method = "bad";
    bad.verdict = verdict;
    bad.views = good.views;
    bad.views[0].errors.missed = 7;
    bad.views[0].errors.depth_away.p99 = 0.25;
    if (!failure.empty()) bad.failures.push_back(failure);
    StabilityMatrix matrix;
    matrix.methods = {"good", "bad"};
    matrix.rows.push_back({"maps", "pits", "a map of pits & holes", {}, {good, bad}});
    return matrix;
}

TEST(StabilityReport, APageHoldsEveryCaseMethodAndFailureWithoutAClick) {
    const std::string html = html_text(matrix_with(Verdict::wrong, "7 missed, 0 < promised"));
    for (const char* text :
         {"<b>pits</b>", "a map of pits &amp; holes", "good", "bad", "class='verdict right'",
          "class='verdict wrong'", "<td>7</td>", "7 missed, 0 &lt; promised", "stability.csv"})
        EXPECT_NE(html.find(text), std::string::npos) << text;
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("http"), std::string::npos) << "nothing is fetched";
    EXPECT_EQ(html.find("<details"), std::string::npos) << "nothing is folded away";
}

TEST(StabilityReport, CsvHasALineACaseAndMethod) {
    const std::string csv = csv_text(matrix_with(Verdict::known, ""));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
    EXPECT_NE(csv.find("\nmaps,pits,bad,known limit,0,7,"), std::string::npos) << csv;
    const auto columns = [&](std::size_t line_start) {
        return std::count(csv.begin() + static_cast<std::ptrdiff_t>(line_start),
                          csv.begin() + static_cast<std::ptrdiff_t>(csv.find('\n', line_start)), ',');
    };
    EXPECT_EQ(columns(0), columns(csv.find('\n') + 1));
}

TEST(StabilityReport, JsonHoldsEveryView) {
    const auto json = nlohmann::json::parse(json_text(matrix_with(Verdict::broken, "it crashed")));
    EXPECT_EQ(json["promises_kept"], false);
    const auto& bad = json["cases"][0]["methods"][1];
    EXPECT_EQ(bad["verdict"], "BROKEN");
    EXPECT_EQ(bad["failures"][0], "it crashed");
    EXPECT_EQ(bad["views"][0]["view"], "from <above>");
    EXPECT_EQ(bad["views"][0]["missed"], 7);
    EXPECT_EQ(bad["worst"]["most_steps"], 12);
}

TEST(StabilityReport, KnownLimitsKeepThePromise) {
    EXPECT_TRUE(matrix_with(Verdict::known, "3 missed").kept());
    EXPECT_TRUE(matrix_with(Verdict::rough, "").kept());
    EXPECT_FALSE(matrix_with(Verdict::wrong, "3 missed").kept());
    EXPECT_NE(summary_text(matrix_with(Verdict::known, "3 missed")).find("known limit"), std::string::npos);
    EXPECT_NE(summary_text(matrix_with(Verdict::wrong, "3 missed")).find("3 missed"), std::string::npos);
}

TEST(StabilityReport, UnknownCasesAreRefused) {
    EXPECT_EQ(parse_cases("dunes,cliffs"), (std::vector<std::string>{"dunes", "cliffs"}));
    EXPECT_TRUE(parse_cases("").empty());
    EXPECT_THROW(parse_cases("dunes,quicksand"), std::invalid_argument);
}

TEST(StabilityCases, HaveNamesOfTheirOwnThatFilesCanHave) {
    std::vector<std::string> names;
    for (const stability::CaseEntry& entry : stability::cases()) {
        names.push_back(entry.name);
        EXPECT_FALSE(entry.what.empty()) << entry.name;
        EXPECT_EQ(entry.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos);
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
    EXPECT_GT(names.size(), 100u);
}

}  // namespace
}  // namespace relievo::report_test
