// See height_fit.h.
#include "editor/session/surface/height_fit.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <glm/geometric.hpp>

namespace relievo {
namespace {

constexpr double kSoftness = 0.25;  // of the weights, squared: nearer sites count hardly more
constexpr double kMostGrowth = 3;   // of the weights' absolute sum
constexpr double kRidge = 1e-10;    // settles sites that leave terms open

double weight_of(const FitSite& site) {
    const double square = glm::dot(site.way, site.way) + kSoftness;
    return 1 / (square * square);
}

// The first `Count` of 1, x, y, x^2, xy, y^2.
template <int Count>
std::vector<double> fitted(const std::vector<FitSite>& sites) {
    using Terms = Eigen::Matrix<double, Count, 1>;
    const auto terms_of = [](glm::dvec2 d) {
        Eigen::Matrix<double, 6, 1> terms;
        terms << 1, d.x, d.y, d.x * d.x, d.x * d.y, d.y * d.y;
        return Terms(terms.template head<Count>());
    };
    Eigen::Matrix<double, Count, Count> moments = Eigen::Matrix<double, Count, Count>::Zero();
    double sum = 0;
    for (const FitSite& site : sites) {
        const Terms terms = terms_of(site.way);
        moments += weight_of(site) * terms * terms.transpose();
        sum += weight_of(site);
    }
    moments /= sum;
    moments.diagonal().array() += kRidge;
    const Terms at_place = moments.ldlt().solve(Terms::Unit(0));
    std::vector<double> weights;
    double total = 0, growth = 0;
    for (const FitSite& site : sites) {
        weights.push_back(weight_of(site) * at_place.dot(terms_of(site.way)) / sum);
        total += weights.back();
        growth += std::abs(weights.back());
    }
    if (!(std::abs(total - 1) < 1e-3) || !(growth < kMostGrowth)) return {};
    for (double& weight : weights) weight /= total;
    return weights;
}

}  // namespace

std::vector<SeamExtension::Source> fitted_height(const std::vector<FitSite>& sites) {
    if (sites.empty()) return {};
    std::vector<double> weights = fitted<6>(sites);
    if (weights.empty()) weights = fitted<3>(sites);
    if (weights.empty()) weights = fitted<1>(sites);
    std::vector<SeamExtension::Source> sources;
    for (std::size_t i = 0; i < weights.size(); ++i)
        sources.push_back({sites[i].texel, static_cast<float>(weights[i])});
    return sources;
}

}  // namespace relievo
