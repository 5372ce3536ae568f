// The session's commands, and that a replay of their record gives the same bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include "editor/session/replay.h"
#include "editor/session/settings.h"
#include "tests/session/test_scene.h"

namespace relievo::session_test {
namespace {

using test::headless;
using test::sculpt;
using test::TemporaryFolder;
using test::texels;
using test::write_scene;

SessionOptions recorded(const TemporaryFolder& folder) {
    SessionOptions options = headless();
    options.journal = folder.path() / "live.jsonl";
    return options;
}

// A session in which everything happens that can happen to a map.
void work(Session& session) {
    sculpt(session, 1);
    sculpt(session, 2, 8, Tool::smooth);
    sculpt(session, 3, 8, Tool::flatten);
    session.undo();
    session.set("amplitude", 0.3);
    sculpt(session, 4, 5, Tool::level);
    session.undo();
    session.redo();
    session.set("midlevel", 0.25);
    session.brush().invert = true;
    sculpt(session, 5, 30);
    session.begin_stroke();
    session.dab(Dab{});
    session.cancel_stroke();
    sculpt(session, 6, 3, Tool::erase);
}

TEST(Session, ReplayGivesTheLiveBytes) {
    const TemporaryFolder folder;
    const auto scene = write_scene(folder.path());
    std::vector<std::uint16_t> start, live;
    {
        Session session(scene, recorded(folder));
        start = texels(session);
        work(session);
        live = texels(session);
        EXPECT_EQ(session.journal_error(), "");
    }
    EXPECT_NE(start, live);
    const Journal journal = read_journal(folder.path() / "live.jsonl");
    EXPECT_EQ(journal.header.scene, "scene.json");
    Session again(scene, headless());
    const ReplayReport report = replay(journal, again);
    EXPECT_EQ(texels(again), live);
    EXPECT_EQ(report.strokes, 6u);
    EXPECT_EQ(report.dab_times.size(), report.dabs);
}

TEST(Session, ReplaysOnTwoThreadsAtOnceGiveTheSameBytes) {
    const TemporaryFolder folder;
    const auto scene = write_scene(folder.path());
    {
        Session session(scene, recorded(folder));
        work(session);
    }
    const Journal journal = read_journal(folder.path() / "live.jsonl");
    std::uint64_t hashes[2] = {0, 1};
    std::vector<std::thread> threads;
    for (std::uint64_t& hash : hashes)
        threads.emplace_back([&] {
            Session session(scene, headless());
            replay(journal, session);
            hash = session.map().hash();
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Session, AmplitudeOfTheRecordCountsNotTheScenesOfToday) {
    const TemporaryFolder folder;
    const auto scene = write_scene(folder.path());
    std::uint64_t live = 0;
    {
        Session session(scene, recorded(folder));
        work(session);
        live = session.map().hash();
    }
    std::string text = test::read_text(scene);
    text.replace(text.find("0.2"), 3, "0.9");
    test::write_text(scene, text);
    Session again(scene, headless());
    replay(read_journal(folder.path() / "live.jsonl"), again);
    EXPECT_EQ(again.map().hash(), live);
}

TEST(Session, AnotherMapOrMeshIsRefusedUnlessForced) {
    const TemporaryFolder folder, other;
    const auto scene = write_scene(folder.path());
    {
        Session session(scene, recorded(folder));
        sculpt(session, 1);
    }
    const Journal journal = read_journal(folder.path() / "live.jsonl");
    const auto flat = write_scene(other.path(), true);
    Session wrong(flat, headless());
    try {
        replay(journal, wrong);
        FAIL() << "no error";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("live.jsonl:1: map_hash: recorded on map "),
                  std::string::npos)
            << error.what();
    }
    ReplayOptions force;
    force.force = true;
    EXPECT_EQ(replay(journal, wrong, force).strokes, 1u);

    std::string obj = test::read_text(folder.path() / "sheet.obj");
    obj.replace(obj.find("v -1 -1"), 7, "v -2 -1");
    test::write_text(folder.path() / "sheet.obj", obj);
    Session moved(scene, headless());
    try {
        replay(journal, moved);
        FAIL() << "no error";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("mesh_hash"), std::string::npos) << error.what();
    }
}

TEST(Session, UnsavedFollowsUndoRedoAndSave) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    EXPECT_FALSE(session.unsaved());
    EXPECT_FALSE(session.undo());
    const auto start = texels(session);
    sculpt(session, 1);
    EXPECT_TRUE(session.unsaved());
    EXPECT_TRUE(session.undo());
    EXPECT_FALSE(session.unsaved());
    EXPECT_EQ(texels(session), start);
    session.redo();
    session.save(folder.path() / "out.png");
    EXPECT_FALSE(session.unsaved());
    EXPECT_EQ(session.map_path(), folder.path() / "out.png");
    session.undo();
    EXPECT_TRUE(session.unsaved());
    EXPECT_TRUE(session.revert());
    EXPECT_FALSE(session.unsaved());
    session.undo();
    sculpt(session, 2);
    EXPECT_TRUE(session.unsaved()) << "another stroke at the saved depth is another map";
    const auto before = texels(session);
    EXPECT_FALSE(session.revert()) << "the saved state is gone from the stack";
    EXPECT_EQ(texels(session), before);
}

TEST(Session, SavedMapLoadsBackEqual) {
    const TemporaryFolder folder;
    const auto scene = write_scene(folder.path());
    for (const char* name : {"out.png", "out.tif", "out.exr", "map.tif"}) {
        Session session(scene, headless());
        sculpt(session, 1);
        session.save(folder.path() / name);
        EXPECT_EQ(load_map(folder.path() / name).map.hash(), session.map().hash()) << name;
    }
}

TEST(Session, AnExportHoldsTheStatedRangeAndChangesNothing) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    sculpt(session, 1);
    const auto before = session.map_path();
    const std::filesystem::path exported = folder.path() / "exported.exr";
    session.export_map(exported, MapFormat::exr_float, {-0.5, 1.5});
    EXPECT_TRUE(session.unsaved());
    EXPECT_EQ(session.map_path(), before);
    EXPECT_EQ(load_map(exported, {-0.5, 1.5}).map.hash(), session.map().hash());
    EXPECT_NE(load_map(exported, {0, 1}).map.hash(), session.map().hash());
    EXPECT_THROW(session.export_map(exported, MapFormat::png16, {}), std::invalid_argument);
}

TEST(Session, ASceneWithoutAMapStartsFlat) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path(), true), headless());
    EXPECT_EQ(session.map().width(), 64);
    const auto all = texels(session);
    EXPECT_TRUE(std::all_of(all.begin(), all.end(), [](std::uint16_t v) { return v == 32768; }));
    EXPECT_FALSE(session.map_path());
}

TEST(Session, AStrokeWithoutDabsOrWithNoEffectIsNoStep) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), recorded(folder));
    session.begin_stroke();
    session.end_stroke();
    session.brush().strength = 0;
    sculpt(session, 1);
    EXPECT_FALSE(session.unsaved());
    EXPECT_FALSE(session.undo());
}

TEST(Session, AStrokeThatTakesBackItselfIsNoStep) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path(), true), headless());
    session.brush().tool = Tool::level;
    session.brush().level = 0.5f;  // what the flat map holds already
    session.begin_stroke();
    session.dab(Dab{});
    session.end_stroke();
    EXPECT_FALSE(session.unsaved());
    EXPECT_FALSE(session.can_undo());
}

TEST(Session, StepsDroppedForMemoryStayUnsaved) {
    const TemporaryFolder folder;
    SessionOptions options = headless();
    options.undo_budget = 1;
    Session session(write_scene(folder.path()), options);
    sculpt(session, 1);
    EXPECT_FALSE(session.can_undo());
    EXPECT_TRUE(session.unsaved());
    const auto sculpted = texels(session);
    EXPECT_FALSE(session.revert());
    EXPECT_EQ(texels(session), sculpted);
}

TEST(Session, CommandsInsideAStrokeAreRefused) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    session.begin_stroke();
    session.dab(Dab{});
    EXPECT_THROW(session.undo(), std::logic_error);
    EXPECT_THROW(session.save(folder.path() / "a.png"), std::logic_error);
    EXPECT_THROW(session.set("amplitude", 1.0), std::logic_error);
    EXPECT_THROW(session.begin_stroke(), std::logic_error);
    session.end_stroke();
    EXPECT_TRUE(session.undo());
}

TEST(Session, ASessionLeftInsideAStrokeEndsQuietly) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), recorded(folder));
    session.begin_stroke();
    session.dab(Dab{});
}

TEST(Session, WrongSettingsAreNamedAndChangeNothing) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), recorded(folder));
    const std::pair<const char*, SetValue> wrong[] = {
        {"amplitud", 1.0},
        {"amplitude", std::nan("")},
        {"amplitude", std::numeric_limits<double>::infinity()},
        {"amplitude", std::string("big")},
        {"midlevel", 1.5},
        {"method", std::string("magic")},
        {"method", 1.0},
        {"method.nothing", 1.0},
        {"camera", std::vector<double>{1, 2, 3}},
        {"camera", std::vector<double>{0, 0, 0, 0, 0, 0, 0, 1, 0, 40}},
        {"lights[99].intensity", 1.0},
        {"lights[x].intensity", 1.0},
        {"lights[0].colour", 1.0},
        {"material.albedo", std::vector<double>{2, 0, 0}},
        {"environment.sun", 1.0},
        {"environment.up", std::vector<double>{0, 0, 0}},
        {"environment.up", 1.0},
        {"lights", std::vector<double>{0, 1, 0}},
        {"lights", std::vector<double>{0, 1, 0, 0, 0, 0}},
        {"lights", std::vector<double>{0, 0, 0, 0, -1, 0}},
        {"lights", std::vector<double>{0, 1, 0, 0, std::nan(""), 0}},
    };
    for (const auto& [key, value] : wrong) {
        try {
            session.set(key, value);
            ADD_FAILURE() << key << ": no error";
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).size(), 0u);
        }
    }
    EXPECT_EQ(session.scene().objects[0].displacement.amplitude, 0.2);
    EXPECT_EQ(session.scene().environment.up, glm::dvec3(0, 1, 0));
    EXPECT_TRUE(read_journal(folder.path() / "live.jsonl").entries.empty());
}

TEST(Session, SettingsReachTheScene) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    session.set("amplitude", -1.0);
    session.set("lights[0].intensity", 7.0);
    session.set("material.albedo", std::vector<double>{0.1, 0.2, 0.3});
    session.set("environment.intensity", 0.0);
    session.set("environment.up", std::vector<double>{0, -2, 1});
    Camera camera;
    camera.eye = {1, 2, 3};
    camera.fov_deg = 55;
    session.set_camera(camera);
    EXPECT_EQ(session.scene().objects[0].displacement.amplitude, -1.0);
    EXPECT_EQ(session.surface().amplitude(), -1.0f);
    EXPECT_EQ(session.scene().lights[0].intensity, 7.0f);
    EXPECT_EQ(session.scene().camera.eye, glm::dvec3(1, 2, 3));
    EXPECT_EQ(session.scene().camera.fov_deg, 55);
    EXPECT_EQ(session.scene().environment.up, glm::dvec3(0, -2, 1));
}

TEST(Session, TurningAllLightsWithTheSkyIsOneRecordAndReplaysToTheBit) {
    const TemporaryFolder folder;
    const auto file = write_scene(folder.path());
    std::string text = test::read_text(file);
    text.insert(text.find('{') + 1, R"("lights": [{"type": "sun", "direction": [1, -2, 0.5]},
        {"type": "point", "position": [1, 2, 3]}],)");
    test::write_text(file, text);
    Session session(file, recorded(folder));
    ASSERT_EQ(session.scene().lights.size(), 2u);
    std::vector<Light> lights = session.scene().lights;
    glm::dvec3 up = session.scene().environment.up;
    for (int i = 1; i <= 20; ++i) {  // a drag
        lights[0].direction += glm::dvec3(0.1 / i, 0, 1.0 / 3);
        lights[1].position -= glm::dvec3(0, 0.1 * i, 1e-5);
        up += glm::dvec3(0, 0, 0.01 * i);
        session.set("lights", lights_value(lights, up));
    }
    const Journal journal = read_journal(folder.path() / "live.jsonl");
    EXPECT_EQ(journal.entries.size(), 1u);
    Session again(file, headless());
    replay(journal, again);
    for (const Session* each : {&session, &again}) {
        EXPECT_EQ(each->scene().lights[0].direction, lights[0].direction);
        EXPECT_EQ(each->scene().lights[1].position, lights[1].position);
        EXPECT_EQ(each->scene().environment.up, up);
    }
}

TEST(Session, BrushesOutOfRangeAreRefused) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    session.brush().radius = std::nanf("");
    EXPECT_THROW(session.begin_stroke(), std::invalid_argument);
    session.brush().radius = -1;
    EXPECT_THROW(session.begin_stroke(), std::invalid_argument);
    EXPECT_FALSE(session.in_stroke());
}

}  // namespace
}  // namespace relievo::session_test
