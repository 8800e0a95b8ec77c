// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/eigenbasis/tangent_rule.h"

#include <algorithm>
#include <cmath>

#include "mesh/dense_solvers.h"

namespace hull::surface {
namespace {

// A leading mode: how its amplitude follows from the dominant coordinates, and its pattern in them.
struct Mode {
  Eigen::VectorXd weights, pattern;
};

Mode plain_mode(Eigen::Index m, int column) {
  return {Eigen::VectorXd::Unit(m, column), Eigen::VectorXd::Unit(m, column)};
}

// In a Jordan block the nilpotent part leads after k steps, by a factor k. Of rank one, it maps
// everything on one eigenvector (docs/surface.md, trap 5: the osculating plane of a crease).
bool jordan_mode(Eigen::Index m, const DominantBlock& block, Mode& mode) {
  const Eigen::MatrixXd nilpotent =
      block.action - block.eigenvalue * Eigen::MatrixXd::Identity(block.size, block.size);
  // Of a complex pair this part has full rank: it has no leading direction, and no plane.
  const mesh::SingularValues svd = mesh::singular_values(nilpotent);
  if (svd.values[1] > 1e-6 * svd.values[0]) return false;
  mode = {Eigen::VectorXd::Zero(m), Eigen::VectorXd::Zero(m)};
  mode.weights.segment(block.begin, block.size) = svd.v.col(0);
  mode.pattern.segment(block.begin, block.size) = svd.u.col(0);
  return true;
}

bool leading_modes(const DominantSpectrum& spectrum, Mode& a, Mode& b) {
  const auto& blocks = spectrum.blocks;
  const Eigen::Index m = spectrum.right.cols();
  if (blocks.size() < 2) return false;
  // Two modes of one eigenvalue, as of interior points.
  if (blocks[1].size == 2 && !blocks[1].coupled) {
    a = plain_mode(m, blocks[1].begin);
    b = plain_mode(m, blocks[1].begin + 1);
    return true;
  }
  if (blocks[1].size != 1 || blocks.size() < 3) return false;
  a = plain_mode(m, blocks[1].begin);
  if (blocks[2].size == 1) {
    b = plain_mode(m, blocks[2].begin);
    return true;
  }
  return blocks[2].coupled && jordan_mode(m, blocks[2], b);
}

// The sense in which the ring's points follow each other around the corner in the plane of the two
// patterns; 0 if they don't all turn the same way.
double turning_sense(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  // Ends of rays and opposite corners take turns. An even number of points ends with the last ray;
  // else the first ray follows the last corner.
  const Eigen::Index around = x.size() - 1, steps = x.size() % 2 ? around : around - 1;
  double sense = 0.0;
  for (Eigen::Index i = 0; i < steps; ++i) {
    const Eigen::Index p = 1 + i, q = 1 + (i + 1) % around;
    const double cross = x[p] * y[q] - x[q] * y[p];
    const double scale = std::hypot(x[p], y[p]) * std::hypot(x[q], y[q]);
    // Two points in line with the corner, or one that falls on it.
    if (std::abs(cross) <= 1e-6 * scale || scale < 1e-12 * x.norm() * y.norm()) return 0.0;
    if (cross * sense < 0.0) return 0.0;
    sense = cross;
  }
  return sense;
}

}  // namespace

TangentRule tangent_rule(const DominantSpectrum& spectrum) {
  TangentRule rule;
  Mode a, b;
  if (!leading_modes(spectrum, a, b)) return rule;
  const double sense = turning_sense(spectrum.right * a.pattern, spectrum.right * b.pattern);
  if (sense == 0.0) return rule;
  return {true, a.weights, b.weights, sense < 0.0 ? -1.0 : 1.0};
}

}  // namespace hull::surface
