// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/crease_moves.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

#include "mesh/dense_solvers.h"
#include "surface/pieces/point_weights.h"

namespace hull::modelling {
namespace {

// The chain's control points, in order: a corner where it both begins and ends once.
std::vector<int> points_of(const surface::CreaseCurve& curve) {
  std::vector<int> points = curve.vertices();
  if (points.front() == points.back()) points.pop_back();
  return points;
}

void check_curve(const surface::LimitSurface& surface, const surface::CreaseCurve& curve,
                 const std::vector<double>& t) {
  for (std::size_t k = 0; k < t.size(); ++k) {
    if (!(t[k] >= 0.0 && t[k] <= curve.edge_count())) {
      throw std::invalid_argument("t[" + std::to_string(k) + "] is outside of [0, " +
                                  std::to_string(curve.edge_count()) + "].");
    }
  }
  for (int vertex : curve.vertices()) {
    if (surface.mesh().topology().kind(vertex) == mesh::VertexKind::kDart) {
      throw std::invalid_argument("The crease fades out at point " + std::to_string(vertex) +
                                  ", where it depends on points beside it: make that a corner.");
    }
  }
}

void check_shifts(const std::vector<double>& t, const std::vector<Vector3d>& shifts) {
  if (t.size() != shifts.size() || t.empty()) {
    throw std::invalid_argument("There must be a shift for each t, and one at least: there are " +
                                std::to_string(shifts.size()) + " for " + std::to_string(t.size()) +
                                ".");
  }
  for (const Vector3d& shift : shifts) {
    if (!shift.allFinite()) throw std::invalid_argument("A wanted shift is no number.");
  }
}

// A row for each t: weights of the chain's control points.
Eigen::MatrixXd weights_of(const surface::LimitSurface& surface, const surface::CreaseCurve& curve,
                           const std::vector<double>& t) {
  std::map<int, Eigen::Index> column;
  for (int vertex : points_of(curve)) {
    column.emplace(vertex, static_cast<Eigen::Index>(column.size()));
  }
  surface::PointWeights weights(surface);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(t.size()),
                                               static_cast<Eigen::Index>(column.size()));
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    surface::CellPlace place = curve.left(t[k]);
    if (place.cell < 0) place = curve.right(t[k]);
    for (const surface::PointWeight& w : weights.at(place.cell, place.u, place.v)) {
      const auto own = column.find(w.point);
      // Others have weights of rounding at most: a crease without darts is of its own points alone.
      if (own != column.end()) rows(k, own->second) += w.weight;
    }
  }
  return rows;
}

}  // namespace

CreaseMoves crease_moves(const surface::LimitSurface& surface, const surface::CreaseCurve& curve,
                         const std::vector<double>& t, const std::vector<Vector3d>& shifts,
                         const std::vector<int>& staying) {
  check_shifts(t, shifts);
  check_curve(surface, curve, t);
  const std::vector<int> points = points_of(curve);
  const Eigen::MatrixXd rows = weights_of(surface, curve, t);
  Eigen::MatrixX3d wanted(rows.rows(), 3);
  for (Eigen::Index k = 0; k < rows.rows(); ++k) wanted.row(k) = shifts[k].transpose();
  Eigen::MatrixX3d moves = Eigen::MatrixX3d::Zero(rows.cols(), 3);
  Eigen::MatrixXd free = rows;
  for (Eigen::Index k = 0; k < rows.rows() && !curve.closed(); ++k) {
    const bool is_first = t[k] == 0.0, is_last = t[k] == curve.edge_count();
    if (!is_first && !is_last) continue;
    // The curve ends in its control point, which so moves by the whole shift, whatever the rest of
    // the curve would rather have.
    const int corner = is_first ? curve.vertices().front() : curve.vertices().back();
    const Eigen::Index end = std::ranges::find(points, corner) - points.begin();
    moves.row(end) = wanted.row(k);
    free.col(end).setZero();
  }
  for (Eigen::Index i = 0; i < moves.rows(); ++i) {
    // After the ends: what stays does so whatever is wanted of an end.
    if (std::ranges::find(staying, points[i]) == staying.end()) continue;
    moves.row(i).setZero();
    free.col(i).setZero();
  }
  const Eigen::MatrixX3d left = wanted - rows * moves;
  // x, y and z have the same matrix.
  const Eigen::MatrixX3d rest = mesh::least_norm_solutions(free, left);
  for (Eigen::Index i = 0; i < moves.rows(); ++i) {
    // Those that are told, and those that no t depends on, stay as they are to the bit.
    if (!free.col(i).isZero(0.0)) moves.row(i) += rest.row(i);
  }
  Eigen::Index farthest = 0;
  CreaseMoves result{points, {}, 0.0, 0.0};
  result.distance = (wanted - rows * moves).rowwise().norm().maxCoeff(&farthest);
  result.t = t[farthest];
  for (Eigen::Index i = 0; i < moves.rows(); ++i) {
    result.moves.emplace_back(moves.row(i).transpose());
  }
  return result;
}

std::vector<Vector3d> crease_shifts(const surface::LimitSurface& surface,
                                    const surface::CreaseCurve& curve, const std::vector<double>& t,
                                    const std::vector<Vector3d>& moves) {
  check_curve(surface, curve, t);
  const std::size_t count = points_of(curve).size();
  if (moves.size() != count) {
    throw std::invalid_argument("There must be a move for each of the crease's " +
                                std::to_string(count) + " control points, not " +
                                std::to_string(moves.size()) + ".");
  }
  const Eigen::MatrixXd rows = weights_of(surface, curve, t);
  std::vector<Vector3d> shifts(t.size(), Vector3d::Zero());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    for (Eigen::Index i = 0; i < rows.cols(); ++i) shifts[k] += rows(k, i) * moves[i];
  }
  return shifts;
}

}  // namespace hull::modelling
