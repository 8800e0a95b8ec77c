// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "network/curves/nurbs_curve.h"

namespace hull::network {

// A part of a curve as a rational Bézier curve: it lies in the hull of its control points.
struct CurvePiece {
  double low, high;                                 // parameters of the curve
  Eigen::Matrix<double, Eigen::Dynamic, 4> points;  // w·x, w·y, w·z, w

  Eigen::AlignedBox3d box() const;
  // At the middle of the parameters (de Casteljau).
  void split(CurvePiece& first, CurvePiece& second) const;
};

// From knot to knot.
std::vector<CurvePiece> pieces_of(const NurbsCurve& curve);

}  // namespace hull::network
