#include "editor/session/surface/seam_equations.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/session/surface/texel_classes.h"

namespace relievo {
namespace {

constexpr double kNoWeight = 1e-9;
constexpr double kLongestStretch = 0.5;  // texels

// A seam longer than this (a layout far outside the map) is sampled no more often.
constexpr double kMostCrossings = 1 << 20;

void add_crossings(double from, double to, std::vector<double>& at) {
    const double d = to - from;
    if (std::abs(d) < kTexelSlack || std::abs(d) > kMostCrossings) return;
    const double low = std::min(from, to), high = std::max(from, to);
    for (double line = std::floor(low) + 1; line < high; line += 1) at.push_back((line - from) / d);
}

std::vector<double> tidy(std::vector<double> at) {
    at.push_back(0);
    at.push_back(1);
    std::sort(at.begin(), at.end());
    at.erase(std::remove_if(at.begin(), at.end(), [](double t) { return t < 0 || t > 1; }), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    return at;
}

void add_sample(const UvSeam& seam, const MapGrid& grid, double t, std::vector<TexelSum>& sums) {
    const BilinearTaps a = bilinear_taps(grid, seam.a.from + (seam.a.to - seam.a.from) * t);
    const BilinearTaps b = bilinear_taps(grid, seam.b.from + (seam.b.to - seam.b.from) * t);
    TexelSum sum;
    for (std::size_t i = 0; i < 4; ++i) sum.emplace_back(a.texel[i], a.weights()[i]);
    for (std::size_t i = 0; i < 4; ++i) sum.emplace_back(b.texel[i], -b.weights()[i]);
    sums.push_back(std::move(sum));
}

bool same_equation(const SeamEquation& a, const SeamEquation& b) {
    return std::equal(a.texel, a.texel + 8, b.texel) && std::equal(a.weight, a.weight + 8, b.weight);
}

bool before(const SeamEquation& a, const SeamEquation& b) {
    if (!std::equal(a.texel, a.texel + 8, b.texel)) {
        return std::lexicographical_compare(a.texel, a.texel + 8, b.texel, b.texel + 8);
    }
    return std::lexicographical_compare(a.weight, a.weight + 8, b.weight, b.weight + 8);
}

}  // namespace

std::vector<double> cell_crossings(const UvSide& side) {
    std::vector<double> at;
    add_crossings(side.from.x, side.to.x, at);
    add_crossings(side.from.y, side.to.y, at);
    return tidy(std::move(at));
}

void add_seam_samples(const UvSeam& seam, const MapGrid& grid, std::vector<TexelSum>& sums) {
    std::vector<double> at = cell_crossings(seam.a);
    const std::vector<double> at_b = cell_crossings(seam.b);
    at.insert(at.end(), at_b.begin(), at_b.end());
    at = tidy(std::move(at));
    const double texels = std::min(std::max(seam.a.length(), seam.b.length()), kMostCrossings);
    add_sample(seam, grid, 0, sums);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        const double length = at[i + 1] - at[i];
        const auto pieces = std::max(1, static_cast<int>(std::ceil(length * texels / kLongestStretch)));
        if (length * texels < kTexelSlack) continue;
        if (i > 0) add_sample(seam, grid, at[i], sums);
        for (int k = 0; k < pieces; ++k) add_sample(seam, grid, at[i] + length * (k + 0.5) / pieces, sums);
    }
    add_sample(seam, grid, 1, sums);
}

TexelSum column_sum(const SeamColumn& c) {
    return {{c.a_in, c.weight_in}, {c.a_out, c.weight_out}, {c.b_in, -c.weight_out}, {c.b_out, -c.weight_in}};
}

TexelSum reduced(const TexelSum& sum, const TexelClasses& classes) {
    TexelSum merged;
    for (const auto& [texel, weight] : sum) {
        const std::uint32_t root = classes.root(texel);
        const auto same =
            std::find_if(merged.begin(), merged.end(), [&](const auto& t) { return t.first == root; });
        if (same == merged.end()) {
            merged.emplace_back(root, weight);
        } else {
            same->second += weight;
        }
    }
    const auto none = [](const auto& t) { return std::abs(t.second) < kNoWeight; };
    merged.erase(std::remove_if(merged.begin(), merged.end(), none), merged.end());
    std::sort(merged.begin(), merged.end());
    return merged;
}

std::vector<SeamEquation> equations(const std::vector<TexelSum>& sums, const TexelClasses& classes) {
    std::vector<SeamEquation> all;
    all.reserve(sums.size());
    for (const TexelSum& sum : sums) {
        const TexelSum terms = reduced(sum, classes);
        if (terms.empty()) continue;
        SeamEquation e{};
        for (std::size_t i = 0; i < 8; ++i) {
            e.texel[i] = terms[std::min(i, terms.size() - 1)].first;
            e.weight[i] = i < terms.size() ? static_cast<float>(terms[i].second) : 0.0f;
        }
        all.push_back(e);
    }
    std::sort(all.begin(), all.end(), before);
    all.erase(std::unique(all.begin(), all.end(), same_equation), all.end());
    return all;
}

}  // namespace relievo
