// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/sections.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/sections/cell_boxes.h"
#include "analysis/sections/plane_sides.h"
#include "analysis/sections/section_arcs.h"
#include "analysis/sections/section_curves.h"
#include "analysis/sections/section_spots.h"
#include "mesh/tolerances.h"
#include "surface/parallel_for.h"

namespace hull::analysis {
namespace {

// Of the mesh's size: parts nearer to the plane lie in it, unless the caller says how near.
constexpr double kFlat = 1e-10;
// Squares and pieces at irregular knots are taken for flat down to this part of a cell, and so are
// sides that do not go on from such. Smaller ones lie near the plane because they are small.
constexpr double kSmallestFlat = 1.0 / 32.0;

void check(const std::vector<Plane>& planes, const SectionOptions& options) {
  for (const Plane& plane : planes) {
    if (!std::isfinite(plane.offset)) {
      throw std::invalid_argument("The position of a section must be a finite number.");
    }
    if (!(std::abs(plane.normal.norm() - 1.0) < 1e-9)) {
      throw std::invalid_argument("The normal of a section's plane must be of unit length.");
    }
  }
  if (!(options.chord_tolerance > 0.0)) {
    throw std::invalid_argument("The chord tolerance of a section must be positive.");
  }
  if (options.flat_tolerance && !(*options.flat_tolerance >= 0.0)) {
    throw std::invalid_argument("The flat tolerance of a section must not be negative.");
  }
}

// Cuts one surface by plane after plane.
class Cutter {
 public:
  Cutter(const surface::LimitSurface& surface, const SectionOptions& options)
      : surface_(surface),
        size_(surface.mesh().size()),
        chord_tolerance_(options.chord_tolerance),
        heights_{kZeroHeight * size_,
                 std::max(options.flat_tolerance.value_or(kFlat * size_), kZeroHeight * size_)} {}

  std::vector<SectionCurve> cut(const CellBoxes& boxes, const Plane& plane) {
    parts_.clear();
    PlaneSides sides(surface_, plane);
    const double low = plane.offset - heights_.flat, high = plane.offset + heights_.flat;
    const auto descend = [&](const surface::CornerSquare& square) {
      return wants(square, plane, sides);
    };
    const auto take = [&](const surface::SurfacePiece& piece) { add_piece(piece, plane, sides); };
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      if (boxes.least(cell, plane.normal) > high || boxes.most(cell, plane.normal) < low) continue;
      // Lines are known by their places within a cell.
      lines_.clear();
      surface::for_each_piece(surface_, cell, descend, take);
    }
    if (!sides.empty()) sides.add_arcs(chord_tolerance_, parts_);
    return section_curves(surface_, parts_);
  }

 private:
  bool wants(const surface::CornerSquare& square, const Plane& plane, PlaneSides& sides);
  void add_piece(const surface::SurfacePiece& piece, const Plane& plane, PlaneSides& sides);
  SideFlags sides_that_may_lie(const surface::SurfacePiece& piece) const;
  void add_spot(const surface::CornerSquare& square, const Plane& plane, double radius);

  const surface::LimitSurface& surface_;
  double size_;
  double chord_tolerance_;
  HeightTolerances heights_;
  SectionParts parts_;
  NetCut net_cut_;
  // A side's line within a cell: u or v = at.
  struct Line {
    bool along_v;
    double at;
    bool operator==(const Line&) const = default;
  };
  static Line line_of(const surface::DomainSquare& square, int side) {
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
  std::vector<Line> lines_;  // in the plane, of the cell's smaller pieces so far
};

bool Cutter::wants(const surface::CornerSquare& square, const Plane& plane, PlaneSides& sides) {
  const auto [lowest, highest] = height_range(square, plane);
  if (lowest > heights_.flat || highest < -heights_.flat) return false;
  // A flat square is taken as one: sides of rings within it would cancel.
  if (lowest >= -heights_.flat && highest <= heights_.flat) {
    if (square.size >= kSmallestFlat) {
      sides.add_flat(square.cell, {square.u, square.v, square.size});
    } else {
      // So small a square is near the plane by its size: whether it lies in it is not told by that.
      add_spot(square, plane, square.extent());
    }
    return false;
  }
  const double extent = square.extent();
  if (extent > kSmallestCorner * size_) return true;
  add_spot(square, plane, extent);
  return false;
}

void Cutter::add_spot(const surface::CornerSquare& square, const Plane& plane, double radius) {
  const auto height = [&plane](const Vector3d& p) { return plane.height(p); };
  parts_.spots.push_back(spot_of(surface_, square, radius, height));
}

void Cutter::add_piece(const surface::SurfacePiece& piece, const Plane& plane, PlaneSides& sides) {
  // Most pieces of a cell are beside the plane, as their points tell without a net.
  double low = plane.height(piece.points[0]), high = low;
  for (int i = 1; i < 16; ++i) {
    const double height = plane.height(piece.points[i]);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (low > heights_.flat || high < -heights_.flat) return;
  const surface::DomainSquare square{piece.u, piece.v, piece.size};
  const HeightNet height = height_net(piece.points, plane, heights_, sides_that_may_lie(piece));
  if (height.flat) return sides.add_flat(piece.cell, square);
  for (int side = 0; side < 4 && height.divided; ++side) {
    if (!height.in_plane[side]) continue;
    sides.add_side(piece.cell, square, side, height.along(side));
    // Rings come from the outside in: a smaller side finds the line that it goes on with.
    if (piece.size < 0.5) lines_.push_back(line_of(square, side));
  }
  add_section_arcs(piece, height, plane, chord_tolerance_, heights_.zero, net_cut_, parts_);
}

SideFlags Cutter::sides_that_may_lie(const surface::SurfacePiece& piece) const {
  if (piece.size >= kSmallestFlat) return kAllSides;
  SideFlags flags;
  for (int side = 0; side < 4; ++side) {
    const Line line = line_of({piece.u, piece.v, piece.size}, side);
    flags[side] = std::find(lines_.begin(), lines_.end(), line) != lines_.end();
  }
  return flags;
}

}  // namespace

Plane plane_across(Axis axis, double position) {
  return {Vector3d::Unit(static_cast<int>(axis)), position};
}

Plane diagonal_plane(double height, double angle) {
  return {Vector3d(0.0, std::sin(angle), std::cos(angle)), height * std::cos(angle)};
}

std::vector<std::vector<SectionCurve>> sections(const surface::LimitSurface& surface,
                                                const std::vector<Plane>& planes,
                                                const SectionOptions& options) {
  check(planes, options);
  const CellBoxes boxes(surface);
  std::vector<std::vector<SectionCurve>> result(planes.size());
  constexpr std::size_t kGrain = 2;  // a section takes some 100 microseconds
  surface::parallel_for(
      planes.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        // One for a range of planes, whose lists keep their memory from one to the next.
        Cutter cutter(surface, options);
        for (std::size_t i = begin; i < end; ++i) result[i] = cutter.cut(boxes, planes[i]);
      },
      kGrain);
  return result;
}

std::vector<SectionCurve> section(const surface::LimitSurface& surface, const Plane& plane,
                                  const SectionOptions& options) {
  return std::move(sections(surface, {plane}, options).front());
}

std::vector<SectionCurve> section(const surface::LimitSurface& surface, const Plane& plane,
                                  double chord_tolerance) {
  return section(surface, plane, SectionOptions{chord_tolerance, {}});
}

std::vector<SectionCurve> section(const surface::LimitSurface& surface, Axis axis, double position,
                                  double chord_tolerance) {
  return section(surface, plane_across(axis, position), chord_tolerance);
}

}  // namespace hull::analysis
