// Normal equations by Eigen's sparse Cholesky factorisation.
#include "brushes/seam_solver.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace relievo {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// Damping against unit residuals; an equation's weights are about 1 in sum on each side and come at least
// twice a texel. Less damping bends the border's texels, or tosses those beyond it, to cancel kinks that the
// two grids cannot share, and shows as a line; so it starts here and falls by tens only while a difference of
// more than kAccepted of the stroke's height is left (brushes of a few texels, islands narrower than a
// texel).
constexpr double kOwnedDamping = 3e-3;
constexpr double kLooseDamping = 1e-3;
constexpr double kAccepted = 0.003;
constexpr double kAcceptedCounts = 0.5;  // rounding leaves as much
constexpr int kMostSolutions = 5;

}  // namespace

std::vector<double> solve_seam(const SeamSystem& system) {
    const auto rows = static_cast<Eigen::Index>(system.residual.size());
    const auto columns = static_cast<Eigen::Index>(system.loose.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(system.entries.size());
    for (const SeamSystem::Entry& entry : system.entries)
        entries.emplace_back(static_cast<int>(entry.row), static_cast<int>(entry.column), entry.weight);
    Matrix equations(rows, columns);
    equations.setFromTriplets(entries.begin(), entries.end());

    const Vector residual = Eigen::Map<const Vector>(system.residual.data(), rows);
    const Matrix squares = equations.transpose() * equations;
    const Vector right = equations.transpose() * residual;
    const double accepted = std::max(kAccepted * system.relief, kAcceptedCounts);
    Vector step;
    double scale = 1.0;
    for (int i = 0; i < kMostSolutions; ++i, scale *= 0.1) {
        Matrix normal = squares;
        for (Eigen::Index k = 0; k < columns; ++k)
            normal.coeffRef(k, k) +=
                scale * (system.loose[static_cast<std::size_t>(k)] ? kLooseDamping : kOwnedDamping);
        step = Eigen::SimplicialLDLT<Matrix>(normal).solve(right);
        if ((residual - equations * step).lpNorm<Eigen::Infinity>() <= accepted) break;
    }
    return {step.begin(), step.end()};
}

}  // namespace relievo
