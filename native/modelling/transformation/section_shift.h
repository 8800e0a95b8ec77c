// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/hydrostatics/hydrostatics.h"
#include "modelling/transformation/longitudinal_reshape.h"
#include "modelling/transformation/shift_functions.h"

namespace hull::modelling {

// How a wanted displacement is said: ∇ in m³, Δ in t, Cb, or Cp on the station at length_pp / 2.
enum class VolumeMeasure { kVolume, kDisplacement, kBlock, kPrismatic };

struct FormTargets {
  struct Volume {
    VolumeMeasure measure;
    double value;
  };
  std::optional<Volume> volume;
  std::optional<double> lcb;  // x, m
};

// A hull whose sections were shifted.
struct SectionsShifted {
  std::vector<Vector3d> moves;       // of all control points, m
  std::vector<double> coefficients;  // as ShiftFunctions has them: A and B, or of fore and aft body
  double rms, largest;               // of the wanted shifts less what the surface does, m
  Vector3d largest_place;            // where on the surface as it was
  double volume, lcb;                // of the resulting surface: m³, x in m
  int iterations;
  bool converged;  // targets are met to kMet
};

// Changes displacement and centre of buoyancy of a hull by shifts of its sections along the ship
// (shift_functions.h): those coefficients by which the exact hydrostatics of the resulting surface
// are as wanted. Sections keep their outlines as far as the control points can follow, and parts
// that are parallel stay so exactly, because control points keep their y and z.
//
// One that is wanted alone is met by A (∇ and what says the same) or by B (LCB) with the other at
// zero; by fore and aft body together where these are apart.
class SectionShift {
 public:
  // Of ∇, relative, and of LCB as a part of length_pp.
  static constexpr double kMet = 1e-10;

  // The body is copied. Throws std::invalid_argument as Reshape, ShiftFunctions and WorkingHull do.
  SectionShift(const analysis::HullBody& body, const analysis::FloatingPosition& position,
               const analysis::ProjectDimensions& project, double water_density,
               const ShiftSettings& settings, const TransformLimits& limits);

  // Throws std::invalid_argument where the targets are out of reach, with what can be reached:
  // beyond, sections would overtake one another or the surface would fold.
  SectionsShifted solve(const FormTargets& targets);

  // With coefficients as given, met or not. Throws std::invalid_argument where sections overtake
  // one another or the surface folds.
  SectionsShifted shifted(const std::vector<double>& coefficients);

  const ShiftFunctions& functions() const { return functions_; }
  // From the measure of ∇ = 1 m³: Cb, for one; for Cp with the present station amidships. Throws
  // std::invalid_argument where a dimension is not given.
  double per_volume(VolumeMeasure measure) const;

 private:
  class Solver;
  friend class Solver;

  struct Shift {
    LongitudinalReshape::Wanted wanted;
    std::vector<Vector3d> moves;  // of all control points, m
  };

  Shift shift_by(const std::function<double(double x)>& function) const;
  std::vector<Vector3d> moves(const std::vector<double>& coefficients) const;
  bool is_sound(const std::vector<double>& coefficients) const;
  SectionsShifted outcome(const std::vector<double>& coefficients);

  WorkingHull hull_;
  analysis::ProjectDimensions project_;
  double water_density_;
  double midship_area_;
  LongitudinalReshape reshape_;
  ShiftFunctions functions_;
  Eigen::MatrixXd slopes_;    // of the functions, all along the hull
  std::vector<Shift> units_;  // by coefficient
  Shift parallel_;            // what the parallel body's change takes
};

}  // namespace hull::modelling
