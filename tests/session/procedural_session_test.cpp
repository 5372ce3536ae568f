// Procedural heights in a session: settings, the bake and the strokes after it, all of it replayed.
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "editor/session/bake.h"
#include "editor/session/replay.h"
#include "tests/session/test_scene.h"

namespace relievo::procedural_session_test {
namespace {

namespace fs = std::filesystem;
using test::headless;
using test::TemporaryFolder;

// The sheet with procedural heights made of map.tif.
fs::path write_procedural_scene(const TemporaryFolder& folder) {
    const fs::path scene = test::write_scene(folder.path());
    std::string text = test::read_text(scene);
    const std::string map = "\"map\": \"map.tif\"";
    text.replace(text.find(map), map.size(), R"("procedural": {"exemplar": "map.tif", "scale": 2, "seed": 4})");
    test::write_text(scene, text);
    return scene;
}

std::string refusal(const std::function<void()>& command) {
    try {
        command();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "not refused";
}

TEST(ProceduralSession, StrokesAreRefusedUntilABake) {
    const TemporaryFolder folder;
    Session session(write_procedural_scene(folder), headless());
    ASSERT_NE(session.procedural(0), nullptr);
    EXPECT_EQ(refusal([&] { session.begin_stroke(); }),
              "the heights are procedural: bake them into a map first, then sculpt that");
    const fs::path out = folder.path() / "out.tif";  // where the exemplar would be
    EXPECT_EQ(refusal([&] { session.save(out); }),
              "the heights are procedural: bake them into a map first, then save that");
    EXPECT_EQ(refusal([&] { session.export_map(out, MapFormat::tiff16, {}); }),
              "the heights are procedural: bake them into a map first, then export that");
    EXPECT_FALSE(fs::exists(out));
    EXPECT_FALSE(session.unsaved());
    EXPECT_THROW(session.bake({96, 80}, [](double part) { return part == 0; }), Stopped);
    EXPECT_NE(session.procedural(0), nullptr);
    session.bake({96, 80});
    EXPECT_EQ(session.procedural(0), nullptr);
    EXPECT_EQ(session.map().width(), 96);
    EXPECT_EQ(session.map().height(), 80);
    EXPECT_TRUE(session.unsaved());
    test::sculpt(session, 3);
    EXPECT_TRUE(session.can_undo());
    EXPECT_EQ(refusal([&] { session.bake({8, 8}); }), "the heights are a map already; there is nothing to bake");
    EXPECT_EQ(refusal([&] { session.set("procedural.seed", 3.0); }),
              "set procedural.seed: the heights are a map, not procedural");
}

TEST(ProceduralSession, ABakeHoldsTheHeightsAtItsTexelsCentres) {
    const TemporaryFolder folder;
    Session session(write_procedural_scene(folder), headless());
    const auto source = session.procedural(0);
    session.bake({40, 30});
    for (int y = 0; y < 30; y += 7)
        for (int x = 0; x < 40; x += 3)
            EXPECT_NEAR(session.map().at(x, y), 65535 * source->value(source->texel_at({(x + 0.5) / 40, (y + 0.5) / 30})),
                        0.5);
    const Displacement& d = session.scene().objects[0].displacement;
    EXPECT_EQ(d.wrap, Wrap::clamp);
    EXPECT_EQ(d.amplitude, 0.2);
}

TEST(ProceduralSession, SettingsBakeAndStrokesReplayToTheByte) {
    const TemporaryFolder folder;
    const fs::path scene = write_procedural_scene(folder), journal = folder.path() / "session.jsonl";
    SessionOptions options = headless();
    options.journal = journal;
    std::uint64_t hash = 0;
    {
        Session session(scene, options);
        session.set("procedural.scale", 1.5);
        session.set("procedural.offset", std::vector<double>{0.25, -3});
        session.set("procedural.seed", 99.0);
        session.set("procedural.triangle_size", 0.4);
        session.set("procedural.exemplar", std::string("map.tif"));
        session.bake({64, 64});
        test::sculpt(session, 2);
        hash = session.map().hash();
    }
    Session again(scene, headless());
    replay(read_journal(journal), again);
    EXPECT_EQ(again.map().hash(), hash);
    EXPECT_FALSE(again.scene().objects[0].displacement.procedural);
}

TEST(ProceduralSession, SettingsOutOfRangeChangeNothing) {
    const TemporaryFolder folder;
    Session session(write_procedural_scene(folder), headless());
    const Procedural before = *session.scene().objects[0].displacement.procedural;
    const std::uint64_t revision = session.map_revision();
    EXPECT_EQ(refusal([&] { session.set("procedural.scale", 0.0); }),
              "set procedural.scale: is 0, must be in [0.001, 1000]");
    EXPECT_EQ(refusal([&] { session.set("procedural.seed", 1.5); }), "set procedural.seed: must be a whole number");
    EXPECT_EQ(refusal([&] { session.set("procedural.offset", 1.0); }),
              "set procedural.offset: must be an array of 2 numbers");
    EXPECT_NE(refusal([&] { session.set("procedural.exemplar", std::string("none.png")); }), "not refused");
    EXPECT_NE(refusal([&] { session.set("procedural.tiles", 1.0); }), "not refused");
    const Procedural& after = *session.scene().objects[0].displacement.procedural;
    EXPECT_EQ(after.exemplar, before.exemplar);
    EXPECT_EQ(after.scale, before.scale);
    EXPECT_EQ(session.map_revision(), revision);
    session.set("procedural.scale", 3.0);
    EXPECT_NE(session.map_revision(), revision);
}

TEST(ProceduralSession, TextureCoordinatesBeyondTheMapAreNotBaked) {
    const TemporaryFolder folder;
    const fs::path scene = write_procedural_scene(folder);
    std::string obj = test::read_text(folder.path() / "sheet.obj");
    obj.replace(obj.find("vt 0 0"), 6, "vt -1 0");
    test::write_text(folder.path() / "sheet.obj", obj);
    Session session(scene, headless());
    EXPECT_EQ(refusal([&] { session.bake({8, 8}); }),
              "sheet: texture coordinates (-1, 0) leave [0, 1], which is all that a baked map holds");
    EXPECT_NE(session.procedural(0), nullptr);
}

}  // namespace
}  // namespace relievo::procedural_session_test
