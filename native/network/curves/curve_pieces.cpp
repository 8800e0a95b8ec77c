// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/curves/curve_pieces.h"

namespace hull::network {
namespace {

using Eigen::Index;
using Homogeneous = Eigen::Matrix<double, Eigen::Dynamic, 4>;

// Of a span's polynomial, at `high` for `count_high` of its arguments and at `low` for the others:
// the Bézier point of that number between the two (Ramshaw 1989).
Eigen::RowVector4d blossom(const std::vector<double>& knots, int degree, Index span,
                           Homogeneous points, double low, double high, int count_high) {
  for (int round = 1; round <= degree; ++round) {
    const double t = round <= count_high ? high : low;
    // Downwards, so that each point is made of those of the round before.
    for (int i = degree; i >= round; --i) {
      const double from = knots[span - degree + i], to = knots[span + 1 + i - round];
      // Both knots are on different sides of the span, which has a width.
      const double share = (t - from) / (to - from);
      points.row(i) = (1.0 - share) * points.row(i - 1) + share * points.row(i);
    }
  }
  return points.row(degree);
}

}  // namespace

Eigen::AlignedBox3d CurvePiece::box() const {
  Eigen::AlignedBox3d around;
  for (Index i = 0; i < points.rows(); ++i) {
    around.extend(Vector3d(points.row(i).head<3>().transpose() / points(i, 3)));
  }
  return around;
}

void CurvePiece::split(CurvePiece& first, CurvePiece& second) const {
  const double middle = 0.5 * (low + high);
  first = {low, middle, points};
  second = {middle, high, points};
  // The first points of the rounds are those of the first half; what is left after all is the
  // second.
  const Index last = points.rows() - 1;
  for (Index round = 1; round <= last; ++round) {
    for (Index i = 0; i <= last - round; ++i) {
      second.points.row(i) = 0.5 * (second.points.row(i) + second.points.row(i + 1));
    }
    first.points.row(round) = second.points.row(0);
  }
}

std::vector<CurvePiece> pieces_of(const NurbsCurve& curve) {
  const auto& knots = curve.knots();
  const int degree = curve.degree();
  Homogeneous all(curve.points().rows(), 4);
  // In homogeneous coordinates a rational curve is a polynomial one, of which there are blossoms.
  all.leftCols<3>() = curve.points().array().colwise() * curve.weights().array();
  all.col(3) = curve.weights();
  std::vector<CurvePiece> pieces;
  for (Index span = degree; span < all.rows(); ++span) {
    const double low = knots[span], high = knots[span + 1];
    // Multiple knots have no span between them.
    if (!(low < high)) continue;
    CurvePiece piece{low, high, Homogeneous(degree + 1, 4)};
    for (int i = 0; i <= degree; ++i) {
      piece.points.row(i) =
          blossom(knots, degree, span, all.middleRows(span - degree, degree + 1), low, high, i);
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace hull::network
