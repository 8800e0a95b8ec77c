// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "modelling/reshape/move_space.h"
#include "surface/limit_surface.h"
#include "surface/progress.h"

namespace hull::modelling {

// Points that a surface is to go through.
struct FitTarget {
  std::vector<Vector3d> points;   // m
  std::vector<Vector3d> normals;  // none, or one a point: it counts where the
                                  // surface's normal is within 60° of it
  std::vector<double> weights;    // none, or one a point, not negative
  // The shape that the points are of: places all over the surface are to lie on it, too, and their
  // mean squared distance counts as much as that of the targets. nullptr: none.
  const surface::LimitSurface* shape = nullptr;
};

// A line that creases or borders are to go along.
struct FitCurve {
  static constexpr int kNearest = -1;

  std::vector<Vector3d> points;  // m, in order
  // Index in crease_curves(surface); kNearest: for each point that which is nearest and runs in the
  // line's direction there, within FitOptions::reach.
  int chain = kNearest;
  bool whole = false;  // the chain's ends are to come to the line's ends; not for kNearest
};

// Fits that settle do so within some dozens.
inline constexpr int kMostFitSteps = 1000;

// A sum over control points, Σ weights[i] · points[i], that is wanted to be `rest`, m: its squared
// distance from that is added to what the fit makes least. Second differences along rows of control
// points, with their values at the start as rest, keep a layout even, however small its faces are.
struct FitSum {
  std::vector<int> points;
  std::vector<double> weights;
  Vector3d rest;
};

// A half space that a control point stays in: direction · point >= least, m.
struct FitBound {
  int point;
  Vector3d direction;  // of any length but zero
  double least;
};

struct FitOptions {
  ReshapeLimits limits;  // nothing of it is prescribed
  // What fair costs: this squared, times the mesh's size squared, times the thin-plate energy, is
  // added to the mean squared distance. 0: nothing.
  double fairness = 1e-4;
  // The same for the thin-plate energy of the moves from the start: what keeps rows of control
  // points as they are laid out, where the target does not tell.
  double stiffness = 0.0;
  // Whose metric bending of the moves is measured by: a surface of the same topology, not folded
  // where the start may be. nullptr: the start's.
  const surface::LimitSurface* metric = nullptr;
  double curve_weight = 1.0;  // of the curves' mean squared distance
  std::vector<FitSum> sums = {};
  // Points that begin beyond them are brought in by the shortest moves. A bound has no say along
  // what limits don't let its point move.
  std::vector<FitBound> bounds = {};
  // Farther targets and points of curves are left out, m.
  double reach = std::numeric_limits<double>::infinity();
  // Targets beyond the surface's border are left out; or they draw the border.
  bool draw_border = false;
  int most_steps = 60;        // not more than kMostFitSteps
  double least_move = 1e-10;  // of the mesh's size: the fit ends when no control point moves more
  surface::Progress progress;
};

// Where the surface came to lie.
struct Fit {
  std::vector<Vector3d> points;  // the control points
  // Of the targets from the surface, m, positive on the normal's side; at the border the part
  // across the surface unless targets draw it. NaN for those left out.
  std::vector<double> distances;
  int counted;                          // targets not left out
  double rms, largest;                  // m, of them
  int largest_target;                   // -1 without any
  Vector3d largest_place;               // where on the surface
  std::vector<double> curve_distances;  // of all curves' points, in order, m; NaN if left out
  double curve_rms, curve_largest;      // m
  double energy;                        // thin-plate energy of the surface
  int steps;
  bool settled;  // the fit ended by itself, not by most_steps
};

// Moves the control points of a surface so that it goes through targets, its creases along curves,
// and bends little: the least sum of the mean squared distance of the targets from the exact
// surface, the same of the curves, the sums' squares, and the energies, by the method of Levenberg
// 1944 and Marquardt 1963. Distances are to the closest points (closest_point.h), found anew for
// each step; control points count by their exact weights there (point_weights.h). What neither
// targets nor curves tell of stays where it is nearest to its start, but for fairness and
// stiffness.
//
// The surface's own energy has a say by its slope with the metric as it is (thin_plate.h): without
// what would draw borders in and slide points along the surface. The fit settles where that and the
// rest are in balance, or where no step lowers the sum; with fairness the sum may have a lower
// place.
//
// Bounds hold for every step, to rounding (MoveBounds): each is the least of the damped equations
// within them, not one that is cut off where it meets them.
//
// The same arguments give the same points. Throws std::invalid_argument for what is none of a
// target, a curve, a limit, a bound or a metric, and where no target lies within reach.
Fit fit(const surface::LimitSurface& surface, const FitTarget& target,
        const std::vector<FitCurve>& curves, const FitOptions& options = {});

}  // namespace hull::modelling
