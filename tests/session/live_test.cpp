// The live path on a device: a stroke by picking and its replay without one, and the window under the brush.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "editor/session/render_output.h"
#include "editor/session/replay.h"
#include "editor/session/stroke_input.h"
#include "editor/session/view_window.h"
#include "renderer/vulkan/context.h"
#include "tests/session/on_device.h"

namespace relievo::live_test {
namespace {

class Live : public test::OnDevice {
  protected:
    void SetUp() override {
        OnDevice::SetUp();
        if (IsSkipped()) return;
        scene_ = test::write_scene(folder_.path());
    }

    static SessionOptions on_device() { return OnDevice::on_device(160, 120); }

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
        StrokeInput input(
            session.brush(), [&](std::span<const Ray> rays) { return session.renderer().pick(rays); },
            [&](double x, double y) { return session.renderer().camera_ray(x, y); },
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

// Dabs side by side and one upon another, over both halves of the map.
TEST_F(Live, DabsShownManyAtOnceAreShownAsOneByOne) {
    const auto shown_every = [&](std::size_t count) {
        Session session(scene_, on_device());
        session.make_colours(8);
        session.brush().paint = Paint::both;
        session.begin_stroke();
        for (std::uint32_t i = 0; i < 24; ++i) {
            session.dab({0, 60 + 5 * (i / 2), 300000, 300000, 65535});
            if (i % count == 0) session.show_edits();
        }
        Renderer& renderer = session.renderer();
        renderer.restart();
        renderer.render();
        return std::pair(renderer.read_back(Layer::depth), renderer.read_back(Layer::beauty));
    };
    const auto one_by_one = shown_every(1);
    EXPECT_EQ(shown_every(7), one_by_one);
    EXPECT_EQ(shown_every(1000), one_by_one);
    Session untouched(scene_, on_device());
    untouched.renderer().render();
    EXPECT_NE(untouched.renderer().read_back(Layer::depth), one_by_one.first);
}

// By several bands, the last of which is lower than the others.
TEST_F(Live, APictureSavedByBandsHoldsTheLayersAsTheyAreReadAtOnce) {
    SessionOptions options = on_device();
    options.width = 300;
    options.height = 450;
    Session session(scene_, options);
    Renderer& renderer = session.renderer();
    renderer.render();
    const std::vector<Layer> layers{Layer::id, Layer::depth, Layer::uv, Layer::normal};
    const auto path = folder_.path() / "a.exr";
    write_render(renderer, path, layers);
    const auto input = OIIO::ImageInput::open(path.string());
    ASSERT_TRUE(input);
    const auto channels = static_cast<std::size_t>(input->spec().nchannels);
    std::vector<float> values(300 * 450 * channels);
    ASSERT_TRUE(input->read_image(0, 0, 0, input->spec().nchannels, OIIO::TypeDesc::FLOAT, values.data()));
    std::size_t compared = 0;
    const auto compare = [&](Layer layer, const std::vector<std::string>& names) {
        const std::vector<float> wanted = renderer.read_back(layer);
        std::size_t differ = 0;
        for (std::size_t k = 0; k < names.size(); ++k, ++compared) {
            const int found = input->spec().channelindex(names[k]);
            ASSERT_GE(found, 0) << names[k];
            for (std::size_t i = 0; i < 300 * 450; ++i)
                differ += values[i * channels + static_cast<std::size_t>(found)] != wanted[i * names.size() + k];
        }
        EXPECT_EQ(differ, 0u) << names.front();
    };
    compare(Layer::beauty, {"R", "G", "B", "A"});
    for (const AovName& aov : aov_names())
        if (std::find(layers.begin(), layers.end(), aov.layer) != layers.end()) compare(aov.layer, aov.channels);
    EXPECT_EQ(compared, channels);
}

TEST_F(Live, APictureBeingSavedTellsHowFarItIsAndAStoppedOneLeavesTheFolderAsItWas) {
    SessionOptions options = on_device();
    options.width = 300;
    options.height = 450;
    Session session(scene_, options);
    session.renderer().render();
    const std::vector<Layer> layers{Layer::depth, Layer::normal, Layer::uv, Layer::id};
    const auto folder = folder_.path() / "pictures";
    std::filesystem::create_directory(folder);
    // The last one's light is read by bands, three of them, before eight parts are packed.
    for (const std::string name : {"a.png", "a.exr", "light.exr"}) {
        const auto path = folder / name;
        std::vector<double> parts;
        const auto save = [&](std::size_t last) {  // stopped when it asks so many times
            parts.clear();
            write_render(session.renderer(), path, name == "a.exr" ? layers : std::vector<Layer>{}, [&](double part) {
                parts.push_back(part);
                return parts.size() < last;
            });
        };
        EXPECT_THROW(save(1), Stopped) << name;
        EXPECT_TRUE(std::filesystem::is_empty(folder)) << name;
        save(1000);
        const std::size_t asked = parts.size();
        EXPECT_GT(asked, name == "a.png" ? 7u : 11u) << name;
        EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end())) << name;
        EXPECT_GE(parts.front(), 0.0);
        EXPECT_LT(parts.back(), 1.0);
        test::write_text(path, "older");
        for (std::size_t last = 1; last <= asked; ++last) {
            EXPECT_THROW(save(last), Stopped) << name << ", " << last;
            EXPECT_EQ(test::read_text(path), "older") << name << ", " << last;
        }
        std::filesystem::remove(path);
        EXPECT_THROW(save(asked), Stopped) << name;
        EXPECT_TRUE(std::filesystem::is_empty(folder)) << name;
    }
}

TEST_F(Live, EveryStageOfADabIsTimed) {
    Session session(scene_, on_device());
    session.brush().radius = 0.3f;
    session.begin_stroke();
    session.dab({0, 60, 300000, 300000, 65535});
    ASSERT_TRUE(session.last_dab());
    EXPECT_EQ(session.last_dab()->radius, 0.3f);
    EXPECT_GT(session.times().edit_ms, 0);
    session.show_edits();
    EXPECT_GT(session.times().upload_ms, 0);
    EXPECT_GT(session.times().bounds_ms, 0);
    session.trace({0, 0, 64, 64});
    EXPECT_GT(session.times().trace_ms, 0);
    session.cancel_stroke();
    EXPECT_FALSE(session.unsaved());
}

TEST_F(Live, AStoppedUndoOrRedoLeavesMapColoursPictureAndJournalAsTheyWere) {
    SessionOptions options = on_device();
    options.journal = folder_.path() / "live.jsonl";
    Session session(scene_, options);
    session.make_colours(8);
    session.brush().paint = Paint::both;
    test::sculpt(session, 3);
    const auto state = [&] {
        Renderer& renderer = session.renderer();
        renderer.restart();
        renderer.render();
        return std::tuple(session.map().hash(), session.colours()->hash(), renderer.read_back(Layer::beauty),
                          renderer.read_back(Layer::depth), test::read_text(options.journal), session.can_undo());
    };
    const auto stop_at = [](int last) -> Advance {
        return [last, asked = 0](double) mutable { return ++asked < last; };
    };
    constexpr int kTimes = 3;  // before all, before the heights are shown, and before the colours are
    const auto done = state();
    for (int last = 1; last <= kTimes; ++last) {
        EXPECT_THROW(session.undo(stop_at(last)), Stopped) << last;
        EXPECT_EQ(state(), done) << last;
    }
    EXPECT_TRUE(session.undo(stop_at(kTimes + 1)));
    const auto undone = state();
    EXPECT_NE(undone, done);
    for (int last = 1; last <= kTimes; ++last) {
        EXPECT_THROW(session.redo(stop_at(last)), Stopped) << last;
        EXPECT_EQ(state(), undone) << last;
    }
    EXPECT_TRUE(session.redo(stop_at(kTimes + 1)));
    EXPECT_EQ(session.map().hash(), std::get<0>(done));
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
}  // namespace relievo::live_test
