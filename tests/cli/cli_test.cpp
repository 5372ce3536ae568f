// The program from end to end: exit status, one clear line for each bad input, and nothing lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "editor/session/image_file.h"
#include "editor/session/journal.h"
#include "tests/cli/program.h"
#include "tests/session/test_scene.h"

namespace relievo::cli_test {
namespace {

using test::Outcome;
using test::run_program;
using test::TemporaryFolder;
using test::write_scene;
using test::write_text;

constexpr const char* kStroke =
    R"({"op":"stroke","brush":{"tool":"draw","radius":0.3,"strength":1},"dabs":[[0,60,300000,300000,65535]]})"
    "\n";

class Program : public testing::Test {
  protected:
    Program() : scene_(write_scene(folder_.path()).string()), journal_(path("a.jsonl")) {
        write_text(journal_, "{\"relievo_journal\":1,\"scene\":\"scene.json\"}\n" + std::string(kStroke));
    }

    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    // One line on stderr, nothing on stdout.
    static void expect_refused(const std::vector<std::string>& arguments, const std::string& words,
                               int status = 2, const test::Surroundings& surroundings = {}) {
        const Outcome outcome = run_program(arguments, surroundings);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(outcome.err.starts_with("relievo: ")) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << "expected: " << words << "\n" << outcome.err;
    }

    void change_scene(const std::string& from, const std::string& to) {
        std::string text = test::read_text(scene_);
        text.replace(text.find(from), from.size(), to);
        write_text(scene_, text);
    }

    TemporaryFolder folder_;
    std::string scene_, journal_;
};

TEST_F(Program, EveryVerbHasHelp) {
    for (const char* verb : {"edit", "render", "replay", "compare", "bake", "explain", "devices"}) {
        const Outcome outcome = run_program({verb, "--help"});
        EXPECT_EQ(outcome.status, 0) << verb;
        EXPECT_NE(outcome.out.find("Options:"), std::string::npos) << verb;
        EXPECT_EQ(outcome.err, "") << verb;
    }
    EXPECT_EQ(run_program({"--help"}).status, 0);
    EXPECT_TRUE(run_program({"--version"}).out.starts_with("relievo "));
}

TEST_F(Program, BakesProceduralHeightsIntoAMap) {
    expect_refused({"bake", scene_, "-o", path("baked.png")}, "no object has procedural heights");
    change_scene("\"map\": \"map.tif\"", "\"procedural\": {\"exemplar\": \"map.tif\"}");
    expect_refused({"bake", scene_}, "--output is required");
    expect_refused({"bake", scene_, "-o", path("baked.jpg")}, "baked.jpg");
    expect_refused({"bake", scene_, "-o", path("baked.png"), "--size", "12"}, "--size: is \"12\"");
    const Outcome outcome = run_program({"bake", scene_, "-o", path("baked.png"), "--size", "40x30", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const auto result = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(result["width"], 40);
    EXPECT_EQ(result["displacement"]["wrap"], "clamp");
    const LoadedMap map = load_map(path("baked.png"));
    EXPECT_EQ(map.map.width(), 40);
    EXPECT_EQ(map.map.height(), 30);
}

TEST_F(Program, WrongUsageIsOneLine) {
    expect_refused({"rendr"},
                   "\"rendr\" is not a verb; known are edit, render, replay, compare, bake, explain, devices");
    expect_refused({"render"}, "SCENE");
    expect_refused({"render", scene_}, "--output is required");
    expect_refused({"render", scene_, "-o", path("a.png"), "--quick"}, "--quick");
    expect_refused({"render", scene_, "-o", path("a.png"), "--spp", "0"}, "--spp");
    expect_refused({"render", scene_, "-o", path("a.png"), "--spp", "many"}, "--spp");
    expect_refused({"render", scene_, "-o", path("a.png"), "--size", "12"}, "--size: is \"12\", must be WxH");
    expect_refused({"render", scene_, "-o", path("a.png"), "--size", "0x5"}, "--size");
    expect_refused({"render", scene_, "-o", path("a.png"), "--path", "fast"},
                   "must be ray-query, pipeline or bvh");
    expect_refused({"render", scene_, "-o", path("a.png"), "--method", "magic"}, "magic");
    expect_refused({"render", scene_, "-o", path("a.png"), "--set", "dt"},
                   "--set: is \"dt\", must be PARAM=NUMBER");
    expect_refused({"render", scene_, "-o", path("a.png"), "--set", "dt=x"}, "--set");
    expect_refused({"render", scene_, "-o", path("a.exr"), "--aov", "Z,depth"}, "\"depth\" is not a layer");
    expect_refused({"render", scene_, "-o", path("a.png"), "--aov", "Z"},
                   "--aov needs a file that ends in .exr");
    expect_refused({"render", scene_, "-o", path("a.jpg")}, "must end in .png or .exr");
    EXPECT_FALSE(std::filesystem::exists(path("a.png")));
}

TEST_F(Program, BadScenesAreRefusedWithoutADevice) {
    const auto replaying = [&](const std::string& words) {
        expect_refused({"replay", journal_, "-o", path("out.png")}, words, 2, test::without_vulkan());
    };
    change_scene("amplitude", "amplitud");
    replaying("amplitud");
    change_scene("amplitud", "amplitude");
    change_scene("0.2", "\"big\"");
    replaying("displacement.amplitude");
    change_scene("\"big\"", "0.2");
    change_scene("\"image\"", "\"method\": {\"name\": \"pdm\", \"dt\": -1}, \"image\"");
    replaying("scene.json: method: method parameter 'dt' is -1");
    change_scene("\"dt\": -1", "\"dt\": 0.01");
    change_scene("map.tif", "none.tif");
    replaying("none.tif");
    change_scene("none.tif", "map.tif");
    std::filesystem::rename(path("sheet.obj"), path("moved.obj"));
    replaying("sheet.obj");
    write_text(path("sheet.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    replaying("texture coordinates");
    std::filesystem::rename(path("moved.obj"), path("sheet.obj"));
    const std::string map = test::read_text(path("map.tif"));
    write_text(path("map.tif"), map.substr(0, map.size() / 2));
    replaying("map.tif");
    write_text(path("map.tif"), map);
    write_text(scene_, "{\"relievo\": 1,");
    replaying("scene.json");
    std::filesystem::remove(scene_);
    replaying("scene.json");
    EXPECT_FALSE(std::filesystem::exists(path("out.png")));
}

TEST_F(Program, BadJournalsAreRefused) {
    expect_refused({"replay", path("none.jsonl")}, "none.jsonl: no such journal");
    write_text(journal_, "{\"relievo_journal\":1}\n" + std::string(kStroke));
    expect_refused({"replay", journal_}, "a.jsonl:1: scene: is missing; add it, or give --scene SCENE");
    EXPECT_EQ(run_program({"replay", journal_, "--scene", scene_}).status, 0);
    write_text(journal_, "{\"relievo_journal\":1,\"scene\":\"scene.json\"}\n{\"op\":\"strok\"}\n");
    expect_refused({"replay", journal_}, "a.jsonl:2: op: is \"strok\"");
    write_text(journal_, "{\"relievo_journal\":1,\"scene\":\"scene.json\",\"map_hash\":\"1\"}\n");
    expect_refused({"replay", journal_}, "a.jsonl:1: map_hash: recorded on map 0000000000000001");
    EXPECT_EQ(run_program({"replay", journal_, "--force"}).status, 0);
}

TEST_F(Program, UnwritableOutputsAreRefusedBeforeTheWork) {
    expect_refused({"replay", journal_, "-o", path("no/out.png")}, "no/out.png");
    expect_refused({"replay", journal_, "-o", path("out.bmp")}, "out.bmp");
    expect_refused({"replay", journal_, "-o", folder_.path().string()}, folder_.path().string());
    expect_refused({"replay", journal_, "--render", path("no/a.png")}, "no/a.png");
    expect_refused({"render", scene_, "-o", path("no/a.png")}, "no/a.png");
}

TEST_F(Program, AFullDiskWhileSavingKeepsTheOldMapWhole) {
    const std::string before = test::read_text(path("map.tif"));
    test::Surroundings full = test::without_vulkan();
    full.file_size_limit = 300;
    expect_refused({"replay", journal_, "-o", path("map.tif")}, "map.tif", 2, full);
    EXPECT_TRUE(test::read_text(path("map.tif")) == before);
    for (const auto& file : std::filesystem::directory_iterator(folder_.path()))
        EXPECT_EQ(file.path().filename().string().find(".map.tif"), std::string::npos)
            << "a temporary file is left";
}

TEST_F(Program, ReplayWritesHeightsAloneUnlessColoursAreAskedFor) {
    const std::string painted =
        std::string(kStroke).insert(std::string(kStroke).find("\"radius\""), "\"paint\":\"both\",");
    write_text(
        journal_,
        "{\"relievo_journal\":1,\"scene\":\"scene.json\"}\n{\"op\":\"colour_map\",\"bits\":16}\n" + painted);
    EXPECT_EQ(run_program({"replay", journal_, "-o", path("a.tif")}).status, 0);
    EXPECT_FALSE(std::filesystem::exists(path("a_colour.png")));
    for (const char* name : {"c.png", "d.png"})
        EXPECT_EQ(run_program({"replay", journal_, "--colour-output", path(name)}).status, 0);
    EXPECT_EQ(test::read_text(path("c.png")), test::read_text(path("d.png")));
    const Outcome json = run_program({"replay", journal_, "--json"});
    EXPECT_EQ(nlohmann::json::parse(json.out)["colour_hash"].get<std::string>().size(), 16u);
    // What was painted goes on being painted.
    write_text(journal_, "{\"relievo_journal\":1,\"scene\":\"scene.json\"}\n" + painted);
    EXPECT_EQ(
        run_program({"replay", journal_, "--colour-map", path("c.png"), "--colour-output", path("e.tif")})
            .status,
        0);
    expect_refused({"replay", journal_, "--colour-map", path("none.png")}, "none.png': no such file");
    expect_refused({"replay", journal_, "--colour-output", path("e.exr")}, "use .png, .tif or .tiff");
    expect_refused({"replay", journal_}, ":2: painting needs a colour map: make one first");
}

TEST_F(Program, TwoOutputsInOneFileAreRefused) {
    std::filesystem::create_directory(path("folder"));
    const std::string out = path("both.tif"), same = path("folder/../both.tif");
    expect_refused({"replay", journal_, "-o", out, "--colour-output", same}, "is what --output writes");
    expect_refused({"replay", journal_, "-o", path("a.exr"), "--render", path("a.exr")}, "--render: ");
    expect_refused({"replay", journal_, "--render", path("a.png"), "--render-before", path("a.png")},
                   "is what --render-before writes");
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Program, ReplayNeedsNoDeviceAndGivesTheSameFileEveryTime) {
    for (const char* name : {"a.tif", "b.tif"})
        ASSERT_EQ(run_program({"replay", journal_, "-o", path(name)}, test::without_vulkan()).status, 0);
    EXPECT_TRUE(test::read_text(path("a.tif")) == test::read_text(path("b.tif")));
    EXPECT_NE(load_map(path("a.tif")).map.hash(), load_map(path("map.tif")).map.hash());
}

TEST_F(Program, ReplayAnswersInJson) {
    const Outcome outcome = run_program({"replay", journal_, "-o", path("a.exr"), "--json", "--timings"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto answer = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(answer["strokes"], 1);
    EXPECT_EQ(answer["dabs"], 1);
    EXPECT_EQ(answer["timings"][0]["stage"], "edit");
    EXPECT_EQ(answer["map_hash"], hash_text(load_map(path("a.exr")).map.hash()));
}

TEST_F(Program, AFailedExpectationIsStatusOneWithTheDifference) {
    write_text(journal_, test::read_text(journal_) + "{\"op\":\"expect\",\"map\":\"12\"}\n");
    const Outcome outcome = run_program({"replay", journal_, "-o", path("out.png")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("a.jsonl:3: expect: the map should be 0000000000000012, it is "),
              std::string::npos)
        << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(path("out.png"))) << "what was sculpted is there to be looked at";
}

TEST_F(Program, ATornJournalIsReplayedWithAWarning) {
    write_text(journal_, test::read_text(journal_) + std::string(kStroke).substr(0, 40));
    const Outcome outcome = run_program({"replay", journal_, "--json"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("warning: "), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["strokes"], 1);
}

TEST_F(Program, WithoutADeviceRenderSaysWhatToInstall) {
    expect_refused({"render", scene_, "-o", path("a.png")}, "mesa-vulkan-drivers", 1, test::without_vulkan());
    const Outcome devices = run_program({"devices", "--json"}, test::without_vulkan());
    EXPECT_EQ(devices.status, 0) << devices.err;
    EXPECT_TRUE(nlohmann::json::parse(devices.out)["devices"].empty());
}

TEST_F(Program, RenderWritesPngAndLayers) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device with ray tracing";
    EXPECT_EQ(run_program({"render", scene_, "-o", path("a.png"), "--spp", "1"}).status, 0);
    EXPECT_TRUE(std::filesystem::exists(path("a.png")));
    const Outcome outcome = run_program({"render", scene_, "-o", path("a.exr"), "--aov", "Z,N,Ns,uv,id",
                                         "--size", "33x17", "--spp", "3", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto answer = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(answer["width"], 33);
    EXPECT_EQ(answer["spp"], 3);
}

TEST_F(Program, TheReferenceRendersWithoutADevice) {
    const std::vector<std::string> ask{"render", scene_, "--method", "reference", "--size", "33x17", "-o"};
    const auto with = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = ask;
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    EXPECT_EQ(run_program(with({path("a.png")}), test::without_vulkan()).status, 0);
    EXPECT_EQ(read_display_picture(path("a.png")).width, 33);
    const Outcome outcome =
        run_program(with({path("a.exr"), "--aov", "Z,N,uv,id", "--json"}), test::without_vulkan());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto answer = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(answer["height"], 17);
    EXPECT_EQ(answer["method"], "reference");
    EXPECT_EQ(answer["undecided"], 0);
    expect_refused(with({path("b.exr"), "--aov", "Ns"}), "no layer Ns; it has Z, N, uv, id");
    expect_refused(with({path("b.exr"), "--set", "dt=0.1"}), "--set: does not go with --method reference");
    expect_refused(with({path("b.exr"), "--path", "pipeline"}), "--path: does not go");
    expect_refused(with({path("b.exr"), "--spp", "4"}), "--spp: does not go");
    expect_refused(with({path("b.png"), "--aov", "Z"}), "--aov needs a file that ends in .exr");
    EXPECT_FALSE(std::filesystem::exists(path("b.exr")));
}

TEST_F(Program, ParametersTakeTheNamesOfTheirValues) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device with ray tracing";
    const Outcome outcome = run_program({"explain", scene_, "--method", "dbvh", "--set", "leaf=triangles"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("leaf triangles, level 0"), std::string::npos) << outcome.out;
    expect_refused({"explain", scene_, "--method", "dbvh", "--set", "leaf=4"},
                   "method parameter 'leaf' is 4, must be 0 (box), 1 (triangles), 2 (bilinear), 3 (bspline)");
}

TEST_F(Program, SceneFilesTakeTheNamesOfValuesToo) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device with ray tracing";
    const auto with = [&](const std::string& method) {
        write_text(path("words.json"),
                   R"({"relievo": 1, "objects": [{"mesh": "sheet.obj"}], "method": )" + method + "}");
        return path("words.json");
    };
    for (const char* leaf : {"\"triangles\"", "1"}) {
        const Outcome outcome =
            run_program({"explain", with(R"({"name": "dbvh", "leaf": )" + std::string(leaf) + "}")});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(outcome.out.find("leaf triangles, level 0"), std::string::npos) << outcome.out;
    }
    expect_refused({"explain", with(R"({"name": "dbvh", "leaf": "balls"})")},
                   "words.json: method: method parameter 'leaf' is \"balls\", must be 0 (box), 1 (triangles), 2 "
                   "(bilinear), 3 (bspline)");
    expect_refused({"explain", with(R"({"name": "pdm", "dt": "small"})")},
                   "words.json: method: method parameter 'dt' is \"small\", must be a number");
    expect_refused({"explain", with(R"({"name": "pdm", "leaf": "box"})")}, "has no parameter 'leaf'");
}

TEST_F(Program, ExplainSaysWhatIsBuiltAndWhyInText) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device with ray tracing";
    const Outcome outcome = run_program({"explain", scene_, "--method", "pdm", "--set", "dt=0.01"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const char* text : {"method  pdm (Projective displacement mapping): dt 0.01, jitter on",
                             "sheet.obj: 128 triangles, map of 64 x 64", "\nbuilt\n", "\nleft out\n", " kB",
                             "of device memory", "method pdm samples heights"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text << "\n" << outcome.out;
    // Reasons stand in one column, behind three spaces.
    const std::size_t total = outcome.out.find("of device memory");
    const std::size_t column = total - outcome.out.rfind('\n', total) - 1;
    std::istringstream lines(outcome.out);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  ")) continue;
        ASSERT_GT(line.size(), column) << line;
        EXPECT_EQ(line.substr(column - 3, 3), "   ") << line;
        EXPECT_NE(line[column], ' ') << line;
    }
}

TEST_F(Program, ExplainAnswersInJson) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device with ray tracing";
    const Outcome outcome = run_program({"explain", scene_, "--method", "exact", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto answer = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(answer["method"], "exact");
    EXPECT_EQ(answer["parameters"]["correct_normals"], 1);
    EXPECT_FALSE(answer["device"].empty());
    EXPECT_EQ(answer["objects"][0]["triangles"], 128);
    std::uint64_t sum = 0;
    for (const auto& feature : answer["features"]) {
        EXPECT_FALSE(feature["reason"].empty()) << feature["name"];
        sum += feature["bytes"].get<std::uint64_t>();
        EXPECT_TRUE(feature["name"] != "bounds about planes" || feature["built"]);
    }
    EXPECT_EQ(answer["bytes_total"], sum);
    expect_refused({"explain", scene_, "--method", "reference"}, "there is no method 'reference'");
}

TEST_F(Program, AJournalRendersAndComparesPictures) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device with ray tracing";
    const std::string start = "{\"relievo_journal\":1,\"scene\":\"scene.json\"}\n";
    const std::string render = "{\"op\":\"render\",\"out\":\"before.png\",\"spp\":8,\"size\":[96,96]}\n";
    const std::string expect =
        "{\"op\":\"expect_image\",\"image\":\"before.png\",\"tolerance\":0.0005,\"spp\":8}\n";
    write_text(journal_, start + render + expect);
    EXPECT_EQ(run_program({"replay", journal_}).status, 0);
    write_text(journal_, start + kStroke + expect);
    const Outcome outcome = run_program({"replay", journal_, "-o", path("out.png")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("a.jsonl:3: expect_image: differs from before.png by rmse "),
              std::string::npos)
        << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(path("before.got.png")));
}

TEST_F(Program, ReplayLeavesPicturesMapAndTimings) {
    if (!test::have_device()) GTEST_SKIP() << "no Vulkan device with ray tracing";
    const Outcome outcome =
        run_program({"replay", journal_, "-o", path("out.tif"), "--render", path("after.png"),
                     "--render-before", path("before.png"), "--timings", "--live", "--spp", "1"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(test::read_text(path("before.png")) != test::read_text(path("after.png")));
    for (const char* stage : {"edit", "upload", "bounds", "refit", "trace"})
        EXPECT_NE(outcome.out.find(stage), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace relievo::cli_test
