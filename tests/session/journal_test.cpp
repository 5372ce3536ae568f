// Journals: bit-exact round trips, torn lines, and every kind of wrong line named by file, line and key.
#include "editor/session/journal.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/session/test_scene.h"

namespace relievo::journal_test {
namespace {

constexpr const char* kHeader = "{\"relievo_journal\":1}\n";

Journal read_back(const JournalHeader& header, const std::vector<JournalOp>& ops) {
    const test::TemporaryFolder folder;
    std::string text = format_header(header) + "\n";
    for (const JournalOp& op : ops) text += format_op(op) + "\n";
    test::write_text(folder.path() / "a.jsonl", text);
    return read_journal(folder.path() / "a.jsonl");
}

std::string error_of(const std::string& text) {
    const test::TemporaryFolder folder;
    test::write_text(folder.path() / "a.jsonl", text);
    try {
        read_journal(folder.path() / "a.jsonl");
    } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        const std::string file = (folder.path() / "a.jsonl").string();
        EXPECT_TRUE(message.starts_with(file)) << message;
        return message.substr(std::min(message.size(), file.size()));
    }
    return "no error";
}

TEST(Journal, EveryOperationReadsBackEqual) {
    JournalHeader header{"0.1.0", "../a scene/\"quoted\" ä.json", 0x0123456789abcdef, 0xf, 8192, 1, 0.1, -0.3,
                         1u << 29, "colours.png", 0xfedcba9876543210, "map.tif.mask.png", 1};
    Dab last{4294967295u, 22300, 1048576, 0, 0};
    const std::vector<JournalOp> ops{
        StrokeOp{Brush{}, {Dab{}, last}},
        StrokeOp{Brush{Tool::erase, Falloff::constant, true, 3.3f, 1.0f, 0.7f, 0.02f, 0.1f}, {}},
        StrokeOp{Brush{.tool = Tool::noise, .grain = 0.3f, .seed = 7, .accumulate = false},
                 {Dab{.size = 1}, Dab{.drag = {-Dab::kLargestDrag, 0, 17}}}},
        StrokeOp{Brush{.mirror_x = true, .radial = 2, .radial_axis = Axis::z},
                 {Dab{}, Dab{}},
                 {{FacePoint{7, 1, 2}, FacePoint{8, 1048576, 0}}, {{}, {}}, {{}, {}}}},
        StrokeOp{Brush{.tool = Tool::stamp, .stamp_spacing = 1.5f, .rotation = -90},
                 {Dab{.drag = {65536, 0, -1}}},
                 {},
                 AlphaRef{"../alphas/\"ä\".png", 0x0fedcba987654321}},
        StrokeOp{Brush{.tool = Tool::clone, .mirror_y = true},
                 {Dab{}, Dab{}},
                 {{FacePoint{3, 4, 5}, {}}},
                 std::nullopt,
                 {{FacePoint{1, 2, 3}, FacePoint{6, 0, 1048576}}, {{}, {}}}},
        StrokeOp{Brush{.tool = Tool::erase, .erase_to = EraseTo::saved}, {}},
        StrokeOp{Brush{.falloff = Falloff::custom}, {}},
        StrokeOp{Brush{.falloff = Falloff::custom,
                       .falloff_curve = FalloffCurve(std::array{CurvePoint{0, 0.1f}, CurvePoint{1.0f / 3, 1},
                                                                CurvePoint{0.99f, 0}, CurvePoint{1, 0.7f}})},
                 {}},
        StrokeOp{Brush{.tool = Tool::mask, .blur = true}, {}},
        MaskOp{MaskCommand::blur},
        UndoOp{},
        RedoOp{},
        SetOp{"amplitude", 0.1},
        SetOp{"method", std::string("pdm")},
        SetOp{"camera", std::vector<double>{1.0 / 3, -2e-300, 5e20}},
        ExpectOp{0xdeadbeefcafef00d},
        ExpectOp{1, 2},
        ExpectImageOp{"golden/a.png", 0.02, 16, ImageSize{640, 480}},
        ExpectImageOp{"b.png", 0, std::nullopt, std::nullopt},
        RenderOp{"out.png", 1, std::nullopt},
        SaveOp{"/tmp/map.tif", 0},
        SaveOp{"/tmp/map.tif", 0, {}, std::nullopt, 7},
        SaveOp{"map.png", std::nullopt},
    };
    const Journal journal = read_back(header, ops);
    EXPECT_EQ(journal.header, header);
    ASSERT_EQ(journal.entries.size(), ops.size());
    for (std::size_t i = 0; i < ops.size(); ++i) {
        EXPECT_EQ(journal.entries[i].op, ops[i]) << format_op(ops[i]);
        EXPECT_EQ(journal.entries[i].line, static_cast<int>(i) + 2);
    }
    EXPECT_TRUE(journal.warnings.empty());
}

TEST(Journal, FloatsOfEveryMagnitudeReadBackBitForBit) {
    std::mt19937 random(7);
    std::vector<JournalOp> ops;
    while (ops.size() < 3000) {
        Brush brush;
        const float radius = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!(radius >= 1e-6f && radius <= 1e6f)) continue;
        brush.radius = radius;
        brush.strength = static_cast<float>(random()) / 4294967296.0f;
        brush.level = std::nextafter(1.0f, 0.0f);
        const double value = std::bit_cast<double>((std::uint64_t{random()} << 32) | random());
        ops.emplace_back(StrokeOp{brush, {}});
        ops.emplace_back(SetOp{"x", std::isfinite(value) && std::abs(value) < 1e30 ? value : 0.0});
    }
    const Journal journal = read_back({}, ops);
    ASSERT_EQ(journal.entries.size(), ops.size());
    for (std::size_t i = 0; i < ops.size(); ++i)
        ASSERT_EQ(journal.entries[i].op, ops[i]) << format_op(ops[i]);
}

TEST(Journal, NewerSettingsAreLeftOutAtTheirStandard) {
    EXPECT_EQ(format_op(StrokeOp{Brush{}, {Dab{}}}),
              R"({"op":"stroke","brush":{"tool":"draw","falloff":"smooth","invert":false,"radius":0.1,)"
              R"("strength":0.5,"hardness":0,"spacing":0.15,"level":0.5},"dabs":[[0,0,0,0,65535]]})");
}

TEST(Journal, TornLastLineIsLeftOutWithAWarning) {
    const test::TemporaryFolder folder;
    const std::string stroke = format_op(StrokeOp{Brush{}, {Dab{}}});
    const std::string whole = std::string(kHeader) + "{\"op\":\"undo\"}\n";
    for (std::size_t cut = 1; cut < stroke.size(); ++cut) {
        test::write_text(folder.path() / "a.jsonl", whole + stroke.substr(0, cut));
        const Journal journal = read_journal(folder.path() / "a.jsonl");
        ASSERT_EQ(journal.entries.size(), 1u) << cut;
        ASSERT_EQ(journal.warnings.size(), 1u) << cut;
        EXPECT_NE(journal.warnings[0].find("a.jsonl:3: the last line was cut off"), std::string::npos);
    }
    test::write_text(folder.path() / "a.jsonl", whole + std::string(100, '\0'));
    EXPECT_EQ(read_journal(folder.path() / "a.jsonl").entries.size(), 1u);
}

TEST(Journal, BrokenLineInTheMiddleIsAnError) {
    const std::string error = error_of(std::string(kHeader) + "{\"op\":\"un\n{\"op\":\"undo\"}\n");
    EXPECT_NE(error.find(":2: column"), std::string::npos) << error;
    EXPECT_NE(error.find("not JSON"), std::string::npos) << error;
}

TEST(Journal, BlankLinesAndWindowsLineEndsAreRead) {
    const test::TemporaryFolder folder;
    test::write_text(folder.path() / "a.jsonl",
                     "{\"relievo_journal\":1}\r\n\r\n  \n{\"op\":\"undo\"}\r\n{\"op\":\"redo\"}");
    const Journal journal = read_journal(folder.path() / "a.jsonl");
    ASSERT_EQ(journal.entries.size(), 2u);
    EXPECT_EQ(journal.entries[1].line, 5);
}

TEST(Journal, WrongKeysTypesAndRangesAreNamed) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"op":"fly"})", ":2: op: is \"fly\", must be one of stroke, undo"},
        {R"({"path":"a"})", ":2: op: must be a string"},
        {R"([1])", ":2: op: must be a string"},
        {R"({"op":"undo","steps":2})", ":2: steps: is not a key here; known are op"},
        {R"({"op":"set","key":"amplitude"})", ":2: value: is missing"},
        {R"({"op":"set","key":3,"value":1})", ":2: key: is a number, must be a string"},
        {R"({"op":"set","key":"a","value":{}})",
         ":2: value: is an object, must be a number, string or array"},
        {R"({"op":"set","key":"a","value":[1,"b"]})", ":2: value: holds a string, must hold numbers"},
        {R"({"op":"expect","map":"xyz"})", ":2: map: is \"xyz\", must be up to 16 hexadecimal digits"},
        {R"({"op":"expect_image","image":"a.png"})", ":2: tolerance: is missing"},
        {R"({"op":"expect_image","image":"a.png","tolerance":2})", ":2: tolerance: is 2, must be in [0, 1]"},
        {R"({"op":"render","out":"a.png","spp":0})", ":2: spp: is 0, must be in [1, "},
        {R"({"op":"render","out":"a.png","spp":1.5})", ":2: spp: is a number, must be a whole number"},
        {R"({"op":"render","out":"a.png","size":[1]})", ":2: size: must be [width, height]"},
        {R"({"op":"save"})", ":2: path: is missing"},
        {R"({"op":"save","path":""})", ":2: path: is empty"},
        {R"({"op":"stroke","dabs":[]})", ":2: brush: is missing"},
        {R"({"op":"stroke","brush":[],"dabs":[]})", ":2: brush: is an array, must be an object"},
        {R"({"op":"stroke","brush":{},"dabs":1})", ":2: dabs: is a number, must be an array"},
        {R"({"op":"stroke","brush":{"tool":"saw"},"dabs":[]})",
         ":2: brush: tool: is \"saw\", must be one of draw, "},
        {R"({"op":"stroke","brush":{"falloff":"x"},"dabs":[]})",
         ":2: brush: falloff: is \"x\", must be one of smooth"},
        {R"({"op":"stroke","brush":{"radius":"big"},"dabs":[]})",
         ":2: brush: radius: is a string, must be a number"},
        {R"({"op":"stroke","brush":{"radius":-1},"dabs":[]})", ":2: brush: radius: is -1, must be in ["},
        {R"({"op":"stroke","brush":{"strength":1.5},"dabs":[]})",
         ":2: brush: strength: is 1.5, must be in [0, 1]"},
        {R"({"op":"stroke","brush":{"invert":1},"dabs":[]})",
         ":2: brush: invert: is a number, must be true or false"},
        {R"({"op":"stroke","brush":{"size":1},"dabs":[]})",
         ":2: brush: size: is not a key here; known are tool"},
        {R"({"op":"stroke","brush":{},"dabs":[[0,0,0,0]]})",
         ":2: dabs[0]: must be [time_us, face, b1, b2, pressure]"},
        {R"({"op":"stroke","brush":{},"dabs":[[0,0,0,0,1,0]]})",
         ":2: dabs[0][5]: is 0, must be in [1, 65535]"},
        {R"({"op":"stroke","brush":{},"dabs":[[0,0,0,0,1,1,0,0,1e9]]})", ":2: dabs[0][8]: is a number, must"},
        {R"({"op":"mask","do":"fold"})", ":2: do: is \"fold\", must be one of clear, invert, blur"},
        {R"({"op":"stroke","brush":{},"dabs":[],"copies":[[[0,0,0]]]})",
         ":2: copies[0]: must be an array of one place a dab: 0"},
        {R"({"op":"stroke","brush":{"radial_axis":"w"},"dabs":[]})",
         ":2: brush: radial_axis: is \"w\", must be one of x, y, z"},
        {R"({"op":"stroke","brush":{"erase_to":"zero"},"dabs":[]})",
         ":2: brush: erase_to: is \"zero\", must be one of midlevel, saved"},
        {R"({"op":"stroke","brush":{"falloff_curve":[[0,1]]},"dabs":[]})",
         ":2: brush: falloff_curve: must be an array of 2 to 8 points [part, weight]"},
        {R"({"op":"stroke","brush":{"falloff_curve":[[0,1],[1,"a"]]},"dabs":[]})",
         ":2: brush: falloff_curve[1]: must be [part, weight], two numbers"},
        {R"({"op":"stroke","brush":{"falloff_curve":[[0.1,1],[1,0]]},"dabs":[]})",
         ":2: brush: falloff_curve[0]: must lie at 0, the middle"},
        {R"({"op":"stroke","brush":{"falloff_curve":[[0,1],[0.5,0],[0.25,0],[1,0]]},"dabs":[]})",
         ":2: brush: falloff_curve[2]: must lie at least 0.0078125 beyond the one before, at 0.5"},
        {R"({"op":"stroke","brush":{"falloff_curve":[[0,1],[0.9,0]]},"dabs":[]})",
         ":2: brush: falloff_curve[1]: must lie at 1, the rim"},
        {R"({"op":"stroke","brush":{"falloff_curve":[[0,1],[1,1e300]]},"dabs":[]})",
         ":2: brush: falloff_curve[1]: must have a weight in [0, 1]"},
        {R"({"op":"stroke","brush":{"seed":-1},"dabs":[]})", ":2: brush: seed: is -1, must be in [0, 65535]"},
        {R"({"op":"stroke","brush":{},"dabs":[[0,0,0,0,-1]]})",
         ":2: dabs[0][4]: is -1, must be in [0, 65535]"},
        {R"({"op":"stroke","brush":{},"dabs":[[0,0,0,0,1],[0.5,0,0,0,1]]})",
         ":2: dabs[1][0]: is a number, must be a"},
        {R"({"op":"stroke","brush":{},"dabs":[[0,18446744073709551615,0,0,1]]})",
         ":2: dabs[0][1]: is 18446744073709"},
        {R"({"op":"stroke","brush":{},"dabs":[[0,0,600000,600000,1]]})",
         ":2: dabs[0]: b1 + b2 is 1200000, must be"},
    };
    for (const auto& [line, expected] : cases) {
        const std::string error = error_of(std::string(kHeader) + line + "\n");
        EXPECT_TRUE(error.starts_with(expected)) << line << "\n  " << error;
    }
}

TEST(Journal, WrongHeadersAreNamed) {
    EXPECT_EQ(error_of(""), ": is empty, must begin with a journal's header");
    EXPECT_TRUE(error_of("{\"op\":\"undo\"}\n").starts_with(":1: not a journal"));
    EXPECT_TRUE(
        error_of("{\"relievo_journal\":2}\n").starts_with(":1: relievo_journal: is 2, this program reads 1"));
    EXPECT_TRUE(error_of("{\"relievo_journal\":1,\"mid\":0}\n").starts_with(":1: mid: is not a key here"));
    EXPECT_TRUE(
        error_of("{\"relievo_journal\":1,\"midlevel\":2}\n").starts_with(":1: midlevel: is 2, must be"));
    EXPECT_TRUE(error_of("{\"relievo_journal\":1").starts_with(":1: column"));
    EXPECT_THROW(read_journal("/nowhere/a.jsonl"), std::invalid_argument);
    EXPECT_THROW(read_journal("/tmp"), std::invalid_argument);
}

TEST(Journal, NamesThatAreNotUtf8AreRefused) {
    EXPECT_THROW(format_op(RenderOp{"a\xff.png", std::nullopt, std::nullopt}), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::journal_test
