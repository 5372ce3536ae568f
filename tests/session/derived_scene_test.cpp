// A dropped mesh or map, and a new map, become scenes that open, save and recover as any other.
#include "editor/session/derived_scene.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "brushes/colour_file.h"
#include "editor/session/session.h"
#include "tests/session/test_scene.h"

namespace relievo::derived_scene_test {
namespace {

namespace fs = std::filesystem;

class DerivedScene : public testing::Test {
  protected:
    DerivedScene() {
        setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
        scene_ = test::write_scene(folder_.path());
    }
    ~DerivedScene() override { unsetenv("XDG_STATE_HOME"); }

    fs::path at(const char* name) const { return folder_.path() / name; }

    test::TemporaryFolder folder_;
    fs::path scene_;
};

TEST_F(DerivedScene, FilesAreToldApartByTheirExtensionInEitherCase) {
    EXPECT_EQ(kind_of_file("a/b.JSON"), FileKind::scene);
    EXPECT_EQ(kind_of_file("b.Obj"), FileKind::mesh);
    EXPECT_EQ(kind_of_file("b.tiff"), FileKind::map);
    EXPECT_EQ(kind_of_file("png"), FileKind::unknown);
    EXPECT_EQ(kind_of_file(""), FileKind::unknown);
}

TEST_F(DerivedScene, AMeshOpensWithANewMap) {
    const fs::path scene = scene_of_mesh(at("sheet.obj"));
    Session session(scene, test::headless());
    EXPECT_EQ(session.map().width(), 1024);
    EXPECT_FALSE(session.map_path());
    EXPECT_EQ(scene_of_mesh(at("sheet.obj")), scene) << "the same mesh is the same recent file";
}

TEST_F(DerivedScene, ABareMeshTakesAMapAndANewOne) {
    const fs::path bare = scene_of_mesh(at("sheet.obj"));
    save_map(HeightMap(33, 20, 7), at("other.tif"), MapFormat::tiff16);
    Session given(scene_with_map(bare, at("other.tif")), test::headless());
    EXPECT_EQ(given.map_path(), at("other.tif"));
    EXPECT_TRUE(is_derived(given.scene().path));
    EXPECT_FALSE(is_derived(scene_));
    Session made(scene_with_new_map(bare, {at("fresh.png"), 16, 8}), test::headless());
    EXPECT_EQ(made.map().height(), 8);
}

TEST_F(DerivedScene, ANewMapDoesNotReplaceTheOneThatIsOpen) {
    save_map(HeightMap(8, 8, 7), at("open.png"), MapFormat::png16);
    EXPECT_THROW(scene_with_new_map(scene_, {at("./open.png"), 16, 8}, at("open.png")), std::invalid_argument);
    EXPECT_EQ(load_map(at("open.png")).map.width(), 8);
    EXPECT_NO_THROW(scene_with_new_map(scene_, {at("other.png"), 16, 8}, at("open.png")));
}

TEST_F(DerivedScene, SavedHeightsAndColoursOpenTogether) {
    save_map(HeightMap(33, 20, 7), at("other.tif"), MapFormat::tiff16);
    save_colours(ColourMap(33, 20, 16, {1, 2, 3}), at("other_colour.png"));
    const fs::path scene = scene_with_maps(scene_, at("other.tif"), at("other_colour.png"));
    Session session(scene, test::headless());
    EXPECT_EQ(session.map_path(), at("other.tif"));
    ASSERT_NE(session.colours(), nullptr);
    EXPECT_EQ(session.colours()->plane(2).at(0, 0), 3);
    EXPECT_THROW(scene_with_maps(scene_, at("other.tif"), at("none.png")), std::invalid_argument);
    // Another map goes into that scene, whose own files it still names.
    Session again(scene_with_map(scene, at("other.tif")), test::headless());
    EXPECT_NE(again.colours(), nullptr);
}

TEST_F(DerivedScene, IsCalledByTheSceneAndItsMapHoweverOftenThatChanges) {
    EXPECT_EQ(scene_name(scene_), "scene.json");
    for (const char* name : {"other.tif", "third.tif", "scene.tif"}) save_map(HeightMap(9, 9), at(name), MapFormat::tiff16);
    const fs::path other = scene_with_map(scene_, at("other.tif"));
    EXPECT_EQ(scene_name(other), "scene-other");
    const fs::path third = scene_with_map(other, at("third.tif"));
    EXPECT_EQ(scene_name(third), "scene-third");
    EXPECT_EQ(scene_name(scene_with_map(third, at("scene.tif"))), "scene");
    EXPECT_EQ(scene_name(scene_with_map(scene_of_mesh(at("sheet.obj")), at("other.tif"))), "sheet-other");
}

TEST_F(DerivedScene, AMeshThatCannotBeUsedLeavesNoScene) {
    test::write_text(at("bad.obj"), "v 0 0\n");
    EXPECT_THROW(scene_of_mesh(at("bad.obj")), std::invalid_argument);
    EXPECT_TRUE(fs::is_empty(folder_.path() / "state" / "relievo" / "scenes"));
}

TEST_F(DerivedScene, AnotherMapKeepsTheRestOfTheScene) {
    save_map(HeightMap(33, 20, 7), at("other.tif"), MapFormat::tiff16);
    const fs::path scene = scene_with_map(scene_, at("other.tif"));
    Session session(scene, test::headless()), before(scene_, test::headless());
    EXPECT_EQ(session.map().width(), 33);
    EXPECT_EQ(session.map_path(), at("other.tif"));
    EXPECT_EQ(session.scene().objects[0].displacement.amplitude,
              before.scene().objects[0].displacement.amplitude);
    EXPECT_EQ(session.header().mesh_hash, before.header().mesh_hash);
}

TEST_F(DerivedScene, AnotherMapKeepsTheMethodAndItsNamedParameters) {
    std::string text = test::read_text(scene_);
    text.insert(text.rfind('}'), R"(, "method": {"name": "dbvh", "leaf": "triangles", "level": 1})");
    test::write_text(scene_, text);
    save_map(HeightMap(33, 20, 7), at("other.tif"), MapFormat::tiff16);
    const Session session(scene_with_map(scene_, at("other.tif")), test::headless());
    EXPECT_EQ(session.scene().method.name, "dbvh");
    EXPECT_EQ(session.scene().method.parameters, (std::map<std::string, double>{{"leaf", 1}, {"level", 1}}));
}

TEST_F(DerivedScene, AMapTakesThePlaceOfProceduralHeightsAsTheirBakeDoes) {
    std::string text = test::read_text(scene_);
    const std::string map = R"("map": "map.tif")";
    text.replace(text.find(map), map.size(), R"("procedural": {"exemplar": "map.tif"})");
    test::write_text(scene_, text);
    save_map(HeightMap(33, 20, 7), at("bake.png"), MapFormat::png16);
    const Session session(scene_with_map(scene_, at("bake.png")), test::headless());
    const Displacement& displacement = session.scene().objects[0].displacement;
    EXPECT_FALSE(displacement.procedural);
    EXPECT_EQ(displacement.map, at("bake.png"));
    EXPECT_EQ(displacement.wrap, Wrap::clamp);
}

TEST_F(DerivedScene, WhatIsNoMapIsRefused) {
    EXPECT_THROW(scene_with_map(scene_, at("sheet.obj")), std::invalid_argument);
    EXPECT_THROW(scene_with_map(scene_, at("none.png")), std::invalid_argument);
}

TEST_F(DerivedScene, ANewMapOfEachFormatStartsAtMidlevelAndIsSavedAsItWasAskedFor) {
    for (const auto& [name, format] :
         {std::pair{"n.png", MapFormat::png16}, std::pair{"n.tiff", MapFormat::tiff16},
          std::pair{"f.exr", MapFormat::exr_float}, std::pair{"h.exr", MapFormat::exr_half}}) {
        const fs::path scene = scene_with_new_map(scene_, {at(name), 48, 17, format});
        Session session(scene, test::headless());
        EXPECT_EQ(session.map().width(), 48);
        EXPECT_EQ(session.map().height(), 17);
        EXPECT_NEAR(session.map().at(5, 5) / 65535.0, session.scene().objects[0].displacement.midlevel, 1e-3)
            << name;
        test::sculpt(session, 2);
        session.save(*session.map_path());
        EXPECT_EQ(map_info(at(name)).format, format) << name;
    }
}

TEST_F(DerivedScene, ANewMapOfAWrongSizeOrNameIsRefused) {
    EXPECT_THROW(scene_with_new_map(scene_, {at("n.png"), 0, 16, MapFormat::png16}), std::invalid_argument);
    EXPECT_THROW(scene_with_new_map(scene_, {at("n.png"), 16, 16385, MapFormat::png16}),
                 std::invalid_argument);
    EXPECT_THROW(scene_with_new_map(scene_, {at("n.tif"), 16, 16, MapFormat::png16}), std::invalid_argument);
    EXPECT_FALSE(fs::exists(at("n.png")));
}

}  // namespace
}  // namespace relievo::derived_scene_test
