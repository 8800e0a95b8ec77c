// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "modelling/reshape/surface_places.h"
#include "modelling/transformation/area_curve.h"

namespace hull::modelling {

// What such shifts are to leave.
struct ShiftConstraints {
  double length_pp;                     // m: the sections at x = 0 and there stay
  std::vector<HullRange> still, rigid;  // sections that stay, and that move as one
};

// The two shifts s(x) of sections along the ship that change displacement and LCB and bend the
// hull's lines the least. Where a line's half breadth is y(x) a shift adds -(y s)'' to its second
// derivative. Of this y''' s + 2 y'' s' moves and stretches what bend is there; only y' s'' makes
// new one, hollows in a straight entrance for one. So all lines together have
//
//     ∫ w(x) s''² dx,   w(x) = ∫ n_x² dl around the section,
//
// n_x the part of the normal along the ship, evened out over kEven of the length, with kFloor of
// its largest added. The least of it with given first-order changes of the volume, ∫ a s' dx, and
// of its moment, ∫ a (x s' + s) dx, is a sum of two functions, whatever is given: cubic splines.
// (With w at the middle alone they were those of the "1 - Cp" method, straight in each half.)
//
// The first changes the displacement, the second LCB while the displacement stays, to first order.
// Each has 1 for its largest slope.
class FairShifts {
 public:
  FairShifts(const AreaCurve& areas, const HullRange& immersed, const SurfacePlaces& places,
             const ShiftConstraints& constraints);

  // Of function 0 or 1, m; beyond the hull it goes on straight.
  double value(int k, double x) const;

 private:
  using Row = Eigen::RowVectorXd;
  Row row(double x, int derivative) const;  // of the splines' coefficients
  Eigen::VectorXd weights(const SurfacePlaces& places, const Eigen::VectorXd& samples) const;
  Eigen::MatrixXd energy(const SurfacePlaces& places, const ShiftConstraints& constraints) const;

  double aft_ = 0.0, forward_ = 0.0;  // m: ends of the hull
  std::array<Eigen::VectorXd, 2> coefficients_;
};

}  // namespace hull::modelling
