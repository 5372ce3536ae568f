// See face_tree.h. Median split of the boxes' centres along their longest axis.
#include "renderer/reference/face_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>

namespace relievo::reference {

using glm::dvec3;

void Bounds::include(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
}

FaceTree::FaceTree(std::vector<Bounds> boxes) {
    // Wider than the rounding of the slab test below.
    for (Bounds& box : boxes) {
        const dvec3 margin = glm::max(glm::abs(box.low), glm::abs(box.high)) * 1e-13;
        box.low -= margin;
        box.high += margin;
    }
    std::vector<std::uint32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0u);
    nodes_.reserve(2 * boxes.size());
    if (!boxes.empty()) build(boxes, order, 0, boxes.size());
}

std::uint32_t FaceTree::build(const std::vector<Bounds>& boxes, std::vector<std::uint32_t>& order,
                              std::size_t first, std::size_t count) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Bounds bounds, centres;
    for (std::size_t i = first; i < first + count; ++i) {
        const Bounds& box = boxes[order[i]];
        const dvec3 centre = (box.low + box.high) * 0.5;
        bounds.include(box);
        centres.include({centre, centre});
    }
    nodes_[index].bounds = bounds;
    if (count == 1) {
        nodes_[index].box = order[first];
        return index;
    }
    const dvec3 size = centres.high - centres.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = count / 2;
    const auto begin = order.begin() + static_cast<std::ptrdiff_t>(first);
    std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half),
                     begin + static_cast<std::ptrdiff_t>(count), [&](std::uint32_t a, std::uint32_t b) {
                         const double ca = boxes[a].low[axis] + boxes[a].high[axis];
                         const double cb = boxes[b].low[axis] + boxes[b].high[axis];
                         return ca != cb ? ca < cb : a < b;
                     });
    const std::uint32_t left = build(boxes, order, first, half);
    const std::uint32_t right = build(boxes, order, first + half, count - half);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
}

void FaceTree::push(std::vector<Entry>& stack, std::uint32_t node, const dvec3& origin,
                    const dvec3& direction, double z_min, double z_max) const {
    const Bounds& box = nodes_[node].bounds;
    double low = z_min, high = z_max;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(direction[axis]) < 1e-300) {
            if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) return;
            continue;
        }
        const double a = (box.low[axis] - origin[axis]) / direction[axis];
        const double b = (box.high[axis] - origin[axis]) / direction[axis];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    const double slack = 1e-14 * (std::abs(low) + std::abs(high));
    if (low <= high + slack) stack.push_back({node, low - slack});
}

}  // namespace relievo::reference
