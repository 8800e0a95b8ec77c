// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/slow_spectrum.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>

namespace hull {
namespace {

using Eigen::MatrixXd;

// Rounding splits a Jordan block of size m into eigenvalues about eps^(1/m) apart.
constexpr double kSameEigenvalue = 1e-4;

std::vector<std::complex<double>> sorted_eigenvalues(const MatrixXd& S) {
  const Eigen::EigenSolver<MatrixXd> solver(S, false);
  assert(solver.info() == Eigen::Success);
  std::vector<std::complex<double>> values(solver.eigenvalues().begin(),
                                           solver.eigenvalues().end());
  std::sort(values.begin(), values.end(),
            [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
  return values;
}

// How many of the sorted eigenvalues are slow: the cut is in the widest gap of moduli that ends
// between floor and 1/4. The first three are always slow: they hold the tangent plane.
int count_slow(const std::vector<std::complex<double>>& values, double floor) {
  int best = 0;
  double widest = -1.0;
  const int n = static_cast<int>(values.size());
  for (int i = std::min(3, n); i <= n; ++i) {
    const double above = std::abs(values[i - 1]);
    const double below = i < n ? std::abs(values[i]) : 0.0;
    if (above <= floor && best > 0) break;
    if (below > 0.25) continue;
    const double gap = above - std::max(below, floor);
    if (gap > widest) {
      widest = gap;
      best = i;
    }
  }
  return best;
}

// Orthonormal basis of the invariant subspace of the `size` eigenvalues of S nearest to `centre`.
MatrixXd invariant_subspace(const MatrixXd& S, double centre, int size, double gap) {
  const Eigen::Index n = S.rows();
  // A shift too close to a multiple eigenvalue would drown its generalised eigenvectors; one well
  // inside the gap converges by a factor of ten or more a step.
  const double shift = centre + (size == 1 ? 1e-3 : 0.08) * gap;
  const Eigen::PartialPivLU<MatrixXd> solver(S - shift * MatrixXd::Identity(n, n));
  MatrixXd basis(n, size);
  // Any start with a share of the wanted vectors does; this one is the same on every machine.
  for (Eigen::Index i = 0; i < n; ++i) {
    for (int j = 0; j < size; ++j) {
      basis(i, j) = std::sin(1.0 + 3.7 * static_cast<double>(i) + 1.3 * j * (2.0 + 0.11 * i));
    }
  }
  const int steps = size == 1 ? 6 : 22;
  for (int step = 0; step < steps; ++step) {
    const Eigen::HouseholderQR<MatrixXd> qr(solver.solve(basis));
    basis = qr.householderQ() * MatrixXd::Identity(n, size);
  }
  return basis;
}

}  // namespace

SlowSpectrum slow_spectrum(const MatrixXd& S, double floor) {
  const std::vector<std::complex<double>> values = sorted_eigenvalues(S);
  const int m = count_slow(values, floor);
  const Eigen::Index n = S.rows();
  SlowSpectrum result{MatrixXd(n, m), MatrixXd(n, m), {}, 0.0};
  result.rest = m < n ? std::abs(values[m]) : 0.0;
  for (int begin = 0; begin < m;) {
    int end = begin + 1;
    while (end < m && std::abs(values[end - 1] - values[end]) < kSameEigenvalue) ++end;
    std::complex<double> sum = 0.0;
    for (int i = begin; i < end; ++i) sum += values[i];
    const double centre = sum.real() / (end - begin);
    double gap = 1.0;
    for (int i = 0; i < n; ++i) {
      if (i < begin || i >= end) gap = std::min(gap, std::abs(values[i] - centre));
    }
    const int size = end - begin;
    result.right.middleCols(begin, size) = invariant_subspace(S, centre, size, gap);
    result.left.middleCols(begin, size) = invariant_subspace(S.transpose(), centre, size, gap);
    result.blocks.push_back({centre, begin, size, false, {}});
    begin = end;
  }
  // The eigenvalue 1 is known exactly: rows sum to one, so its eigenvector is constant.
  assert(result.blocks.front().size == 1);
  result.blocks.front().eigenvalue = 1.0;
  result.right.col(0).setOnes();
  const MatrixXd pairing = result.left.transpose() * result.right;
  result.left = result.left * pairing.inverse().transpose();
  const MatrixXd action = result.left.transpose() * S * result.right;
  for (SlowBlock& block : result.blocks) {
    block.action = action.block(block.begin, block.begin, block.size, block.size);
    if (block.begin > 0) block.eigenvalue = block.action.trace() / block.size;
    const MatrixXd rest =
        block.action - block.eigenvalue * MatrixXd::Identity(block.size, block.size);
    block.defective = rest.cwiseAbs().maxCoeff() > 1e-10;
  }
  return result;
}

}  // namespace hull
