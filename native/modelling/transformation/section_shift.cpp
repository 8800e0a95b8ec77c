// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/section_shift.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "modelling/transformation/shift_solver.h"

namespace hull::modelling {
namespace {

ShiftSettings with_length(ShiftSettings settings, const analysis::ProjectDimensions& project) {
  settings.length_pp = project.length_pp;
  return settings;
}

Eigen::MatrixXd slopes_along(const ShiftFunctions& functions, const SurfacePlaces& places) {
  // All of the hull, beyond the perpendiculars, too.
  double from = INFINITY, to = -INFINITY;
  for (int k = 0; k < places.count(); ++k) {
    from = std::min(from, places.position(k).x());
    to = std::max(to, places.position(k).x());
  }
  return functions.slopes(from, to);
}

void add(double factor, const std::vector<Vector3d>& vectors, std::vector<Vector3d>& sums) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += factor * vectors[i];
}

// In dimensions of the project.
double dimension(double value, const char* name, const char* what) {
  if (value > 0.0) return value;
  throw std::invalid_argument(std::string("Give the ") + name + ": " + what + " stands on it.");
}

}  // namespace

SectionShift::SectionShift(const analysis::HullBody& body,
                           const analysis::FloatingPosition& position,
                           const analysis::ProjectDimensions& project, double water_density,
                           const ShiftSettings& settings, const TransformLimits& limits)
    : hull_(body, position),
      project_(project),
      water_density_(water_density),
      reshape_(hull_.surface(), limits),
      functions_(with_length(settings, project), hull_, reshape_.places()) {
  // Cb stands on the draft of the project or, where that is not given, on that of the water.
  if (!(project_.draft > 0.0)) project_.draft = position.draft;
  slopes_ = slopes_along(functions_, reshape_.places());
  // Moves are linear in the coefficients: with those of each function alone no step of the solver
  // has equations to solve.
  for (int k = 0; k < functions_.count(); ++k) {
    units_.push_back(shift_by([&](double x) { return functions_.value(k, x); }));
  }
  if (functions_.changes_parallel_body()) {
    parallel_ = shift_by([&](double x) { return functions_.parallel_change(x); });
  } else {
    parallel_.wanted.at_places.assign(reshape_.places().count(), Vector3d::Zero());
    parallel_.moves.assign(hull_.points().size(), Vector3d::Zero());
  }
  midship_area_ = hull_.section_area(0.5 * project_.length_pp);
}

double SectionShift::per_volume(VolumeMeasure measure) const {
  const double length = project_.length_pp;
  switch (measure) {
    case VolumeMeasure::kVolume:
      return 1.0;
    case VolumeMeasure::kDisplacement:
      return water_density_;
    case VolumeMeasure::kBlock:
      return 1.0 / (length * dimension(project_.beam, "beam", "Cb") *
                    dimension(project_.draft, "draft", "Cb"));
    case VolumeMeasure::kPrismatic:
      if (midship_area_ > 0.0) return 1.0 / (length * midship_area_);
      throw std::invalid_argument(
          "The hull has no area under water at half the Lpp, which Cp stands on: correct the Lpp, "
          "or give Cb.");
  }
  return 1.0;
}

SectionShift::Shift SectionShift::shift_by(const std::function<double(double x)>& function) const {
  LongitudinalReshape::Wanted wanted = reshape_.wanted(function);
  std::vector<Vector3d> moves = reshape_.moves(wanted);
  return {std::move(wanted), std::move(moves)};
}

std::vector<Vector3d> SectionShift::moves(const std::vector<double>& coefficients) const {
  std::vector<Vector3d> sum = parallel_.moves;
  for (std::size_t k = 0; k < units_.size(); ++k) add(coefficients[k], units_[k].moves, sum);
  return sum;
}

bool SectionShift::is_sound(const std::vector<double>& coefficients) const {
  // Sections that overtake one another are told by the functions alone, before all cells are
  // looked at.
  if (!(ShiftFunctions::least_stretch(slopes_, coefficients) > 0.0)) return false;
  std::vector<Vector3d> points = moves(coefficients);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += hull_.points()[i];
  return reshape_.places().first_fold(points) < 0;
}

SectionsShifted SectionShift::outcome(const std::vector<double>& coefficients) {
  SectionsShifted result;
  result.moves = moves(coefficients);
  LongitudinalReshape::Wanted wanted{parallel_.wanted.at_places, {}};
  for (std::size_t k = 0; k < units_.size(); ++k) {
    add(coefficients[k], units_[k].wanted.at_places, wanted.at_places);
  }
  const Residual left = reshape_.residual(result.moves, wanted);
  result.coefficients = coefficients;
  result.rms = left.rms;
  result.largest = left.largest;
  result.largest_place = reshape_.places().position(left.largest_place);
  // The solver may have left the hull at a step that was not taken.
  hull_.move(result.moves);
  const analysis::Immersion& immersion = hull_.immersion();
  result.volume = immersion.volume;
  result.lcb = immersion.centre_of_buoyancy.x();
  result.iterations = 0;
  result.converged = true;
  return result;
}

SectionsShifted SectionShift::shifted(const std::vector<double>& coefficients) {
  if (static_cast<int>(coefficients.size()) != functions_.count()) {
    throw std::invalid_argument("There must be " + std::to_string(functions_.count()) +
                                " coefficients, not " + std::to_string(coefficients.size()) + ".");
  }
  if (!std::ranges::all_of(coefficients, [](double c) { return std::isfinite(c); }) ||
      !is_sound(coefficients)) {
    throw std::invalid_argument(
        "Sections would overtake one another, or the surface fold, with so large a shift: make the "
        "coefficients smaller.");
  }
  return outcome(coefficients);
}

SectionsShifted SectionShift::solve(const FormTargets& targets) {
  Solver solver(*this, targets);
  const std::vector<double> coefficients = solver.solve();
  SectionsShifted result = outcome(coefficients);
  result.iterations = solver.iterations();
  result.converged = solver.converged();
  return result;
}

}  // namespace hull::modelling
