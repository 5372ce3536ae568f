// Erase to what was saved in a session: the journal's saves and its start suffice to replay it.
#include <gtest/gtest.h>

#include <stdexcept>

#include "editor/session/replay.h"
#include "tests/session/test_scene.h"

namespace relievo::erase_test {
namespace {

using test::headless;
using test::sculpt;
using test::TemporaryFolder;
using test::write_scene;

void erase_everything(Session& session, EraseTo where) {
    Brush& brush = session.brush();
    brush.tool = Tool::erase;
    brush.erase_to = where;
    brush.falloff = Falloff::constant;
    brush.strength = 1;
    brush.radius = 10;
    session.begin_stroke();
    session.dab(Dab{.b1 = 300000, .b2 = 300000});
    session.end_stroke();
    brush.falloff = Falloff::smooth;
    brush.strength = 0.5f;
}

TEST(EraseToSaved, GoesToTheLoadedMapThenToEachSave) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    const std::uint64_t loaded = session.map().hash();
    sculpt(session, 1);
    erase_everything(session, EraseTo::saved);
    EXPECT_EQ(session.map().hash(), loaded);
    sculpt(session, 3);
    session.save(folder.path() / "out.png");
    const std::uint64_t saved = session.map().hash();
    sculpt(session, 4);
    session.export_map(folder.path() / "copy.png", MapFormat::png16, {});
    session.undo();
    session.undo();
    erase_everything(session, EraseTo::saved);
    EXPECT_EQ(session.map().hash(), saved) << "an export is no save";
    erase_everything(session, EraseTo::midlevel);
    EXPECT_EQ(session.map().at(30, 30), 32768);
}

TEST(EraseToSaved, ReplayGivesTheLiveBytesThoughTheMapWasSavedOver) {
    const TemporaryFolder folder;
    const auto scene = write_scene(folder.path());
    const std::string start = test::read_text(folder.path() / "map.tif");
    SessionOptions options = headless();
    options.journal = folder.path() / "live.jsonl";
    std::uint64_t live = 0;
    {
        Session session(scene, options);
        session.brush().mirror_x = true;
        session.brush().erase_to = EraseTo::saved;
        sculpt(session, 1);
        session.save(folder.path() / "map.tif");
        sculpt(session, 2);
        sculpt(session, 3);
        session.undo();
        sculpt(session, 2, 9, Tool::erase);
        session.save(folder.path() / "other.exr");
        session.undo();
        session.undo();
        sculpt(session, 1, 7, Tool::erase);
        session.undo();
        session.redo();
        live = session.map().hash();
    }
    test::write_text(folder.path() / "map.tif", start);
    Session again(scene, headless());
    const ReplayReport report = replay(read_journal(options.journal), again);
    EXPECT_TRUE(report.failures.empty());
    EXPECT_EQ(again.map().hash(), live);
}

TEST(EraseToSaved, ABakedMapIsWhereItGoesUntilTheFirstSave) {
    const TemporaryFolder folder;
    const auto scene = write_scene(folder.path());
    std::string text = test::read_text(scene);
    const std::string map = "\"map\": \"map.tif\"";
    text.replace(text.find(map), map.size(), R"("procedural": {"exemplar": "map.tif"})");
    test::write_text(scene, text);
    Session session(scene, headless());
    session.bake({64, 64});
    const std::uint64_t baked = session.map().hash();
    sculpt(session, 2);
    erase_everything(session, EraseTo::saved);
    EXPECT_EQ(session.map().hash(), baked);
}

}  // namespace
}  // namespace relievo::erase_test
