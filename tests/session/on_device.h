// Tests of sessions on a Vulkan device, of which no message of the validation layers may come; skipped without one.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/vulkan/context.h"
#include "tests/session/test_scene.h"

namespace relievo::test {

class OnDevice : public testing::Test {
  protected:
    void SetUp() override {
        const auto devices = vulkan::list_devices();
        if (std::ranges::none_of(devices, &vulkan::DeviceInfo::usable))
            GTEST_SKIP() << "no Vulkan device with ray tracing";
    }
    void TearDown() override { EXPECT_EQ(vulkan::Context::validation_messages(), 0); }

    // 0: the scene's size.
    static SessionOptions on_device(int width = 0, int height = 0) {
        SessionOptions options;
        options.validation = true;
        options.width = width;
        options.height = height;
        return options;
    }

    TemporaryFolder folder_;
};

}  // namespace relievo::test
