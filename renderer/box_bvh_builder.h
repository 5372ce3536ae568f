// Which boxes lie together: the shape of a tree of four children a node, for rays that walk it without an
// acceleration structure of the device. Knows nothing of what is stored (wide_bvh.h).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/primitives.h"
#include "shaders/shared.h"

namespace relievo {

struct BvhBranch {
    std::array<std::uint32_t, 4> child{gpu::kBvhNone, gpu::kBvhNone, gpu::kBvhNone,
                                       gpu::kBvhNone};  // as in BvhNode
    std::uint32_t parent = gpu::kBvhNone;
};

// Every box is the leaf of exactly one branch; the root comes first, every branch after its parent. At least
// one box. Boxes are split where the surface-area heuristic is least (Goldsmith and Salmon 1987, MacDonald
// and Booth 1990), over all splits of three presorted axes (Wald 2007: O(n log n)); a node's four children
// come from splitting the group of the largest area first.
//
// A walk that pushes all met children but the nearest never holds more than gpu::kBvhStack of them, whatever
// the boxes: three a level. Where a group could not be finished within what is left of that, it is cut into
// quarters by number, which takes ceil(log4 n) levels: it is always possible up to 4^(kBvhStack / 3) boxes.
std::vector<BvhBranch> build_box_bvh(std::span<const Box> boxes);

}  // namespace relievo
