// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/derivatives/closing_derivatives.h"

#include <array>

#include "analysis/immersion/border_centroid.h"

namespace hull::analysis {
namespace {

// By the four Bézier points of a cubic, from the derivatives by its B-spline points, both run
// through against each other's direction: what closings.cpp makes of a border.
PointColumns by_bezier(const PointColumns& by_bspline) {
  // Rows: B-spline points from Bézier points in the same direction.
  static const Eigen::Matrix4d kFromBezier = (Eigen::Matrix4d() << 6.0, -7.0, 2.0, 0.0,  //
                                              0.0, 2.0, -1.0, 0.0,                       //
                                              0.0, -1.0, 2.0, 0.0,                       //
                                              0.0, 2.0, -7.0, 6.0)
                                                 .finished();
  const PointColumns forward = kFromBezier.transpose() * by_bspline;
  return forward.colwise().reverse();
}

// By the points of the border's cubic and by those of the cubic that it is ruled to.
struct ByCubics {
  PointColumns border, target;
};

ByCubics by_cubics(const PointColumns& by_points) {
  PointColumns near = PointColumns::Zero(4, by_points.cols()), far = near;
  for (int b = 0; b < 4; ++b) {
    // Across the border a cap is a straight line, and the points of a line's cubic B-spline are its
    // places at -1, 0, 1 and 2: point b is at b - 1.
    near += (2.0 - b) * by_points.middleRows(4 * b, 4);
    far += (b - 1.0) * by_points.middleRows(4 * b, 4);
  }
  return {by_bezier(near), by_bezier(far)};
}

// Whether both ends of the rulings, in the two middle rows, differ in y alone: bit by bit, as x and
// z are copied.
bool is_athwartships(const surface::BicubicPoints& cap) {
  for (int a = 4; a < 8; ++a) {
    if (cap[a].x() != cap[a + 4].x() || cap[a].z() != cap[a + 4].z()) return false;
  }
  return true;
}

// What the centroid's shift contributes: border_centroid()'s derivative, run through backwards.
void add_centroid(const std::vector<ClosingPatch>& closings, std::size_t begin, std::size_t end,
                  const Eigen::RowVectorXd& by_apex, SurfaceAdjoint::Sum& sum) {
  std::vector<std::array<Vector3d, 4>> spans;
  double length = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    spans.push_back(closings[i].border);
    for (int k = 0; k < 3; ++k) length += (spans.back()[k + 1] - spans.back()[k]).norm();
  }
  if (!(length > 0.0)) return;
  const Vector3d centroid = border_centroid(spans);
  for (std::size_t i = begin; i < end; ++i) {
    const std::array<Vector3d, 4>& c = closings[i].border;
    PointColumns by_border = PointColumns::Zero(4, by_apex.size());
    for (int k = 0; k < 3; ++k) {
      const Vector3d chord = c[k + 1] - c[k];
      const double l = chord.norm();
      if (!(l > 0.0)) continue;
      // The centroid is ∑ l m / ∑ l, of chords' lengths l and middles m: the middle moves, and with
      // its chord's length its share grows.
      const Vector3d arm = 0.5 * (c[k] + c[k + 1]) - centroid, along = chord / l;
      for (Eigen::Index column = 0; column < by_apex.size(); column += 3) {
        const Eigen::RowVector3d apex = by_apex.segment<3>(column);
        const Eigen::RowVector3d stretched = apex.dot(arm) / length * along.transpose();
        by_border.block<1, 3>(k, column) += 0.5 * l / length * apex - stretched;
        by_border.block<1, 3>(k + 1, column) += 0.5 * l / length * apex + stretched;
      }
    }
    sum.add_border(static_cast<int>(i), by_border);
  }
}

}  // namespace

void add_closing_derivatives(const std::vector<BorderEdge>& border,
                             const std::vector<ClosingPatch>& closings, int numbers,
                             const SpanDerivatives& by_points, SurfaceAdjoint::Sum& sum) {
  for (std::size_t begin = 0; begin < closings.size();) {
    Eigen::RowVectorXd by_apex = Eigen::RowVectorXd::Zero(3 * numbers);
    std::size_t i = begin;
    for (; i < closings.size() && border[i].loop == border[begin].loop; ++i) {
      PointColumns columns = PointColumns::Zero(16, 3 * numbers);
      by_points(closings[i].cap, columns);
      if (columns.isZero(0.0)) continue;
      ByCubics cubics = by_cubics(columns);
      if (is_athwartships(closings[i].cap)) {
        // The far side has x and z of the border, and follows it in these.
        for (Eigen::Index y = 1; y < columns.cols(); y += 3) cubics.target.col(y).setZero();
        cubics.border += cubics.target;
      } else {
        // The far side of a fan is the centroid, four times.
        by_apex += cubics.target.colwise().sum();
      }
      sum.add_border(static_cast<int>(i), cubics.border);
    }
    if (!by_apex.isZero(0.0)) add_centroid(closings, begin, i, by_apex, sum);
    begin = i;
  }
}

}  // namespace hull::analysis
