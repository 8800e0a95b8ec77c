// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modelling/fields/along_base.h"
#include "modelling/fields/field_curve.h"

namespace hull::modelling {

// How a curve becomes another one: S(l) = other(m(l)) - curve(l), by lengths (Veelo 2004, equations
// 4 and 5).
//
// Only the stretches in which the two differ take part: what they have in common at either end, to
// 1e-9 of the length, stays bit by bit. Veelo maps by equal proportions of the lengths of these
// stretches, which gives the shift a kink along the curve of (other length / length) - 1 where they
// begin, and a surface a knuckle. Here m has the slope 1 and no bend there, and rises everywhere.
// At an end of the curve that moves itself m keeps to the proportion. Where one curve is the other
// but for a stretch that it lacks, as a straight line that becomes a longer one, all of both takes
// part.
class CurveChange {
 public:
  CurveChange(FieldCurve curve, FieldCurve other);

  const FieldCurve& curve() const { return curve_; }
  // The stretch of the curve that differs, m from its beginning; empty where the curves are equal.
  double begin() const { return begin_; }
  double end() const { return end_; }

  // The length along the other curve that goes with one along the curve, and its slope.
  ValueAlong<double> mapped(double length) const;
  // The shift of the curve's point at a length, and its slope per m; 0 outside the stretch.
  ValueAlong<Vector3d> shift(double length) const;

 private:
  FieldCurve curve_, other_;
  double begin_ = 0.0, end_ = 0.0, other_begin_ = 0.0, other_end_ = 0.0;
  // Widths of the slope's way from 1 to what it is between, as parts of the stretch; 0 at an end
  // that moves itself.
  double rise_ = 0.0, fall_ = 0.0;
};

}  // namespace hull::modelling
