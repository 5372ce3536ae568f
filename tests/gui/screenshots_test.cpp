// Screenshots are written beside the window's own work, and none takes another's name.
#include "editor/gui/screenshots.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

#include "tests/session/test_scene.h"

namespace relievo::gui::screenshots_test {
namespace {

TEST(Screenshots, TakingOneDoesNotWaitForItToBeWritten) {
    const test::TemporaryFolder folder;
    std::promise<void> may_write;
    const std::shared_future<void> allowed = may_write.get_future().share();
    std::atomic<int> finished = 0;
    Screenshots screenshots(
        [&](const std::filesystem::path& path, const DisplayPicture& picture) {
            allowed.wait();
            if (picture.width == 0) throw std::invalid_argument("no room");
            test::write_text(path, std::to_string(picture.width));
        },
        [&] { ++finished; });
    test::write_text(folder.path() / "relievo-screenshot-2.png", "older");
    for (const int width : {7, 8, 0}) screenshots.take({width, 1, {}}, folder.path());
    EXPECT_TRUE(screenshots.take_done().empty());
    may_write.set_value();
    std::vector<Screenshots::Done> done;
    while (done.size() < 3)
        for (const auto& each : screenshots.take_done()) done.push_back(each);
    EXPECT_EQ(finished, 3);
    EXPECT_EQ(done[0].path, folder.path() / "relievo-screenshot-1.png");
    EXPECT_EQ(done[1].path, folder.path() / "relievo-screenshot-3.png");
    EXPECT_EQ(test::read_text(done[0].path) + test::read_text(done[1].path), "78");
    EXPECT_EQ(done[0].trouble + done[1].trouble, "");
    EXPECT_EQ(done[2].trouble, "no room");
    EXPECT_EQ(test::read_text(folder.path() / "relievo-screenshot-2.png"), "older");
}

TEST(Screenshots, WhatIsUnderWayAtTheEndIsWritten) {
    const test::TemporaryFolder folder;
    {
        Screenshots screenshots([](const auto& path, const DisplayPicture&) { test::write_text(path, "whole"); }, [] {});
        for (int i = 0; i < 9; ++i) screenshots.take({1, 1, {}}, folder.path());
    }
    for (int i = 1; i <= 9; ++i)
        EXPECT_EQ(test::read_text(folder.path() / ("relievo-screenshot-" + std::to_string(i) + ".png")), "whole") << i;
}

}  // namespace
}  // namespace relievo::gui::screenshots_test
