// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hull_body.h"

#include <cmath>
#include <stdexcept>

namespace hull {
namespace {

// Of the mesh's size, or of its powers.
constexpr double kZeroHeight = 1e-13;
constexpr double kCornerFirst = 1e-14;    // per irregular corner
constexpr double kAreaTolerance = 1e-12;  // per span
constexpr double kCornerArea = 1e-11;     // per irregular corner
constexpr double kSmallestCorner = 1e-9;  // beyond it a corner cut by the water is left out

// What water does to a body whose shell has these moments below it, all about one origin.
Immersion immersion_of(const ShellMoments& wet, const Plane& water) {
  const Vector3d& e = water.normal;
  const double d = water.offset;
  const double area = wet.normal.dot(e);                          // ∫ e·n
  const Vector3d first = wet.first * e;                           // ∫ p e·n
  const Eigen::Matrix3d second = wet.second_along(e);             // ∫ p pᵀ e·n
  const double height = e.dot(first) - d * area;                  // ∫ h e·n
  const Vector3d height_first = second * e - d * first;           // ∫ p h e·n
  const double height_square = e.dot(height_first) - d * height;  // ∫ h² e·n

  Immersion result;
  result.water = water;
  result.volume = height;
  if (height > 0.0) {
    result.centre_of_buoyancy = (height_first - 0.5 * height_square * e) / height;
  }
  result.wetted_surface = wet.area;
  result.waterplane_area = -area;
  if (area < 0.0) {
    // Of the waterplane's points q = p - h e.
    const Vector3d moment = e * height - first;
    const Eigen::Matrix3d about_origin = height_first * e.transpose() +
                                         e * height_first.transpose() - second -
                                         e * e.transpose() * height_square;
    result.centre_of_flotation = moment / -area;
    result.waterplane_second = about_origin - moment * result.centre_of_flotation.transpose();
  }
  result.flux_forms = wet.first.diagonal();
  result.volume_error = wet.cut_error;
  result.wetted_surface_error = wet.area_error;
  return result;
}

Plane mirror_image(const Plane& plane) {
  return {plane.normal.cwiseProduct(Vector3d(1.0, -1.0, 1.0)), plane.offset};
}

}  // namespace

HullBody::HullBody(const LimitSurface& surface, bool mirrored)
    : surface_(&surface), mirrored_(mirrored) {
  const SurfaceLayout& layout = surface.layout();
  for (int i = 0; i < layout.corner_count(); ++i) {
    const CornerBasis& basis = layout.basis(i);
    if (!series_.contains(&basis)) series_.emplace(&basis, CornerSeries(basis));
  }
  update();
}

const CornerSeries& HullBody::series(int corner) const {
  return series_.at(&surface_->layout().basis(corner));
}

HullBody::Box HullBody::box_of(const Vector3d* points, std::size_t count, const Vector3d& centre) {
  Vector3d low = points[0], high = points[0];
  for (std::size_t i = 1; i < count; ++i) {
    low = low.cwiseMin(points[i]);
    high = high.cwiseMax(points[i]);
  }
  return {0.5 * (low + high) - centre, 0.5 * (high - low)};
}

void HullBody::update() {
  const LimitSurface& surface = *surface_;
  const SurfaceLayout& layout = surface.layout();
  const double size = surface.mesh().size();
  const Box all =
      box_of(surface.mesh().points().data(), surface.mesh().points().size(), Vector3d::Zero());
  centre_ = mirrored_ ? Vector3d(all.middle.x(), 0.0, all.middle.z()) : all.middle;
  corner_tolerance_ = {kCornerFirst * size * size * size, kCornerArea * size * size};
  cut_tolerance_ = {kZeroHeight * size, kAreaTolerance * size * size};

  leaf_boxes_.resize(layout.leaf_count());
  leaf_moments_.resize(layout.leaf_count());
  for (int i = 0; i < layout.leaf_count(); ++i) {
    const BicubicPoints& points = surface.leaf(i);
    leaf_boxes_[i] = box_of(points.data(), points.size(), centre_);
    leaf_moments_[i] = span_moments({points, centre_}, SpanRule::kExact, cut_tolerance_.area);
  }
  corner_boxes_.resize(layout.corner_count());
  corner_moments_.resize(layout.corner_count());
  for (int i = 0; i < layout.corner_count(); ++i) {
    const CornerBasis& basis = layout.basis(i);
    const std::vector<Vector3d>& points = surface.corner(i).squares.front();
    corner_boxes_[i] = box_of(points.data(), points.size(), centre_);
    CornerRing ring(basis, surface.corner(i));
    corner_moments_[i] = corner_moments(ring, basis, series(i), centre_, corner_tolerance_);
  }
}

// The part of a corner's square below the water, which crosses the hull of its control points.
ShellMoments HullBody::wet_corner(int corner, const Plane& water) const {
  const CornerBasis& basis = surface_->layout().basis(corner);
  const double smallest = kSmallestCorner * surface_->mesh().size();
  ShellMoments sum;
  for (CornerRing ring(basis, surface_->corner(corner));; ring.advance()) {
    const std::vector<Vector3d> points = ring.points();
    double lowest = water.height(points[0]), highest = lowest;
    for (const Vector3d& p : points) {
      lowest = std::min(lowest, water.height(p));
      highest = std::max(highest, water.height(p));
    }
    if (lowest > -cut_tolerance_.zero) return sum;
    if (highest < -cut_tolerance_.zero) {
      sum += corner_moments(ring, basis, series(corner), centre_, corner_tolerance_);
      return sum;
    }
    const Box box = box_of(points.data(), points.size(), centre_);
    if (box.half.norm() < smallest) return sum;
    for (int s = 0; s < basis.segment_count(); ++s) {
      sum += wet_moments(ring.segment_points(s), centre_, water, cut_tolerance_);
    }
  }
}

ShellMoments HullBody::wet_part(const Plane& water) const {
  const Plane from_centre{water.normal, water.height(centre_) * -1.0};
  const Vector3d extent = water.normal.cwiseAbs();
  ShellMoments sum;
  for (std::size_t i = 0; i < leaf_boxes_.size(); ++i) {
    const double height = from_centre.height(leaf_boxes_[i].middle);
    const double half = extent.dot(leaf_boxes_[i].half) + cut_tolerance_.zero;
    if (height >= half) continue;
    if (height < -half) {
      sum += leaf_moments_[i];
    } else {
      sum += wet_moments(surface_->leaf(static_cast<int>(i)), centre_, water, cut_tolerance_);
    }
  }
  for (std::size_t i = 0; i < corner_boxes_.size(); ++i) {
    const double height = from_centre.height(corner_boxes_[i].middle);
    const double half = extent.dot(corner_boxes_[i].half) + cut_tolerance_.zero;
    if (height >= half) continue;
    if (height < -half) {
      sum += corner_moments_[i];
    } else {
      sum += wet_corner(static_cast<int>(i), water);
    }
  }
  return sum;
}

Immersion HullBody::immersion(const Plane& water) const {
  if (!water.normal.allFinite() || !std::isfinite(water.offset)) {
    throw std::invalid_argument("The water's surface must be given by finite numbers.");
  }
  ShellMoments wet = wet_part(water);
  if (mirrored_) {
    const bool even = water.normal.y() == 0.0;
    wet += hull::mirrored(even ? wet : wet_part(mirror_image(water)));
  }
  // About a point in the water's surface, where heights do not cancel.
  const double level = -water.height(centre_);
  Immersion result = immersion_of(moved(wet, -level * water.normal), {water.normal, 0.0});
  const Vector3d origin = centre_ + level * water.normal;
  result.water = water;
  if (result.volume > 0.0) result.centre_of_buoyancy += origin;
  if (result.waterplane_area > 0.0) result.centre_of_flotation += origin;
  return result;
}

}  // namespace hull
