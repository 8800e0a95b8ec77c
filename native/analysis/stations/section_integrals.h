// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <vector>

#include "analysis/sections/arc_square.h"
#include "analysis/sections/cell_boxes.h"
#include "analysis/sections/plane_cut.h"
#include "mesh/tolerances.h"

namespace hull::analysis {

// A plane with coordinates a and b in it: `up` is the direction of b, and across x up = normal.
struct SectionFrame {
  Plane plane;
  Vector3d origin, across, up;

  // b measured from the water's surface, straight up within the plane, and a along the water.
  // REQUIRES: the water is not parallel to the plane.
  static SectionFrame above_water(const Plane& plane, const Plane& water);

  Vector3d point(double a, double b) const { return origin + a * across + b * up; }
  // The same frame as seen in the mirror y = 0, for planes across x.
  SectionFrame mirrored() const;
};

// Line integrals along the part of a section that lies below b = level, the section run through so
// that the body is on its left, seen against the plane's normal. For a closed outline, and for one
// that lines b = constant close, they are the integrals over the figure that their names say.
struct SectionIntegrals {
  double area = 0.0;      // ∫ a db, m²
  double moment_a = 0.0;  // ∫ ½ a² db, m³: first moment ∫ a dA
  double moment_b = 0.0;  // ∫ a b db, m³: ∫ b dA
  double girth = 0.0;     // ∫ ds, m; of the shell alone
  double breadth = 0.0;   // ∫ da, m: length of the figure's border on b = level
  double error = 0.0;     // estimate of the area's, m²

  SectionIntegrals& operator+=(const SectionIntegrals& other);
};

// How closely an arc is integrated: by how many nodes, and how much its share of the area (m²) and
// its length (m) may be off, as estimated, before it is halved. deepest: how often pieces are
// halved at most where the section only touches them (plane_cut.h).
struct ArcRule {
  int nodes;
  double area, length;
  int deepest = kDeepestCut;

  // Any order of them, for what is kept by rule.
  auto operator<=>(const ArcRule&) const = default;
};

// For a mesh of that size and a body's tolerance (body_rules.h).
ArcRule arc_rule(double size, double tolerance);

// Adds the integrals along one square.
void add_arcs(const ArcSquare& square, double level, const ArcRule& rule, SectionIntegrals& sum);

// Adds a straight line from (a0, b0) to (a1, b1), which is no part of the shell.
void add_line(double a0, double b0, double a1, double b1, double level, SectionIntegrals& sum);

// What of a plane's section is looked at: pieces that may reach below b = level.
struct ArcReach {
  ArcReach(const surface::LimitSurface& surface, const SectionFrame& frame, double level)
      : surface(surface), frame(frame), level(level), top(level + frame.up.dot(frame.origin)) {}

  // Whether a cell's box leaves room for such.
  bool may_reach(const CellBoxes& boxes, int cell) const {
    return boxes.least(cell, frame.plane.normal) < frame.plane.offset &&
           boxes.most(cell, frame.plane.normal) >= frame.plane.offset &&
           boxes.least(cell, frame.up) < top;
  }

  const surface::LimitSurface& surface;
  const SectionFrame& frame;
  double level, top;
};

// Calls visit(const ArcPiece&) for such pieces of a cell. Squares at irregular knots are left out
// once they are below 1e-9 of the size.
struct ArcPiece {
  const surface::SurfacePiece& piece;
  BezierNet h;  // heights of rounding size are zero
};
template <class Visit>
void for_each_arc_piece_in(const ArcReach& search, int cell, const Visit& visit);

// The same for all cells.
template <class Visit>
void for_each_arc_piece(const surface::LimitSurface& surface, const CellBoxes& boxes,
                        const SectionFrame& frame, double level, const Visit& visit) {
  const ArcReach search(surface, frame, level);
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    if (search.may_reach(boxes, cell)) for_each_arc_piece_in(search, cell, visit);
  }
}

// Calls visit(const ArcSquare&) for all squares of a cell that the section crosses and that reach
// below b = level. What lies in the plane counts as above it.
template <class Visit>
void for_each_arc_in(const ArcReach& search, int cell, int deepest, const Visit& visit);

namespace section_internal {

inline bool reaches(const Vector3d* begin, const Vector3d* end, const SectionFrame& frame,
                    double top) {
  double low = frame.plane.height(*begin), high = low, bottom = frame.up.dot(*begin);
  for (const Vector3d* p = begin + 1; p != end; ++p) {
    const double height = frame.plane.height(*p);
    low = std::min(low, height);
    high = std::max(high, height);
    bottom = std::min(bottom, frame.up.dot(*p));
  }
  return low < 0.0 && high >= 0.0 && bottom < top;
}

}  // namespace section_internal

template <class Visit>
void for_each_arc_piece_in(const ArcReach& search, int cell, const Visit& visit) {
  using namespace section_internal;
  const SectionFrame& frame = search.frame;
  const double size = search.surface.mesh().size();
  const auto descend = [&](const surface::CornerSquare& square) {
    const std::vector<Vector3d>& points = square.points();
    if (!reaches(points.data(), points.data() + points.size(), frame, search.top)) return false;
    return square.extent() > kSmallestCorner * size;
  };
  const auto take = [&](const surface::SurfacePiece& piece) {
    const Vector3d* begin = piece.points.data();
    if (!reaches(begin, begin + 16, frame, search.top)) return;
    ArcPiece found{piece, bezier_net(piece.points, frame.plane.normal, frame.plane.offset)};
    flush_to_zero(found.h, kZeroHeight * size);
    visit(found);
  };
  surface::for_each_piece(search.surface, cell, descend, take);
}

// The squares of one piece.
template <class Visit>
void for_each_arc_of(const ArcPiece& piece, const SectionFrame& frame, double level,
                     const Visit& visit, int deepest = kDeepestCut) {
  const BezierNet& h = piece.h;
  if (lowest(h) >= 0.0 || highest(h) < 0.0) return;
  const surface::BicubicPoints& points = piece.piece.points;
  const BezierNet b = bezier_net(points, frame.up, frame.up.dot(frame.origin));
  if (lowest(b) >= level) return;
  const BezierNet a = bezier_net(points, frame.across, frame.across.dot(frame.origin));
  cut_piece(
      BezierBicubic(h),
      [&](const CutSquare& cut) {
        if (cut.side != CutSquare::Side::kCut) return;
        ArcSquare square{restricted(h, cut.u, cut.v, cut.size),
                         restricted(a, cut.u, cut.v, cut.size),
                         restricted(b, cut.u, cut.v, cut.size), 1.0};
        if (cut.swapped) {
          square = {transposed(square.h), transposed(square.a), transposed(square.b), -1.0};
        }
        // The section runs along plane normal x surface normal, so that h_v > 0 means towards
        // larger u; the exchange of u and v turned the surface's normal.
        double rise = 0.0;
        for (int i = 0; i < 4; ++i) rise += square.h[12 + i] - square.h[i];
        if (rise < 0.0) square.sign = -square.sign;
        visit(square);
      },
      deepest);
}

template <class Visit>
void for_each_arc_in(const ArcReach& search, int cell, int deepest, const Visit& visit) {
  for_each_arc_piece_in(search, cell, [&](const ArcPiece& piece) {
    for_each_arc_of(piece, search.frame, search.level, visit, deepest);
  });
}

}  // namespace hull::analysis
