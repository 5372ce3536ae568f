// The height at a place from texels about it: exact for what is curved, and tame where they cannot tell.
#include "editor/session/surface/height_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relievo::height_fit_test {
namespace {

using Sites = std::vector<FitSite>;

// Texels of columns [0, wide) and rows [0, tall), seen from a place.
Sites block(int wide, int tall, glm::dvec2 place) {
    Sites sites;
    for (int y = 0; y < tall; ++y)
        for (int x = 0; x < wide; ++x)
            sites.push_back({static_cast<std::uint32_t>(sites.size()), glm::dvec2(x, y) - place});
    return sites;
}

template <typename Height>
double fitted(const Sites& sites, Height height) {
    double sum = 0;
    for (const SeamExtension::Source& source : fitted_height(sites))
        sum += static_cast<double>(source.weight) * height(sites[source.texel].way);
    return sum;
}

double growth(const Sites& sites) {
    double sum = 0;
    for (const SeamExtension::Source& source : fitted_height(sites))
        sum += std::abs(static_cast<double>(source.weight));
    return sum;
}

double one(glm::dvec2) {
    return 1;
}

TEST(HeightFit, a_quadratic_has_its_own_height_within_and_half_a_texel_beyond) {
    const auto bowl = [](glm::dvec2 d) {
        return 7 + 3 * d.x - 2 * d.y + 5 * d.x * d.x - d.x * d.y + 4 * d.y * d.y;
    };
    for (const glm::dvec2 place : {glm::dvec2(2.3, 2.6), {2.5, 0}, {-0.5, 2.2}, {2, 2}})
        EXPECT_NEAR(fitted(block(6, 6, place), bowl), 7, 1e-4);
}

TEST(HeightFit, a_plane_where_there_are_too_few_for_more) {
    const auto plane = [](glm::dvec2 d) { return 7 + 3 * d.x - 2 * d.y; };
    EXPECT_NEAR(fitted(block(2, 2, {0.4, 1.3}), plane), 7, 1e-4);
}

TEST(HeightFit, texels_in_a_line_and_a_single_one_give_their_mean) {
    for (const Sites& sites : {block(5, 1, {2.5, 1}), block(1, 1, {0, 0}), block(1, 1, {2, 1})})
        EXPECT_NEAR(fitted(sites, one), 1, 1e-6);
    EXPECT_TRUE(fitted_height({}).empty());
}

TEST(HeightFit, noise_grows_little_however_far_the_place) {
    for (const double far : {0.5, 1.0, 2.0, 5.0, 1e3, 1e9})
        for (const Sites& sites :
             {block(6, 6, {-far, 2.5}), block(3, 3, {-far, -far}), block(2, 4, {far, 1})}) {
            EXPECT_LE(growth(sites), 3.0001) << far;
            EXPECT_NEAR(fitted(sites, one), 1, 1e-5) << far;
        }
}

}  // namespace
}  // namespace relievo::height_fit_test
