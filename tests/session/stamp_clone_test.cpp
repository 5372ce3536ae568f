// Stamp and clone in a session: what journals hold of them, replay to the byte, sources that move along, and
// every kind of wrong line or image.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "editor/session/recovery.h"
#include "editor/session/replay.h"
#include "tests/session/test_scene.h"

namespace relievo::stamp_clone_test {
namespace {

using test::headless;
using test::TemporaryFolder;
using test::write_scene;

void write_alpha(const std::filesystem::path& path, std::uint8_t first = 200) {
    const std::uint8_t pixels[] = {first, 30, 90, 255};
    const auto out = OIIO::ImageOutput::create(path.string());
    ASSERT_TRUE(out && out->open(path.string(), OIIO::ImageSpec(2, 2, 1, OIIO::TypeDesc::UINT8)));
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::UINT8, pixels) && out->close());
}

// Faces 2 (8 row + column) and the next make a quad of the sheet.
FacePoint quad(int row, int column) {
    return {static_cast<std::uint32_t>(2 * (8 * row + column)), 300000, 250000};
}

void sculpt_along(Session& session, Tool tool, int row) {
    session.brush().tool = tool;
    session.brush().radius = 0.3f;
    session.brush().strength = 0.8f;
    session.begin_stroke();
    for (int i = 4; i < 8; ++i) {
        const FacePoint at = quad(row, i);
        Dab dab{.time_us = static_cast<std::uint32_t>(i) * 5000, .face = at.face, .b1 = at.b1, .b2 = at.b2};
        if (tool == Tool::stamp) dab.drag = {40000, 1000 * i, 52000};
        session.dab(dab);
    }
    session.end_stroke();
}

// A session with strokes of both tools, mirrored too, recorded in `journal`; the hash of its map.
std::uint64_t record(const TemporaryFolder& folder, const std::filesystem::path& journal) {
    SessionOptions options = headless();
    options.journal = journal;
    Session session(write_scene(folder.path()), options);
    session.set_alpha(load_alpha(folder.path() / "images" / "a.png"));
    test::sculpt(session, 1);
    sculpt_along(session, Tool::stamp, 2);
    session.set_clone_source(quad(1, 2));
    sculpt_along(session, Tool::clone, 6);
    session.brush().mirror_x = session.brush().mirror_y = true;
    session.brush().rotation = 70;
    sculpt_along(session, Tool::stamp, 5);
    sculpt_along(session, Tool::clone, 3);
    return session.map().hash();
}

std::string replay_error(const TemporaryFolder& folder, const std::filesystem::path& journal,
                         bool force = false) {
    Session session(folder.path() / "scene.json", headless());
    const std::uint64_t before = session.map().hash();
    ReplayOptions options;
    options.force = force;
    try {
        replay(read_journal(journal), session, options);
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(session.map().hash(), before) << "nothing is half done";
        const std::string message = error.what();
        return message.substr(message.find("a.jsonl"));
    }
    return "no error";
}

struct Recorded {
    Recorded() {
        std::filesystem::create_directory(folder.path() / "images");
        write_alpha(image);
        hash = record(folder, journal);
    }
    TemporaryFolder folder;
    std::filesystem::path image = folder.path() / "images" / "a.png", journal = folder.path() / "a.jsonl";
    std::uint64_t hash = 0;
};

TEST(StampAndClone, ReplayToTheByteAlsoFromAnotherFolder) {
    const Recorded recorded;
    const std::string text = test::read_text(recorded.journal);
    EXPECT_NE(text.find(R"("alpha":{"file":"images/a.png","hash":")"), std::string::npos) << text;
    Session again(recorded.folder.path() / "scene.json", headless());
    replay(read_journal(recorded.journal), again);
    EXPECT_EQ(again.map().hash(), recorded.hash);

    const TemporaryFolder other;  // both moved together
    std::filesystem::copy(recorded.folder.path(), other.path(), std::filesystem::copy_options::recursive);
    Session moved(other.path() / "scene.json", headless());
    replay(read_journal(other.path() / "a.jsonl"), moved);
    EXPECT_EQ(moved.map().hash(), recorded.hash);
}

TEST(StampAndClone, AnImageThatIsMissingOrChangedIsOneClearErrorBeforeAnythingIsDone) {
    const Recorded recorded;
    const std::string old_hash = hash_text(load_alpha(recorded.image)->hash());
    write_alpha(recorded.image, 201);
    EXPECT_EQ(replay_error(recorded.folder, recorded.journal),
              "a.jsonl:3: alpha '" + recorded.image.string() + "': the image has changed: recorded with " +
                  old_hash + ", it is " + hash_text(load_alpha(recorded.image)->hash()) +
                  "; put the recorded image back, or give --force");
    EXPECT_EQ(replay_error(recorded.folder, recorded.journal, true), "no error");
    std::filesystem::remove(recorded.image);
    EXPECT_EQ(replay_error(recorded.folder, recorded.journal),
              "a.jsonl:3: alpha '" + recorded.image.string() + "': no such file");
}

TEST(StampAndClone, LinesThatLackWhatTheToolNeedsAreRefused) {
    const auto error_of = [](const std::string& stroke) {
        const TemporaryFolder folder;
        test::write_text(folder.path() / "a.jsonl",
                         "{\"relievo_journal\":1}\n{\"op\":\"stroke\"," + stroke + "}\n");
        try {
            read_journal(folder.path() / "a.jsonl");
        } catch (const std::invalid_argument& error) {
            const std::string message = error.what();
            return message.substr(message.find("a.jsonl"));
        }
        return std::string("no error");
    };
    const std::string stamp = R"("brush":{"tool":"stamp"},"dabs":[])",
                      clone = R"("brush":{"tool":"clone"},"dabs":)";
    EXPECT_EQ(error_of(stamp), "a.jsonl:2: alpha: is missing");
    EXPECT_EQ(error_of(stamp + R"(,"alpha":"a.png")"), "a.jsonl:2: alpha: is a string, must be an object");
    EXPECT_EQ(error_of(stamp + R"(,"alpha":{"file":"a.png"})"), "a.jsonl:2: alpha: hash: is missing");
    EXPECT_EQ(error_of(R"("brush":{},"dabs":[],"alpha":{"file":"a.png","hash":"1"})"),
              "a.jsonl:2: alpha: belongs to strokes of the stamp tool alone");
    EXPECT_EQ(error_of(clone + "[]"), "a.jsonl:2: sources: is missing");
    EXPECT_EQ(error_of(clone + R"([[0,0,0,0,1]],"sources":[[]])"),
              "a.jsonl:2: sources[0]: must be an array of one place a dab: 1");
    EXPECT_EQ(error_of(clone + R"([],"sources":[[],[]])"),
              "a.jsonl:2: sources: has 2 lists, must have one for the hand and one for each of 0 copies");
    EXPECT_EQ(error_of(clone + R"([[0,0,0,0,1]],"sources":[[[0,1048576,1]]])"),
              "a.jsonl:2: sources[0][0]: b1 + b2 must be at most 1048576");
    EXPECT_EQ(error_of(R"("brush":{},"dabs":[],"sources":[])"),
              "a.jsonl:2: sources: belongs to strokes of the clone tool alone");
    EXPECT_EQ(error_of(stamp + R"(,"alpha":{"file":"a.png","hash":"1"})"), "no error");
}

TEST(StampAndClone, ASourceOnNoFaceIsNamedByLine) {
    const TemporaryFolder folder;
    write_scene(folder.path());
    test::write_text(
        folder.path() / "a.jsonl",
        "{\"relievo_journal\":1}\n"
        R"({"op":"stroke","brush":{"tool":"clone"},"dabs":[[0,0,0,0,1]],"sources":[[[128,0,0]]]})"
        "\n");
    EXPECT_EQ(replay_error(folder, folder.path() / "a.jsonl"),
              "a.jsonl:2: sources[0]: names face 128, the mesh has 128 faces, counted from 0");
}

TEST(StampAndClone, WithoutImageOrSourceAStrokeDoesNotBegin) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    for (const Tool tool : {Tool::stamp, Tool::clone}) {
        session.brush().tool = tool;
        EXPECT_THROW(session.begin_stroke(), std::invalid_argument);
        EXPECT_FALSE(session.in_stroke());
    }
    EXPECT_THROW(session.set_clone_source({128, 0, 0}), std::out_of_range);
    EXPECT_THROW(session.set_clone_source({0, Dab::kBarycentricOne, 1}), std::out_of_range);
    EXPECT_FALSE(session.clone_source(quad(0, 0)));
}

TEST(StampAndClone, TheSourceMovesAlongAndStaysAlignedUntilItIsSetAgain) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    session.set_clone_source(quad(1, 1));
    EXPECT_EQ(session.clone_source(quad(6, 6)), quad(1, 1)) << "nothing has settled an offset";
    const auto face_of = [&](int row, int column) { return session.clone_source(quad(row, column))->face; };

    sculpt_along(session, Tool::clone, 6);  // from column 4 on
    EXPECT_EQ(face_of(6, 4), quad(1, 1).face);
    EXPECT_EQ(face_of(6, 6), quad(1, 3).face);
    EXPECT_EQ(face_of(5, 4), quad(0, 1).face);

    session.stroke_settings().aligned = false;
    sculpt_along(session, Tool::clone, 5);
    EXPECT_EQ(face_of(5, 4), quad(1, 1).face) << "it began at the source again";

    session.set_clone_source(quad(2, 2));
    EXPECT_EQ(session.clone_source(quad(0, 0)), quad(2, 2));
}

TEST(StampAndClone, ACancelledStrokeSettlesNoOffset) {
    const TemporaryFolder folder;
    Session session(write_scene(folder.path()), headless());
    session.set_clone_source(quad(1, 1));
    session.brush().tool = Tool::clone;
    session.begin_stroke();
    const FacePoint at = quad(6, 6);
    session.dab({.face = at.face, .b1 = at.b1, .b2 = at.b2});
    session.cancel_stroke();
    EXPECT_EQ(session.clone_source(quad(3, 3)), quad(1, 1));
}

}  // namespace
}  // namespace relievo::stamp_clone_test
