// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/eigenbasis/dominant_spectrum.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>

namespace hull::surface {
namespace {

using Eigen::MatrixXd;

// Rounding splits a Jordan block of size m into eigenvalues about eps^(1/m) apart; and eigenvectors
// of merely close eigenvalues (high valences have them) are nearly parallel, a bad basis.
constexpr double kSameEigenvalue = 1e-3;

std::vector<std::complex<double>> sorted_eigenvalues(const MatrixXd& S) {
  // Where eigenvalues are, roughly: one of a Jordan block may be off by 1e-8, which inverse
  // iteration and the bases' own action then mend.
  const Eigen::EigenSolver<MatrixXd> solver(S, false);
  assert(solver.info() == Eigen::Success);
  std::vector<std::complex<double>> values(solver.eigenvalues().begin(),
                                           solver.eigenvalues().end());
  std::sort(values.begin(), values.end(),
            [](const auto& a, const auto& b) { return std::abs(a) > std::abs(b); });
  return values;
}

// How many of the sorted eigenvalues are dominant: the cut is in the widest gap of moduli that ends
// between floor and 1/4. The first three are always dominant: they hold the tangent plane.
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

// Eigenvalues that must be kept together, and how far off the others are.
struct Group {
  std::vector<std::complex<double>> members;  // complex ones with their conjugates
  double gap = 1.0;                           // smallest distance to another eigenvalue
};

bool belong_together(const std::complex<double>& a, const std::complex<double>& b) {
  // A complex pair shares a real subspace of two dimensions, so it is never divided.
  return std::abs(a - b) < kSameEigenvalue || std::abs(a - std::conj(b)) < kSameEigenvalue;
}

// The group of eigenvalue `first`: all that are connected to it by short steps.
Group group_of(const std::vector<std::complex<double>>& values, int first,
               std::vector<char>& taken) {
  Group group{{values[first]}};
  taken[first] = 1;
  std::vector<char> mine(values.size(), 0);
  mine[first] = 1;
  for (std::size_t i = 0; i < group.members.size(); ++i) {
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (taken[j] || !belong_together(group.members[i], values[j])) continue;
      // The loop goes on over the members that are added here.
      taken[j] = mine[j] = 1;
      group.members.push_back(values[j]);
    }
  }
  for (const auto& member : group.members) {
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (!mine[j]) group.gap = std::min(group.gap, std::abs(member - values[j]));
    }
  }
  return group;
}

// Factors whose product is small on the group's subspace only: S - λ of each real member, and
// (S - λ)(S - conj λ), which is real, of each complex pair, all a little off.
std::vector<Eigen::PartialPivLU<MatrixXd>> near_singular_factors(const MatrixXd& S,
                                                                 const Group& group) {
  // A shift too close to a multiple eigenvalue would drown its generalised eigenvectors; one well
  // inside the gap converges by a factor of five or more a step.
  const double offset = (group.members.size() == 1 ? 1e-3 : 0.08) * group.gap;
  std::vector<Eigen::PartialPivLU<MatrixXd>> factors;
  for (const auto& member : group.members) {
    // Its conjugate serves for both.
    if (member.imag() < 0.0) continue;
    MatrixXd factor = S;
    factor.diagonal().array() -= member.real() + offset;
    if (member.imag() > 0.0) {
      // (S - λ)(S - conj λ) = (S - Re λ)² + (Im λ)², of real numbers only.
      factor = (factor * factor).eval();
      factor.diagonal().array() += member.imag() * member.imag();
    }
    factors.emplace_back(factor);
  }
  return factors;
}

// One Newton step for an orthonormal basis Q of a nearly invariant subspace: with B = Q^T S Q, the
// correction X solves S X - X B = Q B - S Q, Q^T X = 0. In the Schur form of B this is one bordered
// system per column, each with the columns before it on its right-hand side.
MatrixXd polished(const MatrixXd& S, const MatrixXd& Q) {
  using Eigen::MatrixXcd;
  const Eigen::Index n = S.rows(), m = Q.cols();
  const MatrixXd B = Q.transpose() * S * Q;
  // The Sylvester equation column by column, after Bartels and Stewart (1972).
  const Eigen::ComplexSchur<MatrixXd> schur(B);
  const MatrixXcd& T = schur.matrixT();
  const MatrixXcd residual = (Q * B - S * Q) * schur.matrixU();
  MatrixXcd bordered = MatrixXcd::Zero(n + m, n + m);
  // The border asks for Q^T X = 0, without which S - T(j, j) would be all but singular.
  bordered.topRightCorner(n, m) = Q;
  bordered.bottomLeftCorner(m, n) = Q.transpose();
  MatrixXcd X(n, m);
  Eigen::VectorXcd wanted = Eigen::VectorXcd::Zero(n + m);
  for (Eigen::Index j = 0; j < m; ++j) {
    bordered.topLeftCorner(n, n) = S;
    bordered.topLeftCorner(n, n).diagonal().array() -= T(j, j);
    wanted.head(n) = residual.col(j) + X.leftCols(j) * T.col(j).head(j);
    X.col(j) = bordered.partialPivLu().solve(wanted).head(n);
  }
  const MatrixXd improved = Q + (X * schur.matrixU().adjoint()).real();
  return Eigen::HouseholderQR<MatrixXd>(improved).householderQ() * MatrixXd::Identity(n, m);
}

// Orthonormal basis of the invariant subspace of a group of eigenvalues of S.
MatrixXd invariant_subspace(const MatrixXd& S, const Group& group) {
  const Eigen::Index n = S.rows();
  const int size = static_cast<int>(group.members.size());
  const std::vector<Eigen::PartialPivLU<MatrixXd>> factors = near_singular_factors(S, group);
  MatrixXd basis(n, size);
  // Any start with a share of the wanted vectors does; this one is the same on every machine.
  for (Eigen::Index i = 0; i < n; ++i) {
    for (int j = 0; j < size; ++j) {
      basis(i, j) = std::sin(1.0 + 3.7 * static_cast<double>(i) + 1.3 * j * (2.0 + 0.11 * i));
    }
  }
  // By the factors above, 1000 and five a step, more than doubles can tell.
  const int steps = size == 1 ? 6 : 24;
  for (int step = 0; step < steps; ++step) {
    for (const auto& factor : factors) {
      const Eigen::HouseholderQR<MatrixXd> qr(factor.solve(basis));
      basis = qr.householderQ() * MatrixXd::Identity(n, size);
    }
  }
  return size == 1 ? basis : polished(S, basis);
}

}  // namespace

DominantSpectrum dominant_spectrum(const MatrixXd& S, double floor) {
  const std::vector<std::complex<double>> values = sorted_eigenvalues(S);
  const int m = count_slow(values, floor);
  const Eigen::Index n = S.rows();
  DominantSpectrum result{MatrixXd(n, m), MatrixXd(n, m), {}, 0.0};
  result.rest = m < n ? std::abs(values[m]) : 0.0;
  std::vector<char> taken(values.size(), 0);
  int begin = 0;
  for (int i = 0; i < m; ++i) {
    if (taken[i]) continue;
    const Group group = group_of(values, i, taken);
    const int size = static_cast<int>(group.members.size());
    std::complex<double> sum = 0.0;
    for (const auto& member : group.members) sum += member;
    assert(begin + size <= m);  // the cut is in a gap, so groups are dominant as a whole
    result.right.middleCols(begin, size) = invariant_subspace(S, group);
    // Eigenvalues of the transpose are the same, and so are the groups.
    result.left.middleCols(begin, size) = invariant_subspace(S.transpose(), group);
    result.blocks.push_back({sum.real() / size, begin, size, false, {}});
    begin += size;
  }
  // The eigenvalue 1 is known exactly: rows sum to one, so its eigenvector is constant.
  assert(result.blocks.front().size == 1);
  result.blocks.front().eigenvalue = 1.0;
  result.right.col(0).setOnes();
  // Left and right vectors of different groups are at right angles but for rounding, which this
  // takes out too; within a group it makes the left basis the dual of the right one.
  const MatrixXd pairing = result.left.transpose() * result.right;
  result.left = result.left * pairing.inverse().transpose();
  for (DominantBlock& block : result.blocks) {
    // The bases are orthonormal: the projection gives the action with the least residual, where
    // left vectors, long if eigenvalues are close, would magnify rounding.
    const auto basis = result.right.middleCols(block.begin, block.size);
    block.action =
        block.begin == 0 ? MatrixXd::Ones(1, 1) : MatrixXd(basis.transpose() * S * basis);
    if (block.begin > 0) block.eigenvalue = block.action.trace() / block.size;
    const MatrixXd rest =
        block.action - block.eigenvalue * MatrixXd::Identity(block.size, block.size);
    // A multiple eigenvalue with as many eigenvectors leaves rounding here, a Jordan block does
    // not.
    block.coupled = rest.cwiseAbs().maxCoeff() > 1e-10;
  }
  return result;
}

}  // namespace hull::surface
