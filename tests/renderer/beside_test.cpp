// Work beside the thread that asked for it.
#include "renderer/beside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <vector>

namespace relievo::beside_test {
namespace {

struct Stop {};

TEST(WorkBeside, IsToldFromItsBeginningToItsEndAlsoWhereItTellsNothingItself) {
    std::vector<double> parts;
    const auto asker = std::this_thread::get_id();
    const WorkProgress note = [&](double part) {
        EXPECT_EQ(std::this_thread::get_id(), asker);
        parts.push_back(part);
    };
    const int result = run_beside(note, [&](const WorkPart& part) {
        EXPECT_NE(std::this_thread::get_id(), asker);
        const WorkPart second = part.within(0.5, 1);
        part.at(0.25);
        second.at(0, 0.5);
        while (parts.size() < 8) std::this_thread::yield();
        second.at(0.75);
        return 3;
    });
    EXPECT_EQ(result, 3);
    EXPECT_TRUE(std::ranges::is_sorted(parts));
    EXPECT_EQ(parts.front(), 0);
    EXPECT_EQ(parts.back(), 1);
    EXPECT_GT(*(parts.end() - 3), 0.5);  // what tells nothing for a while creeps on
    EXPECT_LT(*(parts.end() - 3), 0.9);
}

TEST(WorkBeside, EndsWhereItIsStopped) {
    for (const double last : {0.0, 0.5, 1.0}) {
        bool ended = false;
        const WorkProgress stop = [&](double part) {
            if (part >= last) throw Stop();
        };
        EXPECT_THROW(run_beside(stop,
                                [&](const WorkPart& part) {
                                    part.at(0.5);
                                    for (int i = 0; last == 0.5; ++i) part.at(0.5);  // until it is told to end
                                    ended = true;
                                    return 0;
                                }),
                     Stop);
        EXPECT_EQ(ended, last == 1) << last;
    }
}

TEST(WorkBeside, FailsWithWhatTheWorkThrows) {
    const auto fail = [](const WorkPart&) -> int { throw std::invalid_argument("refused"); };
    EXPECT_THROW(run_beside([](double) {}, fail), std::invalid_argument);
    EXPECT_THROW(run_beside({}, fail), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::beside_test
