// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "modelling/reshape/reshape.h"

namespace hull::modelling {

// What stays, and how, while a hull is transformed.
struct TransformLimits {
  MoveLimits limits;                // locked points, and points held in planes
  std::vector<TiedPoint> tied;      // as of square_ties()
  std::vector<MoveCondition> kept;  // as of square_sums()
  // Groups of control points that move along the ship as one: transoms in planes that are across
  // it or raked, bulbs. One with a locked point stays.
  std::vector<std::vector<int>> rigid;
};

// The control points of faces in a plane across the ship, as of a transom: a group for each that
// hangs together.
std::vector<std::vector<int>> plane_ends(const surface::LimitSurface& surface);

// Reshaping by shifts along the ship alone: control points move along x, but for those held in
// planes that are raked, which move within these. Rigid groups move by what is wanted in their
// middle, and sections along a group with them: the shift goes over to what is wanted elsewhere
// within twice its length; where several groups are near it is a mean of theirs. Creases and
// borders in a plane across the ship stay in one. Immutable.
class LongitudinalReshape {
 public:
  // Throws std::invalid_argument as Reshape does.
  LongitudinalReshape(const surface::LimitSurface& surface, const TransformLimits& limits);

  // What is wanted all over the hull, m: at each of places(), and of each point of rigid groups.
  // Sums of these are wanted by sums of shifts.
  struct Wanted {
    std::vector<Vector3d> at_places, of_groups;
  };

  // `shift`: wanted of a place at x, m.
  Wanted wanted(const std::function<double(double x)>& shift) const;
  Reshaped solve(const std::function<double(double x)>& shift) const;
  // The moves of solve() alone: sooner done.
  std::vector<Vector3d> moves(const Wanted& wanted) const;
  // Of moves that are known: sums of solutions.
  Residual residual(const std::vector<Vector3d>& moves, const Wanted& wanted) const;

  const SurfacePlaces& places() const { return reshape_.places(); }

 private:
  struct Group {
    double aft, forward;  // x, m
    double middle() const { return 0.5 * (aft + forward); }
    double nearest(double x) const { return std::clamp(x, aft, forward); }
    // 1 within the group, falling to 0 within twice its length.
    double weight(double x) const;
  };
  struct Rigid;

  LongitudinalReshape(const surface::LimitSurface& surface, const TransformLimits& limits,
                      const Rigid& rigid);
  double with_groups(const std::function<double(double x)>& shift, double x) const;
  std::vector<Vector3d> of_groups(const std::function<double(double x)>& shift) const;
  std::vector<Vector3d> at_places(const std::function<double(double x)>& shift) const;

  std::vector<Group> groups_;
  std::vector<int> group_of_;  // of each prescribed point
  Reshape reshape_;
};

}  // namespace hull::modelling
