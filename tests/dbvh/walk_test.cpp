// The walk over squares without a stack: every one of a triangle's squares once, the nearest first, from up to four roots.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

#include "tests/dbvh/dbvh_shader.h"

namespace relievo::dbvh::walk_test {
namespace {

// A triangle of a flat mesh at z = 0, with texel coordinates of its own.
Domain domain_over(const std::array<glm::dvec2, 3>& texels) {
    Primitive p{};
    p.tangent = vec3(1, 0, 0);
    p.ng = vec3(0, 0, 1);
    p.q1x = 1;
    p.q2 = vec2(0.3f, 1);
    p.tx0 = vec2(texels[0]);
    p.tx1 = vec2(texels[1]);
    p.tx2 = vec2(texels[2]);
    return make_domain(p, {vec3(0, 0, 1), vec3(0, 0, 1), vec3(0, 0, 1)}, is_thin(p), 0.1f, 0);
}

struct Visited {
    std::vector<vec2> roots, leaves;  // squares in the order of the walk
};

Visited walk_all(const Domain& g, vec3 direction, int leaf_level) {
    Visited visited;
    Walk w = start_walk(vec2(0), g, direction, leaf_level);
    go_down(w);
    for (bool more = true; more; more = go_next(w)) {
        while (true) {
            if (w.level == w.top - 1) visited.roots.push_back(square_of(w));
            if (w.level == leaf_level) break;
            go_down(w);
        }
        visited.leaves.push_back(square_of(w));
    }
    return visited;
}

TEST(DbvhWalk, VisitsEverySquareOnceAndCoversTheFootprint) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-9, 9);
    for (int i = 0; i < 200; ++i) {
        const Domain g = domain_over({{{place(random), place(random)}, {place(random), place(random)}, {place(random), place(random)}}});
        if (g.thin) continue;
        const Visited visited = walk_all(g, vec3(place(random), place(random), -1), 0);
        EXPECT_EQ(visited.roots.size(), 4u);
        std::set<std::pair<float, float>> squares;
        for (const vec2& s : visited.leaves) EXPECT_TRUE(squares.insert({s.x, s.y}).second) << s.x << " " << s.y;
        const vec2 low = floor(g.t0 + g.low), high = floor(g.t0 + g.high);
        for (float y = low.y; y <= high.y; ++y)
            for (float x = low.x; x <= high.x; ++x) EXPECT_TRUE(squares.count({x, y})) << x << " " << y;
    }
}

TEST(DbvhWalk, VisitsSiblingsInTheOrderOfTheRay) {
    const Domain g = domain_over({{{0, 0}, {8, 0}, {0, 8}}});
    for (const vec3& direction : {vec3(1, 0.2f, -1), vec3(-1, 0.2f, -1), vec3(1, -2, -1), vec3(-1, -1, 0)}) {
        const Visited visited = walk_all(g, direction, 0);
        for (std::size_t i = 0; i < visited.leaves.size(); i += 4) {
            const auto ahead = [&](std::size_t k) {
                return dot(g.px * visited.leaves[k].x + g.py * visited.leaves[k].y, direction);
            };
            for (std::size_t k = i + 1; k < i + 4; ++k) EXPECT_LE(ahead(i), ahead(k));
            for (std::size_t k = i; k < i + 3; ++k) EXPECT_LE(ahead(k), ahead(i + 3));
        }
    }
}

}  // namespace
}  // namespace relievo::dbvh::walk_test
