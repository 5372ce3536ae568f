// Items in the cells of a grid: each found once, in order, whatever the cells.
#include "brushes/cell_table.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace relievo::cell_table_test {
namespace {

using Place = std::array<std::int64_t, 3>;

std::int64_t key_of(const Place& place) {
    return CellTable::key(place[0], place[1], place[2]);
}

std::vector<std::uint32_t> items_in(const CellTable& table, const std::vector<std::uint32_t>& at,
                                    const Place& cell) {
    const auto [first, count] = table.find(key_of(cell));
    return {at.begin() + first, at.begin() + first + count};
}

TEST(CellTable, items_of_a_cell_stand_together_in_their_given_order) {
    constexpr std::int64_t kFar = 500000;
    const std::vector<Place> cells{{0, 0, 0},          {1, 0, 0},          {0, 0, 0}, {-kFar, -kFar, -kFar},
                                   {kFar, kFar, kFar}, {kFar, kFar, kFar}, {0, 0, 0}, {0, 1, 0}};
    CellTable table;
    const std::vector<std::uint32_t> places = table.place(static_cast<std::uint32_t>(cells.size()),
                                                          [&](std::uint32_t i) { return key_of(cells[i]); });
    std::vector<std::uint32_t> at(cells.size(), ~0u);
    for (std::uint32_t i = 0; i < cells.size(); ++i) at[places[i]] = i;
    using Items = std::vector<std::uint32_t>;
    EXPECT_EQ(items_in(table, at, {0, 0, 0}), (Items{0, 2, 6}));
    EXPECT_EQ(items_in(table, at, {1, 0, 0}), (Items{1}));
    EXPECT_EQ(items_in(table, at, {-kFar, -kFar, -kFar}), (Items{3}));
    EXPECT_EQ(items_in(table, at, {kFar, kFar, kFar}), (Items{4, 5}));
    EXPECT_EQ(items_in(table, at, {0, 0, 1}), Items{});
}

TEST(CellTable, without_items_every_cell_is_empty) {
    CellTable table;
    EXPECT_EQ(table.find(CellTable::key(0, 0, 0)).count, 0u);
    EXPECT_TRUE(table.place(0, [](std::uint32_t) { return std::int64_t{0}; }).empty());
    EXPECT_EQ(table.find(CellTable::key(0, 0, 0)).count, 0u);
}

TEST(CellTable, many_cells_of_one_item_each) {
    constexpr std::int64_t kSide = 47;
    const auto key = [](std::uint32_t i) {
        return CellTable::key(i % kSide - 20, i / kSide % kSide - 20, i / (kSide * kSide) - 20);
    };
    CellTable table;
    const std::vector<std::uint32_t> places = table.place(kSide * kSide * kSide, key);
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        const auto [first, count] = table.find(key(i));
        ASSERT_EQ(count, 1u) << i;
        ASSERT_EQ(first, places[i]) << i;
    }
}

}  // namespace
}  // namespace relievo::cell_table_test
