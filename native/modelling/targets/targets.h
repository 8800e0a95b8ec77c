// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "modelling/targets/target_problem.h"
#include "surface/progress.h"

namespace hull::modelling {

struct TargetOptions {
  TargetWater water;
  ReshapeLimits limits;         // what control points may do …
  std::vector<MoveMode> modes;  // … or, if there are any, the moves that are added up instead
  // What bending costs, as ReshapeOptions has it.
  double stiffness = 0.05;
  // Of the scaling of length, beam and draft, from the after perpendicular, the centre plane and
  // the base line; water and project dimensions take part in it.
  std::array<ScaleBounds, 3> scales;
  // What scaling costs: this times the mean squared shift that it makes.
  double scale_cost = 0.01;
  // Of the surface's places, if they were made before: of one that differs in its points only.
  std::shared_ptr<const PlaceWeights> weights = nullptr;
};

enum class TargetStatus {
  kMet,          // all targets, by the cheapest moves
  kUnreachable,  // not all can be met: the nearest are reached, weighed
  kFolded,       // beyond what was reached the surface would be turned over
  kUnsettled     // no progress any longer, or too many steps
};

struct TargetOutcome {
  double before = 0.0, reached = 0.0;
  double miss = 0.0;  // how far out of its bounds, with sign; 0 where met
  // What the cost would rise by if the bound were moved by one unit, m² per unit; not 0 where the
  // target binds.
  double price = 0.0;
  double most_price = 0.0;  // what is paid for a miss of one unit at most
};

struct TargetsReached {
  TargetStatus status = TargetStatus::kUnsettled;
  int iterations = 0;
  std::vector<Vector3d> moves;  // of all control points, scaling included, m
  Vector3d scale = Vector3d::Ones();
  std::vector<TargetOutcome> targets;
  std::array<double, 3> scale_prices{};  // of the bounds of the scaling, m²
  double cost = 0.0;  // ½ the mean squared shift, bending and scaling added, m²
  double rms = 0.0;   // of the surface's shift but for scaling, m
  std::optional<Vector3d> folded_place;  // where it would be, on the surface as it was
};

// Changes a hull so that numbers of its form are as wanted, at the least cost: the mean squared
// shift of the surface and the bending energy of the moves. A quadratic function under a few
// nonlinear conditions, whose values and derivatives are exact: sequential quadratic programming
// (Nocedal & Wright 2006, chapter 18) with prices for what is missed (elastic mode, 18.4), a trust
// region by proximal terms and second-order corrections. As the quadratic form stays the same it is
// factored once, and a step costs a few substitutions and a small dual problem.
//
// Met means within 1e-9 of a target's size. Where targets contradict one another the sum of misses,
// each in parts of what a shift of the same size changes the number by, times its weight, is the
// least that can be found nearby.
//
// `progress` is told the share of what was missing that is met. Throws std::invalid_argument for
// what is none, as a water in which the hull floods, scaling together with trim or with locked
// points, or limits by which nothing may move.
TargetsReached reach_targets(const surface::LimitSurface& surface,
                             const std::vector<FormTarget>& targets, const TargetOptions& options,
                             const surface::Progress& progress = {});

}  // namespace hull::modelling
