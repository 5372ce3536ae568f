// Painting in a session: journal and replay, saving beside the heights, recovery, and what is refused.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "brushes/colour_file.h"
#include "editor/session/recovery.h"
#include "editor/session/replay.h"
#include "renderer/vulkan/context.h"
#include "tests/session/test_scene.h"

namespace relievo::paint_test {
namespace {

namespace fs = std::filesystem;
using test::headless;
using test::sculpt;

void paint(Session& session, int row, Paint what = Paint::both, float red = 0.1f) {
    Brush& brush = session.brush();
    brush.paint = what;
    brush.red = red, brush.green = 0.7f, brush.blue = 0.9f;
    sculpt(session, row);
    brush.paint = Paint::height;
}

// The test scene with a colour map of `size` x `size` texels.
fs::path painted_scene(const fs::path& folder, int bits, int size = 64) {
    const fs::path scene = test::write_scene(folder);
    save_colours(ColourMap(size, size, bits, {40000, 30000, 20000}), folder / "bark.png");
    std::string text = test::read_text(scene);
    const std::string mesh = "\"mesh\": \"sheet.obj\",";
    text.replace(text.find(mesh), mesh.size(), mesh + " \"material\": {\"albedo_map\": \"bark.png\"},");
    test::write_text(scene, text);
    return scene;
}

std::string refusal(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

class PaintSession : public testing::Test {
  protected:
    PaintSession() { setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1); }
    fs::path at(const char* name) const { return folder_.path() / name; }
    SessionOptions recording(const char* name) const {
        SessionOptions options = headless();
        options.journal = at(name);
        return options;
    }
    test::TemporaryFolder folder_;
};

TEST_F(PaintSession, ANewMapHasTheSizeOfTheHeightsAndTheMaterialsColour) {
    Session session(test::write_scene(folder_.path()), headless());
    EXPECT_EQ(session.colours(), nullptr);
    EXPECT_EQ(refusal([&] { paint(session, 1); }), "painting needs a colour map: make one first");
    EXPECT_FALSE(session.in_stroke());
    session.brush().paint = Paint::height;
    session.set("material.albedo", std::vector<double>{1, 0.21404114, 0});  // half, encoded
    EXPECT_EQ(refusal([&] { session.make_colours(12); }), "a colour map of 12 bits: it must be 8 or 16");
    session.make_colours(8);
    ASSERT_NE(session.colours(), nullptr);
    EXPECT_EQ(session.colours()->width(), 64);
    EXPECT_EQ(session.colours()->plane(0).at(5, 5), 65535);
    EXPECT_EQ(session.colours()->plane(1).at(5, 5), 128 * 257);
    EXPECT_EQ(session.colours()->plane(2).at(5, 5), 0);
    EXPECT_FALSE(session.unsaved());
    EXPECT_FALSE(session.colour_path());
    session.save(at("first.tif"));
    EXPECT_EQ(session.colour_path(), at("first_colour.png"));
    EXPECT_EQ(refusal([&] { session.make_colours(8); }), "there is a colour map already");
}

TEST_F(PaintSession, TheColourAtAHitIsThatOfItsTexelOrTheMaterials) {
    const fs::path scene = painted_scene(folder_.path(), 16);
    ColourMap map(64, 64, 16);
    map.plane(0).set(8 * 3 + 6, 8 * 5 + 4, 65535);  // where the hit is
    map.plane(2).set(8 * 3 + 6, 8 * 5 + 4, 13107);
    save_colours(map, at("bark.png"));
    PickHit hit;
    hit.hit = true;
    hit.face = 2 * (5 * 8 + 3);
    hit.b1 = 0.3f, hit.b2 = 0.5f;
    Session session(scene, headless());
    EXPECT_EQ(session.colour_at(hit), (std::array{1.0f, 0.0f, 0.2f}));
    hit.face += 2;
    EXPECT_EQ(session.colour_at(hit), (std::array{0.0f, 0.0f, 0.0f}));
    Session bare(test::write_scene(folder_.path()), headless());
    bare.set("material.albedo", std::vector<double>{1, 0, 0.21404114});
    EXPECT_NEAR(bare.colour_at(hit)[2], 0.5f, 1e-4f);
}

TEST_F(PaintSession, AJournalReplaysToTheSameColoursAndHeights) {
    for (const int bits : {8, 16}) {
        const std::string name = "journal" + std::to_string(bits) + ".jsonl";
        const fs::path scene = test::write_scene(folder_.path());
        std::uint64_t colours = 0, heights = 0;
        {
            Session session(scene, recording(name.c_str()));
            session.make_colours(bits);
            paint(session, 1);
            sculpt(session, 2, 4, Tool::mask);
            paint(session, 2, Paint::colour, 1.0f);
            session.brush().mirror_x = true;
            paint(session, 4, Paint::both, 0.5f);
            session.brush().mirror_x = false;
            session.undo();
            session.undo();
            session.redo();
            sculpt(session, 5);
            colours = session.colours()->hash();
            heights = session.map().hash();
        }
        std::string text = test::read_text(at(name.c_str()));
        EXPECT_NE(text.find("{\"op\":\"colour_map\",\"bits\":" + std::to_string(bits) + "}"),
                  std::string::npos);
        EXPECT_NE(text.find(R"("red":0.1,"green":0.7,"blue":0.9,"paint":"both")"), std::string::npos) << text;
        text += R"({"op":"expect","map":")" + hash_text(heights) + R"(","colour":")" + hash_text(colours) +
                "\"}\n";
        text += R"({"op":"expect","map":")" + hash_text(heights) + R"(","colour":"1"})" + "\n";
        test::write_text(at("again.jsonl"), text);
        Session again(scene, headless());
        const ReplayReport report = replay(read_journal(at("again.jsonl")), again);
        ASSERT_EQ(report.failures.size(), 1u);
        EXPECT_NE(report.failures[0].find("expect: the colour map should be 0000000000000001, it is"),
                  std::string::npos);
        EXPECT_EQ(again.colours()->hash(), colours);
        EXPECT_EQ(again.map().hash(), heights);
    }
}

TEST_F(PaintSession, AStrokeIsOneStepOfBothMapsAndUnsavedUntilItIsTakenBack) {
    Session session(painted_scene(folder_.path(), 16), headless());
    const std::uint64_t colours = session.colours()->hash(), heights = session.map().hash();
    const std::uint64_t revision = session.colour_revision();
    paint(session, 2);
    EXPECT_NE(session.colours()->hash(), colours);
    EXPECT_NE(session.colour_revision(), revision);
    EXPECT_TRUE(session.unsaved());
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(session.colours()->hash(), colours);
    EXPECT_EQ(session.map().hash(), heights);
    EXPECT_FALSE(session.unsaved());
    paint(session, 2, Paint::colour);
    EXPECT_EQ(session.map().hash(), heights);
    EXPECT_TRUE(session.unsaved());
    EXPECT_TRUE(session.revert());
    EXPECT_EQ(session.colours()->hash(), colours);
}

TEST_F(PaintSession, SavesTheColoursBesideTheHeightsWithTheirBitsAndOnlyWhenTheyChanged) {
    for (const int bits : {8, 16}) {
        const fs::path folder = folder_.path() / std::to_string(bits);
        fs::create_directory(folder);
        const auto at = [&](const char* name) { return folder / name; };
        Session session(painted_scene(folder, bits), headless());
        sculpt(session, 1);
        const auto before = fs::last_write_time(at("bark.png"));
        EXPECT_TRUE(session.colour_path_for(at("map.tif")).empty());
        session.save(at("map.tif"));
        EXPECT_EQ(fs::last_write_time(at("bark.png")), before) << "no stroke painted";
        paint(session, 2);
        session.save(at("map.tif"));
        EXPECT_FALSE(session.unsaved());
        const LoadedColours saved = load_colours(at("bark.png"));
        EXPECT_EQ(saved.map.hash(), session.colours()->hash());
        EXPECT_EQ(saved.map.bits(), bits);
        session.save(at("other.tif"));
        EXPECT_EQ(load_colours(at("other_colour.png")).map.hash(), session.colours()->hash());
        test::write_text(at("third_colour.png"), "somebody's");
        session.save(at("third.tif"));
        EXPECT_EQ(test::read_text(at("third_colour.png")), "somebody's");
        EXPECT_TRUE(fs::exists(at("third_colour_2.png")));
        session.save(at("other.tif"), {at("other_colour.png")});
        paint(session, 3, Paint::colour);
        session.save(at("other.tif"), {});
        EXPECT_TRUE(session.unsaved()) << "heights alone were saved";
        session.export_colours(at("export.tif"));
        EXPECT_TRUE(session.unsaved());
        EXPECT_EQ(load_colours(at("export.tif")).map.hash(), session.colours()->hash());
        session.save(at("other.tif"));
        EXPECT_FALSE(session.unsaved());
        EXPECT_EQ(load_colours(at("other_colour.png")).map.hash(), session.colours()->hash());
    }
}

TEST_F(PaintSession, ColoursThatCannotBeWrittenLeaveBothFilesAndStayUnsaved) {
    Session session(painted_scene(folder_.path(), 8), headless());
    const std::string heights = test::read_text(at("map.tif"));
    paint(session, 2);
    EXPECT_NE(refusal([&] { session.save(at("map.tif"), {at("no/such/c.png")}); }), "");
    EXPECT_NE(refusal([&] { session.save(at("map.tif"), {at("c.exr")}); }), "");
    EXPECT_EQ(test::read_text(at("map.tif")), heights);
    EXPECT_TRUE(session.unsaved());
}

TEST_F(PaintSession, TheRecordOfASaveReplaysWithoutWriting) {
    const fs::path scene = painted_scene(folder_.path(), 8);
    {
        Session session(scene, recording("saved.jsonl"));
        paint(session, 2);
        session.save(at("new.tif"));
    }
    const fs::path colours = at("new_colour.png");
    EXPECT_TRUE(fs::remove(colours));
    Session again(scene, headless());
    EXPECT_TRUE(replay(read_journal(at("saved.jsonl")), again).failures.empty());
    EXPECT_FALSE(fs::exists(colours));
    EXPECT_FALSE(again.unsaved());
    test::write_text(at("script.jsonl"),
                     "{\"relievo_journal\":1}\n"
                     "{\"op\":\"save\",\"path\":\"s.png\",\"colour_map\":\"s_c.tif\"}\n");
    Session script(scene, headless());
    replay(read_journal(at("script.jsonl")), script);
    EXPECT_TRUE(fs::exists(at("s.png")));
    EXPECT_TRUE(fs::exists(at("s_c.tif")));
}

TEST_F(PaintSession, AJournalKnowsTheColourMapThatItBeganWith) {
    const fs::path scene = painted_scene(folder_.path(), 16);
    {
        Session session(scene, recording("begun.jsonl"));
        paint(session, 2);
    }
    const Journal journal = read_journal(at("begun.jsonl"));
    EXPECT_EQ(journal.header.colour_map, "bark.png");
    ASSERT_TRUE(journal.header.colour_hash.has_value());
    save_colours(ColourMap(64, 64, 16), at("bark.png"));
    Session other(scene, headless());
    EXPECT_NE(refusal([&] { replay(journal, other); }).find("colour_hash: recorded on colour map"),
              std::string::npos);
    Session none(test::write_scene(folder_.path()), headless());
    EXPECT_NE(refusal([&] { replay(journal, none); }).find("this scene has none"), std::string::npos);
}

TEST_F(PaintSession, AKillAfterSavingBringsHeightsAndColoursBack) {
    const fs::path scene = at("scene.json");
    SessionOptions options = headless();
    options.recovery = true;
    test::run_forked([&] {
        Session session(painted_scene(folder_.path(), 8), options);
        paint(session, 1);
        session.save(at("map.tif"));
        paint(session, 3, Paint::colour);
        std::raise(SIGKILL);
    });
    std::uint64_t wanted = 0;
    {
        const test::TemporaryFolder unsaved;
        Session session(painted_scene(unsaved.path(), 8), headless());
        paint(session, 1);
        paint(session, 3, Paint::colour);
        wanted = session.colours()->hash();
    }
    const auto found = find_abandoned_journals();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].base_colours.extension(), ".png");
    options.map = found[0].base_map;
    options.colour_map = found[0].base_colours;
    {
        Session session(scene, options);
        replay(read_journal(found[0].journal), session);
        EXPECT_EQ(session.colours()->hash(), wanted);
        EXPECT_TRUE(session.unsaved());
        EXPECT_EQ(session.colour_path_for(at("map.tif")), at("bark.png"));
    }
    for (const auto& abandoned : find_abandoned_journals()) remove_recovery(abandoned.journal);
    EXPECT_TRUE(fs::is_empty(recovery_folder())) << "what was kept goes with the journal";
}

TEST_F(PaintSession, AMapOfAnotherSizeIsShownButNotPainted) {
    Session session(painted_scene(folder_.path(), 8, 32), headless());
    EXPECT_EQ(session.colours()->width(), 32);
    EXPECT_EQ(refusal([&] { paint(session, 1); }),
              "the colour map has 32 x 32 texels, the displacement map 64 x 64: to be painted, it must have "
              "as many");
    session.brush().paint = Paint::height;
    sculpt(session, 1);
    EXPECT_TRUE(session.can_undo());
}

TEST_F(PaintSession, BadJournalsNameLineAndKey) {
    const fs::path scene = test::write_scene(folder_.path());
    const auto refused = [&](const std::string& line) {
        test::write_text(at("bad.jsonl"), "{\"relievo_journal\":1}\n" + line + "\n");
        return refusal([&] {
            Session session(scene, headless());
            replay(read_journal(at("bad.jsonl")), session);
        });
    };
    const auto has = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has(refused(R"({"op":"colour_map","bits":10})"), "bad.jsonl:2: bits: is 10, must be 8 or 16");
    has(refused(R"({"op":"colour_map"})"), "bits: is missing");
    has(refused(R"({"op":"stroke","brush":{"paint":"colours"},"dabs":[]})"),
        "paint: is \"colours\", must be one of");
    has(refused(R"({"op":"stroke","brush":{"paint":"both","red":2},"dabs":[]})"),
        "red: is 2, must be in [0, 1]");
    has(refused(R"({"op":"stroke","brush":{"paint":"both"},"dabs":[[0,0,0,0,65535]]})"),
        "bad.jsonl:2: painting needs a colour map");
    has(refused(R"({"op":"save","path":"a.png","colour_map":"b.png"})"), "there is no colour map to save");
}

TEST_F(PaintSession, TheRendererShowsEveryDabAndUndo) {
    bool usable = false;
    for (const vulkan::DeviceInfo& device : vulkan::list_devices()) usable = usable || device.usable;
    if (!usable) GTEST_SKIP() << "no Vulkan device";
    SessionOptions options;
    options.validation = true;
    options.width = 80, options.height = 60;
    const fs::path scene = test::write_scene(folder_.path());
    const auto shown_by = [](Renderer& renderer) {
        renderer.restart();
        renderer.render();
        return renderer.read_back(Layer::beauty);
    };
    const auto image = [&](Session& session) { return shown_by(session.renderer()); };
    Session session(scene, options);
    const auto bare = image(session);
    Renderer& second = session.compare_with({"march", {}});
    session.make_colours(16);
    const auto filled = image(session);
    for (std::size_t i = 0; i < bare.size(); ++i) ASSERT_NEAR(filled[i], bare[i], 2e-3f * (1 + bare[i]));
    paint(session, 3, Paint::colour, 0.9f);
    const auto painted = image(session), painted_by_second = shown_by(second);
    session.save(at("after.tif"));
    std::string text = test::read_text(scene);
    const std::string mesh = "\"mesh\": \"sheet.obj\",";
    text.replace(text.find(mesh), mesh.size(),
                 mesh + " \"material\": {\"albedo_map\": \"after_colour.png\"},");
    test::write_text(at("after.json"), text);
    {
        Session fresh(at("after.json"), options);
        EXPECT_TRUE(image(fresh) == painted);
        fresh.set("method", std::string("march"));
        EXPECT_TRUE(image(fresh) == painted_by_second);
    }
    EXPECT_TRUE(session.undo());
    EXPECT_TRUE(image(session) == filled);
    EXPECT_EQ(vulkan::Context::validation_messages(), 0);
}

}  // namespace
}  // namespace relievo::paint_test
