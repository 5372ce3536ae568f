// See box_bvh_builder.h.
#include "renderer/box_bvh_builder.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace relievo {
namespace {

constexpr std::uint32_t kPushed = 3;  // children of a node that wait while the nearest is walked

// Half the surface area.
double area(const Box& b) {
    const glm::dvec3 d = glm::dvec3(b.high) - glm::dvec3(b.low);
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

Box joined(const Box& a, const Box& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

constexpr Box kEmpty{glm::vec3(1e38f), glm::vec3(-1e38f)};

// What a walk of n boxes in quarters needs at most.
std::uint32_t least_stack(std::size_t n) {
    std::uint32_t need = 0;
    for (; n > 1; n = (n + 3) / 4) need += kPushed;
    return need;
}

class Builder {
  public:
    explicit Builder(std::span<const Box> boxes)
        : boxes_(boxes), goes_left_(boxes.size()), scratch_(boxes.size()), areas_(boxes.size()) {
        std::vector<float> keys(boxes.size());
        for (int axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < keys.size(); ++i) {
                const float key = boxes[i].low[axis] * 0.5f + boxes[i].high[axis] * 0.5f;
                keys[i] = std::isnan(key) ? 0.0f : key;
            }
            auto& order = order_[static_cast<std::size_t>(axis)];
            order.resize(boxes.size());
            std::iota(order.begin(), order.end(), 0u);
            std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
                return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
            });
        }
    }

    std::vector<BvhBranch> build() {
        Box all = kEmpty;
        for (const Box& b : boxes_) all = joined(all, b);
        add(Group{0, boxes_.size(), all}, gpu::kBvhNone, gpu::kBvhStack);
        return std::move(branches_);
    }

  private:
    struct Group {  // the same range of every axis' order
        std::size_t first, count;
        Box box;
    };
    struct Split {
        int axis = 0;
        std::size_t left = 0;  // boxes to the left
        float cost = 1e38f;
    };

    std::uint32_t add(const Group& group, std::uint32_t parent, std::uint32_t stack) {
        const auto index = static_cast<std::uint32_t>(branches_.size());
        branches_.push_back({});
        branches_[index].parent = parent;
        const bool by_number = least_stack(group.count) + kPushed > stack;
        const std::vector<Group> children = by_number ? quarters(group) : four(group);
        for (std::size_t i = 0; i < children.size(); ++i) {
            const Group& c = children[i];
            const std::uint32_t child =
                c.count == 1 ? gpu::kBvhLeaf | order_[0][c.first] : add(c, index, stack - kPushed);
            branches_[index].child[i] = child;
        }
        return index;
    }

    std::vector<Group> four(const Group& group) {
        std::vector<Group> groups{group};
        while (groups.size() < 4) {
            std::size_t widest = groups.size();
            for (std::size_t i = 0; i < groups.size(); ++i) {
                if (groups[i].count == 1) continue;
                if (widest == groups.size() || area(groups[i].box) > area(groups[widest].box)) widest = i;
            }
            if (widest == groups.size()) break;
            const auto [left, right] = cut(groups[widest], best_split(groups[widest]));
            groups[widest] = left;
            groups.push_back(right);
        }
        return groups;
    }

    std::vector<Group> quarters(const Group& group) {
        std::vector<Group> groups{group};
        for (int round = 0; round < 2; ++round) {
            std::vector<Group> halves;
            for (const Group& g : groups) {
                if (g.count == 1) {
                    halves.push_back(g);
                    continue;
                }
                const glm::vec3 size = g.box.high - g.box.low;
                const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
                const auto [left, right] = cut(g, {axis, (g.count + 1) / 2, 0});
                halves.push_back(left);
                halves.push_back(right);
            }
            groups = std::move(halves);
        }
        return groups;
    }

    static std::size_t evenness(const Group& g, std::size_t left) { return std::min(left, g.count - left); }

    Split best_split(const Group& g) {
        Split best;
        best.left = g.count / 2;  // where no cost is a number
        for (int axis = 0; axis < 3; ++axis) {
            const std::uint32_t* order = order_[static_cast<std::size_t>(axis)].data() + g.first;
            Box right = kEmpty;
            for (std::size_t i = g.count; --i > 0;) {
                right = joined(right, boxes_[order[i]]);
                areas_[i] = area(right);
            }
            Box left = kEmpty;
            for (std::size_t i = 1; i < g.count; ++i) {
                left = joined(left, boxes_[order[i - 1]]);
                const auto cost = static_cast<float>(area(left) * static_cast<double>(i) +
                                                     areas_[i] * static_cast<double>(g.count - i));
                // Among equals, as among equal boxes, the most even split.
                if (cost < best.cost || (cost == best.cost && evenness(g, i) > evenness(g, best.left)))
                    best = {axis, i, cost};
            }
        }
        return best;
    }

    // Divides the group's range in every order, each half sorted as before.
    std::pair<Group, Group> cut(const Group& g, const Split& split) {
        const auto& by = order_[static_cast<std::size_t>(split.axis)];
        Group left{g.first, split.left, kEmpty}, right{g.first + split.left, g.count - split.left, kEmpty};
        for (std::size_t i = 0; i < g.count; ++i) {
            const std::uint32_t box = by[g.first + i];
            goes_left_[box] = i < split.left;
            Group& side = i < split.left ? left : right;
            side.box = joined(side.box, boxes_[box]);
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (static_cast<int>(axis) == split.axis) continue;
            std::uint32_t* order = order_[axis].data() + g.first;
            std::size_t kept = 0, moved = 0;
            for (std::size_t i = 0; i < g.count; ++i) {
                if (goes_left_[order[i]])
                    order[kept++] = order[i];
                else
                    scratch_[moved++] = order[i];
            }
            std::copy_n(scratch_.begin(), moved, order + kept);
        }
        return {left, right};
    }

    std::span<const Box> boxes_;
    std::array<std::vector<std::uint32_t>, 3> order_;  // boxes along each axis
    std::vector<char> goes_left_;
    std::vector<std::uint32_t> scratch_;
    std::vector<double> areas_;
    std::vector<BvhBranch> branches_;
};

}  // namespace

std::vector<BvhBranch> build_box_bvh(std::span<const Box> boxes) {
    return Builder(boxes).build();
}

}  // namespace relievo
