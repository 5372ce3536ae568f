#include "editor/session/surface/seam_settling.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "editor/session/surface/seam_equations.h"

namespace relievo {
namespace {

bool two_equal(const TexelSum& sum) {
    return sum.size() == 2 && std::abs(sum[0].second + sum[1].second) < 1e-9;
}

bool all_owned(const TexelSum& sum, const TexelClasses& classes) {
    return std::all_of(sum.begin(), sum.end(), [&](const auto& t) { return classes.owned(t.first); });
}

bool holds(const SeamColumn& column, const TexelClasses& classes) {
    return reduced(column_sum(column), classes).empty();
}

// Columns that say "this free texel equals that one" leave no choice; each may free the next.
void propagate(std::vector<SeamColumn>& columns, TexelClasses& classes) {
    for (bool changed = true; changed;) {
        changed = false;
        std::erase_if(columns, [&](const SeamColumn& column) {
            const TexelSum sum = reduced(column_sum(column), classes);
            if (sum.empty()) return true;
            const bool on_edge = column.a_in == column.a_out && column.b_in == column.b_out;
            if (!two_equal(sum) || (all_owned(sum, classes) && !on_edge)) return false;
            classes.join(sum[0].first, sum[1].first);
            changed = true;
            return true;
        });
    }
}

bool neighbours(std::uint32_t a, std::uint32_t b, const MapGrid& grid) {
    const auto width = static_cast<std::uint32_t>(grid.width);
    const int dx = std::abs(static_cast<int>(a % width) - static_cast<int>(b % width));
    const int dy = std::abs(static_cast<int>(a / width) - static_cast<int>(b / width));
    const bool wraps = grid.wrap == Wrap::repeat;
    return std::min(dx, wraps ? grid.width - dx : dx) <= 1 &&
           std::min(dy, wraps ? grid.height - dy : dy) <= 1;
}

// A gutter texel in a corner cut out of an island is beside two of its texels, and both seams want it.
void join_corners(const std::vector<SeamColumn>& columns, const MapGrid& grid, TexelClasses& classes) {
    for (const SeamColumn& column : columns) {
        const TexelSum sum = reduced(column_sum(column), classes);
        if (column.at_end && two_equal(sum) && neighbours(sum[0].first, sum[1].first, grid)) {
            classes.join(sum[0].first, sum[1].first);
        }
    }
}

// Columns that share a free texel, directly or through others; columns without free texels are left out.
std::vector<std::vector<SeamColumn>> components(const std::vector<SeamColumn>& columns,
                                                const TexelClasses& classes) {
    std::vector<std::pair<std::uint32_t, std::size_t>> uses;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        for (const auto& [texel, weight] : reduced(column_sum(columns[i]), classes)) {
            if (!classes.owned(texel)) uses.emplace_back(texel, i);
        }
    }
    std::sort(uses.begin(), uses.end());
    std::vector<std::size_t> group(columns.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto top = [&](std::size_t i) {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    };
    std::vector<bool> free(columns.size());
    for (std::size_t i = 0; i < uses.size(); ++i) {
        free[uses[i].second] = true;
        if (i > 0 && uses[i].first == uses[i - 1].first) group[top(uses[i].second)] = top(uses[i - 1].second);
    }
    std::vector<std::vector<SeamColumn>> sets(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (free[i]) sets[top(i)].push_back(columns[i]);
    }
    std::erase_if(sets, [](const auto& set) { return set.empty(); });
    return sets;
}

void join_if_free(std::uint32_t a, std::uint32_t b, TexelClasses& classes) {
    if (!classes.owned(classes.root(a)) || !classes.owned(classes.root(b))) classes.join(a, b);
}

// Tries texel by texel equality on one column after the other, and what follows from it; takes it all back if
// some column cannot hold then.
void guess(std::vector<SeamColumn> columns, TexelClasses& classes) {
    const std::size_t mark = classes.mark();
    while (!columns.empty()) {
        join_if_free(columns.front().a_in, columns.front().b_out, classes);
        join_if_free(columns.front().a_out, columns.front().b_in, classes);
        const bool held = holds(columns.front(), classes);
        propagate(columns, classes);
        const bool stuck = std::any_of(columns.begin(), columns.end(), [&](const SeamColumn& column) {
            return all_owned(reduced(column_sum(column), classes), classes);
        });
        if (!held || stuck) {
            classes.roll_back(mark);
            return;
        }
    }
}

}  // namespace

std::vector<SeamColumn> settle(std::vector<SeamColumn> columns, const MapGrid& grid, TexelClasses& classes) {
    propagate(columns, classes);
    join_corners(columns, grid, classes);
    propagate(columns, classes);
    for (const auto& set : components(columns, classes)) guess(set, classes);
    std::erase_if(columns, [&](const SeamColumn& column) { return holds(column, classes); });
    return columns;
}

}  // namespace relievo
