// Camera moves of the window: what they must keep, and the places where a turntable breaks.
#include "editor/gui/camera_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace relievo::gui::camera_control_test {
namespace {

Camera camera_at(glm::dvec3 eye, glm::dvec3 up = {0, 1, 0}) {
    return {eye, {0.5, 0, 0}, up, 40};
}

double distance(const Camera& camera) {
    return glm::length(camera.eye - camera.look_at);
}

Scene scene_with_box(glm::vec3 low, glm::vec3 high, double amplitude) {
    Scene scene;
    scene.objects.emplace_back();
    scene.objects[0].mesh.bounds_low = low;
    scene.objects[0].mesh.bounds_high = high;
    scene.objects[0].displacement.amplitude = amplitude;
    return scene;
}

TEST(CameraControl, orbitKeepsDistanceAndTarget) {
    const Camera before = camera_at({1, 2, 3});
    const Camera after = orbited(before, 120, -45, 600);
    EXPECT_NEAR(distance(after), distance(before), 1e-12);
    EXPECT_EQ(after.look_at, before.look_at);
    EXPECT_GT(glm::length(after.eye - before.eye), 0.1);
}

TEST(CameraControl, orbitThereAndBackReturns) {
    const Camera before = camera_at({1, 2, 3}, {0, 0, 1});
    const Camera after = orbited(orbited(before, 77, 31, 600), -77, -31, 600);
    EXPECT_NEAR(glm::length(after.eye - before.eye), 0, 1e-9);
}

TEST(CameraControl, orbitOverThePoleStopsShortOfIt) {
    Camera camera = camera_at({0.5, 0.1, 4});
    for (int i = 0; i < 100; ++i) camera = orbited(camera, 3, 200, 600);
    const glm::dvec3 out = glm::normalize(camera.eye - camera.look_at);
    EXPECT_GT(out.y, 0.999);
    EXPECT_GT(glm::length(glm::cross(out, camera.up)), 1e-3);  // left and right still exist
}

TEST(CameraControl, panMovesThePointUnderThePointerWithIt) {
    const Camera before = camera_at({0.5, 0, 5});
    const double half_height = std::tan(20 * 3.14159265358979323846 / 180) * distance(before);
    const Camera after = panned(before, 300, 0, 600);  // half the picture's height to the right
    EXPECT_NEAR(after.look_at.x, before.look_at.x - half_height, 1e-9);
    EXPECT_NEAR(distance(after), distance(before), 1e-12);
}

TEST(CameraControl, zoomInAndOutReturns) {
    const Camera before = camera_at({1, 2, 3});
    const Scene scene = scene_with_box({-1, -1, -1}, {1, 1, 1}, 0.4);
    const Camera near = zoomed(before, 7, scene);
    EXPECT_LT(distance(near), distance(before));
    EXPECT_NEAR(glm::length(zoomed(near, -7, scene).eye - before.eye), 0, 1e-9);
}

TEST(CameraControl, zoomEndsWhereThereIsAWayBack) {
    const Scene scene = scene_with_box({-1, -1, -1}, {1, 1, 1}, 0.4);
    const Camera before = camera_at({1, 2, 3});
    for (const double notches : {1.0, -1.0}) {
        Camera camera = before;
        for (int i = 0; i < 2000; ++i) camera = zoomed(camera, notches, scene);
        EXPECT_GT(distance(camera), 1e-4);
        EXPECT_LT(distance(camera), 1e3);
        const glm::dvec3 out = (camera.eye - camera.look_at) / distance(camera);
        EXPECT_NEAR(glm::length(out - (before.eye - before.look_at) / distance(before)), 0, 1e-9);
    }
    const Camera far = camera_at({1e5, 0, 0});  // as its scene says
    EXPECT_EQ(zoomed(far, -1, scene).eye, far.eye);
    EXPECT_LT(distance(zoomed(far, 1, scene)), distance(far));
}

TEST(CameraControl, viewsAlongTheAxesTurnRoundWhenRepeated) {
    const Camera front = looking_along(camera_at({1, 2, 3}), Axis::front);
    EXPECT_NEAR(front.eye.x, front.look_at.x, 1e-9);
    EXPECT_GT(front.eye.z, 1);
    EXPECT_LT(looking_along(front, Axis::front).eye.z, -1);
    const Camera top = looking_along(front, Axis::top);
    EXPECT_GT(top.eye.y, 1);
    EXPECT_LT(looking_along(top, Axis::top).eye.y, -1);
}

TEST(CameraControl, frontOfASceneWithZUpIsMinusY) {
    const Camera front = looking_along(camera_at({1, 2, 3}, {0, 0, 1}), Axis::front);
    EXPECT_LT(front.eye.y, -1);
    EXPECT_NEAR(front.eye.z, 0, 1e-9);
}

TEST(CameraControl, framingHoldsTheSphereInATallNarrowPicture) {
    Scene scene = scene_with_box({-1, -1, -1}, {1, 1, 1}, 0.4);
    scene.camera = camera_at({3, 1, 2});
    scene.origin = {1e5, 0, 0};
    for (const PixelSize picture : {PixelSize{900, 300}, PixelSize{300, 900}, PixelSize{1, 1}}) {
        const Camera camera = framing_all(scene, picture);
        const double radius = std::sqrt(3.0) + 0.2;
        const double half_height = std::tan(20 * 3.14159265358979323846 / 180);
        const double half = std::atan(half_height * std::min(1.0, 1.0 * picture.width / picture.height));
        EXPECT_GT(distance(camera) * std::sin(half), radius);
        EXPECT_NEAR(camera.look_at.x, 1e5, 1e-6);
    }
}

}  // namespace
}  // namespace relievo::gui::camera_control_test
