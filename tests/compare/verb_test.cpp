// relievo compare as its users run it: the files that it leaves, a budget that is kept, and one line for bad
// input.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "brushes/map_file.h"
#include "tests/cli/program.h"
#include "tests/session/test_scene.h"

namespace relievo::verb_test {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_program;

class CompareVerb : public testing::Test {
  protected:
    CompareVerb() : scene_(test::write_scene(folder_.path()).string()) {}

    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    static void expect_refused(const std::vector<std::string>& arguments, const std::string& words) {
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }

    // An irregular lump of 20 triangles with a wavy map.
    std::string write_lump() const {
        constexpr double kPhi = 1.618033988749895;
        constexpr double kVertices[12][3] = {{-1, kPhi, 0}, {1, kPhi, 0}, {-1, -kPhi, 0}, {1, -kPhi, 0},
                                             {0, -1, kPhi}, {0, 1, kPhi}, {0, -1, -kPhi}, {0, 1, -kPhi},
                                             {kPhi, 0, -1}, {kPhi, 0, 1}, {-kPhi, 0, -1}, {-kPhi, 0, 1}};
        constexpr int kFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
        std::ostringstream obj;
        for (int i = 0; i < 12; ++i) {
            const double* v = kVertices[i];
            const double r = 0.35 + 0.4 * (i * 7 % 12) / 12;
            obj << "v " << v[0] * r << " " << v[1] * r << " " << v[2] * r << "\nvt " << 0.5 + 0.2 * v[0]
                << " " << 0.5 + 0.2 * v[1] + 0.05 * v[2] << "\n";
        }
        for (const auto& f : kFaces) {
            obj << "f";
            for (const int corner : f) obj << " " << corner + 1 << "/" << corner + 1;
            obj << "\n";
        }
        test::write_text(path("lump.obj"), obj.str());
        HeightMap map(64, 64);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                map.set(x, y,
                        static_cast<std::uint16_t>(32768 + 16000 * std::sin(0.14 * x) * std::cos(0.17 * y)));
        save_map(map, path("lump.tif"), MapFormat::tiff16);
        test::write_text(path("lump.json"), R"({"relievo": 1, "objects": [{"mesh": "lump.obj", "displacement":
            {"map": "lump.tif", "amplitude": 0.3, "midlevel": 0.5}}]})");
        return path("lump.json");
    }

    test::TemporaryFolder folder_;
    std::string scene_;
};

// No edits are timed there: procedural heights have none.
TEST_F(CompareVerb, MeasuresProceduralHeights) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device";
    std::string text = test::read_text(write_lump());
    const std::string map = R"("map": "lump.tif")";
    text.replace(text.find(map), map.size(), R"("procedural": {"exemplar": "lump.tif"})");
    test::write_text(path("procedural.json"), text);
    const Outcome outcome = run_program({"compare", path("procedural.json"), "-o", path("report"), "--methods",
                                         "march", "--size", "24x24"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto results = nlohmann::json::parse(test::read_text(path("report/results.json")));
    const auto& points = results["scenes"][0]["points"];
    EXPECT_GE(points.size(), 5u);
    for (const auto& point : points) EXPECT_FALSE(point.contains("edit") && !point["edit"].is_null());
}

TEST_F(CompareVerb, WritesAReportWithinItsBudget) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device";
    constexpr double kBudget = 12;
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome =
        run_program({"compare", scene_, "-o", path("report"), "--budget", "12", "--size", "64x48", "--json"});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_LT(seconds, kBudget + 4);
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json, nlohmann::json::parse(test::read_text(path("report/results.json"))));
    EXPECT_LE(json["spent_s"], kBudget + 3);
    ASSERT_EQ(json["scenes"].size(), 1u);
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["frame"], nlohmann::json({64, 48}));
    ASSERT_GE(scene["points"].size(), 2u);
    const auto& first = scene["points"][0];
    EXPECT_GT(first["errors"]["both"], 100);
    EXPECT_GT(first["per_ray"]["boxes"], 0);
    EXPECT_GT(first["bytes"], 1000);
    EXPECT_GE(first["primary_ms"]["rounds"], 1);
    EXPECT_GT(first["primary_ms"]["wall"]["median"], 0);
    EXPECT_GT(first["primary_ms"]["device"]["median"], 0);
    EXPECT_GT(first["edge_gap"]["points"], 100);
    for (const auto& point : scene["points"]) {
        EXPECT_TRUE(fs::exists(folder_.path() / "report" / point["picture"].get<std::string>()));
        EXPECT_TRUE(fs::exists(folder_.path() / "report" / point["error_map"].get<std::string>()));
    }
    for (const char* file : {"index.html", "results.csv", "summary.md", "plot_all.svg", "plot_scene.svg"})
        EXPECT_GT(fs::file_size(folder_.path() / "report" / file), 200u) << file;
    EXPECT_EQ(test::read_text(path("report/index.html")).find("http"), std::string::npos);
}

TEST_F(CompareVerb, JudgesTheMethodsThatAreAskedForTheFirstFirst) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device";
    const Outcome outcome = run_program({"compare", scene_, "-o", path("report"), "--budget", "6", "--size",
                                         "32x32", "--methods", "exact", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("--budget"), std::string::npos) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["methods"], nlohmann::json({"exact"}));
    ASSERT_EQ(json["scenes"][0]["points"].size(), 1u);
    const auto& errors = json["scenes"][0]["points"][0]["errors"];
    EXPECT_EQ(errors["missed"], 0);
    EXPECT_LE(errors["depth"]["p99"], 1e-4);
    EXPECT_LE(json["scenes"][0]["points"][0]["edge_gap"]["gap"]["max"], 1e-4);
}

TEST_F(CompareVerb, SaysAtTheStartThatABudgetIsTooSmallToBeKept) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device";
    const Outcome outcome = run_program(
        {"compare", scene_, "-o", path("report"), "--budget", "1", "--size", "16x16", "--methods", "exact"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(
        outcome.err.find("--budget: the first method is measured once on every scene, which takes about 5 s"),
        std::string::npos)
        << outcome.err;
}

TEST_F(CompareVerb, ShowsTheSampledMethodsGapAtEveryStepAndNoneOfTheExactOne) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device";
    const Outcome outcome = run_program({"compare", write_lump(), "-o", path("report"), "--size", "48x48",
                                         "--methods", "exact,pdm", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto points = nlohmann::json::parse(outcome.out)["scenes"][0]["points"];
    ASSERT_EQ(points.size(), 9u);
    const auto& exact = points[0]["edge_gap"];
    EXPECT_GT(exact["points"], 300);
    EXPECT_LT(exact["gap"]["max"], 1e-4);
    EXPECT_EQ(exact["above_0.001"], 0);
    EXPECT_EQ(exact["leaks"], 0);
    const auto& finest = points.back()["edge_gap"]["gap"];
    EXPECT_GT(finest["p99"], 2e-3);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto& gap = points[i]["edge_gap"]["gap"];
        EXPECT_NEAR(gap["median"], finest["median"], 0.1 * finest["median"].get<double>())
            << points[i]["label"];
        EXPECT_NEAR(gap["p99"], finest["p99"], 0.1 * finest["p99"].get<double>()) << points[i]["label"];
    }
}

TEST_F(CompareVerb, BadInputIsOneLine) {
    expect_refused({"compare", scene_}, "--output is required");
    expect_refused({"compare", "-o", path("report")}, "SCENE");
    expect_refused({"compare", path("none.json"), "-o", path("report")}, "none.json");
    expect_refused({"compare", scene_, "-o", path("report"), "--methods", "exact,magic"},
                   "--methods: there is no method 'magic'");
    expect_refused({"compare", scene_, "-o", path("report"), "--budget", "-3"}, "--budget");
    expect_refused({"compare", scene_, "-o", path("report"), "--size", "12"}, "--size");
    expect_refused({"compare", scene_, "-o", scene_}, "cannot make the folder");
    expect_refused({"compare", scene_, "-o", "/proc/none/report"},
                   "/proc/none/report: cannot make the folder");
    EXPECT_FALSE(fs::exists(path("report")));
}

TEST_F(CompareVerb, JudgesExtremeCases) {
    expect_refused({"compare", "-o", path("report")}, "SCENE: is required, or --stability");
    expect_refused({"compare", scene_, "-o", path("report"), "--cases", "dunes"},
                   "--cases: goes with --stability");
    expect_refused({"compare", scene_, "-o", path("report"), "--stability"}, "does not go with --stability");
    expect_refused({"compare", "-o", path("report"), "--stability", "--cases", "quicksand"}, "--cases: ");
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device";
    const Outcome outcome = run_program(
        {"compare", "-o", path("report"), "--stability", "--cases", "flat_mid,rays_in_a_plane", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["cases"].size(), 2u);
    EXPECT_EQ(json["cases"][0]["case"], "flat_mid");
    EXPECT_GE(json["cases"][0]["methods"].size(), 2u);
    for (const char* file : {"index.html", "stability.csv", "stability.json"})
        EXPECT_GT(fs::file_size(path(std::string("report/") + file)), 100u) << file;
}

}  // namespace
}  // namespace relievo::verb_test
