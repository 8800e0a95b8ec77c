// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit_feet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/fairness/cell_places.h"
#include "modelling/fit/even_ranges.h"
#include "modelling/fit/fit_rows.h"
#include "surface/queries/closest_point.h"

namespace hull::modelling::fit_internal {
namespace {

// Of the size: nearer targets are on the surface, and p - foot has no direction but that of
// rounding, which must not choose among the sides of a crease or leave out a target on the border.
constexpr double kOnSurface = 1e-10;
// Cosine of the angle between p - foot and the normal: below, a target beyond the border is there
// because the surface ends too early, not because it lies off the surface.
constexpr double kAcross = 0.7;
// Cosine of the largest angle between the normals of target and surface.
constexpr double kSameSide = 0.5;

bool is_on_border(const mesh::Topology& cells, const surface::CellPlace& at) {
  // In the order of the cell's half-edges, and exact: feet on an edge have its 0 or 1.
  const bool sides[] = {at.v == 0.0, at.u == 1.0, at.v == 1.0, at.u == 0.0};
  for (int k = 0; k < 4; ++k) {
    if (sides[k] && cells.twin(4 * at.cell + k) < 0) return true;
  }
  return false;
}

// What a foot on a crease or border is like, from whichever of the cells that meet there it was
// found.
struct Rim {
  bool border = false;
  Vector3d normal = Vector3d::Zero();
};

// The normal is that of these cells' which is most along p - foot, `off`, or most that of the
// target where it has one, `wanted`; else where p - foot has no direction that of the first cell.
Rim rim_at(const surface::LimitSurface& surface, const surface::ClosestPoint& at,
           const Vector3d& off, const Vector3d* wanted, bool on_surface) {
  const auto agreement = [&](const Vector3d& normal) {
    if (wanted) return normal.dot(*wanted);
    return on_surface ? 0.0 : std::abs(normal.dot(off));
  };
  analysis::CellPlaces places =
      analysis::cell_places(surface.cells(), at.cell, Eigen::Vector2d(at.u, at.v));
  // In an order that does not depend on the cell the foot was found in, as the first of equals is
  // taken.
  std::ranges::sort(places, {}, &surface::CellPlace::cell);
  Rim rim;
  double most = -std::numeric_limits<double>::infinity();
  for (const surface::CellPlace& place : places) {
    rim.border = rim.border || is_on_border(surface.cells(), place);
    const Vector3d normal = surface.normal(place.cell, place.u, place.v);
    const double here = agreement(normal);
    if (here <= most) continue;
    most = here;
    rim.normal = normal;
  }
  return rim;
}

Foot foot_of(const surface::LimitSurface& surface, const surface::ClosestPoint& at,
             const Vector3d& target, const Vector3d* normal, double on_surface, bool draw_border) {
  if (at.cell < 0) return {};
  const Vector3d off = target - at.point;
  const bool is_on = at.distance <= on_surface;
  Vector3d own = surface.normal(at.cell, at.u, at.v);
  const bool smooth = at.kind == surface::FootKind::kSmooth && !own.isZero();
  Rim rim;
  if (!smooth) {
    rim = rim_at(surface, at, off, normal, is_on);
    own = rim.normal;
  }
  if (normal && own.dot(*normal) < kSameSide * normal->norm()) return {};
  Foot foot{at.cell, at.u, at.v, at.point, own, off.dot(own)};
  if (is_on || smooth) return foot;
  if (!draw_border && rim.border) {
    // Across the surface only, so that the border is not drawn out by and by.
    return std::abs(foot.distance) > kAcross * at.distance ? foot : Foot{};
  }
  // The whole of p - foot, not its part across the surface alone; direction times distance is p -
  // foot for either sign.
  const double sign = foot.distance < 0.0 ? -1.0 : 1.0;
  foot.direction = sign * off / at.distance;
  foot.distance = sign * at.distance;
  return foot;
}

}  // namespace

Feet find_feet(const surface::LimitSurface& surface, const surface::SurfaceTree& tree,
               const FitTarget& target, const FitOptions& options) {
  Feet feet;
  feet.all.resize(target.points.size());
  const double on_surface = kOnSurface * tree.error_size();
  for_even_ranges(target.points.size(), [&](std::size_t begin, std::size_t end) {
    const std::vector<Vector3d> some(target.points.begin() + static_cast<std::ptrdiff_t>(begin),
                                     target.points.begin() + static_cast<std::ptrdiff_t>(end));
    const std::vector<surface::ClosestPoint> closest =
        surface::closest_points(tree, some, options.reach);
    for (std::size_t i = begin; i < end; ++i) {
      feet.all[i] = foot_of(surface, closest[i - begin], target.points[i],
                            target.normals.empty() ? nullptr : &target.normals[i], on_surface,
                            options.draw_border);
    }
  });
  // By one thread in the targets' order, so that sums are the same however many threads found the
  // feet.
  double sum = 0.0;
  for (std::size_t i = 0; i < feet.all.size(); ++i) {
    if (feet.all[i].cell < 0) continue;
    const double weight = target.weights.empty() ? 1.0 : target.weights[i];
    feet.weight += weight;
    sum += weight * feet.all[i].distance * feet.all[i].distance;
  }
  if (feet.weight > 0.0) feet.mean_square = sum / feet.weight;
  return feet;
}

void add_feet(const Feet& feet, const FitTarget& target, const surface::LimitSurface& surface,
              const surface::PieceWeights& pieces, FitEquations& equations) {
  if (!(feet.weight > 0.0)) return;
  std::vector<FitRow> rows;
  rows.reserve(feet.all.size());
  for (std::size_t i = 0; i < feet.all.size(); ++i) {
    const Foot& foot = feet.all[i];
    if (foot.cell < 0) continue;
    const double weight = (target.weights.empty() ? 1.0 : target.weights[i]) / feet.weight;
    rows.push_back({foot.cell, foot.u, foot.v, foot.direction, foot.distance, weight});
  }
  add_rows(rows, surface, pieces, equations);
}

}  // namespace hull::modelling::fit_internal
