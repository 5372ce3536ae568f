// The report of a made-up comparison: every file holds what it should, whatever the names hold.
#include "editor/session/compare/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "editor/session/compare/plots.h"
#include "editor/session/compare/points.h"
#include "editor/session/compare/words.h"

namespace relievo::report_test {
namespace {

ComparedPoint point(const std::string& method, double dt, double error, double ms) {
    ComparedPoint p;
    p.method = method;
    p.label = method;
    if (dt > 0) {
        p.swept["dt"] = dt;
        p.label += " dt " + swept_text(dt);
    }
    p.errors.both = 10000;
    p.errors.depth = {error / 100, error / 10, error, 10 * error};
    p.primary.wall = {ms, ms * 1.1, ms * 0.9};
    p.primary.device = p.preview.wall = p.preview.device = p.primary.wall;
    p.bytes = 1234567;
    p.picture = "pictures/a.jpg";
    p.error_map = "pictures/a.png";
    return p;
}

Comparison made_up() {
    Comparison c;
    c.version = "1.2.3";
    c.machine = {"A <fast> & \"new\" CPU", "Linux x86_64", 2, 0.1};
    c.device = "device";
    c.driver = "driver";
    c.path = "ray query";
    c.methods = {"exact", "pdm"};
    for (const char* name : {"orb", "fur"}) {
        ComparedScene s;
        s.name = name;
        s.file = std::string(name) + ", the second.json";
        s.error_unit = "amplitude";
        s.width = s.height = s.judged_width = s.judged_height = 64;
        s.rounds = 3;
        s.points = {point("exact", 0, 1e-5, 20), point("pdm", 0.02, 0.3, 10), point("pdm", 0.0005, 9e-4, 40)};
        s.points[1].errors.missed = 500;
        s.answers.push_back({"exact", "pdm", {"pdm dt 0.0005", 0.5, 0.6}, {}, {"pdm dt 0.0005", 0.5, 0.6}});
        s.cut.push_back("pdm dt 0.00025 was not <measured>");
        c.scenes.push_back(s);
    }
    return c;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(Reports, CsvHasALineAPointAndAsManyFieldsInEach) {
    const std::vector<std::string> lines = lines_of(csv_text(made_up()));
    ASSERT_EQ(lines.size(), 7u);
    const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
    for (const std::string& line : lines) EXPECT_EQ(commas(line), commas(lines[0]));
    EXPECT_TRUE(lines[0].starts_with("scene,method,point,both,missed,invented,"));
    EXPECT_TRUE(lines[2].starts_with("orb,pdm,pdm dt 0.02,10000,500,0,"));
    for (const char* column :
         {"depth_p999", "normal_deg_median", "gap_max", "image_rmse", "steps_per_ray", "primary_ms_p90",
          "primary_device_ms", "edit_upload_ms", "bytes", "grazing_depth_p99"})
        EXPECT_NE(lines[0].find(column), std::string::npos) << column;
}

TEST(Reports, JsonHoldsEveryPoint) {
    const auto json = nlohmann::json::parse(json_text(made_up()));
    EXPECT_EQ(json["relievo_compare"], 1);
    EXPECT_EQ(json["machine"]["cpu"], "A <fast> & \"new\" CPU");
    EXPECT_EQ(json["scenes"].size(), 2u);
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["points"].size(), 3u);
    EXPECT_EQ(scene["points"][1]["parameters"]["dt"], 0.02);
    EXPECT_DOUBLE_EQ(scene["points"][1]["errors"]["depth"]["p999"], 0.3);
    EXPECT_DOUBLE_EQ(scene["points"][0]["primary_ms"]["wall"]["median"], 20);
    EXPECT_EQ(scene["points"][0]["edit_ms"], nullptr);
    EXPECT_EQ(scene["speed"][0]["coarsest_p999_below_0.001"]["point"], "pdm dt 0.0005");
    EXPECT_EQ(scene["speed"][0]["coarsest_p99_below_0.001"], nullptr);
    EXPECT_EQ(scene["cut"].size(), 1u);
}

TEST(Reports, ThePageNeedsNoNetworkAndEscapesNames) {
    const std::string html = html_text(made_up());
    EXPECT_EQ(html.find("http:"), std::string::npos);
    EXPECT_EQ(html.find("https:"), std::string::npos);
    EXPECT_EQ(html.find("<fast>"), std::string::npos);
    EXPECT_EQ(html.find("<measured>"), std::string::npos);
    EXPECT_NE(html.find("A &lt;fast&gt; &amp; &quot;new&quot; CPU"), std::string::npos);
    EXPECT_NE(html.find("none does"), std::string::npos);
    EXPECT_NE(html.find("<svg"), std::string::npos);
    EXPECT_NE(html.find("src='pictures/a.jpg'"), std::string::npos);
}

TEST(Reports, TheSummaryIsTables) {
    const std::string text = markdown_text(made_up());
    EXPECT_NE(text.find("| orb | 20.0 (20.0) | 1.0e-6, 1.0e-5 | 0, 0 | dt 0.0005: 0.50 (0.60) | none does |"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("| scene | exact: ms | p99, p99.9 | missed, invented | over pdm |"), std::string::npos);
    EXPECT_NE(text.find("| orb | 20.0 (20.0) | 1.0e-6, 1.0e-5 | 0, 0 | dt 0.0005: 0.50 (0.60) |\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("| pdm dt 0.02 | 10.0 ms; 0.3; 500, 0 | 10.0 ms; 0.3; 500, 0 |"), std::string::npos) << text;
    EXPECT_NE(text.find("- fur: pdm dt 0.00025 was not <measured>"), std::string::npos);
}

TEST(Plots, MarkTheFrontAndHollowPoints) {
    const Comparison c = made_up();
    const Plot plot = scene_plot(c, c.scenes[0], PlottedError::p999);
    ASSERT_EQ(plot.series.size(), 2u);
    EXPECT_EQ(plot.series[1].points[0].label, "0.02");
    EXPECT_TRUE(plot.series[1].points[0].hollow);
    EXPECT_FALSE(plot.series[0].points[0].hollow);
    const std::string svg = plot_svg(plot, true);
    EXPECT_NE(svg.find("xmlns"), std::string::npos);
    // Two of the three points are not beaten; one ring stands in the legend.
    std::size_t rings = 0;
    for (auto at = svg.find("class='ring'"); at != std::string::npos; at = svg.find("class='ring'", at + 1))
        ++rings;
    EXPECT_EQ(rings, 3u);
    EXPECT_EQ(overall_plot(c, PlottedError::p99).series.size(), 6u);
}

TEST(Plots, LinesBreakWhereAnotherBeginsAndLongLegendsWrap) {
    Plot plot;
    plot.series.push_back({"dbvh", 0, {}, false});
    const auto add = [&](double x, const char* line) {
        PlotPoint p;
        p.x = p.y = p.x_low = p.x_high = x;
        p.line = line;
        plot.series[0].points.push_back(p);
    };
    add(1, "box");
    add(2, "box");
    add(3, "bilinear");
    const std::string svg = plot_svg(plot, true);
    const auto from = svg.find(" d='M", svg.find("stroke-opacity='0.75'")), to = svg.find("'/>", from);
    const std::string line = svg.substr(from + 4, to - from - 4);
    EXPECT_EQ(std::count(line.begin(), line.end(), 'M'), 2) << line;
    EXPECT_EQ(std::count(line.begin(), line.end(), 'L'), 1) << line;
    EXPECT_EQ(svg.find("translate(74.0 61.0)"), std::string::npos);
    for (int i = 0; i < 8; ++i) plot.series.push_back({"another method", i, {}, false});
    EXPECT_NE(plot_svg(plot, true).find("translate(74.0 61.0)"), std::string::npos);
}

TEST(Plots, OfNothingAreEmptyAxes) {
    Comparison c = made_up();
    for (ComparedScene& s : c.scenes)
        for (ComparedPoint& p : s.points) p.primary = {};
    EXPECT_NE(plot_svg(scene_plot(c, c.scenes[0], PlottedError::p99), true).find("</svg>"),
              std::string::npos);
    EXPECT_NE(plot_svg(overall_plot(c, PlottedError::p99), true).find("</svg>"), std::string::npos);
}

TEST(Words, AreShort) {
    EXPECT_EQ(error_text(0), "0");
    EXPECT_EQ(error_text(3.44e-6), "3.4e-6");
    EXPECT_EQ(error_text(0.184), "0.18");
    EXPECT_EQ(error_text(77), "77");
    EXPECT_EQ(ms_text(0.4249), "0.42");
    EXPECT_EQ(ms_text(845.3), "845");
    EXPECT_EQ(bytes_text(3200000), "3.2 MB");
    EXPECT_EQ(percent_text(0.153), "15.3%");
}

}  // namespace
}  // namespace relievo::report_test
