// Journals as tests: what they expect, what they save, and operations that do not fit the scene.
#include "editor/session/replay.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/session/test_scene.h"

namespace relievo::replay_test {
namespace {

using test::headless;
using test::TemporaryFolder;
using test::write_scene;

constexpr const char* kStroke =
    R"({"op":"stroke","brush":{"tool":"draw","radius":0.3,"strength":1},"dabs":[[0,10,300000,300000,65535]]})"
    "\n";

// Replays lines on the sheet; line numbers start at 2.
ReplayReport run(const TemporaryFolder& folder, const std::string& lines, Session& session) {
    test::write_text(folder.path() / "a.jsonl", "{\"relievo_journal\":1,\"scene\":\"scene.json\"}\n" + lines);
    return replay(read_journal(folder.path() / "a.jsonl"), session);
}

std::string error_of(const std::string& lines) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    try {
        run(folder, lines, session);
    } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        return message.substr(message.find("a.jsonl"));
    }
    return "no error";
}

TEST(Replay, AMetExpectationIsCountedAFailedOneNamesBothHashes) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    const std::string start = hash_text(session.map().hash());
    const ReplayReport report = run(folder,
                                    "{\"op\":\"expect\",\"map\":\"" + start + "\"}\n" + kStroke +
                                        "{\"op\":\"expect\",\"map\":\"" + start + "\"}\n",
                                    session);
    EXPECT_EQ(report.expectations, 2u);
    ASSERT_EQ(report.failures.size(), 1u);
    const std::string got = hash_text(session.map().hash());
    EXPECT_NE(got, start);
    EXPECT_NE(report.failures[0].find("a.jsonl:4: expect: the map should be " + start + ", it is " + got),
              std::string::npos)
        << report.failures[0];
}

TEST(Replay, OperationsThatDoNotFitAreNamedByLine) {
    EXPECT_EQ(error_of("{\"op\":\"undo\"}\n"), "a.jsonl:2: undo: there is nothing to undo");
    EXPECT_EQ(error_of("{\"op\":\"redo\"}\n"), "a.jsonl:2: redo: there is nothing to redo");
    EXPECT_EQ(error_of("{\"op\":\"stroke\",\"brush\":{},\"dabs\":[[0,128,0,0,1]]}\n"),
              "a.jsonl:2: dabs[0][1]: is 128, the mesh has 128 faces, counted from 0");
    EXPECT_EQ(error_of("{\"op\":\"set\",\"key\":\"midlevel\",\"value\":3}\n"),
              "a.jsonl:2: set midlevel: is 3, must be in [0, 1]");
}

TEST(Replay, AScriptedSaveWritesARecordedOneIsOnlyChecked) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    const std::string before = test::read_text(folder.path() / "map.tif");
    ReplayReport report =
        run(folder, std::string(kStroke) + "{\"op\":\"save\",\"path\":\"out.png\"}\n", session);
    EXPECT_EQ(load_map(folder.path() / "out.png").map.hash(), session.map().hash());
    const std::string record = "{\"op\":\"save\",\"path\":\"map.tif\",\"map\":\"";
    report = run(folder, record + hash_text(session.map().hash()) + "\"}\n" + record + "0\"}\n", session);
    EXPECT_EQ(test::read_text(folder.path() / "map.tif"), before);
    ASSERT_EQ(report.failures.size(), 1u);
    EXPECT_NE(report.failures[0].find("a.jsonl:3: save: the map saved then was 0000000000000000"),
              std::string::npos);
}

TEST(Replay, UndoBudgetOfTheRecordIsItsOwn) {
    const TemporaryFolder folder;
    const auto scene = write_scene(folder.path());
    SessionOptions options = headless();
    options.journal = folder.path() / "small.jsonl";
    options.undo_budget = 1;
    {
        Session session(scene, options);
        test::sculpt(session, 1);
        EXPECT_FALSE(session.undo()) << "no step fits into one byte";
    }
    EXPECT_EQ(read_journal(options.journal).header.undo_budget, 1u);
}

TEST(Replay, StageFiguresAreMediansOfTheDabsThatRanTheStage) {
    std::vector<StageTimes> times(100);
    for (std::size_t i = 0; i < times.size(); ++i) times[i].edit_ms = static_cast<double>(i + 1);
    times[3].refit_ms = 5;
    const auto summary = summarize(times);
    ASSERT_EQ(summary.size(), 5u);
    EXPECT_EQ(summary[0].stage, "edit");
    EXPECT_EQ(summary[0].median_ms, 51);
    EXPECT_EQ(summary[0].p95_ms, 96);
    EXPECT_EQ(summary[0].max_ms, 100);
    EXPECT_EQ(summary[1].count, 0u);
    EXPECT_EQ(summary[3].count, 1u);
    EXPECT_EQ(summary[3].median_ms, 5);
}

}  // namespace
}  // namespace relievo::replay_test
