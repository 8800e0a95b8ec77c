// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mesh/vectors.h"
#include "surface/creases/cubic_spline.h"

namespace hull::modelling {

// The point of a curve that is nearest to a point p.
struct CurveFoot {
  Vector3d point;
  double distance;  // m
  double length;    // along the curve from its beginning, m
  // How the length changes with p, per m: 0 where the foot is an end or a knuckle and stays there.
  Vector3d length_slope;
};

// A curve in space that fields are based on or lead to: cubic arcs one after the other, which may
// meet at knuckles, measured by its length.
class FieldCurve {
 public:
  // The four Bézier points of a cubic arc, m.
  using Arc = std::array<Vector3d, 4>;

  // Each arc begins where the one before ends. Throws std::invalid_argument for no arc, one that
  // has no length or is no number, and arcs that do not meet.
  explicit FieldCurve(std::vector<Arc> arcs);

  // The same curve as a cubic B-spline, such as a crease.
  static FieldCurve of_spline(const surface::CubicSpline& spline);

  // Through points in order, m: between knuckles (indices of points, of which the ends are always
  // two) the cubic spline by chord length with free ends; a straight line through two points. A
  // closed one goes from the last point to the first, smoothly where 0 is no knuckle. Throws
  // std::invalid_argument for fewer than two points (three of a closed curve), for points that
  // follow on themselves and for knuckles that are none.
  static FieldCurve through(const std::vector<Vector3d>& points,
                            const std::vector<int>& knuckles = {}, bool closed = false);

  const std::vector<Arc>& arcs() const { return arcs_; }
  double length() const { return starts_.back(); }  // m

  // The point at a length from the beginning, and the unit tangent there. Lengths beyond an end are
  // taken for the end.
  Vector3d point_at(double length) const;
  Vector3d tangent_at(double length) const;

  // The nearest of all points of the curve; of several at the same distance one of them. The length
  // up to it takes longer than all else: it is 0 where it is not asked for.
  CurveFoot foot(const Vector3d& p, bool with_length = true) const;

 private:
  struct Place {
    int arc;
    double t;
  };
  Place place_at(double length) const;
  double length_at(const Place& place) const;

  std::vector<Arc> arcs_;
  std::vector<double> starts_;  // lengths at the beginning of each arc, and of the whole
};

}  // namespace hull::modelling
