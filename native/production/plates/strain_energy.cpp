// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/strain_energy.h"

#include <algorithm>
#include <cmath>

#include "production/plates/strained_sheet.h"

namespace hull::production {

namespace {

// Steps with turns held, which find the way from any start, before those of Gauss and Newton.
constexpr int kFirstSteps = 8, kMostIterations = 150;
// Strains in the mean that are none.
constexpr double kNoStrain = 1e-10;
// Steps that gain less than this part of the energy end the search: stretches change by half of it.
constexpr double kSmallGain = 1e-10;
// A matrix serves further steps as long as each promises no more than this part of the last's gain.
constexpr double kFalls = 1e-2;

}  // namespace

Vector2d SheetMap::place(const Vector3d& point) const {
  const SheetSplines::Values at = splines.at(chart.value(point).at);
  Vector2d sum = Vector2d::Zero();
  for (int k = 0; k < SheetSplines::kOnPoint; ++k) {
    if (at.functions[k] >= 0) sum += at.values[k] * coefficients[at.functions[k]];
  }
  return sum;
}

Eigen::Matrix2d SheetMap::slopes(const PlatePoint& point) const {
  const PlateChart::Value in_chart = chart.value(point.at);
  const SheetSplines::Values at = splines.at(in_chart.at);
  Eigen::Matrix2d f = Eigen::Matrix2d::Zero();
  for (int k = 0; k < SheetSplines::kOnPoint; ++k) {
    if (at.functions[k] >= 0) f += coefficients[at.functions[k]] * at.slopes.row(k);
  }
  // By the chain rule: spline by chart, chart by point, point by lengths along the tangents.
  return f * (in_chart.slopes * point.tangents);
}

LeastEnergy make_energy_least(SheetMap& map, const std::vector<PlatePoint>& points, double poisson,
                              bool is_near) {
  StrainedSheet sheet(map.chart, map.splines, points, poisson);
  for (int i = 0; i < (is_near ? 0 : kFirstSteps); ++i)
    map.coefficients = sheet.with_turns_held(map.coefficients);
  LeastEnergy found;
  found.energy = sheet.energy(map.coefficients);
  double damping = 0.0, promised = 0.0;
  const double none = kNoStrain * kNoStrain * sheet.area();
  while (found.iterations < kMostIterations && !found.converged) {
    ++found.iterations;
    const Eigen::VectorXd downhill = sheet.downhill(map.coefficients);
    Eigen::VectorXd steps;
    // Near the end the matrix hardly changes, and is most of the work.
    if (promised > 0.0) steps = sheet.step(downhill);
    const bool is_fresh = !(promised > 0.0) || downhill.dot(steps) > kFalls * promised;
    if (is_fresh) {
      sheet.set_matrix(map.coefficients, damping);
      steps = sheet.step(downhill);
    }
    promised = downhill.dot(steps);
    std::vector<Vector2d> tried = map.coefficients;
    for (std::size_t i = 0; i < tried.size(); ++i) tried[i] += steps.segment<2>(2 * i);
    // The energy need not fall by rounding: a small change either way is the end.
    const double energy = sheet.energy(tried), change = std::abs(energy - found.energy);
    found.converged = change <= kSmallGain * found.energy + none;
    if (energy <= found.energy) {
      found.energy = energy;
      map.coefficients = std::move(tried);
      // A matrix with damping does not serve again: without it the next step is longer.
      if (damping > 0.0) promised = 0.0;
      damping = damping < 1e-8 ? 0.0 : 0.1 * damping;
    } else {
      promised = 0.0;
      // An old matrix is no reason to damp: a fresh one comes first.
      if (is_fresh) damping = std::max(10.0 * damping, 1e-4);
    }
  }
  return found;
}

}  // namespace hull::production
