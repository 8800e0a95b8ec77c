// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <array>
#include <memory>
#include <vector>

#include "modelling/reshape/move_space.h"
#include "modelling/reshape/surface_places.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

// Moves of all control points, one of several that a hull may be changed by.
using MoveMode = std::vector<Vector3d>;

// The moves that may be taken, Δ = basis · y, and what they cost: y'Hy/2 is half of the mean, by
// area, of the squared shift of the surface, in m², plus `stiffness`² times the mesh's size squared
// times the thin-plate energy of the moves. Factored once.
//
// Immutable: queries are thread-safe.
class MoveFamily {
 public:
  // All moves of the control points within the limits, or, if there are modes, sums of these, which
  // nothing else limits. `weights`: of the surface's places, if they are known already. Throws
  // std::invalid_argument for limits, modes or a stiffness that are none, for weights of another
  // surface, and where nothing is left that may move.
  MoveFamily(const surface::LimitSurface& surface, const ReshapeLimits& limits,
             const std::vector<MoveMode>& modes, double stiffness,
             const std::shared_ptr<const PlaceWeights>& weights = nullptr);

  const SurfacePlaces& places() const { return places_; }
  Eigen::Index size() const { return basis_.cols(); }

  // 3 x points numbers: x, y and z in turn.
  Eigen::VectorXd moves(const Eigen::VectorXd& y) const { return basis_ * y; }
  // By y, from what is known by the moves: basisᵀ · columns.
  Eigen::MatrixXd by_freedoms(const Eigen::MatrixXd& by_moves) const {
    return basis_.transpose() * by_moves;
  }
  // H⁻¹ · columns, and ½ y'Hy.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& columns) const { return factors_.solve(columns); }
  double cost(const Eigen::VectorXd& y) const { return 0.5 * y.dot(form_ * y); }

  // The mean, by area, of the squared coordinates of the surface: what scaling costs.
  std::array<double, 3> mean_squares() const;

 private:
  using Sparse = Eigen::SparseMatrix<double>;

  SurfacePlaces places_;
  Sparse basis_, form_;
  Eigen::SimplicialLLT<Sparse> factors_;
};

}  // namespace hull::modelling
