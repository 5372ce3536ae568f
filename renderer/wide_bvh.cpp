// See wide_bvh.h.
#include "renderer/wide_bvh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace relievo {
namespace {

constexpr float kMost = 1e30f;  // coordinates beyond are as far: the walk's products stay finite
constexpr int kLeastExponent = -100, kExponentBias = 127;
constexpr int kSteps = 255;
// The walk's rounding within a node, in steps of its grid, is under 1e-4 (trace/bvh.glsl).
constexpr double kStepSlack = 1.0 / 256;

// Whatever is not a number is everywhere.
Box sane(Box b) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(b.low[axis] >= -kMost)) b.low[axis] = -kMost;
        if (!(b.high[axis] <= kMost)) b.high[axis] = kMost;
        b.low[axis] = std::min(b.low[axis], kMost);
        b.high[axis] = std::max(b.high[axis], b.low[axis]);
    }
    return b;
}

struct Axis {
    float origin;
    int exponent;
    std::array<std::uint32_t, 4> low{}, high{};
};

// The finest grid of powers of two whose 255 steps hold the node, with room for what rounding takes.
Axis quantised(float node_low, float node_high, const std::array<float, 4>& low,
               const std::array<float, 4>& high, std::size_t count) {
    const double extent = double{node_high} - double{node_low};
    const double rounding = 0x1p-22 * std::max(std::abs(double{node_low}), std::abs(double{node_high}));
    Axis axis{};
    axis.origin = static_cast<float>(double{node_low} - rounding);
    std::frexp((extent + 2 * rounding) / kSteps, &axis.exponent);
    axis.exponent = std::max(axis.exponent - 1, kLeastExponent);
    for (bool fits = false; !fits; ++axis.exponent) {
        const double step = std::ldexp(1.0, axis.exponent), pad = rounding / 2 + kStepSlack * step;
        fits = true;
        for (std::size_t i = 0; i < count; ++i) {
            const double from = std::floor((low[i] - pad - axis.origin) / step);
            const double to = std::ceil((high[i] + pad - axis.origin) / step);
            fits = fits && to <= kSteps;
            axis.low[i] = static_cast<std::uint32_t>(std::max(from, 0.0));
            axis.high[i] = static_cast<std::uint32_t>(std::clamp(to, 0.0, double{kSteps}));
        }
        if (fits) break;
    }
    return axis;
}

}  // namespace

WideBvh::WideBvh(std::span<const Box> boxes) : branch_of_(boxes.size()) {
    boxes_.reserve(boxes.size());
    for (const Box& b : boxes) boxes_.push_back(sane(b));
    branches_ = build_box_bvh(boxes_);
    nodes_.resize(branches_.size());
    node_boxes_.resize(branches_.size());
    for (auto i = static_cast<std::uint32_t>(branches_.size()); i-- > 0;) {
        for (const std::uint32_t child : branches_[i].child)
            if (child != gpu::kBvhNone && child >= gpu::kBvhLeaf) branch_of_[child & ~gpu::kBvhLeaf] = i;
        fit(i);
    }
}

void WideBvh::set_box(std::uint32_t i, const Box& box) {
    boxes_[i] = sane(box);
    touched_.push_back(branch_of_[i]);
}

std::vector<std::uint32_t> WideBvh::refit() {
    // Children come after their parents: from the last to the first, none is met twice.
    std::priority_queue<std::uint32_t> waiting(std::less<std::uint32_t>(), std::move(touched_));
    touched_.clear();
    std::vector<std::uint32_t> changed;
    while (!waiting.empty()) {
        const std::uint32_t node = waiting.top();
        while (!waiting.empty() && waiting.top() == node) waiting.pop();
        changed.push_back(node);
        if (fit(node) && branches_[node].parent != gpu::kBvhNone) waiting.push(branches_[node].parent);
    }
    return changed;
}

bool WideBvh::fit(std::uint32_t index) {
    const BvhBranch& branch = branches_[index];
    std::array<Box, 4> child{};
    Box whole{glm::vec3(kMost), glm::vec3(-kMost)};
    std::size_t count = 0;
    for (; count < 4 && branch.child[count] != gpu::kBvhNone; ++count) {
        const std::uint32_t c = branch.child[count];
        child[count] = c >= gpu::kBvhLeaf ? boxes_[c & ~gpu::kBvhLeaf] : node_boxes_[c];
        whole = {glm::min(whole.low, child[count].low), glm::max(whole.high, child[count].high)};
    }
    gpu::BvhNode node{};
    for (int axis = 0; axis < 3; ++axis) {
        std::array<float, 4> low{}, high{};
        for (std::size_t i = 0; i < count; ++i) {
            low[i] = child[i].low[axis];
            high[i] = child[i].high[axis];
        }
        const Axis grid = quantised(whole.low[axis], whole.high[axis], low, high, count);
        node.origin[axis] = grid.origin;
        node.exponents |= static_cast<std::uint32_t>(grid.exponent + kExponentBias) << (8 * axis);
        for (std::size_t i = 0; i < count; ++i) {
            node.low[axis] |= grid.low[i] << (8 * i);
            node.high[axis] |= grid.high[i] << (8 * i);
        }
    }
    node.child = {branch.child[0], branch.child[1], branch.child[2], branch.child[3]};
    const bool moved = whole.low != node_boxes_[index].low || whole.high != node_boxes_[index].high;
    nodes_[index] = node;
    node_boxes_[index] = whole;
    return moved;
}

std::uint32_t WideBvh::deepest_stack() const {
    std::vector<std::uint32_t> waiting(branches_.size(), 0);  // above a node's own children
    std::uint32_t most = 0;
    for (std::size_t i = 0; i < branches_.size(); ++i) {
        std::uint32_t children = 0;
        for (const std::uint32_t c : branches_[i].child) children += c != gpu::kBvhNone ? 1 : 0;
        const std::uint32_t held = waiting[i] + children - 1;
        most = std::max(most, held);
        for (const std::uint32_t c : branches_[i].child)
            if (c < gpu::kBvhLeaf) waiting[c] = held;
    }
    return most;
}

std::uint64_t WideBvh::bytes() const {
    return branches_.size() * (sizeof(BvhBranch) + sizeof(Box) + sizeof(gpu::BvhNode)) +
           boxes_.size() * (sizeof(Box) + sizeof(std::uint32_t));
}

}  // namespace relievo
