// The live path on a device: a stroke by picking and its replay without one, and the window under the brush.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <stdexcept>

#include "editor/session/replay.h"
#include "editor/session/stroke_input.h"
#include "editor/session/view_window.h"
#include "renderer/vulkan/context.h"
#include "tests/session/test_scene.h"

namespace relievo {
namespace {

bool have_device() {
    for (const vulkan::DeviceInfo& device : vulkan::list_devices())
        if (device.usable) return true;
    return false;
}

class Live : public testing::Test {
  protected:
    void SetUp() override {
        if (!have_device()) GTEST_SKIP() << "no Vulkan device with ray tracing";
        scene_ = test::write_scene(folder_.path());
    }
    void TearDown() override { EXPECT_EQ(vulkan::Context::validation_messages(), 0); }

    SessionOptions on_device() const {
        SessionOptions options;
        options.validation = true;
        options.width = 160;
        options.height = 120;
        return options;
    }

    test::TemporaryFolder folder_;
    std::filesystem::path scene_;
};

TEST_F(Live, APickedStrokeAndItsReplayWithoutADeviceGiveTheSameBytes) {
    SessionOptions options = on_device();
    options.journal = folder_.path() / "live.jsonl";
    std::uint64_t live = 0;
    std::size_t dabs = 0;
    {
        Session session(scene_, options);
        const std::uint64_t start = session.map().hash();
        session.brush().radius = 0.2f;
        session.brush().strength = 1;
        Renderer& renderer = session.renderer();
        StrokeInput input(
            session.brush(), [&](std::span<const Ray> rays) { return renderer.pick(rays); },
            [&](double x, double y) { return renderer.camera_ray(x, y); },
            [&](const Dab& dab) {
                session.dab(dab);
                ++dabs;
            });
        session.begin_stroke();
        input.begin({0, 60, 50, 1});
        for (std::uint64_t i = 1; i < 20; ++i)
            input.move({i * 8000, 60 + 2.7 * static_cast<double>(i), 50 + static_cast<double>(i % 7), 0.9});
        input.end({160000, 112, 60, 1});
        session.end_stroke();
        live = session.map().hash();
        EXPECT_NE(live, start);
        EXPECT_GT(dabs, 5u);
    }
    Session again(scene_, test::headless());
    EXPECT_EQ(replay(read_journal(options.journal), again).dabs, dabs);
    EXPECT_EQ(again.map().hash(), live);
}

TEST_F(Live, APickedPointProjectsBackToItsPixel) {
    Session session(scene_, on_device());
    Renderer& renderer = session.renderer();
    int hits = 0;
    for (double y = 5.5; y < 120; y += 20)
        for (double x = 5.5; x < 160; x += 20) {
            const Ray ray = renderer.camera_ray(x, y);
            const PickHit hit = renderer.pick({&ray, 1}).front();
            if (!hit.hit) continue;
            ++hits;
            const auto place =
                project(session.scene().camera, session.scene().origin, 160, 120, hit.position);
            ASSERT_TRUE(place);
            EXPECT_NEAR(place->x, x, 0.01);
            EXPECT_NEAR(place->y, y, 0.01);
            const glm::vec3 address = session.surface().at(hit.face, hit.b1, hit.b2).position;
            EXPECT_LT(glm::length(address - hit.position), 2e-3f) << "the dab's address is where the ray hit";
        }
    EXPECT_GT(hits, 5);
}

TEST_F(Live, EveryStageOfADabIsTimed) {
    Session session(scene_, on_device());
    session.brush().radius = 0.3f;
    session.begin_stroke();
    session.dab({0, 60, 300000, 300000, 65535});
    ASSERT_TRUE(session.last_dab());
    EXPECT_EQ(session.last_dab()->radius, 0.3f);
    EXPECT_GT(session.times().edit_ms, 0);
    EXPECT_GT(session.times().upload_ms, 0);
    EXPECT_GT(session.times().bounds_ms, 0);
    session.trace({0, 0, 64, 64});
    EXPECT_GT(session.times().trace_ms, 0);
    session.cancel_stroke();
    EXPECT_FALSE(session.unsaved());
}

TEST_F(Live, WhatChangesTheMaskAloneKeepsThePicturesSamples) {
    Session session(scene_, on_device());
    Renderer& renderer = session.renderer();
    test::sculpt(session, 2);
    renderer.render();
    renderer.render();
    test::sculpt(session, 3, 4, Tool::mask);
    session.begin_stroke();
    session.dab({0, 60, 300000, 300000, 65535});
    session.cancel_stroke();
    session.undo();
    session.redo();
    EXPECT_EQ(renderer.samples(), 2);
    session.undo();
    session.undo();  // the surface
    EXPECT_EQ(renderer.samples(), 0);
    renderer.render();
    session.redo();
    EXPECT_EQ(renderer.samples(), 0);
    renderer.render();
    test::sculpt(session, 4);
    EXPECT_EQ(renderer.samples(), 0);
}

}  // namespace
}  // namespace relievo
