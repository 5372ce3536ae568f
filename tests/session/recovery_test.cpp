// kill -9 loses at most the stroke under way.
#include "editor/session/recovery.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>

#include "editor/session/replay.h"
#include "tests/session/test_scene.h"

namespace relievo::recovery_test {
namespace {

using test::sculpt;
using test::TemporaryFolder;

class Recovery : public testing::Test {
  protected:
    Recovery() {
        setenv("XDG_STATE_HOME", folder_.path().c_str(), 1);
        EXPECT_EQ(test::run_forked([&] { test::write_scene(folder_.path()); }), 0);
        scene_ = folder_.path() / "scene.json";
    }

    static SessionOptions recovering() {
        SessionOptions options = test::headless();
        options.recovery = true;
        return options;
    }

    // Runs `work` in another process, which ends by kill -9.
    void run_killed(const std::function<void(Session&)>& work) {
        const int status = test::run_forked([&] {
            Session session(scene_, recovering());
            work(session);
            std::raise(SIGKILL);
        });
        ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    }

    std::uint64_t hash_after(const std::function<void(Session&)>& work) {
        Session session(scene_, test::headless());
        work(session);
        return session.map().hash();
    }

    // What a restart without a recovery journal of its own would show.
    std::unique_ptr<Session> restored(const AbandonedJournal& found) const {
        SessionOptions options = test::headless();
        options.map = found.base_map;
        auto session = std::make_unique<Session>(scene_, options);
        replay(read_journal(found.journal), *session);
        return session;
    }

    TemporaryFolder folder_;
    std::filesystem::path scene_;
};

TEST_F(Recovery, AKillInsideAStrokeLosesThatStrokeOnly) {
    const auto three = [](Session& session) {
        sculpt(session, 1);
        sculpt(session, 2, 20, Tool::smooth);
        sculpt(session, 3);
    };
    run_killed([&](Session& session) {
        three(session);
        session.begin_stroke();
        session.dab(Dab{});
        session.dab(Dab{});
    });
    const auto found = find_abandoned_journals();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].edits, 3u);
    EXPECT_EQ(found[0].scene, scene_);
    EXPECT_TRUE(std::filesystem::equivalent(found[0].base_map, folder_.path() / "map.tif")) << "nothing was copied";
    {
        Session session(scene_, recovering());
        replay(read_journal(found[0].journal), session);
        EXPECT_EQ(session.map().hash(), hash_after(three));
        EXPECT_TRUE(session.unsaved());
        remove_recovery(found[0].journal);
        EXPECT_TRUE(find_abandoned_journals().empty()) << "a living session is not offered";
    }
    EXPECT_EQ(find_abandoned_journals().size(), 1u) << "restored, and still unsaved";
}

TEST_F(Recovery, AKillAfterSavingOverTheMapReplaysOnTheOldOne) {
    const auto all = [](Session& session) {
        sculpt(session, 1);
        sculpt(session, 2);
        session.undo();
        session.undo();
        sculpt(session, 4);
    };
    const std::uint64_t wanted = hash_after(all);
    run_killed([&](Session& session) {
        sculpt(session, 1);
        sculpt(session, 2);
        session.save(folder_.path() / "map.tif");
        session.undo();
        session.undo();
        sculpt(session, 4);
    });
    const auto found = find_abandoned_journals();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].edits, 3u);
    EXPECT_EQ(found[0].base_map.extension(), ".tif");
    {
        SessionOptions options = recovering();
        options.map = found[0].base_map;
        Session session(scene_, options);
        replay(read_journal(found[0].journal), session);
        EXPECT_EQ(session.map().hash(), wanted);
        EXPECT_TRUE(session.unsaved());
        EXPECT_EQ(session.map_path(), folder_.path() / "map.tif");
        remove_recovery(found[0].journal);
    }
    const auto again = find_abandoned_journals();  // that session ended with work unsaved
    ASSERT_EQ(again.size(), 1u);
    EXPECT_EQ(restored(again[0])->map().hash(), wanted);
}

TEST_F(Recovery, AMapThatAnotherProgramReplacedIsKeptForTheJournal) {
    const auto all = [](Session& session) {
        sculpt(session, 1);
        sculpt(session, 2);
    };
    const std::uint64_t wanted = hash_after(all);
    run_killed([&](Session& session) {
        sculpt(session, 1);
        save_map(HeightMap(9, 5, 1), folder_.path() / "map.tif", MapFormat::tiff16);
        sculpt(session, 2);
    });
    const auto found = find_abandoned_journals();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(restored(found[0])->map().hash(), wanted);
}

TEST_F(Recovery, AnExportOverTheMapLeavesTheJournalWhatItNeeds) {
    const std::uint64_t wanted = hash_after([](Session& session) { sculpt(session, 1); });
    run_killed([&](Session& session) {
        session.export_map(folder_.path() / "map.tif", MapFormat::tiff16, {});
        session.export_map(folder_.path() / "map.tif", MapFormat::tiff16, {});
        sculpt(session, 1);
    });
    const auto found = find_abandoned_journals();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(restored(found[0])->map().hash(), wanted);
}

// Something in the way of links and copies stands for a full disk.
class BlockedBase {
  public:
    // `journal` has a linked base, which is lost.
    explicit BlockedBase(const std::filesystem::path& journal)
        : base_(base_of(journal, BaseFile::map)), part_(std::filesystem::path(base_).concat(".part")) {
        std::filesystem::remove(base_);
        std::filesystem::create_symlink("nowhere", base_);
        std::filesystem::create_directories(part_ / "in the way");
    }
    void free() { std::filesystem::remove_all(part_); }

  private:
    std::filesystem::path base_, part_;
};

std::filesystem::path only_journal() {
    for (const auto& file : std::filesystem::directory_iterator(recovery_folder()))
        if (file.path().extension() == ".jsonl") return file.path();
    return {};
}

TEST_F(Recovery, AMapThatCouldNotBeKeptIsReportedUntilItIsKept) {
    Session session(scene_, recovering());
    sculpt(session, 1);
    BlockedBase blocked(only_journal());
    const auto no_colours = folder_.path() / "no_colours.png";
    EXPECT_THROW(session.save(folder_.path() / "map.tif", {no_colours}), std::invalid_argument);
    EXPECT_NE(session.journal_error(), "");
    sculpt(session, 2);
    EXPECT_NE(session.journal_error(), "");
    blocked.free();
    session.save(folder_.path() / "map.tif");
    EXPECT_EQ(session.journal_error(), "");
}

TEST_F(Recovery, AMapThatIsGoneIsNotTakenForKept) {
    Session session(scene_, recovering());
    sculpt(session, 1);
    const auto journal = only_journal();
    BlockedBase blocked(journal);
    session.save(folder_.path() / "map.tif");
    blocked.free();
    sculpt(session, 2);
    session.save(folder_.path() / "map.tif");
    EXPECT_NE(session.journal_error(), "");
    EXPECT_TRUE(base_of(journal, BaseFile::map).empty()) << "that is another map";
}

TEST_F(Recovery, ACopyThatFindsNoRoomLeavesTheJournalWhatThereIs) {
    const auto journal = folder_.path() / "a.jsonl", map = folder_.path() / "large.tif";
    test::write_text(map, std::string(100000, 'x'));
    std::filesystem::create_symlink("nowhere", folder_.path() / "a.base.tif");  // no link can be made
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit unlimited{};
    getrlimit(RLIMIT_FSIZE, &unlimited);
    const rlimit full{1000, unlimited.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    EXPECT_THROW(keep_base(journal, BaseFile::map, map), std::runtime_error);
    setrlimit(RLIMIT_FSIZE, &unlimited);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "a.base.tif.part"));
}

TEST_F(Recovery, EraseGoesToTheSaveOfTheKilledSession) {
    const auto erase = [](Session& session) {
        session.undo();
        session.brush().erase_to = EraseTo::saved;
        sculpt(session, 1, 9, Tool::erase);
    };
    run_killed([&](Session& session) {
        sculpt(session, 1);
        session.save(folder_.path() / "map.tif");
        erase(session);
    });
    std::uint64_t wanted = 0;
    {
        const TemporaryFolder alive;
        Session session(test::write_scene(alive.path()), test::headless());
        sculpt(session, 1);
        session.save(alive.path() / "map.tif");
        erase(session);
        wanted = session.map().hash();
    }
    const auto found = find_abandoned_journals();
    ASSERT_EQ(found.size(), 1u);
    const auto session = restored(found[0]);
    EXPECT_EQ(session->map().hash(), wanted);
    session->brush().strength = 1;
    sculpt(*session, 1, 9, Tool::erase);
    EXPECT_NE(session->map().hash(), wanted) << "and goes on from there";
}

TEST_F(Recovery, AKillWithNothingUnsavedOffersNothing) {
    run_killed([](Session&) {});
    EXPECT_TRUE(find_abandoned_journals().empty());
    run_killed([&](Session& session) {
        sculpt(session, 1);
        session.save(folder_.path() / "map.tif");
    });
    EXPECT_TRUE(find_abandoned_journals().empty());
    EXPECT_TRUE(std::filesystem::is_empty(recovery_folder()));
}

TEST_F(Recovery, ACleanEndLeavesNoFile) {
    {
        Session session(scene_, recovering());
        sculpt(session, 1);
        session.save(folder_.path() / "out.png");
    }
    EXPECT_TRUE(std::filesystem::is_empty(recovery_folder()));
    {
        Session session(scene_, recovering());
        sculpt(session, 1);
        session.discard_recovery();
    }
    EXPECT_TRUE(std::filesystem::is_empty(recovery_folder()));
}

TEST_F(Recovery, ADamagedJournalDoesNotKeepTheProgramFromStarting) {
    std::filesystem::create_directories(recovery_folder());
    test::write_text(recovery_folder() / "bad.jsonl", "{\"relievo_journal\":1}\n{\"op\":\"fly\"}\n");
    test::write_text(recovery_folder() / "empty.jsonl", "");
    EXPECT_TRUE(find_abandoned_journals().empty());
}

TEST_F(Recovery, AStateFolderThatCannotBeMadeIsReportedAndSculptingGoesOn) {
    setenv("XDG_STATE_HOME", (scene_ / "not a folder").c_str(), 1);
    Session session(scene_, recovering());
    sculpt(session, 1);
    EXPECT_NE(session.journal_error(), "");
    EXPECT_TRUE(session.undo());
}

TEST_F(Recovery, AStateFolderThatCanBeMadeLaterGetsAllAndTheNamedJournalNeverMissedAny) {
    setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
    test::write_text(folder_.path() / "state", "in the way");
    const auto all = [](Session& session) {
        sculpt(session, 1);
        sculpt(session, 2);
    };
    run_killed([&](Session& session) {
        sculpt(session, 1);
        EXPECT_NE(session.journal_error(), "");
        std::filesystem::remove(folder_.path() / "state");
        sculpt(session, 2);
        EXPECT_EQ(session.journal_error(), "");
    });
    const auto found = find_abandoned_journals();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].edits, 2u);
    EXPECT_EQ(restored(found[0])->map().hash(), hash_after(all));

    test::write_text(folder_.path() / "other", "in the way");
    setenv("XDG_STATE_HOME", (folder_.path() / "other").c_str(), 1);
    SessionOptions options = recovering();
    options.journal = folder_.path() / "named.jsonl";
    {
        Session session(scene_, options);
        all(session);
    }
    EXPECT_EQ(read_journal(options.journal).entries.size(), 2u);
}

TEST_F(Recovery, AStampIsRestoredThoughItsImageIsGoneAndNothingOfItStaysBehind) {
    const auto image = folder_.path() / "a.exr";
    // Nothing is read or written as EXR before the fork: its library's threads would not be there after it.
    const auto stamp = [&](Session& session) {
        save_alpha(Alpha(image, 2, 2, {0.1f, -0.7f, 0.3f, 1.0f}), image);
        session.set_alpha(load_alpha(image));
        std::filesystem::remove(image);
        sculpt(session, 2, 6, Tool::stamp);
        sculpt(session, 4, 6, Tool::stamp);
    };
    run_killed(stamp);
    const auto found = find_abandoned_journals();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(restored(found[0])->map().hash(), hash_after(stamp));
    remove_recovery(found[0].journal);
    EXPECT_TRUE(std::filesystem::is_empty(recovery_folder()));
}

}  // namespace
}  // namespace relievo::recovery_test
