// See wide_bvh.h.
#include "renderer/wide_bvh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <optional>
#include <queue>

namespace relievo {
namespace {

constexpr float kMost = 1e30f;  // coordinates beyond are as far: the walk's products stay finite
constexpr int kLeastExponent = -100, kExponentBias = 127;
constexpr int kMostBelow = 15;  // exponents of one node's axes
constexpr int kSteps = 255;
// The walk's rounding within a node, in steps of its grid, is under 1e-4 (trace/bvh.glsl).
constexpr double kStepSlack = 1.0 / 256;
constexpr double kSlabStep = 1.0 / 16, kSlabReach = 31.0 / 32;

// Slabs across larger subtrees say no more than boxes, and what a refit costs grows with them.
constexpr std::uint32_t kMostSlabLeaves = 1024;
// Coordinates beyond have no slab: the walk's products stay finite.
constexpr float kMostSlab = 1e12f;

// A direction that 12 bits tell, as the walk computes it (trace/node_boxes.glsl): 1 along one axis, a multiple of 1/16 less
// 31/32 along the next two. Not of unit length.
struct SlabDirection {
    std::uint32_t code;
    glm::dvec3 across;
};

std::optional<SlabDirection> slab_direction(const glm::dvec3& facing) {
    const glm::dvec3 size = glm::abs(facing);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (!(size[axis] > 0) || !std::isfinite(size[axis])) return std::nullopt;
    SlabDirection d{static_cast<std::uint32_t>(axis) << 10, glm::dvec3(1)};
    for (int k = 0; k < 2; ++k) {
        const int other = (axis + 1 + k) % 3;
        const double steps = std::clamp(std::round((facing[other] / facing[axis] + kSlabReach) / kSlabStep), 0.0, 31.0);
        d.code |= static_cast<std::uint32_t>(steps) << (5 * k);
        d.across[other] = steps * kSlabStep - kSlabReach;
    }
    return d;
}

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

// The finest grid of powers of two whose 255 steps hold the node along the axis, with room for what rounding takes.
Axis quantised(const Box& node, std::span<const Box> children, int axis_index, int least_exponent) {
    const double node_low = node.low[axis_index], node_high = node.high[axis_index];
    const double extent = node_high - node_low;
    const double rounding = 0x1p-22 * std::max(std::abs(node_low), std::abs(node_high));
    Axis axis{};
    axis.origin = static_cast<float>(node_low - rounding);
    std::frexp((extent + 2 * rounding) / kSteps, &axis.exponent);
    axis.exponent = std::max(axis.exponent - 1, least_exponent);
    for (bool fits = false; !fits; ++axis.exponent) {
        const double step = std::ldexp(1.0, axis.exponent), pad = rounding / 2 + kStepSlack * step;
        fits = true;
        for (std::size_t i = 0; i < children.size(); ++i) {
            const double from = std::floor((children[i].low[axis_index] - pad - axis.origin) / step);
            const double to = std::ceil((children[i].high[axis_index] + pad - axis.origin) / step);
            fits = fits && to <= kSteps;
            axis.low[i] = static_cast<std::uint32_t>(std::max(from, 0.0));
            axis.high[i] = static_cast<std::uint32_t>(std::clamp(to, 0.0, double{kSteps}));
        }
        if (fits) break;
    }
    return axis;
}

void set_boxes(gpu::BvhNode& node, const Box& whole, std::span<const Box> children) {
    std::array<Axis, 3> axes;
    int most = kLeastExponent;
    for (int a = 0; a < 3; ++a) {
        axes[a] = quantised(whole, children, a, kLeastExponent);
        most = std::max(most, axes[a].exponent);
    }
    node.exponents = static_cast<std::uint32_t>(most + kExponentBias);
    for (int a = 0; a < 3; ++a) {
        if (axes[a].exponent < most - kMostBelow) axes[a] = quantised(whole, children, a, most - kMostBelow);
        node.origin[a] = axes[a].origin;
        node.exponents |= static_cast<std::uint32_t>(most - axes[a].exponent) << (8 + 4 * a);
        for (std::size_t i = 0; i < children.size(); ++i) {
            node.low[a] |= axes[a].low[i] << (8 * i);
            node.high[a] |= axes[a].high[i] << (8 * i);
        }
    }
}

double step_of(const gpu::BvhNode& node, int axis) {
    return std::ldexp(1.0, static_cast<int>(node.exponents & 255u) - static_cast<int>(node.exponents >> (8 + 4 * axis) & 15u) -
                               kExponentBias);
}

}  // namespace

WideBvh::WideBvh(std::span<const Box> boxes, std::span<const SurfaceHull> hulls)
    : hulls_(hulls.begin(), hulls.end()), branch_of_(boxes.size()) {
    boxes_.reserve(boxes.size());
    for (const Box& b : boxes) boxes_.push_back(sane(b));
    branches_ = build_box_bvh(boxes_);
    nodes_.resize(branches_.size());
    node_boxes_.resize(branches_.size());
    leaf_count_.resize(branches_.size());
    for (auto i = static_cast<std::uint32_t>(branches_.size()); i-- > 0;) {
        for (const std::uint32_t child : branches_[i].child) {
            if (child == gpu::kBvhNone) continue;
            if (child >= gpu::kBvhLeaf) branch_of_[child & ~gpu::kBvhLeaf] = i;
            leaf_count_[i] += child >= gpu::kBvhLeaf ? 1 : leaf_count_[child];
        }
        fit(i);
    }
}

void WideBvh::set_box(std::uint32_t i, const Box& box) {
    boxes_[i] = sane(box);
    touched_.push_back(branch_of_[i]);
}

void WideBvh::set_hull(std::uint32_t i, const SurfaceHull& hull) {
    hulls_[i] = hull;
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
        const std::uint32_t parent = branches_[node].parent;
        const bool moved = fit(node);
        if (parent != gpu::kBvhNone && (moved || has_slab(parent))) waiting.push(parent);
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
    set_boxes(node, whole, std::span(child).first(count));
    node.child = {branch.child[0], branch.child[1], branch.child[2], branch.child[3]};
    fit_slab(index, node);
    const bool moved = whole.low != node_boxes_[index].low || whole.high != node_boxes_[index].high;
    nodes_[index] = node;
    node_boxes_[index] = whole;
    return moved;
}

bool WideBvh::has_slab(std::uint32_t node) const {
    return !hulls_.empty() && leaf_count_[node] <= kMostSlabLeaves;
}

void WideBvh::collect_leaves(std::uint32_t child, std::vector<std::uint32_t>& leaves) const {
    if (child == gpu::kBvhNone) return;
    if (child >= gpu::kBvhLeaf) return leaves.push_back(child & ~gpu::kBvhLeaf);
    for (const std::uint32_t c : branches_[child].child) collect_leaves(c, leaves);
}

// The children's extents in 255 steps of what the node's grid of boxes has along the slab's direction.
void WideBvh::fit_slab(std::uint32_t index, gpu::BvhNode& node) const {
    node.exponents |= gpu::kBvhNoSlab << 20;
    node.slab_high = 0xffffffffu;
    if (!has_slab(index)) return;
    std::array<std::vector<std::uint32_t>, 4> leaves;
    glm::dvec3 facing(0);
    for (std::size_t i = 0; i < 4; ++i) {
        collect_leaves(branches_[index].child[i], leaves[i]);
        for (const std::uint32_t leaf : leaves[i]) facing += glm::dvec3(hulls_[leaf].facing);
    }
    const auto direction = slab_direction(facing);
    if (!direction || glm::any(glm::greaterThan(glm::abs(node.origin), glm::vec3(kMostSlab)))) return;
    const glm::dvec3 across = direction->across;
    double start = 0, step = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double grid = step_of(node, axis);
        start += std::min(across[axis], 0.0) * kSteps * grid;
        step += std::abs(across[axis]) * grid;
    }
    if (!(step < kMostSlab)) return;
    node.exponents = (node.exponents & 0xfffffu) | direction->code << 20;
    node.slab_high = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        Extent all{1e300, -1e300};
        for (const std::uint32_t leaf : leaves[i]) {
            const Extent extent = extent_along(hulls_[leaf], across, glm::dvec3(node.origin));
            all = {std::min(all.low, extent.low), std::max(all.high, extent.high)};
        }
        const double low = std::floor((all.low - start) / step - kStepSlack);
        const double high = std::ceil((all.high - start) / step + kStepSlack);
        // What is not a number is everywhere here, too.
        const auto from = static_cast<std::uint32_t>(low > 0 ? std::min(low, double{kSteps}) : 0.0);
        const auto to = static_cast<std::uint32_t>(high < kSteps ? std::max(high, 0.0) : double{kSteps});
        node.slab_low |= from << (8 * i);
        node.slab_high |= to << (8 * i);
    }
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
           boxes_.size() * (sizeof(Box) + sizeof(std::uint32_t)) + hulls_.size() * sizeof(SurfaceHull) +
           leaf_count_.size() * sizeof(std::uint32_t);
}

}  // namespace relievo
