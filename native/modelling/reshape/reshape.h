// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "modelling/reshape/move_equations.h"
#include "modelling/reshape/move_space.h"
#include "modelling/reshape/surface_places.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

struct ReshapeOptions {
  ReshapeLimits limits;
  std::vector<MoveCondition> conditions;  // sums that are given values
  // What bending costs: this squared, times the mesh's size squared, times the thin-plate energy of
  // the moves (thin_plate.h), is added to the mean squared residual. 0: nothing.
  double stiffness = 0.0;
  // Of the places where shifts are wanted, made before: these take most of the time. None: three
  // places a side of a piece.
  std::shared_ptr<const PlaceWeights> weights = nullptr;
};

// What is left of wanted shifts.
struct Residual {
  double rms, largest;  // of the wanted shifts less what the surface does, m
  int largest_place;    // where, of places(); -1 where there is none
};

// How a surface comes to lie.
struct Reshaped : Residual {
  std::vector<Vector3d> moves;  // of all control points, m
  int folded_place;             // where the surface is folded then; -1: nowhere
};

// Shifts an exact surface as is wanted at places all over it: of all moves of the control points
// within the limits and conditions the one with the least (1/A) ∫ |shift of the surface - wanted
// shift|² dA. As the surface is linear in its control points this is linear least squares. Places
// and weights are fixed, so everything is factored once: a solution is a right side and
// substitutions back, with refinement until nothing but rounding is left. An affine shift is met
// exactly; one that the control points cannot do leaves a residual, which is told.
//
// Immutable: solutions are thread-safe.
class Reshape {
 public:
  // Throws std::invalid_argument for limits and conditions that are none or depend on one another,
  // and for weights of another surface.
  Reshape(const surface::LimitSurface& surface, const ReshapeOptions& options);

  const SurfacePlaces& places() const { return places_; }

  // `shifts`: wanted at each of places(), m. `prescribed`: moves of the points prescribed in the
  // limits, m. `values`: of the conditions. Throws std::invalid_argument where counts differ, for
  // what is not finite, and where the limits contradict prescribed moves.
  Reshaped solve(const std::vector<Vector3d>& shifts, const std::vector<Vector3d>& prescribed = {},
                 const std::vector<double>& values = {}) const;
  // The moves of solve() alone: sooner done where what the surface does of the shifts is not asked.
  std::vector<Vector3d> moves(const std::vector<Vector3d>& shifts,
                              const std::vector<Vector3d>& prescribed = {},
                              const std::vector<double>& values = {}) const;
  // What solve() tells, but for folds, of moves that are known: sums of its solutions, for one.
  // Throws std::invalid_argument where counts differ.
  Residual residual(const std::vector<Vector3d>& moves, const std::vector<Vector3d>& shifts) const;

 private:
  using Sparse = Eigen::SparseMatrix<double>;

  void add_stiffness(const surface::LimitSurface& surface, double stiffness);
  void factor_conditions();
  // By y: half the gradient of what is to be least, downwards.
  Eigen::VectorXd descent(const Eigen::VectorXd& moves, const VectorRows& shifts) const;
  Eigen::VectorXd descent_along(int axis, const Eigen::VectorXd& moves,
                                const VectorRows& shifts) const;
  // One step of the problem's Newton method, which is exact but for rounding and regularisation.
  Eigen::VectorXd step(const Eigen::VectorXd& descent, const Eigen::VectorXd& missing) const;
  Eigen::VectorXd least(const VectorRows& shifts, const std::vector<Vector3d>& prescribed,
                        const std::vector<double>& values) const;
  Residual left_by(const Eigen::VectorXd& moves, const VectorRows& shifts) const;

  std::vector<Vector3d> points_;
  SurfacePlaces places_;
  MoveSpace space_;
  int only_axis_;             // the one along which there are moves in the space; -1: others, too
  Eigen::VectorXd shares_;    // of the area, by place
  Sparse stiff_;              // points x points
  ConditionRows conditions_;  // by moves of all points
  MoveEquations equations_;
  Eigen::MatrixXd conditioned_;  // equations⁻¹ · conditionsᵀ
  Eigen::LDLT<Eigen::MatrixXd> condition_factors_;
};

}  // namespace hull::modelling
