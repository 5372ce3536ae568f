// The program's own tree of boxes: what it holds, how deep it goes, and that refitting is the same as fitting
// anew.
#include "renderer/wide_bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>

namespace relievo::test::wide_bvh_test {
namespace {

// The arithmetic of shaders/trace/node_boxes.glsl.
float step_of(const gpu::BvhNode& node, int axis) {
    return std::ldexp(1.0f, static_cast<int>(node.exponents & 255u) -
                                static_cast<int>(node.exponents >> (8 + 4 * axis) & 15u) - 127);
}
bool has_slab(const gpu::BvhNode& node) {
    return node.exponents >> 20 < gpu::kBvhNoSlab;
}

bool holds(const Box& outer, const Box& inner) {
    return glm::all(glm::lessThanEqual(outer.low, inner.low)) && glm::all(glm::greaterThanEqual(outer.high, inner.high));
}

Box decoded(const gpu::BvhNode& node, int child) {
    Box box{};
    for (int axis = 0; axis < 3; ++axis) {
        const float step = step_of(node, axis);
        box.low[axis] = node.origin[axis] + step * static_cast<float>(node.low[axis] >> (8 * child) & 255u);
        box.high[axis] = node.origin[axis] + step * static_cast<float>(node.high[axis] >> (8 * child) & 255u);
    }
    return box;
}

// Every box is found once, within every box on the way to it; the walk's stack suffices.
void expect_sound(const WideBvh& bvh, const std::vector<Box>& boxes, const std::string& what) {
    SCOPED_TRACE(what);
    ASSERT_LE(bvh.deepest_stack(), gpu::kBvhStack);
    std::vector<int> met(boxes.size(), 0);
    struct Visit {
        std::uint32_t node;
        std::vector<Box> around;
    };
    std::vector<Visit> waiting{{0, {}}};
    std::size_t nodes = 0;
    while (!waiting.empty()) {
        const Visit visit = std::move(waiting.back());
        waiting.pop_back();
        ++nodes;
        const gpu::BvhNode& node = bvh.nodes()[visit.node];
        bool ended = false;
        for (int i = 0; i < 4; ++i) {
            const std::uint32_t child = node.child[i];
            ended = ended || child == gpu::kBvhNone;
            ASSERT_EQ(child == gpu::kBvhNone, ended) << "children first, then none";
            if (ended) continue;
            std::vector<Box> around = visit.around;
            around.push_back(decoded(node, i));
            if (child < gpu::kBvhLeaf) {
                ASSERT_LT(child, bvh.nodes().size());
                waiting.push_back({child, around});
                continue;
            }
            const std::uint32_t box = child & ~gpu::kBvhLeaf;
            ASSERT_LT(box, boxes.size());
            ++met[box];
            for (const Box& b : around) ASSERT_TRUE(holds(b, boxes[box])) << "box " << box;
        }
    }
    EXPECT_EQ(nodes, bvh.nodes().size());
    EXPECT_TRUE(std::ranges::all_of(met, [](int times) { return times == 1; }));
}

std::vector<Box> random_boxes(std::size_t count, float spread, float size, glm::vec3 centre,
                              glm::vec3 flat = glm::vec3(1)) {
    std::mt19937 random(static_cast<unsigned>(count));
    std::uniform_real_distribution<float> unit(0, 1);
    const auto point = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 low = centre + (point() - 0.5f) * spread * flat;
        boxes.push_back({low, low + point() * size * flat});
    }
    return boxes;
}

TEST(WideBvh, OneBoxTwoBoxesAFewBoxes) {
    for (std::size_t count = 1; count <= 20; ++count) {
        const auto boxes = random_boxes(count, 1, 0.3f, glm::vec3(0));
        expect_sound(WideBvh(boxes), boxes, std::to_string(count));
    }
}

TEST(WideBvh, HoldsItsBoxesAtEveryScaleAndPlace) {
    for (const float scale : {1e-4f, 1.0f, 1e4f})
        for (const float away : {0.0f, 1.0f, 1e5f}) {
            const auto boxes = random_boxes(500, scale, 0.05f * scale, glm::vec3(away, -away, 0.3f * away));
            expect_sound(WideBvh(boxes), boxes, std::to_string(scale) + " at " + std::to_string(away));
        }
}

TEST(WideBvh, FlatBoxesPointsAndNeedles) {
    for (const glm::vec3& flat :
         {glm::vec3(1, 0, 1), glm::vec3(0, 0, 1), glm::vec3(0), glm::vec3(1, 1e-7f, 1e-30f)})
        for (const float place : {0.0f, 3.0f, -1e4f}) {
            const auto boxes = random_boxes(300, 2, 0.1f, glm::vec3(place), flat);
            expect_sound(WideBvh(boxes), boxes, std::to_string(flat.x) + " " + std::to_string(flat.y));
        }
}

TEST(WideBvh, AFlatAxisTakesNoRoom) {
    const std::vector<Box> boxes{{{-1, 0.5f, -1}, {0, 0.5f, 1}}, {{0, 0.5f, -1}, {1, 0.5f, 1}}};
    const WideBvh bvh(boxes);
    const Box box = decoded(bvh.nodes()[0], 0);
    EXPECT_LT(box.high.y - box.low.y, 1e-5f);
}

TEST(WideBvh, IdenticalBoxesAndGrowingOnesStayWithinTheStack) {
    const std::vector<Box> same(100000, Box{glm::vec3(1, 2, 3), glm::vec3(2, 3, 5)});
    expect_sound(WideBvh(same), same, "identical");
    std::vector<Box> growing;  // the heuristic likes to cut the largest off, one by one
    for (int i = 0; i < 2000; ++i)
        growing.push_back({glm::vec3(0), glm::vec3(std::pow(1.04f, static_cast<float>(i % 1500)))});
    expect_sound(WideBvh(growing), growing, "growing");
    std::vector<Box> nested;
    for (int i = 0; i < 3000; ++i)
        nested.push_back({glm::vec3(static_cast<float>(-i)), glm::vec3(static_cast<float>(i))});
    expect_sound(WideBvh(nested), nested, "nested");
}

TEST(WideBvh, WhatIsNotANumberIsEverywhere) {
    auto boxes = random_boxes(50, 1, 0.1f, glm::vec3(0));
    boxes[7].high.y = std::nanf("");
    boxes[9] = {glm::vec3(-INFINITY), glm::vec3(INFINITY)};
    const WideBvh bvh(boxes);
    boxes[7].high.y = 1e30f;
    boxes[9] = {glm::vec3(-1e30f), glm::vec3(1e30f)};
    boxes[7].high.y = 1e30f;
    expect_sound(bvh, boxes, "not finite");
}

bool equal(const gpu::BvhNode& a, const gpu::BvhNode& b) {
    return a.origin == b.origin && a.exponents == b.exponents && a.child == b.child && a.low == b.low &&
           a.high == b.high && a.slab_low == b.slab_low && a.slab_high == b.slab_high;
}

// As if all had been refitted; and the nodes that are not as before are told.
void expect_refitted(const WideBvh& few, const std::vector<gpu::BvhNode>& before, const std::vector<std::uint32_t>& changed,
                     const WideBvh& all, const std::vector<Box>& boxes) {
    for (std::uint32_t i = 0; i < before.size(); ++i) {
        ASSERT_TRUE(equal(few.nodes()[i], all.nodes()[i])) << "node " << i;
        if (!equal(before[i], few.nodes()[i])) {
            ASSERT_TRUE(std::ranges::find(changed, i) != changed.end()) << "node " << i;
        }
    }
    expect_sound(few, boxes, "refitted");
}

TEST(WideBvh, RefittingAFewIsRefittingAll) {
    auto boxes = random_boxes(5000, 1, 0.02f, glm::vec3(0));
    WideBvh few(boxes), all(boxes);
    std::mt19937 random(1);
    for (int round = 0; round < 20; ++round) {
        for (int i = 0; i < 30; ++i) {
            const auto which = static_cast<std::uint32_t>(random() % boxes.size());
            const float by = round % 2 == 0 ? 0.01f : -0.002f;
            boxes[which] = {boxes[which].low - by, boxes[which].high + by};
            few.set_box(which, boxes[which]);
        }
        const auto before = std::vector(few.nodes().begin(), few.nodes().end());
        const auto changed = few.refit();
        for (std::uint32_t i = 0; i < boxes.size(); ++i) all.set_box(i, boxes[i]);
        all.refit();
        expect_refitted(few, before, changed, all, boxes);
    }
}

// Tiles of a bumpy ball, as small triangles of a displaced mesh are.
std::vector<SurfaceHull> tiles(std::size_t count, float radius, glm::vec3 centre) {
    std::mt19937 random(static_cast<unsigned>(count));
    std::normal_distribution<float> normal(0, 1);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<SurfaceHull> hulls;
    const float size = radius * 2 / std::sqrt(static_cast<float>(count));
    while (hulls.size() < count) {
        const glm::vec3 out = glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
        const glm::vec3 facing = glm::normalize(out + 0.3f * glm::vec3(normal(random), normal(random), normal(random)));
        const glm::vec3 a = glm::normalize(glm::cross(facing, glm::vec3(normal(random), normal(random), normal(random))));
        const glm::vec3 b = glm::cross(facing, a), at = centre + radius * out;
        SurfaceHull hull;
        for (const float up : {-0.02f, 0.02f})
            for (int i = 0; i < 3; ++i)
                hull.points[hull.count++] =
                    at + size * (a * (unit(random) - 0.5f) + b * (unit(random) - 0.5f) + facing * up);
        hull.radius = 0.01f * size;
        hull.facing = facing * size;
        hulls.push_back(hull);
    }
    return hulls;
}

std::vector<Box> boxes_of(const std::vector<SurfaceHull>& hulls) {
    std::vector<Box> boxes;
    for (const SurfaceHull& hull : hulls) boxes.push_back(box_of(hull));
    return boxes;
}

// shaders/trace/node_boxes.glsl in C++: the stretch of the ray within child i's slab.
Extent slab_stretch(const gpu::BvhNode& node, int i, glm::vec3 origin, glm::vec3 direction) {
    const std::uint32_t code = node.exponents >> 20;
    if (!has_slab(node)) return {-1e38, 1e38};
    const float u = static_cast<float>(code & 31u) * 0.0625f - 0.96875f;
    const float v = static_cast<float>(code >> 5 & 31u) * 0.0625f - 0.96875f;
    const glm::vec3 across = code < 1024 ? glm::vec3(1, u, v) : code < 2048 ? glm::vec3(v, 1, u) : glm::vec3(u, v, 1);
    const glm::vec3 steps(step_of(node, 0), step_of(node, 1), step_of(node, 2));
    const glm::vec3 away = node.origin - origin;
    const float along = glm::dot(across, direction), inverse = 1 / (std::abs(along) < 1e-20f ? 1e-20f : along);
    const float width = glm::dot(glm::abs(across), steps);
    const float start = glm::dot(across, away) + 255 * glm::dot(glm::min(across, glm::vec3(0)), steps);
    const float rounding = (glm::dot(glm::abs(across), glm::abs(away)) + 255 * width) * std::abs(inverse) * 1e-6f;
    const float step = width * inverse, enter = start * inverse - rounding, leave = start * inverse + rounding;
    const auto low = static_cast<float>(node.slab_low >> (8 * i) & 255u);
    const auto high = static_cast<float>(node.slab_high >> (8 * i) & 255u);
    return {(step < 0 ? high : low) * step + enter, (step < 0 ? low : high) * step + leave};
}

TEST(WideBvh, NoRayToAPointOfAHullPassesASlabOnTheWayBy) {
    for (const float scale : {1e-4f, 1.0f, 1e4f}) {
        for (const float away : {0.0f, 30.0f}) {
            SCOPED_TRACE(std::to_string(scale) + " at " + std::to_string(away));
            const glm::vec3 centre = scale * away * glm::vec3(1, -0.3f, 0.6f);
            const auto hulls = tiles(3000, scale, centre);
            const WideBvh bvh(boxes_of(hulls), hulls);
            std::mt19937 random(2);
            std::normal_distribution<float> normal(0, 1);
            std::size_t with_slab = 0;
            std::vector<std::pair<std::uint32_t, std::vector<std::pair<std::uint32_t, int>>>> waiting{{0, {}}};
            while (!waiting.empty()) {
                const auto [index, way] = waiting.back();
                waiting.pop_back();
                const gpu::BvhNode& node = bvh.nodes()[index];
                with_slab += has_slab(node) ? 1 : 0;
                for (int i = 0; i < 4 && node.child[i] != gpu::kBvhNone; ++i) {
                    auto on = way;
                    on.emplace_back(index, i);
                    if (node.child[i] < gpu::kBvhLeaf) {
                        waiting.emplace_back(node.child[i], on);
                        continue;
                    }
                    const SurfaceHull& hull = hulls[node.child[i] & ~gpu::kBvhLeaf];
                    for (std::uint32_t k = 0; k < hull.count; ++k) {
                        // Near and far; across the tile, and all but along it.
                        const glm::vec3 to = hull.points[k];
                        glm::vec3 from =
                            centre + scale * (k % 2 == 0 ? 3.0f : 200.0f) * glm::vec3(normal(random), normal(random), normal(random));
                        if (k >= 3) from = to + 4 * scale / glm::length(hull.points[1] - hull.points[0]) *
                                                    (hull.points[1] - hull.points[0]);
                        const glm::vec3 direction = glm::normalize(to - from);
                        const double t = glm::dot(glm::dvec3(to) - glm::dvec3(from), glm::dvec3(direction));
                        for (const auto& [n, c] : on) {
                            const Extent stretch = slab_stretch(bvh.nodes()[n], c, from, direction);
                            ASSERT_LE(stretch.low, t) << n;
                            ASSERT_GE(stretch.high * 1.000001, t) << n;
                        }
                    }
                }
            }
            EXPECT_GT(with_slab, bvh.nodes().size() / 2);
        }
    }
}

TEST(WideBvh, RefittingAFewHullsIsRefittingAll) {
    auto hulls = tiles(5000, 1, glm::vec3(0));
    auto boxes = boxes_of(hulls);
    WideBvh few(boxes, hulls), all(boxes, hulls);
    std::mt19937 random(1);
    for (int round = 0; round < 10; ++round) {
        for (int k = 0; k < 20; ++k) {
            const auto which = static_cast<std::uint32_t>(random() % hulls.size());
            // A hull that turns within its box changes slabs alone.
            if (k % 2 == 0) for (glm::vec3& point : hulls[which].points) point *= 1.01f;
            else hulls[which].facing = glm::vec3(hulls[which].facing.y, hulls[which].facing.z, hulls[which].facing.x);
            if (k % 2 == 0) boxes[which] = box_of(hulls[which]);
            few.set_box(which, boxes[which]);
            few.set_hull(which, hulls[which]);
        }
        const auto before = std::vector(few.nodes().begin(), few.nodes().end());
        const auto changed = few.refit();
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            all.set_box(i, boxes[i]);
            all.set_hull(i, hulls[i]);
        }
        all.refit();
        expect_refitted(few, before, changed, all, boxes);
    }
}

TEST(WideBvh, HullsThatAreNotNumbersOrTellNothingAreEverywhere) {
    auto hulls = tiles(64, 1, glm::vec3(0));
    const auto boxes = boxes_of(hulls);
    hulls[3].points[1].y = std::nanf("");
    hulls[5] = SurfaceHull{};
    hulls[7].points[0].x = 1e35f;
    const WideBvh bvh(boxes, hulls);
    int met = 0;
    for (const gpu::BvhNode& node : bvh.nodes()) {
        for (int i = 0; i < 4 && node.child[i] != gpu::kBvhNone; ++i) {
            const std::uint32_t leaf = node.child[i] & ~gpu::kBvhLeaf;
            if (node.child[i] < gpu::kBvhLeaf || (leaf != 3 && leaf != 5 && leaf != 7)) continue;
            EXPECT_TRUE(!has_slab(node) || (node.slab_high >> (8 * i) & 255u) == 255u) << leaf;
            EXPECT_TRUE(!has_slab(node) || leaf == 7 || (node.slab_low >> (8 * i) & 255u) == 0u) << leaf;
            ++met;
        }
    }
    EXPECT_EQ(met, 3);
}

TEST(WideBvh, ARefitTouchesAncestorsOnly) {
    for (const std::size_t count : {1000u, 50000u}) {
        auto boxes = random_boxes(count, 1, 0.01f, glm::vec3(0));
        WideBvh bvh(boxes);
        bvh.set_box(17, {boxes[17].low - 1e-4f, boxes[17].high + 1e-4f});
        EXPECT_LE(bvh.refit().size(), gpu::kBvhStack / 3) << count;
        EXPECT_TRUE(bvh.refit().empty());
    }
}

TEST(WideBvh, FiftyThousandBoxesAreBuiltAtOnce) {
    const auto boxes = random_boxes(50000, 1, 0.01f, glm::vec3(0));
    const auto from = std::chrono::steady_clock::now();
    const WideBvh bvh(boxes);
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - from).count();
    RecordProperty("build_ms", std::to_string(ms));
    EXPECT_LT(ms, 5000);  // about 50 on a quiet machine in release; also run under sanitizers and load
}

}  // namespace
}  // namespace relievo::test::wide_bvh_test
