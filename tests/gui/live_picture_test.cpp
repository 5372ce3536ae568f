// What of the window's picture is saved, from a device; skipped without one.
#include "editor/gui/live_picture.h"

#include <gtest/gtest.h>

#include "tests/session/on_device.h"

namespace relievo::gui::live_picture_test {
namespace {

class LivePictures : public test::OnDevice {
  protected:
    static void trace(LivePicture& live) {
        while (!live.idle()) live.work(5);
    }
};

std::size_t differing(const DisplayPicture& a, const DisplayPicture& b, int x0, int x1) {
    std::size_t count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = x0; x < x1; ++x) {
            const auto at = static_cast<std::size_t>(y * a.width + x) * 4;
            count += !std::equal(&a.rgba[at], &a.rgba[at] + 4, &b.rgba[at]);
        }
    return count;
}

TEST_F(LivePictures, AViewOfLayersIsSavedAsItIsSeenOfBothMethodsAndAfterEveryStroke) {
    Session session(test::write_scene(folder_.path()), on_device());
    LiveReference reference(session, [] {});
    LivePicture live(session, reference, VK_FORMAT_R8G8B8A8_UNORM);
    session.set("amplitude", 2.0);  // too rough for coarse steps
    live.resize({96, 72});
    live.set_view(View::normals);
    trace(live);
    const DisplayPicture before = live.layers();
    ASSERT_EQ(before.width, 96);
    ASSERT_EQ(before.height, 72);
    test::sculpt(session, 4, 20);
    live.restart();
    trace(live);
    const DisplayPicture after = live.layers();
    EXPECT_GT(differing(before, after, 0, 96), 20u);

    live.compare_with(MethodChoice{"march", {{"steps", 10}}});
    live.set_divider(0.375);
    trace(live);
    const DisplayPicture both = live.layers();
    EXPECT_EQ(differing(after, both, 0, 36), 0u);
    EXPECT_GT(differing(after, both, 36, 96), 0u);
    EXPECT_EQ(live.parts().size(), 2u);
    EXPECT_EQ(live.parts()[1].x0, 36);
}

TEST_F(LivePictures, ComeToRestAfterAMotionInWhichTheMethodsDifferInSize) {
    Session session(test::write_scene(folder_.path()), on_device());
    LiveReference reference(session, [] {});
    LivePicture live(session, reference, VK_FORMAT_R8G8B8A8_UNORM);
    live.resize({96, 72});
    live.compare_with(MethodChoice{"march", {{"steps", 10}}});
    const auto path = folder_.path() / "both.png";
    for (const View view : {View::normals, View::beauty}) {
        live.set_view(view);
        live.in_motion();
        live.parts()[1].renderer->resize(48, 36);
        EXPECT_THROW(live.come_to_rest([](double) { return false; }), Stopped);
        live.come_to_rest({});
        EXPECT_EQ(live.progress(), 1);
        for (const RenderPart& part : live.parts()) {
            EXPECT_EQ(part.renderer->width(), 96);
            EXPECT_EQ(part.renderer->height(), 72);
        }
        if (shows_layers(view)) EXPECT_EQ(live.layers().width, 96);
        write_render(live.parts(), path, {});
    }
}

}  // namespace
}  // namespace relievo::gui::live_picture_test
