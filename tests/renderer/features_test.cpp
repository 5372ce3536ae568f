// What scenes build and leave out.
#include "renderer/features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "tests/support/scenes.h"

namespace relievo::test::features_test {
namespace {

FeatureRequest request_of(bool everything = false) { return {&find_method("pdm"), everything, false, TracePath::bvh, false}; }

std::set<std::string> built_by(const Scene& scene, const Method& method) {
    const FeatureRequest request{&method, false, false, TracePath::bvh, false};
    std::set<std::string> built;
    for (const Feature& f :
         describe_features(scene, request, derive_features(scene, request), resolve_parameters(method, {})).features)
        if (f.built) built.insert(f.name);
    return built;
}

// What a method's description asks for, over heights of an exemplar or over a map's.
std::set<std::string> needs_of(const Method& method, bool procedural) {
    std::set<std::string> needs;
    if (method.map_bounds == MapBounds::heights || (method.map_bounds == MapBounds::planes && procedural))
        needs.insert("min-max pyramid");
    if (method.map_bounds == MapBounds::planes && !procedural) needs.insert("bounds about planes");
    if (method.geometry == GeometryKind::surface_bounds) needs.insert("surface bounds");
    if (method.geometry == GeometryKind::triangles) needs.insert("micro-triangles");
    for (const MethodParameter& p : method.parameters) {
        if (p.name == "jitter" && p.standard > 0.5) needs.insert("thin-feature jitter");
        if (p.name == "correct_normals" && p.standard > 0.5) needs.insert("normal correction");
    }
    return needs;
}

TEST(Features, AnOpaqueMatteSceneLeavesOutOpacityAndGloss) {
    Scene scene = make_scene(plane_mesh(), 0.2);
    scene.objects[0].material.specular = 0;
    const Features f = derive_features(scene, request_of());
    EXPECT_TRUE(f.shadows);
    EXPECT_TRUE(f.sky);
    EXPECT_FALSE(f.opacity);
    EXPECT_FALSE(f.gloss);
    EXPECT_FALSE(f.pyramid);
    EXPECT_FALSE(f.mended_creases);
}

TEST(Features, ADarkSceneTracesNoShadows) {
    Scene scene = make_scene(plane_mesh(), 0.2);
    scene.lights.clear();
    scene.environment.intensity = 0;
    const Features f = derive_features(scene, request_of());
    EXPECT_FALSE(f.shadows);
    EXPECT_FALSE(f.sky);
    EXPECT_TRUE(derive_features(scene, request_of(true)).shadows);
}

TEST(Features, RaysOfADenseFlatSheetWalkAlone) {
    const auto bundled = [](const MeshFile& mesh, int size, bool can_bundle) {
        FeatureRequest request = request_of();
        request.can_bundle = can_bundle;
        const Scene scene = make_scene(mesh, 0.2);
        request.dense_sheet = is_dense_sheet(scene, size, size);
        const Features features = derive_features(scene, request);
        for (const Feature& f : describe_features(scene, request, features, resolve_parameters(*request.method, {})).features)
            if (f.name == "bundles of rays") EXPECT_EQ(f.built, features.bundles) << f.reason;
        return features.bundles;
    };
    const MeshFile few = plane_mesh(), ball = ball_mesh(160, 80);
    MeshFile sheet;  // a fan, as flat as a plane
    sheet.positions = {{0, 0, 0}};
    sheet.uvs = {{0, 0}};
    for (std::uint32_t i = 0; i <= 12000; ++i) {
        const double a = i * 1e-4;
        sheet.positions.push_back({std::cos(a), 0, -std::sin(a)});
        sheet.uvs.push_back({std::cos(a), std::sin(a)});
        if (i > 0) sheet.faces.push_back({{0, i, i + 1}, {0, i, i + 1}});
    }
    EXPECT_FALSE(bundled(sheet, 256, true));
    EXPECT_TRUE(bundled(sheet, 512, true)) << "a bundle meets few triangles";
    EXPECT_TRUE(bundled(ball, 256, true)) << "each ray alone meets many boxes";
    EXPECT_TRUE(bundled(few, 256, true));
    EXPECT_FALSE(bundled(few, 256, false)) << "not on this device";
}

// What each sample scene builds by each method, by name; all else is left out.
TEST(Features, SampleScenesBuildWhatTheyNeed) {
    const std::set<std::string> usual{"base mesh prisms", "displacement maps", "height bounds", "shadows", "sky light",
                                      "gloss",            "own BVH",         "image"};
    const std::map<std::string, std::set<std::string>> by_scene{
        {"plane", {}}, {"asteroid", {}}, {"chainmail", {"opacity maps"}}, {"leather", {}},
        {"orb", {}},   {"stump", {}},    {"knot", {}},                    {"fur", {}}, {"scree", {"procedural heights"}},
        {"procedural_plane", {"procedural heights"}}, {"procedural_sphere", {"procedural heights"}}};
    const std::map<std::string, std::set<std::string>> by_method{
        {"pdm", {"thin-feature jitter", "normal correction"}},
        {"exact", {"bounds about planes", "surface bounds", "normal correction"}}};
    for (const auto& [name, scene_needs] : by_scene) {
        const Scene scene = load_scene(std::string(RELIEVO_SAMPLE_SCENES) + "/" + name + ".json");
        const bool procedural = scene_needs.contains("procedural heights");
        for (const auto& [method, needs_over_map] : by_method) {
            std::set<std::string> method_needs = needs_over_map;
            if (procedural && method_needs.erase("bounds about planes") > 0) method_needs.insert("min-max pyramid");
            std::set<std::string> expected = usual;
            expected.insert(scene_needs.begin(), scene_needs.end());
            expected.insert(method_needs.begin(), method_needs.end());
            EXPECT_EQ(built_by(scene, find_method(method)), expected) << name << " by " << method;
            EXPECT_EQ(method_needs, needs_of(find_method(method), procedural)) << method;
        }
        for (const Method* method : methods()) {  // also those that the table does not name
            std::set<std::string> expected = usual;
            expected.insert(scene_needs.begin(), scene_needs.end());
            expected.merge(needs_of(*method, procedural));
            EXPECT_EQ(built_by(scene, *method), expected) << name << " by " << method->name;
        }
    }
}

TEST(Features, SwitchesThatAreOffAreLeftOut) {
    const Scene scene = make_scene(plane_mesh(), 0.2);
    const FeatureRequest request = request_of();
    const FeatureReport report = describe_features(scene, request, derive_features(scene, request),
                                                   {{"dt", 0.01}, {"jitter", 0}, {"correct_normals", 1}});
    for (const Feature& f : report.features) {
        if (f.name == "thin-feature jitter") {
            EXPECT_FALSE(f.built);
            EXPECT_EQ(f.reason, "jitter is off: what is thinner than a step can be missed for good");
        }
        if (f.name == "normal correction") EXPECT_TRUE(f.built);
    }
}

TEST(Features, EverythingIsBuiltWhenItIsAskedFor) {
    Scene scene = make_scene(plane_mesh(), 0.2);
    scene.objects[0].material.specular = 0;
    scene.lights.clear();
    scene.environment.intensity = 0;
    const FeatureRequest request = request_of(true);
    const FeatureReport report =
        describe_features(scene, request, derive_features(scene, request), resolve_parameters(*request.method, {}));
    for (const Feature& f : report.features) {
        const std::set<std::string> named{"shadows", "sky light", "gloss", "opacity maps", "min-max pyramid", "albedo maps"};
        if (!named.contains(f.name)) continue;
        EXPECT_TRUE(f.built) << f.name;
        EXPECT_EQ(f.reason, "everything was asked for") << f.name;
    }
}

TEST(Features, OneWayOfTracingIsBuiltAndTheOthersSayWhyNot) {
    const Scene scene = make_scene(plane_mesh(), 0.2);
    for (const TracePath path : {TracePath::ray_query, TracePath::pipeline, TracePath::bvh}) {
        for (const bool asked_for : {false, true}) {
            const FeatureRequest request{&find_method("exact"), false, false, path, asked_for};
            int ways = 0;
            for (const Feature& f : describe_features(scene, request, derive_features(scene, request), {}).features) {
                if (f.name != "ray query" && f.name != "ray tracing pipeline" && f.name != "own BVH") continue;
                ++ways;
                EXPECT_EQ(f.built, f.name == trace_path_words(path)) << f.name;
                EXPECT_EQ(f.reason == "asked for by --path", f.built && asked_for) << f.name;
            }
            EXPECT_EQ(ways, 3);
        }
    }
}

TEST(Features, EachFeatureHasAReason) {
    const Scene scene = make_scene(plane_mesh(), 0.2);
    for (const bool everything : {false, true}) {
        const FeatureRequest request = request_of(everything);
        const auto report = describe_features(scene, request, derive_features(scene, request),
                                              resolve_parameters(*request.method, {}));
        EXPECT_GE(report.features.size(), 20u);
        for (const Feature& f : report.features) EXPECT_FALSE(f.reason.empty()) << f.name;
    }
}

}  // namespace
}  // namespace relievo::test::features_test
