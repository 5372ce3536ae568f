// Every test of this program runs under the validation layers; a message during a test fails that test.
#include <gtest/gtest.h>

#include "tests/renderer/device.h"

namespace {

class NoValidationMessages : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override { before_ = relievo::vulkan::Context::validation_messages(); }
    void OnTestEnd(const testing::TestInfo&) override {
        EXPECT_EQ(relievo::vulkan::Context::validation_messages(), before_) << "the validation layers spoke";
    }
    int before_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    testing::UnitTest::GetInstance()->listeners().Append(new NoValidationMessages);
    return RUN_ALL_TESTS();
}
