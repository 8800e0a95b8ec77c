// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/derivatives/form_numbers.h"
#include "analysis/stations/station_cutter.h"

namespace hull::analysis {
namespace {

// Of the size: farthest points of the immersed part so near to the water are on the waterline.
constexpr double kOnWater = 1e-9;
// Of a place's distance from a side of its cell, in (u, v): on it.
constexpr double kOnSide = 1e-12;

// Of waterplane_second for q qᵀ.
constexpr int kSecond[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

// The crease or border of its cell that a place is on, or -1.
int crease_at(const surface::LimitSurface& surface, int cell, const Eigen::Vector2d& uv) {
  const double away[] = {uv.y(), 1.0 - uv.x(), 1.0 - uv.y(), uv.x()};
  for (int side = 0; side < 4; ++side) {
    if (away[side] <= kOnSide && surface.cells().is_crease(4 * cell + side)) return side;
  }
  return -1;
}

// A direction along the surface, or along its crease, in which it leaves the water's surface.
Vector3d out_of_water(const surface::LimitSurface& surface, const FarthestPoint& point,
                      const Vector3d& up) {
  const int side = crease_at(surface, point.cell, point.uv);
  if (side >= 0) {
    const surface::SurfaceJet jet = surface.evaluate(point.cell, point.uv.x(), point.uv.y(), 1);
    const Vector3d along = side % 2 == 0 ? jet.du : jet.dv;
    if (!along.isZero(0.0)) return along;
  }
  const Vector3d normal = surface.normal(point.cell, point.uv.x(), point.uv.y());
  // The steepest way up in the tangent plane.
  return up - up.dot(normal) * normal;
}

}  // namespace

const ImmersionDerivatives& FormNumbers::by_points() {
  if (!by_points_) by_points_ = derivatives_->immersion(immersion());
  return *by_points_;
}

Gradient FormNumbers::zero() const {
  return Gradient::Zero(derivatives_->adjoint().point_count(), 3);
}

Gradient FormNumbers::section_area_gradient(double position) {
  require_current();
  return derivatives_->section_area(position, water_);
}

Gradient FormNumbers::largest_section_gradient() {
  if (!(largest().area > 0.0)) return zero();
  const double position = largest().position;
  // A transom whose points do not move together is met at once by no station: the largest area then
  // falls, whichever way they went.
  if (StationCutter(derivatives_->body()).distance_of_flats(position)) {
    throw std::invalid_argument(
        "The largest section is a transom, or another flat or border across the ship, at x = " +
        std::to_string(position) +
        " m, where the area jumps: it has no derivatives, nor have coefficients by it. Ask for "
        "those by the midship section instead, or make a station beside it the largest.");
  }
  // The place where it is largest may move, which does not change it to first order.
  return section_area_gradient(position);
}

// Of the largest value of direction · p. On the waterline, h = 0 there, it is that of
// direction · p - λ h with the λ that makes it stationary across the water, too.
Gradient FormNumbers::farthest_gradient(const FarthestPoint& point, const Vector3d& direction,
                                        Part part) {
  const surface::LimitSurface& surface = derivatives_->body().surface();
  Vector3d slope = direction;
  if (part == Part::kWaterline ||
      std::abs(water_.height(point.point)) < kOnWater * surface.mesh().size()) {
    const Vector3d along = out_of_water(surface, point, water_.normal);
    const double rise = along.dot(water_.normal);
    if (rise != 0.0) slope -= along.dot(direction) / rise * water_.normal;
  }
  return derivatives_->adjoint().at(point.cell, point.uv, slope);
}

Gradient FormNumbers::extent_gradient(int axis, Part part) {
  const Extent& found = extent(axis, part);
  if (!found.high.found) return zero();
  const Vector3d direction = axis == 0 ? forward_direction(position_.trim, 0.0) : Vector3d::UnitY();
  const Gradient high = farthest_gradient(found.high, direction, part);
  // Athwartships, of a half: the image moves as far to the other side.
  if (!found.low.found) return 2.0 * high;
  return high + farthest_gradient(found.low, -direction, part);
}

Gradient FormNumbers::inertia_gradient(const Vector3d& direction) {
  Gradient sum = zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double factor = direction[i] * direction[j];
      if (factor != 0.0) sum += factor * by_points().waterplane_second[kSecond[i][j]];
    }
  }
  return sum;
}

Gradient FormNumbers::gradient(FormNumber number) {
  using N = FormNumber;
  require_current();
  const Immersion& now = immersion();
  const bool is_defined = now.volume > 0.0;
  if (!is_defined) return zero();
  const Vector3d ahead = forward_direction(position_.trim, 0.0);
  const double to_percent = project_.length_pp > 0.0 ? 100.0 / project_.length_pp : 0.0;
  switch (number) {
    case N::kDisplacedVolume:
      return by_points().volume;
    case N::kDisplacement:
      return density_ * by_points().volume;
    case N::kLcb:
      return by_points().centre_of_buoyancy[0];
    case N::kLcbPercent:
      return to_percent * by_points().centre_of_buoyancy[0];
    case N::kTcb:
      return by_points().centre_of_buoyancy[1];
    case N::kKb:
      return by_points().centre_of_buoyancy[2];
    case N::kWettedSurface:
      return by_points().wetted_surface;
    case N::kWaterplaneArea:
      return by_points().waterplane_area;
    case N::kLcf:
      return by_points().centre_of_flotation[0];
    case N::kLcfPercent:
      return to_percent * by_points().centre_of_flotation[0];
    case N::kTcf:
      return by_points().centre_of_flotation[1];
    case N::kWaterplaneInertiaTransverse:
      return inertia_gradient(Vector3d::UnitY());
    case N::kWaterplaneInertiaLongitudinal:
      return inertia_gradient(ahead);
    case N::kBmTransverse:
    case N::kBmLongitudinal: {
      const Vector3d direction = number == N::kBmTransverse ? Vector3d::UnitY() : ahead;
      // The quotient rule, with BM = I / ∇.
      return (inertia_gradient(direction) - value(number) * by_points().volume) / now.volume;
    }
    case N::kKmTransverse:
    case N::kKmLongitudinal: {
      // Wholly under water, there is no metacentre over a centre of buoyancy that there is.
      if (!(now.waterplane_area > 0.0)) return zero();
      const N bm = number == N::kKmTransverse ? N::kBmTransverse : N::kBmLongitudinal;
      return gradient(N::kKb) + water_.normal.z() * gradient(bm);
    }
    case N::kWaterlineLength:
      return extent_gradient(0, Part::kWaterline);
    case N::kWaterlineBeam:
      return extent_gradient(1, Part::kWaterline);
    case N::kImmersedLength:
      return extent_gradient(0, Part::kImmersed);
    case N::kImmersedBeam:
      return extent_gradient(1, Part::kImmersed);
    case N::kImmersedDraft:
      return immersed_draft() > 0.0
                 ? farthest_gradient(extents_[2][0]->low, -water_.normal, Part::kImmersed)
                 : zero();
    case N::kMidshipSectionArea:
      return project_.length_pp > 0.0 ? section_area_gradient(0.5 * project_.length_pp) : zero();
    case N::kLargestSectionArea:
      return largest_section_gradient();
    default:
      break;
  }
  const double whole = value(number);
  Gradient sum = zero();
  if (whole == 0.0) return sum;
  for (const auto& [term, power] : coefficient(number).terms) {
    // As in scaling(), by logarithms.
    sum += (power * whole / value(term)) * gradient(term);
  }
  return sum;
}

}  // namespace hull::analysis
