// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/inflation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace hull::modelling {
namespace {

// Of a normal's part across the ship: below, the shift fades.
constexpr double kLeastAcross = 0.2;
constexpr double kMet = 1e-10;
constexpr int kMostInflations = 20;

ReshapeOptions staying(const TransformLimits& limits) {
  ReshapeOptions options;
  options.limits.limits = limits.limits;
  options.limits.tied = limits.tied;
  options.limits.kept = limits.kept;
  for (const std::vector<int>& group : limits.rigid) {
    options.limits.limits.locked.insert(options.limits.limits.locked.end(), group.begin(),
                                        group.end());
  }
  return options;
}

// 1 at 0, 0 from 1 on, with two derivatives that vanish there.
double bump(double distance) {
  const double rest = 1.0 - distance * distance;
  return rest > 0.0 ? rest * rest * rest : 0.0;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

NormalReshape::NormalReshape(const surface::LimitSurface& surface, const TransformLimits& limits)
    : reshape_(surface, staying(limits)) {
  for (int k = 0; k < places().count(); ++k) {
    Vector3d across = places().normal(k);
    across.x() = 0.0;
    // Of length 1 where the surface runs along the ship, shorter and shorter the more it is across.
    directions_.push_back(across / std::max(across.norm(), kLeastAcross));
  }
}

Reshaped NormalReshape::solve(const std::function<double(double x)>& amount) const {
  std::vector<Vector3d> shifts(directions_.size());
  for (int k = 0; k < places().count(); ++k) {
    shifts[k] = amount(places().position(k).x()) * directions_[k];
  }
  return reshape_.solve(shifts);
}

Inflated inflate(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                 double place, double area, double extent, const TransformLimits& limits) {
  if (!(area > 0.0) || !std::isfinite(area)) {
    throw std::invalid_argument("Give an area above zero for the section.");
  }
  if (!std::isfinite(place) || !(extent > 0.0)) {
    throw std::invalid_argument("Give a place, and an extent above zero.");
  }
  WorkingHull hull(body, position);
  const analysis::SectionArea section = hull.sections({place}).front();
  if (!(section.area > 0.0)) {
    throw std::invalid_argument("Nothing of the section at x = " + number(place) +
                                " m is immersed: give a place where something is.");
  }
  const NormalReshape reshape(hull.surface(), limits);
  const std::function<double(double)> share = [&](double x) {
    return std::isfinite(extent) ? bump((x - place) / extent) : 1.0;
  };
  Inflated result{};
  // Nothing is prescribed, so moves are in proportion to the amount: one solution serves all.
  const Reshaped unit = reshape.solve(share);
  const auto moved = [&](double amount) {
    std::vector<Vector3d> moves = unit.moves;
    for (Vector3d& move : moves) move *= amount;
    return moves;
  };
  const auto refuse = [&] {
    throw std::invalid_argument("The section at x = " + number(place) + " m, of " +
                                number(section.area) + " m² now, cannot be brought to " +
                                number(area) +
                                " m²: the surface would fold, or what is kept "
                                "leaves no room.");
  };
  // A secant of exact areas: the girth is the slope where nothing is kept.
  double before = 0.0, area_before = section.area;
  double amount = (area - section.area) / section.girth, found = area_before;
  for (; result.iterations < kMostInflations; ++result.iterations) {
    std::vector<Vector3d> points = moved(amount);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += hull.points()[i];
    if (!std::isfinite(amount) || reshape.places().first_fold(points) >= 0) refuse();
    hull.move(moved(amount));
    found = hull.section_area(place);
    // Beyond what counts as met, so that it is met whatever is rounded afterwards.
    if (std::abs(found - area) <= 0.01 * kMet * area) break;
    const double slope = (found - area_before) / (amount - before);
    if (amount != before && !(slope > 0.0)) break;  // rounding, or nothing that moves
    before = amount;
    area_before = found;
    amount += (area - found) / slope;
    if (amount == before) break;
  }
  result.converged = std::abs(found - area) <= kMet * area;
  if (!result.converged) refuse();
  result.moves = moved(amount);
  result.amount = amount;
  result.area = found;
  result.rms = std::abs(amount) * unit.rms;
  result.largest = std::abs(amount) * unit.largest;
  result.largest_place = reshape.places().position(unit.largest_place);
  return result;
}

}  // namespace hull::modelling
