// The stability suite: every registered method on every extreme case.
#include <gtest/gtest.h>

#include <cstdio>

#include "renderer/stability/harness.h"
#include "tests/support/device.h"

namespace relievo::stability::stability_test {
namespace {

class Stability : public testing::TestWithParam<std::string> {};

TEST_P(Stability, EveryMethod) {
    const JudgedCase judged(find_case(GetParam()));
    for (const std::string& complaint : judged.complaints())
        ADD_FAILURE() << "the case itself: " << complaint;
    for (const Method* method : methods()) {
        const Cell cell = judged.run(test::device(), *method);
        std::printf("%s\n", cell.text().c_str());
        EXPECT_TRUE(cell.kept()) << method->name << " on " << GetParam() << ": " << verdict_name(cell.verdict)
                                 << ", see above";
        EXPECT_FALSE(cell.stale) << method->name << " is right on " << GetParam()
                                 << ": take it out of known_limits() in renderer/stability/promises.cpp";
    }
}

std::vector<std::string> case_names() {
    std::vector<std::string> names;
    for (const CaseEntry& entry : cases()) names.push_back(entry.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Cases, Stability, testing::ValuesIn(case_names()),
                         [](const auto& test) { return test.param; });

TEST(KnownLimits, NameMethodsAndCasesThatExist) {
    for (const KnownLimit& limit : known_limits()) {
        EXPECT_NO_THROW(find_method(limit.method)) << limit.method;
        EXPECT_NO_THROW(find_case(std::string(limit.name))) << limit.name;
        EXPECT_FALSE(limit.reason.empty());
    }
}

}  // namespace
}  // namespace relievo::stability::stability_test
