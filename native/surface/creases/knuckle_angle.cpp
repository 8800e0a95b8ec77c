// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/creases/knuckle_angle.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hull::surface {

double angle_between(const Vector3d& left, const Vector3d& right, const Vector3d& along) {
  const double length = along.norm();
  if (left.isZero(0.0) || right.isZero(0.0) || !(length > 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  // Not the arc cosine, which has no sign and loses half of its digits at small angles.
  return std::atan2(left.cross(right).dot(along) / length, left.dot(right));
}

double knuckle_angle(const LimitSurface& surface, const CreaseCurve& curve, double t) {
  const CellPlace left = curve.left(t), right = curve.right(t);
  if (left.cell < 0 || right.cell < 0) return std::numeric_limits<double>::quiet_NaN();
  return angle_between(surface.normal(left.cell, left.u, left.v),
                       surface.normal(right.cell, right.u, right.v), curve.evaluate(t, 1).d1);
}

std::vector<int> knuckle_edges(const CreaseCurve& curve, const std::vector<int>& edges) {
  if (curve.kind() == CreaseKind::kBorder) {
    throw std::invalid_argument(
        "This is a border: it has a surface on one side only, and no angle. Choose a crease.");
  }
  std::vector<int> result = edges;
  if (result.empty()) {
    for (int i = 0; i < curve.edge_count(); ++i) result.push_back(i);
  }
  int before = -1;
  for (int edge : result) {
    if (edge <= before || edge >= curve.edge_count()) {
      throw std::invalid_argument("Edge " + std::to_string(edge) +
                                  " of the knuckle: edges are 0 to " +
                                  std::to_string(curve.edge_count() - 1) + ", rising.");
    }
    before = edge;
  }
  return result;
}

}  // namespace hull::surface
