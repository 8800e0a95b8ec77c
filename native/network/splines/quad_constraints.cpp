// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/quad_constraints.h"

#include <Eigen/Geometry>

#include "mesh/dense_solvers.h"

namespace hull::network {
namespace {

using conversion::BSplinePatch;

// Of independent constraints the least one, as a part of the largest: what is below contradicts
// others, or says the same.
constexpr double kIndependent = 1e-9;
constexpr double kLeastShare = 0.02;  // of a side
constexpr double kMostMove = 0.1;     // of a patch's size

// B-spline functions of the points beside the side, against those on it: but for a factor the
// derivative across.
NormalConstraint constraint_at(const BSplinePatch& patch, int side,
                               const std::vector<double>& knots, double t, const Vector3d& normal) {
  NormalConstraint made{{}, normal};
  const conversion::BasisValues values = conversion::basis_values(knots, 3, t);
  for (int a = 0; a < 4; ++a) {
    const double weight = values.rows(0, a);
    // At a simple knot the fourth function is zero.
    if (weight == 0.0) continue;
    made.weights.emplace_back(patch.corner_index(side, values.first + a, 1), weight);
    made.weights.emplace_back(patch.corner_index(side, values.first + a, 0), -weight);
  }
  return made;
}

// Σ of a matrix over the inner control points, by a constraint's weights.
double weighted(const BSplinePatch& patch, const NormalConstraint& constraint,
                const Eigen::MatrixXd& values) {
  double sum = 0.0;
  for (const auto& [point, weight] : constraint.weights) {
    const int number = inner_number(patch, point);
    if (number >= 0) sum += weight * values(number / values.cols(), number % values.cols());
  }
  return sum;
}

Eigen::MatrixXd as_matrix(const BSplinePatch& patch, const NormalConstraint& constraint) {
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(patch.count_u - 2, patch.count_v - 2);
  for (const auto& [point, weight] : constraint.weights) {
    const int number = inner_number(patch, point);
    if (number >= 0) weights(number / weights.cols(), number % weights.cols()) += weight;
  }
  return weights;
}

// Moves control points, unless by more than is meant: by how much, as a part of the size.
double moved_share(BSplinePatch& patch, const std::vector<Vector3d>& moves) {
  Eigen::AlignedBox3d box, moved;
  for (const Vector3d& point : patch.control_points) box.extend(point);
  for (const Vector3d& move : moves) moved.extend(move);
  const double share = moved.diagonal().norm() / box.diagonal().norm();
  // What is no number moves nothing, either.
  if (!(share <= kMostMove)) return share;
  for (std::size_t i = 0; i < moves.size(); ++i) patch.control_points[i] += moves[i];
  return share;
}

}  // namespace

double NormalConstraint::excess(const BSplinePatch& patch) const {
  double sum = 0.0;
  for (const auto& [point, weight] : weights) {
    sum += weight * normal.dot(patch.control_points[static_cast<std::size_t>(point)]);
  }
  return sum;
}

int inner_number(const BSplinePatch& patch, int point) {
  const int u = point / patch.count_v, v = point % patch.count_v;
  const bool is_inner = u > 0 && v > 0 && u + 1 < patch.count_u && v + 1 < patch.count_v;
  return is_inner ? (u - 1) * (patch.count_v - 2) + v - 1 : -1;
}

std::vector<NormalConstraint> normal_constraints(const BSplinePatch& patch,
                                                 const std::array<QuadSide, 4>& sides) {
  std::vector<NormalConstraint> all;
  for (int k = 0; k < 4; ++k) {
    const QuadSide& side = sides[static_cast<std::size_t>(k)];
    if (!side.normal) continue;
    const std::vector<double> knots = patch.side_knots(k);
    for (std::size_t i = 4; i + 4 < knots.size(); ++i) {
      // Beside an end, which has its plane, a knot would say the same again.
      if (knots[i] < kLeastShare || knots[i] > 1.0 - kLeastShare) continue;
      // At a knot of the degree's multiplicity the curve may have a kink, and no plane.
      if (knots[i] == knots[i - 1] || knots[i] == knots[i + 2]) continue;
      if (side.has_normal && !side.has_normal(knots[i])) continue;
      all.push_back(constraint_at(patch, k, knots, knots[i], side.normal(knots[i])));
    }
  }
  return all;
}

// The Schur complement of the constraints: as large as they are many, whatever the patch has.
bool meet_normals(BSplinePatch& patch, const std::array<QuadSide, 4>& sides,
                  const InverseForm& inverse) {
  const std::vector<NormalConstraint> constraints = normal_constraints(patch, sides);
  const auto count = static_cast<Eigen::Index>(constraints.size());
  if (count == 0) return true;
  // With the form H and the constraints C: moves H^-1 C' m such that C H^-1 C' m = -excess. H has
  // the coordinates apart, so that normals come in by their products alone.
  std::vector<Eigen::MatrixXd> answers;
  Eigen::MatrixXd form(count, count);
  Eigen::VectorXd excess(count);
  for (Eigen::Index q = 0; q < count; ++q) {
    // One solution a constraint does for all three coordinates.
    const NormalConstraint& one = constraints[static_cast<std::size_t>(q)];
    answers.push_back(inverse(as_matrix(patch, one)));
    excess[q] = one.excess(patch);
    for (Eigen::Index r = 0; r <= q; ++r) {
      const NormalConstraint& other = constraints[static_cast<std::size_t>(r)];
      form(q, r) = form(r, q) =
          one.normal.dot(other.normal) * weighted(patch, other, answers.back());
    }
  }
  // Constraints that say the same make it singular; what they ask is shared out among them.
  const Eigen::VectorXd multipliers = mesh::least_norm_solution(form, -excess, kIndependent);
  std::vector<Vector3d> moves(patch.control_points.size(), Vector3d::Zero());
  for (int u = 0; u + 2 < patch.count_u; ++u) {
    for (int v = 0; v + 2 < patch.count_v; ++v) {
      Vector3d& move = moves[static_cast<std::size_t>((u + 1) * patch.count_v + v + 1)];
      for (Eigen::Index q = 0; q < count; ++q) {
        const auto at = static_cast<std::size_t>(q);
        move += multipliers[q] * answers[at](u, v) * constraints[at].normal;
      }
    }
  }
  return moved_share(patch, moves) <= kMostMove;
}

}  // namespace hull::network
