// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "modelling/fairing/bend_change.h"
#include "modelling/fairing/surface_energy.h"
#include "modelling/reshape/reshape.h"
#include "surface/limit_surface.h"
#include "surface/progress.h"

namespace hull::modelling {

// A sum over moves that is wished for: weight · (sum - value)² is added to the energy.
struct WishedSum {
  MoveCondition sum;
  double value, weight;
};

struct FairOptions {
  std::vector<int> points;  // control points that are to move
  FairEnergy energy = FairEnergy::kLengthwise;
  // Instead of that energy: how much the surface bends otherwise than before (bend_change.h).
  std::optional<BendsBefore> before;
  ReshapeLimits limits;  // of all control points; nothing prescribed
  // Points of creases and borders, and of corners, stay.
  bool keep_creases = true;
  // x stays, bit by bit.
  bool keep_stations = true;
  // Points move along the surface's normal where they lie on it (with keep_stations its part across
  // the ship), so that no move is spent on sliding them along the surface. Points of creases and
  // borders, where they may move, and where the surface has no such normal, move any way.
  bool along_normals = true;
  std::vector<MoveCondition> conditions;
  std::vector<WishedSum> wishes;  // with quadratic energies alone
  int most_steps = 40;            // of the geometric energies
};

// How a surface comes to lie that was faired.
struct Faired {
  // What keeps the surface from being fairer.
  enum class Bound { kNothing, kDeviation, kLargest };

  std::vector<Vector3d> moves;  // of all control points, m
  double rms, largest;          // of the surface's shift over the region, m
  int largest_place;            // of places(); -1 where nothing moves
  Bound bound;
  double energy_before, energy_after;  // over the region
  int steps;
  bool settled;      // the steps ended by themselves
  int folded_place;  // where the surface is folded then; -1: nowhere
};

// Chosen control points move so that the surface is as fair as can be while it stays near to what
// it was: of all moves within the limits and conditions those with the least energy, the root mean
// square shift of the surface being not more than the deviation M asked for.
//
// The region is where the points that may move have any weight. Its mean is by area (of the surface
// as it was), over the fixed places of SurfacePlaces: RMS² = (1/A) ∫ |shift|² dA. As long as more
// could be gained by moving farther the RMS *is* M, to 1e-9 of it; the weight between energy and
// shift is found for it. A shift is measured between places of the same parameters, so the surface
// is never farther from the old one than told.
//
// Thin plate, lengthwise and what is compared with before: quadratic, one factorisation for each of
// some five to ten weights. Geometric energies: steps of Gauss and Newton, each of which keeps the
// RMS, damped by Levenberg's and Marquardt's rule; they end where the energy does not fall any
// more.
//
// Immutable: solutions are thread-safe.
class FairRegion {
 public:
  // Throws std::invalid_argument where no point may move, and for limits and conditions that are
  // none or depend on one another. `surface` is read here and not kept.
  FairRegion(const surface::LimitSurface& surface, const FairOptions& options);
  ~FairRegion();
  FairRegion(FairRegion&&) noexcept;

  const SurfacePlaces& places() const;
  // Of these, those of the region.
  const std::vector<int>& region() const;
  double area() const;  // of the region, m²

  // deviation, m, not negative; largest: the largest shift anywhere on the surface, m, infinite for
  // any: where it binds the RMS is less than the deviation. `values` of the conditions.
  // Throws std::invalid_argument for what is none of these, and for conditions that need longer
  // moves than these bounds let.
  Faired solve(double deviation, double largest, const std::vector<double>& values = {},
               const surface::Progress& progress = {}) const;

 private:
  class Problem;
  std::unique_ptr<const Problem> problem_;
};

}  // namespace hull::modelling
