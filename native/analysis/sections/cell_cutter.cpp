// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/cell_cutter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/sections/section_arcs.h"
#include "analysis/sections/section_spots.h"
#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

// Of the mesh's size: parts nearer to the plane lie in it, unless the caller says how near.
constexpr double kFlat = 1e-10;
// Squares and pieces at irregular knots are taken for flat down to this part of a cell, and so are
// sides that do not go on from such. Smaller ones lie near the plane because they are small.
constexpr double kSmallestFlat = 1.0 / 32.0;

}  // namespace

SectionRules section_rules(const surface::LimitSurface& surface, const SectionOptions& options) {
  if (!(options.chord_tolerance > 0.0)) {
    throw std::invalid_argument("The chord tolerance of a section must be positive.");
  }
  if (options.flat_tolerance && !(*options.flat_tolerance >= 0.0)) {
    throw std::invalid_argument("The flat tolerance of a section must not be negative.");
  }
  const double size = surface.mesh().size(), zero = kZeroHeight * size;
  const double flat = std::max(options.flat_tolerance.value_or(kFlat * size), zero);
  return {options.chord_tolerance, {zero, flat}, kSmallestCorner * size};
}

void check_planes(const std::vector<Plane>& planes) {
  for (const Plane& plane : planes) {
    if (!std::isfinite(plane.offset)) {
      throw std::invalid_argument("The position of a section must be a finite number.");
    }
    if (!(std::abs(plane.normal.norm() - 1.0) < 1e-9)) {
      throw std::invalid_argument("The normal of a section's plane must be of unit length.");
    }
  }
}

void CellCutter::add_parts(int cell, const Plane& plane, PlaneSides& sides, SectionParts& parts) {
  // Lines are known by their places within a cell.
  lines_.clear();
  const auto descend = [&](const surface::CornerSquare& square) {
    return wants(square, plane, sides, parts);
  };
  const auto take = [&](const surface::SurfacePiece& piece) {
    add_piece(piece, plane, sides, parts);
  };
  surface::for_each_piece(surface_, cell, descend, take);
}

CellCutter::Line CellCutter::line_of(const surface::DomainSquare& square, int side) {
  switch (side) {
    case 0:
      return {false, square.v};
    case 1:
      return {true, square.u + square.size};
    case 2:
      return {false, square.v + square.size};
    default:
      return {true, square.u};
  }
}

bool CellCutter::wants(const surface::CornerSquare& square, const Plane& plane, PlaneSides& sides,
                       SectionParts& parts) const {
  const double flat = rules_.heights.flat;
  const auto [lowest, highest] = height_range(square, plane);
  if (lowest > flat || highest < -flat) return false;
  // A flat square is taken as one: sides of rings within it would cancel.
  if (lowest >= -flat && highest <= flat) {
    if (square.size >= kSmallestFlat) {
      sides.add_flat(square.cell, {square.u, square.v, square.size});
    } else {
      // So small a square is near the plane by its size: whether it lies in it is not told by that.
      add_spot(square, plane, square.extent(), parts);
    }
    return false;
  }
  const double extent = square.extent();
  if (extent > rules_.smallest) return true;
  add_spot(square, plane, extent, parts);
  return false;
}

void CellCutter::add_spot(const surface::CornerSquare& square, const Plane& plane, double radius,
                          SectionParts& parts) const {
  const auto height = [&plane](const Vector3d& p) { return plane.height(p); };
  parts.spots.push_back(spot_of(surface_, square, radius, height));
}

void CellCutter::add_piece(const surface::SurfacePiece& piece, const Plane& plane,
                           PlaneSides& sides, SectionParts& parts) {
  // Most pieces of a cell are beside the plane, as their points tell without a net.
  double low = plane.height(piece.points[0]), high = low;
  for (int i = 1; i < 16; ++i) {
    const double height = plane.height(piece.points[i]);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (low > rules_.heights.flat || high < -rules_.heights.flat) return;
  const surface::DomainSquare square{piece.u, piece.v, piece.size};
  const HeightNet height =
      height_net(piece.points, plane, rules_.heights, sides_that_may_lie(piece));
  if (height.flat) return sides.add_flat(piece.cell, square);
  for (int side = 0; side < 4 && height.divided; ++side) {
    if (!height.in_plane[side]) continue;
    sides.add_side(piece.cell, square, side, height.along(side));
    // Rings come from the outside in: a smaller side finds the line that it goes on with.
    if (piece.size < 0.5) lines_.push_back(line_of(square, side));
  }
  add_section_arcs(piece, height, plane, rules_.chord, rules_.heights.zero, net_cut_, parts);
}

SideFlags CellCutter::sides_that_may_lie(const surface::SurfacePiece& piece) const {
  if (piece.size >= kSmallestFlat) return kAllSides;
  SideFlags flags;
  for (int side = 0; side < 4; ++side) {
    const Line line = line_of({piece.u, piece.v, piece.size}, side);
    flags[side] = std::find(lines_.begin(), lines_.end(), line) != lines_.end();
  }
  return flags;
}

}  // namespace hull::analysis
