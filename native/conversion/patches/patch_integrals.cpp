// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/patch_integrals.h"

#include <Eigen/Geometry>
#include <vector>

#include "analysis/arithmetic/gauss.h"

namespace hull::conversion {
namespace {

// Widths of spans, of the parameters from 0 to 1: wide ones may bend much, narrow ones are knots
// graded towards a corner and hardly bend at all.
constexpr double kWide = 0.12, kNarrow = 0.005;
constexpr int kNodes = 5, kNodesOfWide = 10, kNodesOfNarrow = 3;

struct Node {
  double weight;
  BasisValues basis;
};

std::vector<Node> nodes_of(const std::vector<double>& knots, int degree) {
  static const analysis::GaussRule usual = analysis::gauss_rule(kNodes),
                                   fine = analysis::gauss_rule(kNodesOfWide),
                                   coarse = analysis::gauss_rule(kNodesOfNarrow);
  std::vector<Node> nodes;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    const double width = knots[k + 1] - knots[k];
    if (!(width > 0.0)) continue;
    const analysis::GaussRule& rule = width > kWide ? fine : width < kNarrow ? coarse : usual;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double t = knots[k] + width * rule.nodes[i];
      nodes.push_back({width * rule.weights[i], basis_values(knots, degree, t)});
    }
  }
  return nodes;
}

}  // namespace

SurfaceIntegrals integrals_of(const BSplinePatch& patch) {
  // A tensor rule: the functions along v are computed once for all u, and the sum along u once for
  // all v.
  const std::vector<Node> across = nodes_of(patch.knots_v, patch.degree_v);
  SurfaceIntegrals sum;
  // The control points, and their derivatives by u, of the curve of one u.
  std::vector<Vector3d> points(patch.count_v), slopes(patch.count_v);
  for (const Node& u : nodes_of(patch.knots_u, patch.degree_u)) {
    for (int j = 0; j < patch.count_v; ++j) {
      points[j].setZero();
      slopes[j].setZero();
      for (int i = 0; i <= patch.degree_u; ++i) {
        const Vector3d& control = patch.control_point(u.basis.first + i, j);
        points[j] += u.basis.rows(0, i) * control;
        slopes[j] += u.basis.rows(1, i) * control;
      }
    }
    for (const Node& v : across) {
      Vector3d p = Vector3d::Zero(), du = Vector3d::Zero(), dv = Vector3d::Zero();
      for (int j = 0; j <= patch.degree_v; ++j) {
        p += v.basis.rows(0, j) * points[v.basis.first + j];
        du += v.basis.rows(0, j) * slopes[v.basis.first + j];
        dv += v.basis.rows(1, j) * points[v.basis.first + j];
      }
      // The unit normal times the element of area, so the cone's volume is a polynomial's integral.
      const Vector3d normal = du.cross(dv);
      const double weight = u.weight * v.weight;
      sum.area += weight * normal.norm();
      sum.volume += weight * p.dot(normal) / 3.0;
    }
  }
  return sum;
}

}  // namespace hull::conversion
