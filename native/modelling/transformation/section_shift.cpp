// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/section_shift.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "modelling/transformation/shift_solver.h"

namespace hull::modelling {
namespace {

ShiftSettings with_length(ShiftSettings settings, const analysis::ProjectDimensions& project) {
  settings.length_pp = project.length_pp;
  return settings;
}

Eigen::MatrixXd slopes_along(const ShiftFunctions& functions, const SurfacePlaces& places) {
  double from = INFINITY, to = -INFINITY;
  for (int k = 0; k < places.count(); ++k) {
    from = std::min(from, places.position(k).x());
    to = std::max(to, places.position(k).x());
  }
  return functions.slopes(from, to);
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
  if (!(project_.draft > 0.0)) project_.draft = position.draft;
  slopes_ = slopes_along(functions_, reshape_.places());
  for (int k = 0; k < functions_.count(); ++k) {
    unit_moves_.push_back(reshape_.moves([&](double x) { return functions_.value(k, x); }));
  }
  if (functions_.changes_parallel_body()) {
    parallel_moves_ = reshape_.moves([&](double x) { return functions_.parallel_change(x); });
  } else {
    parallel_moves_.assign(hull_.points().size(), Vector3d::Zero());
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
      return 1.0 / (length * dimension(midship_area_, "Lpp", "Cp"));
  }
  return 1.0;
}

std::vector<Vector3d> SectionShift::moves(const std::vector<double>& coefficients) const {
  std::vector<Vector3d> sum = parallel_moves_;
  for (std::size_t k = 0; k < unit_moves_.size(); ++k) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += coefficients[k] * unit_moves_[k][i];
  }
  return sum;
}

bool SectionShift::is_sound(const std::vector<double>& coefficients) const {
  if (!(ShiftFunctions::least_stretch(slopes_, coefficients) > 0.0)) return false;
  std::vector<Vector3d> points = moves(coefficients);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += hull_.points()[i];
  return reshape_.places().first_fold(points) < 0;
}

SectionsShifted SectionShift::outcome(const std::vector<double>& coefficients) {
  SectionsShifted result;
  result.moves = moves(coefficients);
  const Reshaped reshaped = reshape_.residual(result.moves, [&](double x) {
    double sum = functions_.parallel_change(x);
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      sum += coefficients[k] * functions_.value(static_cast<int>(k), x);
    }
    return sum;
  });
  result.coefficients = coefficients;
  result.rms = reshaped.rms;
  result.largest = reshaped.largest;
  result.largest_place = reshape_.places().position(reshaped.largest_place);
  hull_.move(result.moves);
  const analysis::Immersion immersion = hull_.immersion();
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
