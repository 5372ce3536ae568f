// Normal equations by Eigen's sparse Cholesky factorisation.
#include "brushes/seam_solver.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <limits>
#include <utility>

namespace relievo {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// Against equations whose weights are about 1 in sum on each side and come at least twice a texel. Texels
// start where the stroke, and its extension over the seam, want them, and whatever moves them shows as
// ripples one texel wide: so they are held firmly. As parts of the stroke's height: an equation counts kMore
// times as much, again and again, while it leaves a difference of more than kAccepted (where the brush has a
// few texels, or an island is narrower than one); then all do, while more than kFine is left, no texel has
// moved by more than kMoved, which does not show yet, and it helps: leaves at most kLess of the difference.
constexpr double kDamping = 1;
constexpr double kAccepted = 0.005;
constexpr double kFine = 0.001;
constexpr double kMoved = 0.004;
constexpr double kLess = 0.95;
constexpr double kRounding = 0.5;  // counts that are left anyhow
constexpr double kMore = 3;
constexpr int kMostSolutions = 16;

}  // namespace

std::vector<double> solve_seam(const SeamSystem& system) {
    const auto rows = static_cast<Eigen::Index>(system.residual.size());
    const auto columns = static_cast<Eigen::Index>(system.unknowns);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(system.entries.size());
    for (const SeamSystem::Entry& entry : system.entries)
        entries.emplace_back(static_cast<int>(entry.row), static_cast<int>(entry.column), entry.weight);
    Matrix equations(rows, columns);
    equations.setFromTriplets(entries.begin(), entries.end());

    const Vector residual = Eigen::Map<const Vector>(system.residual.data(), rows);
    const double accepted = std::max(kAccepted * system.relief, kRounding);
    const double fine = std::max(kFine * system.relief, kRounding);
    Matrix damping(columns, columns);
    damping.setIdentity();
    damping *= kDamping;
    Vector weights = Vector::Ones(rows), step;
    double most_left = std::numeric_limits<double>::infinity();
    Eigen::SimplicialLDLT<Matrix> factors;
    for (int i = 0; i < kMostSolutions; ++i) {
        const Matrix weighted = weights.asDiagonal() * equations;
        const Matrix normal = Matrix(equations.transpose() * weighted) + damping;
        if (i == 0) factors.analyzePattern(normal);
        factors.factorize(normal);
        Vector next = factors.solve(weighted.transpose() * residual);
        const Vector left = (residual - equations * next).cwiseAbs();
        const double most = left.maxCoeff();
        if (most_left <= accepted && most > kLess * most_left) break;
        step = std::move(next);
        most_left = most;
        if (most <= fine) break;
        if (most > accepted) {
            weights = (left.array() > accepted).select(kMore * weights, weights);
        } else if (step.lpNorm<Eigen::Infinity>() <= kMoved * system.relief) {
            weights *= kMore;
        } else {
            break;
        }
    }
    return {step.begin(), step.end()};
}

}  // namespace relievo
