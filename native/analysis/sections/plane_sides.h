// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <vector>

#include "analysis/arithmetic/bezier.h"
#include "analysis/sections/plane_cut.h"
#include "analysis/sections/section_point.h"

namespace hull::analysis {

// The sides of pieces that lie in a plane. Each piece says what it knows of its own sides; the two
// sides of a line are then seen together.
//
// A side belongs to the section unless the surface lies in the plane on both sides of it. What is
// above the plane is on its left as it runs, or what is below on its right; where there is only a
// flat, at a border of the surface, the flat is on the left if it looks up, along the plane's
// normal, and on the right if it looks down, unless it goes on from others that run the other way:
// with a body on the inside of the surface, the body is on the left, seen against the normal. Where
// both sides are above or both are below, the side has no direction.
class PlaneSides {
 public:
  enum class State { kNone, kFlat, kAbove, kBelow };

  PlaneSides(const surface::LimitSurface& surface, const Plane& plane)
      : surface_(&surface), plane_(&plane) {}

  bool empty() const { return claims_.empty(); }
  // A square that lies in the plane with all of its sides.
  void add_flat(int cell, const surface::DomainSquare& square);
  // Side 0 … 3 of a square; the sign of `beside`, in the direction of rising u or v, is that of the
  // height beside it.
  void add_side(int cell, const surface::DomainSquare& square, int side, const BezierCubic& beside);

  // Adds what belongs to the section.
  void add_arcs(double chord_tolerance, SectionParts& parts);

 private:
  // A line that sides lie on: an edge between cells, or u or v = at within a cell. t runs along the
  // edge's front half-edge, or with rising v or u.
  struct Line {
    enum class Kind { kEdge, kU, kV } kind;
    int id;  // half-edge or cell
    double at;
    auto operator<=>(const Line&) const = default;
  };
  struct Claim {
    Line line;
    double t0, t1;
    bool left;  // of the line
    State state;
    int cell;
  };

  class SideCurve;

  void add(int cell, const surface::DomainSquare& square, int side, double from, double to,
           State state);
  void add_line(const Claim* begin, const Claim* end, double chord_tolerance, SectionParts& parts);
  void add_arc(const Claim& claim, double t0, double t1, bool backward, SectionArc::Sense sense,
               double chord_tolerance, SectionParts& parts) const;

  const surface::LimitSurface* surface_;
  const Plane* plane_;
  std::vector<Claim> claims_;
};

}  // namespace hull::analysis
