// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

enum class Axis { kX, kY, kZ };

// The plane across an axis.
Plane plane_across(Axis axis, double position);

// The plane of a diagonal: through the line y = 0, z = height, falling to port by `angle` (radians)
// below the horizontal: z = height - y tan(angle). At 0 it is a waterline's plane, at π/2 the
// centre plane.
Plane diagonal_plane(double height, double angle);

// One branch of the intersection of a surface with a plane. It runs so that what is above the plane
// is on its left, seen from the water: with a body inside the surface, the body is on the left,
// seen against the plane's normal, and a convex section has positive curvature.
struct SectionCurve {
  std::vector<Vector3d> points;     // in order; on surface and plane to 1e-10 of the mesh's size
  std::vector<int> cells;           // per point …
  std::vector<Eigen::Vector2d> uv;  // … and where in that cell
  // Per point, in the direction of running: unit tangent, and curvature in the plane (1/m),
  // positive where the curve turns left, seen against the plane's normal. Of a knuckle, those
  // before it.
  std::vector<Vector3d> tangents;
  std::vector<double> curvatures;
  // Indices of the points where the course may break: on creases, and where the tangent turns. At
  // the end of a closed curve the first point is meant, too. A closed curve with knuckles starts
  // at one.
  std::vector<int> knuckles;
  // Per knuckle, after it.
  std::vector<Vector3d> knuckle_tangents;
  std::vector<double> knuckle_curvatures;
  bool closed = false;  // the first point is then repeated at the end
};

// Points first … last of a curve, without a knuckle between.
struct SmoothStretch {
  int first, last;
  Vector3d first_tangent;  // leaving the first point; elsewhere they are those of the curve
  double first_curvature;
};
// The stretches of a curve from knuckle to knuckle, in order.
std::vector<SmoothStretch> smooth_stretches(const SectionCurve& curve);

struct SectionOptions {
  double chord_tolerance;  // m; no chord is further than this from the curve
  // What lies nearer to the plane lies in it, m: rounding, or the noise of coordinates in single
  // precision. By default 1e-10 of the mesh's size.
  std::optional<double> flat_tolerance;
};

// The intersection with a plane, branch by branch.
//
// What lies in the plane: where spans of the surface do, the section is the border of the flat
// region, along the spans' sides, not what is inside. Sides of spans that lie in the plane (along
// creases, borders and the lines between patches) belong to the section: y = 0 of a half hull has
// the border along stem and keel, z = 0 the outline of a flat bottom. Each is there once. Their
// points are as far from the plane as flat_tolerance allows. Where the surface is on one side of
// the plane to the left and the right of such a line, as at a keel, the curve's direction means
// nothing.
//
// Points where the surface only touches the plane give nothing, nor do curves shorter than
// 1e-6 of the size. Where the plane is tangent to the surface at a saddle, branches meet: in
// the saddle's point, or within 1e-6 of a cell. At irregular knots the surface has no curvature;
// next to them that of the section may be of any size.
//
// Throws std::invalid_argument unless the plane's normal is of unit length and its offset finite,
// chord_tolerance is positive and flat_tolerance not negative.
std::vector<SectionCurve> section(const surface::LimitSurface& surface, const Plane& plane,
                                  const SectionOptions& options);
std::vector<SectionCurve> section(const surface::LimitSurface& surface, const Plane& plane,
                                  double chord_tolerance);
std::vector<SectionCurve> section(const surface::LimitSurface& surface, Axis axis, double position,
                                  double chord_tolerance);

// The sections by several planes, in their order; for many planes much cheaper than one by one.
std::vector<std::vector<SectionCurve>> sections(const surface::LimitSurface& surface,
                                                const std::vector<Plane>& planes,
                                                const SectionOptions& options);

}  // namespace hull::analysis
