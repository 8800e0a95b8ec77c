// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/derivatives/body_derivatives.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/derivatives/closing_derivatives.h"
#include "analysis/derivatives/corner_derivatives.h"
#include "analysis/derivatives/span_derivatives.h"
#include "analysis/stations/station_cutter.h"
#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

using namespace immersed_number;

// Of the mesh's size: squares at irregular knots that the water does not cut are left out below,
// which have the square of it of the body's surface.
constexpr double kSmallestWhole = 1e-6;

const Vector3d kMirror(1.0, -1.0, 1.0);

// By the numbers' powers of y: what their mirror image counts for.
constexpr double kImageSigns[kCount] = {1, 1, -1, 1, 1, 1, 1, -1, 1, 1, 1, 1, -1, -1, 1};

double extent_of(const std::vector<Vector3d>& points) {
  double farthest = 0.0;
  for (const Vector3d& p : points) farthest = std::max(farthest, (p - points[0]).squaredNorm());
  return std::sqrt(farthest);
}

struct Heights {
  double low, high;
};

template <class Points>
Heights heights_of(const Points& points, const Plane& plane) {
  Heights range{plane.height(points[0]), plane.height(points[0])};
  for (const Vector3d& p : points) {
    range.low = std::min(range.low, plane.height(p));
    range.high = std::max(range.high, plane.height(p));
  }
  return range;
}

Gradient number(const PointColumns& columns, int index, double factor) {
  return factor * columns.middleCols<3>(3 * static_cast<Eigen::Index>(index));
}

// What is wholly below the water, its parts too whatever rounding does, has nothing to do with the
// waterplane.
Eigen::Index columns_for(const Heights& range, const ImmersionFrame& frame) {
  return 3 * (range.high < -2.0 * frame.zero ? kSubmerged : kCount);
}

// As the points of the port side move, those of starboard move as mirror images.
PointColumns image(PointColumns columns, const double* signs) {
  for (Eigen::Index k = 0; k < columns.cols() / 3; ++k) columns.middleCols<3>(3 * k) *= signs[k];
  return columns;
}

}  // namespace

BodyDerivatives::BodyDerivatives(const HullBody& body) : body_(&body), adjoint_(body.surface()) {}

ImmersionDerivatives BodyDerivatives::immersion(const Immersion& immersion) const {
  const Plane& water = immersion.water;
  PointColumns numbers = immersed_numbers(water, immersion, false);
  if (body_->mirrored()) {
    // Upright both sides have the same integrals. Heeled the image is in the water as the side
    // would be in the mirrored water.
    const bool upright = water.normal.y() == 0.0;
    const Plane mirrored{water.normal.cwiseProduct(kMirror), water.offset};
    numbers += image(upright ? numbers : immersed_numbers(mirrored, immersion, true), kImageSigns);
  }
  ImmersionDerivatives result;
  result.volume = number(numbers, kVolume, 1.0);
  result.wetted_surface = number(numbers, kWettedSurface, 1.0);
  result.waterplane_area = number(numbers, kWaterplaneArea, 1.0);
  // Moments are counted from the centres. So a change of the volume does not move its centre by
  // itself, nor the shift of the centre of flotation change second moments, to first order.
  const double by_volume = immersion.volume > 0.0 ? 1.0 / immersion.volume : 0.0;
  const double by_area = immersion.waterplane_area > 0.0 ? 1.0 / immersion.waterplane_area : 0.0;
  for (int k = 0; k < 3; ++k) {
    result.centre_of_buoyancy[k] = number(numbers, kFirst + k, by_volume);
    result.centre_of_flotation[k] = number(numbers, kWaterplaneFirst + k, by_area);
  }
  for (int k = 0; k < 6; ++k) {
    result.waterplane_second[k] = number(numbers, kWaterplaneSecond + k, 1.0);
  }
  return result;
}

// Of the modelled side; of the image: as it is seen in the mirror, before signs are turned.
PointColumns BodyDerivatives::immersed_numbers(const Plane& water, const Immersion& immersion,
                                               bool is_image) const {
  const surface::LimitSurface& surface = body_->surface();
  const surface::SurfaceLayout& layout = surface.layout();
  const double size = surface.mesh().size();
  const Vector3d mirror = is_image ? kMirror : Vector3d::Ones();
  const ImmersionFrame frame{water, mirror.cwiseProduct(immersion.centre_of_buoyancy),
                             mirror.cwiseProduct(immersion.centre_of_flotation),
                             kZeroHeight * size};
  SurfaceAdjoint::Sum sum(adjoint_, kCount);
  for (int leaf = 0; leaf < layout.leaf_count(); ++leaf) {
    const surface::BicubicPoints& points = surface.leaf(leaf);
    const Heights range = heights_of(points, water);
    if (range.low > -frame.zero) continue;
    PointColumns columns = PointColumns::Zero(16, columns_for(range, frame));
    add_immersion_derivatives(points, frame, SpanRule::kExact, columns);
    sum.add_leaf(leaf, std::move(columns));
  }
  for (int corner = 0; corner < layout.corner_count(); ++corner) {
    bool is_outer = true;
    const auto goes_on = [&](const std::vector<Vector3d>& points) {
      const Heights range = heights_of(points, water);
      const double smallest = range.high < -frame.zero ? kSmallestWhole : kSmallestCorner;
      return range.low <= -frame.zero && extent_of(points) >= smallest * size;
    };
    const surface::CornerPoints& points = surface.corner(corner);
    if (!goes_on(points.outer)) continue;
    int spans = 0;
    const auto add_span = [&](const surface::BicubicPoints& span, PointColumns& columns) {
      // Each ring is half as large as the one before: behind the first fewer nodes will do.
      is_outer = spans++ < layout.basis(corner).segment_count();
      add_immersion_derivatives(span, frame, is_outer ? SpanRule::kExact : SpanRule::kSmall,
                                columns);
    };
    sum.add_corner(corner, corner_derivatives(layout.basis(corner), points,
                                              columns_for(heights_of(points.outer, water), frame),
                                              goes_on, add_span));
  }
  add_closing_derivatives(
      body_->border(), body_->closings(), kCount,
      [&](const surface::BicubicPoints& points, PointColumns& columns) {
        add_immersion_derivatives(points, frame, SpanRule::kExact, columns);
        // Closings are not wetted.
        columns.middleCols<3>(3 * kWettedSurface).setZero();
      },
      sum);
  return sum.by_control_points();
}

Gradient BodyDerivatives::section_area(double position, const Plane& water) const {
  if (!std::isfinite(position)) {
    throw std::invalid_argument("The station's position must be a finite number.");
  }
  body_->border();  // refuses a body that is out of date
  if (StationCutter(*body_).distance_of_flats(position)) {
    throw std::invalid_argument("At the station x = " + std::to_string(position) +
                                " m a flat or a border lies across the ship, where the area "
                                "jumps: choose a station beside it.");
  }
  const Plane station{Vector3d::UnitX(), position};
  PointColumns columns = section(station, water);
  if (body_->mirrored()) {
    const Plane mirrored{water.normal.cwiseProduct(kMirror), water.offset};
    // Areas are even in y: the image's derivatives keep their signs.
    columns += water.normal.y() == 0.0 ? PointColumns(columns) : section(station, mirrored);
  }
  return columns;
}

PointColumns BodyDerivatives::section(const Plane& station, const Plane& water) const {
  const surface::LimitSurface& surface = body_->surface();
  const surface::SurfaceLayout& layout = surface.layout();
  const double size = surface.mesh().size();
  SurfaceAdjoint::Sum sum(adjoint_, 1);
  const auto reaches = [&](const auto& points) {
    const Heights range = heights_of(points, station);
    return range.low < 0.0 && range.high >= 0.0 && heights_of(points, water).low < 0.0;
  };
  const auto add_span = [&](const surface::BicubicPoints& points, PointColumns& columns) {
    if (reaches(points)) add_section_derivatives(points, station, water, size, columns);
  };
  for (int leaf = 0; leaf < layout.leaf_count(); ++leaf) {
    if (!reaches(surface.leaf(leaf))) continue;
    PointColumns columns = PointColumns::Zero(16, 3);
    add_span(surface.leaf(leaf), columns);
    sum.add_leaf(leaf, std::move(columns));
  }
  for (int corner = 0; corner < layout.corner_count(); ++corner) {
    const auto goes_on = [&](const std::vector<Vector3d>& points) {
      return reaches(points) && extent_of(points) >= kSmallestCorner * size;
    };
    const surface::CornerPoints& points = surface.corner(corner);
    if (!goes_on(points.outer)) continue;
    sum.add_corner(corner, corner_derivatives(layout.basis(corner), points, 3, goes_on, add_span));
  }
  add_closing_derivatives(body_->border(), body_->closings(), 1, add_span, sum);
  return sum.by_control_points();
}

}  // namespace hull::analysis
