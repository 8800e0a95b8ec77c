// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/sections.h"

#include <cmath>
#include <stdexcept>

#include "analysis/sections/section_arcs.h"

namespace hull {
namespace {

// Of the mesh's size: heights below are rounding, ends of arcs closer than that are one point, and
// squares at irregular knots smaller than that are left out.
constexpr double kZeroHeight = 1e-13;
constexpr double kSamePoint = 1e-8;
constexpr double kSmallestCorner = 1e-10;

bool on_crease(const Topology& cells, const SectionPoint& p) {
  const double u = p.uv.x(), v = p.uv.y();
  const int h = 4 * p.cell;
  return (v == 0.0 && cells.is_crease(h)) || (u == 1.0 && cells.is_crease(h + 1)) ||
         (v == 1.0 && cells.is_crease(h + 2)) || (u == 0.0 && cells.is_crease(h + 3));
}

SectionCurve to_curve(const Topology& cells, const JoinedArcs& joined) {
  SectionCurve curve;
  curve.closed = joined.closed;
  for (const SectionPoint& p : joined.points) {
    curve.points.push_back(p.point);
    curve.cells.push_back(p.cell);
    curve.uv.push_back(p.uv);
  }
  for (int joint : joined.joints) {
    if (on_crease(cells, joined.points[joint])) curve.knuckles.push_back(joint);
  }
  return curve;
}

}  // namespace

std::vector<SectionCurve> section(const LimitSurface& surface, const Plane& plane,
                                  double chord_tolerance) {
  if (!std::isfinite(plane.offset) || !plane.normal.allFinite()) {
    throw std::invalid_argument("The position of a section must be a finite number.");
  }
  if (!(chord_tolerance > 0.0)) {
    throw std::invalid_argument("The chord tolerance of a section must be positive.");
  }
  const double size = surface.mesh().size();
  const auto descend = [&](const CornerSquare& square) {
    const auto [lowest, highest] = height_range(square, plane);
    if (lowest >= -kZeroHeight * size || highest < 0.0) return false;
    return square.extent() > kSmallestCorner * size;
  };
  std::vector<SectionArc> arcs;
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for_each_piece(surface, cell, descend, [&](const SurfacePiece& piece) {
      std::vector<SectionArc> found =
          section_arcs(piece, plane, kZeroHeight * size, chord_tolerance);
      std::move(found.begin(), found.end(), std::back_inserter(arcs));
    });
  }
  std::vector<SectionCurve> curves;
  for (const JoinedArcs& joined : join_arcs(arcs, kSamePoint * size)) {
    curves.push_back(to_curve(surface.cells(), joined));
  }
  return curves;
}

std::vector<SectionCurve> section(const LimitSurface& surface, Axis axis, double position,
                                  double chord_tolerance) {
  return section(surface, Plane{Vector3d::Unit(static_cast<int>(axis)), position}, chord_tolerance);
}

}  // namespace hull
