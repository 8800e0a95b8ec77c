// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/quad_constraints.h"

#include <Eigen/Geometry>

namespace hull::network {
namespace {

using conversion::BSplinePatch;

// Of independent constraints the least one, as a part of the largest: what is below contradicts
// others, or says the same.
constexpr double kIndependent = 1e-9;
constexpr double kLeastShare = 0.02;  // of a side
constexpr double kMostMove = 0.1;  // of a patch's size

// Σ weights · points at right angles to a normal.
struct Constraint {
  Eigen::MatrixXd weights;  // of the inner control points
  Vector3d normal;
  double excess;  // what it is now
};

// B-spline functions of the points beside the side, against those on it: but for a factor the
// derivative across.
Constraint constraint_at(const BSplinePatch& patch, int side, const std::vector<double>& knots,
                         double t, const Vector3d& normal) {
  Constraint made{Eigen::MatrixXd::Zero(patch.count_u - 2, patch.count_v - 2), normal, 0.0};
  const conversion::BasisValues values = conversion::basis_values(knots, 3, t);
  for (int a = 0; a < 4; ++a) {
    const double weight = values.rows(0, a);
    const int i = values.first + a;
    const int beside = patch.corner_index(side, i, 1), on = patch.corner_index(side, i, 0);
    const auto& points = patch.control_points;
    made.excess += weight * normal.dot(points[static_cast<std::size_t>(beside)] -
                                       points[static_cast<std::size_t>(on)]);
    const int u = beside / patch.count_v - 1, v = beside % patch.count_v - 1;
    const bool is_inner =
        u >= 0 && v >= 0 && u < made.weights.rows() && v < made.weights.cols() && weight != 0.0;
    if (is_inner) made.weights(u, v) += weight;
  }
  return made;
}

std::vector<Constraint> constraints_of(const BSplinePatch& patch,
                                       const std::array<QuadSide, 4>& sides) {
  std::vector<Constraint> all;
  for (int k = 0; k < 4; ++k) {
    const QuadSide& side = sides[static_cast<std::size_t>(k)];
    if (!side.normal) continue;
    const std::vector<double> knots = patch.side_knots(k);
    for (std::size_t i = 4; i + 4 < knots.size(); ++i) {
      // Beside an end, which has its plane, a knot would say the same again.
      if (knots[i] < kLeastShare || knots[i] > 1.0 - kLeastShare) continue;
      // At a knot of the degree's multiplicity the curve may have a kink, and no plane.
      if (knots[i] == knots[i - 1] || knots[i] == knots[i + 2]) continue;
      all.push_back(constraint_at(patch, k, knots, knots[i], side.normal(knots[i])));
    }
  }
  return all;
}

}  // namespace

bool meet_normals(BSplinePatch& patch, const std::array<QuadSide, 4>& sides,
                  const InverseForm& inverse) {
  const std::vector<Constraint> constraints = constraints_of(patch, sides);
  const auto count = static_cast<Eigen::Index>(constraints.size());
  if (count == 0) return true;
  std::vector<Eigen::MatrixXd> answers;
  Eigen::MatrixXd form(count, count);
  Eigen::VectorXd excess(count);
  for (Eigen::Index q = 0; q < count; ++q) {
    const Constraint& one = constraints[static_cast<std::size_t>(q)];
    answers.push_back(inverse(one.weights));
    excess[q] = one.excess;
    for (Eigen::Index r = 0; r <= q; ++r) {
      const Constraint& other = constraints[static_cast<std::size_t>(r)];
      form(q, r) = form(r, q) =
          one.normal.dot(other.normal) * answers.back().cwiseProduct(other.weights).sum();
    }
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(kIndependent);
  const Eigen::VectorXd multipliers = solver.compute(form).solve(-excess);
  std::vector<Vector3d> moves(patch.control_points.size(), Vector3d::Zero());
  Eigen::AlignedBox3d box, moved;
  for (int u = 0; u + 2 < patch.count_u; ++u) {
    for (int v = 0; v + 2 < patch.count_v; ++v) {
      Vector3d& move = moves[static_cast<std::size_t>((u + 1) * patch.count_v + v + 1)];
      for (Eigen::Index q = 0; q < count; ++q) {
        const auto at = static_cast<std::size_t>(q);
        move += multipliers[q] * answers[at](u, v) * constraints[at].normal;
      }
      moved.extend(move);
    }
  }
  for (const Vector3d& point : patch.control_points) box.extend(point);
  if (!(moved.diagonal().norm() <= kMostMove * box.diagonal().norm())) return false;
  for (std::size_t i = 0; i < moves.size(); ++i) patch.control_points[i] += moves[i];
  return true;
}

}  // namespace hull::network
