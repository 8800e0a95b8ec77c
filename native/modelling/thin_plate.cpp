// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/thin_plate.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace hull {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// Gauss's points and weights on [0, 1].
constexpr std::array<double, 3> kGauss = {0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> kWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
// sine of the angle between the sides of a piece: below, it has no area to speak of
constexpr double kNoArea = 1e-6;

Points some_of(const std::vector<Vector3d>& values, const std::vector<int>& which) {
  Points some(static_cast<Eigen::Index>(which.size()), 3);
  for (std::size_t i = 0; i < which.size(); ++i) {
    some.row(static_cast<Eigen::Index>(i)) = values[which[i]].transpose();
  }
  return some;
}

using Rows = Eigen::Matrix<double, 3, Eigen::Dynamic>;

// Orthonormal directions of the tangent plane at a place of a piece.
struct Frame {
  double area = 0.0;  // of the piece's unit square there, m²; 0: none to speak of
  // e1 ∥ s and e2 square to it: e = tangents · per_metre, (s, t) per metre in per_metre's columns.
  Eigen::Matrix<double, 3, 2> tangents;
  Eigen::Matrix2d per_metre;
};

Frame frame_of(const PieceWeights::Jet& jet, const Points& points) {
  Frame frame;
  frame.tangents << points.transpose() * jet.ds, points.transpose() * jet.dt;
  const Vector3d s = frame.tangents.col(0), t = frame.tangents.col(1);
  const double area = s.cross(t).norm();
  if (!(area > kNoArea * s.norm() * t.norm())) return frame;
  frame.area = area;
  frame.per_metre << 1.0 / s.norm(), -s.dot(t) / (s.norm() * area), 0.0, s.norm() / area;
  return frame;
}

// Rows of weights whose products with the points are the second derivatives along e1 and e1, e1 and
// e2, e2 and e2, times the square root of dA: the energy is the sum of their squares. The mixed one
// counts twice, by its factor.
Rows bending_rows(const PieceWeights::Jet& jet, const Points& points, const Frame& frame,
                  double weight) {
  const Eigen::Matrix2d inverse = frame.per_metre * frame.per_metre.transpose();
  // Second derivatives without their part along the surface, which the parameters make.
  const auto covariant = [&](const Eigen::VectorXd& second) -> Eigen::VectorXd {
    const Vector3d along = points.transpose() * second;
    const Eigen::Vector2d symbols = inverse * (frame.tangents.transpose() * along);
    return second - symbols[0] * jet.ds - symbols[1] * jet.dt;
  };
  const Eigen::VectorXd ss = covariant(jet.dss), st = covariant(jet.dst), tt = covariant(jet.dtt);
  const double a = frame.per_metre(0, 0), b = frame.per_metre(0, 1), c = frame.per_metre(1, 1);
  const double root = std::sqrt(weight * frame.area);
  Rows rows(3, points.rows());
  rows.row(0) = root * a * a * ss.transpose();
  rows.row(1) = root * std::sqrt(2.0) * (a * b * ss + a * c * st).transpose();
  rows.row(2) = root * (b * b * ss + 2.0 * b * c * st + c * c * tt).transpose();
  return rows;
}

// What the energy of the surface itself grows by, for moves of its points, because its metric
// changes with them: T dA and g^ij in T = g^ac g^bd D_ab·D_cd, D the normal parts of the second
// derivatives. Those of the parameters along the surface (Christoffel's symbols) change, too, but
// along the surface, which D has no part in. Derived from dg^ij = -g^ie dg_ef g^fj.
Points metric_slopes(const PieceWeights::Jet& jet, const Frame& frame, const Rows& rows,
                     const Points& points) {
  const Eigen::Matrix3d bends = rows * points;
  const Vector3d d11 = bends.row(0), d12 = bends.row(1) / std::sqrt(2.0), d22 = bends.row(2);
  Eigen::Matrix2d squares;
  squares(0, 0) = d11.squaredNorm() + d12.squaredNorm();
  squares(0, 1) = squares(1, 0) = d11.dot(d12) + d12.dot(d22);
  squares(1, 1) = d12.squaredNorm() + d22.squaredNorm();
  const Eigen::Matrix2d both = squares.trace() * Eigen::Matrix2d::Identity() - 4.0 * squares;
  const Eigen::Matrix<double, 3, 2> slopes =
      frame.tangents * frame.per_metre * both * frame.per_metre.transpose();
  return jet.ds * slopes.col(0).transpose() + jet.dt * slopes.col(1).transpose();
}

// Calls visit(jet, frame, rows) for each place of the quadrature on a piece.
template <class Visit>
void for_each_place(const PieceWeights& pieces, int piece, const Points& points,
                    const Visit& visit) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const PieceWeights::Jet jet = pieces.jet({piece, kGauss[i], kGauss[j]});
      const Frame frame = frame_of(jet, points);
      if (frame.area <= 0.0) continue;
      visit(jet, frame, bending_rows(jet, points, frame, kWeights[i] * kWeights[j]));
    }
  }
}

}  // namespace

double thin_plate_energy(const LimitSurface& surface, const PieceWeights& pieces,
                         const std::vector<Vector3d>& values) {
  double energy = 0.0;
  for (int i = 0; i < pieces.piece_count(); ++i) {
    const std::vector<int>& which = pieces.piece(i).points;
    const Points bent = some_of(values, which);
    for_each_place(
        pieces, i, some_of(surface.mesh().points(), which),
        [&](const auto&, const auto&, const Rows& rows) { energy += (rows * bent).squaredNorm(); });
  }
  return energy;
}

void add_thin_plate(const LimitSurface& surface, const PieceWeights& pieces,
                    const std::vector<Vector3d>& values, double factor, FitEquations& equations) {
  for (int i = 0; i < pieces.piece_count(); ++i) {
    const std::vector<int>& which = pieces.piece(i).points;
    const Points points = some_of(surface.mesh().points(), which);
    Eigen::MatrixXd form = Eigen::MatrixXd::Zero(points.rows(), points.rows());
    for_each_place(pieces, i, points, [&](const auto&, const auto&, const Rows& rows) {
      form += factor * rows.transpose() * rows;
    });
    equations.add_scalar(which, form, -form * some_of(values, which));
  }
}

void add_metric_slopes(const LimitSurface& surface, const PieceWeights& pieces, double factor,
                       FitEquations& equations) {
  for (int i = 0; i < pieces.piece_count(); ++i) {
    const std::vector<int>& which = pieces.piece(i).points;
    const Points points = some_of(surface.mesh().points(), which);
    Points slopes = Points::Zero(points.rows(), 3);
    for_each_place(pieces, i, points, [&](const auto& jet, const Frame& frame, const Rows& rows) {
      slopes -= 0.5 * factor * metric_slopes(jet, frame, rows, points);
    });
    equations.add_slope(which, slopes);
  }
}

}  // namespace hull
