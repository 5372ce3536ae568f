// Long work of a session, stopped on its way: all is as it was.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "brushes/advance.h"
#include "brushes/map_file.h"
#include "editor/session/session.h"
#include "tests/session/test_scene.h"

namespace relievo::long_work_test {
namespace {

using test::headless;
using test::sculpt;
using test::TemporaryFolder;
using test::texels;
using test::write_scene;

TEST(Session, OpeningTellsHowFarItIsAndCanBeStopped) {
    const TemporaryFolder folder;
    const auto scene = write_scene(folder.path());
    std::vector<double> parts;
    SessionOptions options = headless();
    options.opening = [&](double part) {
        parts.push_back(part);
        return true;
    };
    { const Session session(scene, options); }
    ASSERT_GT(parts.size(), 3u);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
    EXPECT_GE(parts.front(), 0.0);
    EXPECT_LT(parts.back(), 1.0);
    for (std::size_t last = 1; last <= parts.size(); ++last) {
        std::size_t asked = 0;
        options.opening = [&](double) { return ++asked < last; };
        EXPECT_THROW(Session(scene, options), Stopped) << last;
    }
}

TEST(Session, AStoppedSaveStaysUnsaved) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    sculpt(session, 1);
    const auto hash = load_map(*session.map_path()).map.hash();
    const Advance stop = [](double) { return false; };
    EXPECT_THROW(session.save(*session.map_path(), {}, stop), Stopped);
    EXPECT_THROW(session.export_map(folder.path() / "new.tif", MapFormat::tiff16, {}, stop), Stopped);
    EXPECT_TRUE(session.unsaved());
    EXPECT_EQ(load_map(*session.map_path()).map.hash(), hash);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "new.tif"));
    session.save(*session.map_path());
    EXPECT_FALSE(session.unsaved());
}

TEST(Session, AStoppedBlurOfTheMaskIsInNoJournal) {
    const TemporaryFolder folder;
    SessionOptions options = headless();
    options.journal = folder.path() / "session.jsonl";
    Session session(write_scene(folder.path()), options);
    sculpt(session, 3, 6, Tool::mask);
    const auto hash = session.mask()->hash();
    const std::string before = test::read_text(options.journal);
    EXPECT_THROW(session.change_mask(MaskCommand::blur, [](double) { return false; }), Stopped);
    EXPECT_EQ(test::read_text(options.journal), before);
    EXPECT_EQ(session.mask()->hash(), hash);
    session.change_mask(MaskCommand::blur);
    EXPECT_NE(session.mask()->hash(), hash);
    session.undo();  // the blur alone
    EXPECT_EQ(session.mask()->hash(), hash);
}

TEST(Session, AStoppedRevertLeavesAllAsItWas) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    const auto saved = texels(session);
    for (unsigned seed = 1; seed <= 4; ++seed) sculpt(session, seed);
    const auto before = texels(session);
    std::vector<double> parts;
    const auto first = [&](std::size_t count) -> Advance {
        return [&parts, count](double part) {
            parts.push_back(part);
            return parts.size() <= count;
        };
    };
    EXPECT_THROW(session.revert(first(2)), Stopped);
    EXPECT_EQ(texels(session), before);
    EXPECT_TRUE(session.unsaved());
    parts.clear();
    EXPECT_TRUE(session.revert(first(9)));
    EXPECT_EQ(parts, (std::vector<double>{0, 0.25, 0.5, 0.75}));
    EXPECT_EQ(texels(session), saved);
    EXPECT_TRUE(session.can_redo());
}

}  // namespace
}  // namespace relievo::long_work_test
