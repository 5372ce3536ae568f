// Strokes that are repeated by mirrors and turns of the object: both sides equal to the last count where mesh
// and layout are symmetric, the nearest place elsewhere, and replay to the byte.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "brushes/map_file.h"
#include "editor/session/replay.h"
#include "editor/session/session.h"
#include "tests/session/test_scene.h"

namespace relievo::symmetry_test {
namespace {

constexpr int kQuads = 8;  // a side
constexpr int kMap = 96;   // texels a side

// A vault over [-1, 1]^2, symmetric in x, diagonals included; u runs along x. `skew` moves the right half's
// inner vertices, so that it has no mirror image.
std::string vault(double skew) {
    std::ostringstream obj;
    for (int y = 0; y <= kQuads; ++y)
        for (int x = 0; x <= kQuads; ++x) {
            const double u = static_cast<double>(x) / kQuads, v = static_cast<double>(y) / kQuads;
            const double move = x > kQuads / 2 && x < kQuads ? skew : 0, px = u * 2 - 1;
            obj << "v " << px + move << " " << v * 2 - 1 << " "
                << 0.5 - 0.4 * px * px + 0.05 * std::sin(4 * v) << "\nvt " << u << " " << v << "\n";
        }
    const auto corner = [](int i) { return std::to_string(i) + "/" + std::to_string(i); };
    for (int y = 0; y < kQuads; ++y)
        for (int x = 0; x < kQuads; ++x) {
            const int a = y * (kQuads + 1) + x + 1, b = a + 1, d = a + kQuads + 1, c = d + 1;
            if (x < kQuads / 2)
                obj << "f " << corner(a) << " " << corner(b) << " " << corner(c) << "\nf " << corner(a) << " "
                    << corner(c) << " " << corner(d) << "\n";
            else
                obj << "f " << corner(d) << " " << corner(b) << " " << corner(c) << "\nf " << corner(a) << " "
                    << corner(b) << " " << corner(d) << "\n";
        }
    return obj.str();
}

std::filesystem::path write_vault(const std::filesystem::path& folder, double skew = 0,
                                  const std::string& transform = "") {
    test::write_text(folder / "vault.obj", vault(skew));
    HeightMap map(kMap, kMap);
    for (int y = 0; y < kMap; ++y)
        for (int x = 0; x < kMap; ++x) {
            const int side = std::min(x, kMap - 1 - x);
            map.set(x, y, static_cast<std::uint16_t>(28000 + 97 * ((side * 7 + y * 13) % 31) + 40 * side));
        }
    save_map(map, folder / "map.tif", MapFormat::tiff16);
    test::write_text(folder / "scene.json",
                     R"({"relievo": 1, "objects": [{"mesh": "vault.obj", "displacement": {"map": "map.tif",)"
                     R"( "wrap": "clamp", "amplitude": 0.2, "midlevel": 0.5})" +
                         transform + "}]}");
    return folder / "scene.json";
}

// A stroke on the left half, up to the plane x = 0 and along it.
void sculpt_left(Session& session, Tool tool) {
    Brush& brush = session.brush();
    brush.tool = tool;
    brush.radius = 0.3f;
    brush.strength = 0.8f;
    brush.level = 0.6f;
    session.begin_stroke();
    for (int i = 0; i < 14; ++i) {
        Dab dab;
        dab.face = static_cast<std::uint32_t>(2 * (4 * kQuads + std::min(1 + i / 4, kQuads / 2 - 1)));
        dab.b1 = 250000u + static_cast<std::uint32_t>(i % 4) * 200000u;
        dab.b2 = 123457;
        if (tool == Tool::grab) dab.face = 2 * (4 * kQuads + 3), dab.drag = {i * 3000, i * 1000, i * 2000};
        session.dab(dab);
    }
    session.end_stroke();
}

int asymmetric_texels(const HeightMap& map) {
    int count = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width() / 2; ++x) count += map.at(x, y) != map.at(map.width() - 1 - x, y);
    return count;
}

TEST(Symmetry, BothSidesOfTheMirrorAreEqualToTheLastCountWithEveryTool) {
    const test::TemporaryFolder folder;
    Session session(write_vault(folder.path()), test::headless());
    ASSERT_EQ(asymmetric_texels(session.map()), 0);
    session.brush().mirror_x = true;
    session.set_alpha(
        std::make_shared<const Alpha>(folder.path() / "a.png", 2, 2, std::vector{0.2f, 1.0f, 0.6f, 0.1f}));
    session.set_clone_source({2 * (2 * kQuads + 1), 300000, 123457});
    for (const ToolInfo& info : tools()) {
        const std::uint64_t before = session.map().hash();
        sculpt_left(session, info.tool);
        EXPECT_TRUE(session.map().hash() != before || info.tool == Tool::mask) << info.name;
        EXPECT_EQ(asymmetric_texels(session.map()), 0) << info.name;
    }
    session.brush().erase_to = EraseTo::saved;
    sculpt_left(session, Tool::erase);
    EXPECT_EQ(asymmetric_texels(session.map()), 0);
    ASSERT_TRUE(session.mask());
    EXPECT_EQ(asymmetric_texels(*session.mask()), 0);
    const std::uint64_t hard = session.mask()->hash();
    session.brush().blur = true;
    sculpt_left(session, Tool::mask);
    EXPECT_NE(session.mask()->hash(), hard);
    EXPECT_EQ(asymmetric_texels(*session.mask()), 0);
}

TEST(Symmetry, AnObjectMovedAndTurnedKeepsItsOwnPlanes) {
    const test::TemporaryFolder folder;
    Session session(write_vault(folder.path(), 0,
                                R"(, "transform": {"translate": [30, -2, 7], "rotate_deg": [0, 90, 0]})"),
                    test::headless());
    session.brush().mirror_x = true;
    sculpt_left(session, Tool::draw);
    EXPECT_TRUE(session.can_undo());
    EXPECT_LE(asymmetric_texels(session.map()), kMap * kMap / 500) << "but for rounding of the turned places";
}

TEST(Symmetry, AStrokeAlongThePlaneIsNoStrongerThanWithoutMirror) {
    const test::TemporaryFolder folder;
    int rises[2];
    for (const bool mirror : {false, true}) {
        Session session(write_vault(folder.path()), test::headless());
        session.brush().mirror_x = mirror;
        session.brush().radius = 0.3f;
        const int before = session.map().at(kMap / 2, kMap / 2);
        session.begin_stroke();
        Dab dab;  // the corner on the plane
        dab.face = static_cast<std::uint32_t>(2 * (4 * kQuads + 3));
        dab.b1 = Dab::kBarycentricOne;
        for (int i = 0; i < 5; ++i) session.dab(dab);
        session.end_stroke();
        rises[mirror] = session.map().at(kMap / 2, kMap / 2) - before;
    }
    EXPECT_GT(rises[0], 1000);
    EXPECT_NEAR(rises[1], rises[0], 3);
}

TEST(Symmetry, WhereTheMeshHasNoMirrorImageTheNearestPlaceIsTaken) {
    const test::TemporaryFolder folder;
    Session session(write_vault(folder.path(), 0.05), test::headless());
    session.brush().mirror_x = true;
    session.brush().accumulate = true;
    const HeightMap before = session.map();
    sculpt_left(session, Tool::draw);
    double left = 0, right = 0;
    for (int y = 0; y < kMap; ++y)
        for (int x = 0; x < kMap / 2; ++x) {
            left += session.map().at(x, y) - before.at(x, y);
            right += session.map().at(kMap - 1 - x, y) - before.at(kMap - 1 - x, y);
        }
    EXPECT_GT(left, 1000);
    EXPECT_NEAR(right / left, 1, 0.1);
}

TEST(Symmetry, TurnsRepeatTheStrokeAroundTheAxis) {
    const test::TemporaryFolder folder;
    Session session(write_vault(folder.path()), test::headless());
    session.brush().radial = 2;
    session.brush().radial_axis = Axis::z;
    session.brush().radius = 0.2f;
    const HeightMap before = session.map();
    session.begin_stroke();
    Dab dab;
    dab.face = 2 * (2 * kQuads + 1);
    dab.b1 = dab.b2 = 300000;
    session.dab(dab);
    session.end_stroke();
    const auto risen = [&](int x, int y) { return session.map().at(x, y) > before.at(x, y); };
    const int x = 19, y = 29;  // about (1 + 0.57) / 8 and (2 + 0.29) / 8
    EXPECT_TRUE(risen(x, y));
    EXPECT_TRUE(risen(kMap - 1 - x, kMap - 1 - y));
    EXPECT_FALSE(risen(kMap - 1 - x, y));
}

TEST(Symmetry, ReplayNeedsNoSearchAndIsBitIdentical) {
    const test::TemporaryFolder folder;
    const auto scene = write_vault(folder.path());
    SessionOptions options = test::headless();
    options.journal = folder.path() / "a.jsonl";
    std::uint64_t wanted = 0, mask = 0;
    {
        Session session(scene, options);
        session.brush().mirror_x = session.brush().mirror_y = true;
        session.brush().radial = 3;
        session.brush().radial_axis = Axis::z;
        for (const Tool tool : {Tool::draw, Tool::mask, Tool::smooth, Tool::grab, Tool::noise})
            sculpt_left(session, tool);
        session.brush().blur = true;
        const std::uint64_t hard = session.mask()->hash();
        sculpt_left(session, Tool::mask);
        EXPECT_NE(session.mask()->hash(), hard);
        session.change_mask(MaskCommand::blur);
        session.change_mask(MaskCommand::invert);
        session.undo();
        sculpt_left(session, Tool::draw);
        wanted = session.map().hash();
        mask = session.mask()->hash();
    }
    const Journal journal = read_journal(options.journal);
    ASSERT_EQ(std::get<StrokeOp>(journal.entries[0].op).copies.size(), 11u);
    Session again(scene, test::headless());
    replay(journal, again);
    EXPECT_EQ(again.map().hash(), wanted);
    ASSERT_TRUE(again.mask());
    EXPECT_EQ(again.mask()->hash(), mask);
}

TEST(Symmetry, AnObjectThatTurnsOutOfShapeIsRefusedByName) {
    const test::TemporaryFolder folder;
    Session session(write_vault(folder.path(), 0, R"(, "transform": {"scale": [1, 2, 1]})"),
                    test::headless());
    session.brush().mirror_x = true;
    session.begin_stroke();
    session.cancel_stroke();
    session.brush().radial = 3;
    session.brush().radial_axis = Axis::z;
    EXPECT_THROW(session.begin_stroke(), std::invalid_argument);
    EXPECT_FALSE(session.in_stroke());
}

}  // namespace
}  // namespace relievo::symmetry_test
