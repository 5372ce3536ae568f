// The mask on disk: saved beside the map, found when the scene is opened, kept for recovery.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>

#include "editor/session/derived_scene.h"
#include "editor/session/recovery.h"
#include "editor/session/replay.h"
#include "editor/session/session_mask.h"
#include "tests/session/test_scene.h"

namespace relievo::mask_file_test {
namespace {

namespace fs = std::filesystem;
using test::sculpt;

class MaskFile : public testing::Test {
  protected:
    MaskFile() : MaskFile([](const fs::path& folder) { test::write_scene(folder); }) {}
    explicit MaskFile(const std::function<void(const fs::path&)>& write) {
        setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
        write(folder_.path());
    }

    static SessionOptions opening() {
        SessionOptions options = test::headless();
        options.find_mask = true;
        return options;
    }
    fs::path at(const char* name) const { return folder_.path() / name; }
    // What the scene opens with; 0: no mask.
    std::uint64_t opened(const fs::path& scene) const {
        Session session(scene, opening());
        EXPECT_FALSE(session.unsaved());
        return session.mask() ? session.mask()->hash() : 0;
    }

    test::TemporaryFolder folder_;
    const fs::path scene_ = folder_.path() / "scene.json", file_ = folder_.path() / "map.tif.mask.png";
};

TEST_F(MaskFile, AMaskIsUnsavedUntilItIsSavedAndComesBackWithTheMap) {
    std::uint64_t wanted = 0;
    {
        Session session(scene_, opening());
        EXPECT_FALSE(session.mask());
        sculpt(session, 3, 6, Tool::mask);
        EXPECT_TRUE(session.unsaved());
        session.undo();
        EXPECT_FALSE(session.unsaved());
        session.redo();
        session.change_mask(MaskCommand::blur);
        session.save(at("map.tif"));
        EXPECT_FALSE(session.unsaved());
        wanted = session.mask()->hash();
    }
    EXPECT_EQ(opened(scene_), wanted);
    Session session(scene_, opening());
    const auto before = test::texels(session);
    session.change_mask(MaskCommand::invert);
    EXPECT_TRUE(session.unsaved());
    EXPECT_TRUE(session.revert());
    EXPECT_EQ(session.mask()->hash(), wanted);
    sculpt(session, 3);  // where the mask protects
    const auto file = load_mask(file_, 64, 64);
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_TRUE(file.texels()[i] < 65535 || session.map().texels()[i] == before[i]) << i;
}

TEST_F(MaskFile, SavedAloneWhereTheMapIsAsItsFileHasIt) {
    const auto state = [&] { return std::pair(fs::last_write_time(at("map.tif")), test::read_text(at("map.tif"))); };
    SessionOptions options = opening();
    options.journal = at("live.jsonl");
    Session session(scene_, options);
    sculpt(session, 2);
    session.save(at("map.tif"));
    fs::last_write_time(at("map.tif"), fs::file_time_type::clock::now() - std::chrono::hours(1));
    const auto saved = state();
    sculpt(session, 3, 6, Tool::mask);
    sculpt(session, 4);
    session.undo();
    session.save(at("map.tif"));
    EXPECT_FALSE(session.unsaved());
    EXPECT_EQ(load_mask(file_, 64, 64).hash(), session.mask()->hash());
    EXPECT_EQ(state(), saved) << "the map was written again";
    session.redo();  // a stroke on the map
    EXPECT_TRUE(session.unsaved());
    session.change_mask(MaskCommand::invert);
    session.save(at("map.tif"));
    EXPECT_FALSE(session.unsaved());
    EXPECT_NE(state().second, saved.second);
    sculpt(session, 5, 6, Tool::mask);
    fs::remove(at("map.tif"));
    session.save(at("map.tif"));
    EXPECT_TRUE(fs::exists(at("map.tif"))) << "another program took it away";
    Session again(scene_, test::headless());
    EXPECT_EQ(again.map().hash(), session.map().hash());
}

TEST_F(MaskFile, IsWrittenWithTheMapWhereTheSessionBeganWithAnother) {
    save_map(HeightMap(64, 64, 12345), at("kept.tif"), MapFormat::tiff16);
    SessionOptions options = opening();
    options.map = at("kept.tif");  // as a restore does
    Session session(scene_, options);
    sculpt(session, 3, 6, Tool::mask);
    session.save(at("map.tif"));
    EXPECT_EQ(load_map(at("map.tif")).map.hash(), session.map().hash());
}

TEST_F(MaskFile, WhatProtectsNothingLeavesNoFile) {
    {
        Session session(scene_, opening());
        sculpt(session, 3, 6, Tool::mask);
        session.save(at("map.tif"));
        EXPECT_TRUE(fs::exists(file_));
        session.change_mask(MaskCommand::clear);
        EXPECT_TRUE(session.unsaved());
        session.save(at("map.tif"));
        EXPECT_FALSE(session.unsaved());
        EXPECT_FALSE(fs::exists(file_));
    }
    EXPECT_EQ(opened(scene_), 0u);
    Session session(scene_, opening());
    sculpt(session, 1);
    session.save(at("map.tif"));
    EXPECT_FALSE(fs::exists(file_));
}

TEST_F(MaskFile, SaveAsLeavesNothingUnsavedWhereTheMaskProtectsNothingAnyMore) {
    Session session(scene_, opening());
    sculpt(session, 3, 6, Tool::mask);
    session.save(at("map.tif"));
    session.undo();
    EXPECT_TRUE(session.unsaved());
    session.save(at("other.png"));
    EXPECT_FALSE(session.unsaved());
    EXPECT_FALSE(fs::exists(at("other.png.mask.png")));
    EXPECT_TRUE(fs::exists(file_)) << "of the map that it belongs to";
    session.redo();
    EXPECT_TRUE(session.unsaved());
}

TEST_F(MaskFile, SaveAsTakesTheMaskAlongAndLeavesNoOtherBesideTheNewMap) {
    Session session(scene_, opening());
    sculpt(session, 3, 6, Tool::mask);
    session.save(at("other.png"));
    EXPECT_FALSE(fs::exists(file_));
    EXPECT_EQ(load_mask(at("other.png.mask.png"), 64, 64).hash(), session.mask()->hash());
    EXPECT_EQ(opened(scene_with_map(scene_, at("other.png"))), session.mask()->hash());
    Session bare(scene_, opening());
    bare.save(at("other.png"));  // over that map
    EXPECT_FALSE(fs::exists(at("other.png.mask.png")));
}

TEST_F(MaskFile, ANewMapBeginsWithoutTheMaskOfTheOneInItsPlace) {
    Session session(scene_, opening());
    sculpt(session, 3, 6, Tool::mask);
    session.save(at("other.png"));
    EXPECT_EQ(opened(scene_with_new_map(scene_, {at("other.png"), 32, 32, MapFormat::png16}, at("map.tif"))), 0u);
}

TEST_F(MaskFile, AMapOpensWithoutAMaskThatCannotBeHadAndSaysSo) {
    save_map(HeightMap(9, 5, 65535), file_, MapFormat::png16);
    for (const char* wrong : {"", "not a picture"}) {
        if (*wrong) test::write_text(file_, wrong);
        Session session(scene_, opening());
        EXPECT_FALSE(session.mask());
        ASSERT_EQ(session.scene().warnings.size(), 1u);
        EXPECT_NE(session.scene().warnings[0].find("map.tif.mask.png"), std::string::npos);
        sculpt(session, 1);
        session.save(at("map.tif"));
        EXPECT_TRUE(fs::exists(file_)) << "it may be of use to someone";
    }
}

TEST_F(MaskFile, AStoppedSaveLeavesTheMaskUnsaved) {
    Session session(scene_, opening());
    sculpt(session, 1);
    sculpt(session, 3, 6, Tool::mask);
    int calls = 0;
    const Advance late = [&](double part) { return ++calls, part < 0.5; };  // the map's part
    EXPECT_THROW(session.save(at("map.tif"), session.save_with(at("map.tif")), late), Stopped);
    EXPECT_GT(calls, 1);
    EXPECT_TRUE(session.unsaved());
    session.save(at("map.tif"), {});
    EXPECT_TRUE(session.unsaved()) << "the map alone";
    session.save(at("map.tif"));
    EXPECT_FALSE(session.unsaved());
}

TEST_F(MaskFile, AJournalNamesTheMaskItBeganWithAndReplayTakesThat) {
    {
        Session session(scene_, opening());
        sculpt(session, 3, 6, Tool::mask);
        session.save(at("map.tif"));
    }
    SessionOptions options = opening();
    options.journal = at("live.jsonl");
    std::uint64_t map = 0, mask = 0;
    {
        Session session(scene_, options);
        sculpt(session, 3);
        sculpt(session, 4, 6, Tool::mask);
        sculpt(session, 4);
        map = session.map().hash(), mask = session.mask()->hash();
    }
    const Journal journal = read_journal(at("live.jsonl"));
    EXPECT_EQ(journal.header.mask, "map.tif.mask.png");
    SessionOptions as_recorded = test::headless();
    as_recorded.mask = journal.resolve(journal.header.mask);
    Session again(scene_, as_recorded);
    replay(journal, again);
    EXPECT_EQ(again.map().hash(), map);
    EXPECT_EQ(again.mask()->hash(), mask);
    Session without(scene_, test::headless());
    EXPECT_THROW(replay(journal, without), std::invalid_argument);
}

class MaskRecovery : public MaskFile {
  protected:
    MaskRecovery()
        : MaskFile([](const fs::path& folder) {
              EXPECT_EQ(test::run_forked([&] { test::write_scene(folder); }), 0);
          }) {}
    // Of `work` in a process that is killed; opened again as the window does.
    void expect_restored(const std::function<void(Session&)>& work) {
        const int status = test::run_forked([&] {
            SessionOptions options = opening();
            options.recovery = true;
            Session session(scene_, options);
            work(session);
            test::write_text(at("wanted"), hash_text(session.map().hash()) + hash_text(session.mask_hash()));
            std::raise(SIGKILL);
        });
        ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
        ASSERT_EQ(test::run_forked([&] {
            const auto found = find_abandoned_journals();
            if (found.size() != 1) _exit(1);
            SessionOptions options = test::headless();
            options.map = found[0].base_map;
            options.mask = found[0].base_mask;
            Session session(scene_, options);
            const ReplayReport report = replay(read_journal(found[0].journal), session);
            const std::string got = hash_text(session.map().hash()) + hash_text(session.mask_hash());
            if (got != test::read_text(at("wanted")) || !report.failures.empty() || !session.unsaved()) _exit(2);
            remove_recovery(found[0].journal);
            if (!fs::is_empty(recovery_folder())) _exit(3);
        }), 0);
    }
    void save_a_mask() {
        ASSERT_EQ(test::run_forked([&] {
            Session session(scene_, opening());
            sculpt(session, 3, 6, Tool::mask);
            session.save(at("map.tif"));
        }), 0);
    }
};

TEST_F(MaskRecovery, ACommandOnTheMaskAloneIsOffered) {
    expect_restored([](Session& session) { session.change_mask(MaskCommand::invert); });
}

TEST_F(MaskRecovery, AMaskThatWasSavedInTheSessionIsNotThereBefore) {
    expect_restored([&](Session& session) {
        sculpt(session, 3);
        sculpt(session, 3, 6, Tool::mask);
        session.save(at("map.tif"));
        sculpt(session, 3);
        sculpt(session, 5);
    });
}

TEST_F(MaskRecovery, AMaskThatASaveReplacedOrRemovedIsKept) {
    for (const MaskCommand change : {MaskCommand::invert, MaskCommand::clear}) {
        save_a_mask();
        expect_restored([&](Session& session) {
            sculpt(session, 3);
            session.change_mask(change);
            session.save(at("map.tif"));
            sculpt(session, 3);
            sculpt(session, 5);
        });
    }
}

TEST_F(MaskFile, ARecordOfAnOlderSaveLeavesTheMaskUnsaved) {
    test::write_text(at("old.jsonl"), R"({"relievo_journal":1,"scene":"scene.json"}
{"op":"mask","do":"invert"}
{"op":"save","path":"map.tif","map":")" + hash_text(Session(scene_, test::headless()).map().hash()) + "\"}\n");
    Session session(scene_, test::headless());
    EXPECT_TRUE(replay(read_journal(at("old.jsonl")), session).failures.empty());
    EXPECT_TRUE(session.unsaved());
}

}  // namespace
}  // namespace relievo::mask_file_test
