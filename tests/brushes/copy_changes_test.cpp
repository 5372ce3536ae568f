// Changes of many copies come together to the same bits, whether their lists wait or are summed up as they
// come, and in whatever order.
#include "brushes/copy_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace relievo::copy_changes_test {
namespace {

using Lists = std::vector<std::vector<TexelChange>>;

// Over a map of three by two tiles, the last ones cut, sorted by (y, x), each texel once.
Lists random_lists(std::uint32_t seed, std::size_t copies) {
    std::mt19937 random(seed);
    Lists lists(copies);
    for (auto& list : lists)
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 150; ++x) {
                if (random() % 5 != 0) continue;
                const auto part = [&] { return static_cast<float>(random() % 20001) * 0.01f - 100.0f; };
                list.push_back({x, y, part(), part()});
                if (random() % 7 == 0) list.back().to = list.back().from - 25.0f;  // equal steps
            }
    return lists;
}

struct Outcome {
    std::vector<float> changes;
    std::vector<std::uint32_t> touched;
    bool operator==(const Outcome&) const = default;
};

Outcome brought_together(const Lists& lists, bool add_up, std::size_t waiting, bool backwards = false) {
    HeightMap map(150, 100, std::uint16_t{32768});
    StrokeTiles stroke(map);
    CopyChanges together(lists.size(), add_up, stroke, waiting);
    for (std::size_t i = 0; i < lists.size(); ++i) {
        const std::size_t copy = backwards ? lists.size() - 1 - i : i;
        together.add(copy, lists[copy]);
    }
    together.apply();
    Outcome outcome{{}, stroke.touched()};
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 150; ++x) outcome.changes.push_back(stroke.change(x, y));
    return outcome;
}

TEST(CopyChanges, sums_and_lists_agree_to_the_bit) {
    for (const bool add_up : {false, true})
        for (const std::size_t copies : {1u, 2u, 9u}) {
            const Lists lists = random_lists(static_cast<std::uint32_t>(copies), copies);
            const Outcome waited = brought_together(lists, add_up, CopyChanges::kWaiting);
            EXPECT_EQ(brought_together(lists, add_up, 0), waited);
            EXPECT_EQ(brought_together(lists, add_up, 0, true), waited);
            EXPECT_EQ(brought_together(lists, add_up, 100000), waited);
        }
}

TEST(CopyChanges, a_single_change_is_taken_as_it_is) {
    // 0.1 cannot be reached again by adding a step to 1e7.
    const Lists lists{{{3, 2, 1e7f, 0.1f}}, {}};
    for (const std::size_t waiting : {std::size_t{0}, CopyChanges::kWaiting})
        EXPECT_EQ(brought_together(lists, true, waiting).changes[2 * 150 + 3], 0.1f);
}

TEST(CopyChanges, of_changes_that_do_not_add_up_the_largest_counts_and_of_two_as_large_the_rise) {
    const Lists lists{{{0, 0, 0, -5}, {1, 0, 0, 1}}, {{0, 0, 0, 5}, {1, 0, 0, -4}}, {{0, 0, 0, -5}}};
    for (const std::size_t waiting : {std::size_t{0}, CopyChanges::kWaiting}) {
        const Outcome outcome = brought_together(lists, false, waiting);
        EXPECT_EQ(outcome.changes[0], 5.0f);
        EXPECT_EQ(outcome.changes[1], -4.0f);
        EXPECT_EQ(brought_together(lists, true, waiting).changes[1], -3.0f);
    }
}

TEST(CopyChanges, nothing_wanted_writes_nothing) {
    EXPECT_TRUE(brought_together(Lists(3), true, 0).touched.empty());
    EXPECT_TRUE(brought_together({}, true, 0).touched.empty());
}

}  // namespace
}  // namespace relievo::copy_changes_test
