// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/hull_extents.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace hull::drawing {

namespace {

void extend_by_curves(Eigen::AlignedBox3d& box, const std::vector<ShipCurve>& curves,
                      const std::string& owner) {
  for (const ShipCurve& curve : curves) {
    if (curve.points.size() < 2) {
      throw std::invalid_argument("A curve of " + owner + " has less than two points");
    }
    for (const Eigen::Vector3d& point : curve.points) {
      if (!point.allFinite()) {
        throw std::invalid_argument("A point of " + owner + " is not a finite number");
      }
      box.extend(point);
    }
  }
}

void extend_by_family(Eigen::AlignedBox3d& box, const std::vector<NamedCurves>& family,
                      const std::string& kind) {
  for (const NamedCurves& member : family) {
    const std::string owner = kind + " \"" + member.label + "\"";
    if (!std::isfinite(member.position)) {
      throw std::invalid_argument("The position of " + owner + " is not a finite number");
    }
    extend_by_curves(box, member.curves, owner);
  }
}

void check_dimension(const std::optional<double>& value, const std::string& name) {
  if (value && !std::isfinite(*value)) {
    throw std::invalid_argument("The " + name + " is not a finite number");
  }
}

double extend_by_diagonals(Eigen::AlignedBox3d& box, const LinesDrawing& drawing) {
  double reach = 0.0;
  for (const NamedDiagonal& member : drawing.diagonals) {
    const std::string owner = "diagonal \"" + member.label + "\"";
    const auto& [height, angle] = member.diagonal;
    if (!std::isfinite(height) || !(angle >= 0.0) || !(angle < 0.5 * std::numbers::pi)) {
      throw std::invalid_argument("The height of " + owner +
                                  " must be finite, its angle from 0 to below 90 degrees");
    }
    extend_by_curves(box, member.curves, owner);
    for (const ShipCurve& curve : member.curves) {
      for (const Eigen::Vector3d& point : curve.points) {
        // Of the view below the centre line; in the box a diagonal's points count where they are.
        reach = std::max(reach, expanded(member.diagonal, point));
      }
    }
  }
  return reach;
}

}  // namespace

double expanded(const Diagonal& diagonal, const Eigen::Vector3d& point) {
  return point.y() / std::cos(diagonal.angle);
}

HullExtents hull_extents(const LinesDrawing& drawing) {
  Eigen::AlignedBox3d box;
  extend_by_family(box, drawing.stations, "station");
  extend_by_family(box, drawing.waterlines, "waterline");
  extend_by_family(box, drawing.buttocks, "buttock");
  const double diagonals = extend_by_diagonals(box, drawing);
  extend_by_curves(box, drawing.outlines, "the outline");
  extend_by_curves(box, drawing.knuckles, "a knuckle");
  if (box.isEmpty()) {
    throw std::invalid_argument(
        "There is nothing to draw: no station, waterline or buttock cuts the hull");
  }
  const double size = box.sizes().maxCoeff();
  if (size < 1e-3 || size > 1e5) {
    throw std::invalid_argument("The hull is " + std::to_string(size) +
                                " m large; a lines plan can be drawn from 1 mm to 100 km");
  }
  check_dimension(drawing.draft, "draft");
  check_dimension(drawing.length, "length between perpendiculars");
  if (drawing.length && *drawing.length <= 0.0) {
    throw std::invalid_argument("The length between perpendiculars must be above zero, not " +
                                std::to_string(*drawing.length) + " m");
  }

  // From the centre plane outwards, as the half-breadth plan and both sides of the body plan are.
  HullExtents extents{box.min().x(), box.max().x(), std::max(box.max().y(), 0.0),
                      box.min().z(), box.max().z(), 0.5 * (box.min().x() + box.max().x()),
                      diagonals};
  const auto near = [](double value, double low, double high) {
    // Far from the hull, a perpendicular or the base line would only make the hull small.
    const double reach = 0.25 * (high - low);
    return value > low - reach && value < high + reach;
  };
  if (drawing.length) {
    extents.midship = 0.5 * *drawing.length;
    for (const double perpendicular : {0.0, *drawing.length}) {
      if (near(perpendicular, box.min().x(), box.max().x())) {
        // Exactly, so that it is not beyond the extents by rounding when it is drawn.
        extents.aft = std::min(extents.aft, perpendicular);
        extents.fore = std::max(extents.fore, perpendicular);
      }
    }
  }
  if (near(0.0, box.min().z(), box.max().z())) {
    extents.bottom = std::min(extents.bottom, 0.0);
    extents.top = std::max(extents.top, 0.0);
  }
  return extents;
}

}  // namespace hull::drawing
