// Work that the cores share: each part once, whatever it throws.
#include "brushes/shared_work.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace relievo::shared_work_test {
namespace {

TEST(SharedWork, DoesEveryPartOnce) {
    for (const std::size_t count : {0u, 1u, 2u, 3u, 1000u}) {
        std::vector<std::atomic<int>> done(count);
        share_work(count, [&](std::size_t i) { ++done[i]; });
        for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << i << " of " << count;
    }
}

TEST(SharedWork, WithinAPartIsAPlainLoop) {
    std::atomic<int> elsewhere{0}, done{0};
    share_work(8, [&](std::size_t) {
        const auto here = std::this_thread::get_id();
        share_work(50, [&](std::size_t) {
            ++done;
            if (std::this_thread::get_id() != here) ++elsewhere;
        });
    });
    EXPECT_EQ(done, 400);
    EXPECT_EQ(elsewhere, 0);
    // And it is over with the job.
    EXPECT_FALSE(shares_work);
}

TEST(SharedWork, OneAtATimeEachSharesItsOwnParts) {
    // The parts of each wait for one another: alone on one thread, the second would never begin.
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "needs two cores";
    for (const std::size_t count : {1u, 5u}) {
        std::atomic<int> at_once{0};
        share_work(
            count,
            [&](std::size_t) {
                EXPECT_EQ(++at_once, 1);
                std::atomic<int> begun{0};
                share_work(2, [&](std::size_t) {
                    ++begun;
                    while (begun < 2) std::this_thread::yield();
                });
                --at_once;
            },
            1);
    }
    EXPECT_FALSE(shares_work);
}

TEST(SharedWork, NoMoreAtATimeThanAsked) {
    for (const std::size_t most : {1u, 2u, 3u}) {
        std::atomic<std::size_t> at_once{0}, largest{0}, done{0};
        share_work(
            200,
            [&](std::size_t) {
                const std::size_t now = ++at_once;
                for (std::size_t seen = largest; now > seen && !largest.compare_exchange_weak(seen, now);) {
                }
                std::this_thread::yield();
                ++done;
                --at_once;
            },
            most);
        EXPECT_LE(largest, most);
        EXPECT_EQ(done, 200u);
    }
}

TEST(SharedWork, ThrowsWhatAPartThrew) {
    for (const std::size_t bad : {0u, 7u, 99u})
        EXPECT_THROW(share_work(100,
                                [&](std::size_t i) {
                                    if (i == bad) throw std::runtime_error("bad");
                                }),
                     std::runtime_error);
    EXPECT_FALSE(shares_work);
}

}  // namespace
}  // namespace relievo::shared_work_test
