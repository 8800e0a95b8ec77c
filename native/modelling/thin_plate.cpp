// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/thin_plate.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "modelling/gauss_rule.h"

namespace hull::modelling {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// sine of the angle between the sides of a piece: below, it has no area to speak of
constexpr double kNoArea = 1e-6;

Points some_of(const std::vector<Vector3d>& values, const std::vector<int>& which) {
  Points some(static_cast<Eigen::Index>(which.size()), 3);
  for (std::size_t i = 0; i < which.size(); ++i) {
    some.row(static_cast<Eigen::Index>(i)) = values[which[i]].transpose();
  }
  return some;
}

enum class Bending { kAll, kLengthwise };

// Rows of weights whose products with the points are the components of the second derivatives in
// orthonormal directions of the tangent plane, times the square root of dA: the energy is the sum
// of their squares. The mixed one counts twice, by its factor. Lengthwise: one row, the second
// derivative along the part of the x axis in the tangent plane. Empty where there is no area.
Eigen::MatrixXd bending_rows(const surface::PieceWeights::Jet& jet, const Points& points,
                             double weight, Bending bending) {
  const Vector3d s = points.transpose() * jet.ds, t = points.transpose() * jet.dt;
  const double area = s.cross(t).norm();
  if (!(area > kNoArea * s.norm() * t.norm())) return {};
  Eigen::Matrix2d metric;
  metric << s.dot(s), s.dot(t), s.dot(t), t.dot(t);
  const Eigen::Matrix2d inverse = metric.inverse();
  // Second derivatives without their part along the surface, which the parameters make.
  const auto covariant = [&](const Eigen::VectorXd& second) -> Eigen::VectorXd {
    const Vector3d along = points.transpose() * second;
    const Eigen::Vector2d symbols = inverse * Eigen::Vector2d(along.dot(s), along.dot(t));
    return second - symbols[0] * jet.ds - symbols[1] * jet.dt;
  };
  const Eigen::VectorXd ss = covariant(jet.dss), st = covariant(jet.dst), tt = covariant(jet.dtt);
  const double root = std::sqrt(weight * area);
  if (bending == Bending::kLengthwise) {
    const Eigen::Vector2d along = inverse * Eigen::Vector2d(s.x(), t.x());
    return root *
           (along[0] * along[0] * ss + 2.0 * along[0] * along[1] * st + along[1] * along[1] * tt)
               .transpose();
  }
  // (s, t) per metre along e1 ∥ s and e2 square to it.
  const double a = 1.0 / s.norm();
  const double c = s.norm() / area, b = -s.dot(t) / (s.norm() * area);
  Eigen::MatrixXd rows(3, points.rows());
  rows.row(0) = root * a * a * ss.transpose();
  rows.row(1) = root * std::sqrt(2.0) * (a * b * ss + a * c * st).transpose();
  rows.row(2) = root * (b * b * ss + 2.0 * b * c * st + c * c * tt).transpose();
  return rows;
}

// Calls visit(rows) for each place of the quadrature on a piece.
template <class Visit>
void for_each_place(const surface::PieceWeights& pieces, int piece, const Points& points,
                    const Visit& visit, Bending bending = Bending::kAll) {
  const auto& [count, places, weights] = kThreePoints;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const auto rows = bending_rows(pieces.jet({piece, places[i], places[j]}), points,
                                     weights[i] * weights[j], bending);
      if (rows.cols() > 0) visit(rows);
    }
  }
}

void visit_forms(const surface::LimitSurface& surface, const surface::PieceWeights& pieces,
                 const std::vector<int>& some, double factor, const VisitForm& visit,
                 Bending bending) {
  for (int i : some) {
    const std::vector<int>& which = pieces.piece(i).points;
    const Points points = some_of(surface.mesh().points(), which);
    Eigen::MatrixXd form = Eigen::MatrixXd::Zero(points.rows(), points.rows());
    for_each_place(
        pieces, i, points, [&](const auto& rows) { form += factor * rows.transpose() * rows; },
        bending);
    visit(which, form);
  }
}

}  // namespace

double thin_plate_energy(const surface::LimitSurface& surface, const surface::PieceWeights& pieces,
                         const std::vector<Vector3d>& values) {
  double energy = 0.0;
  for (int i = 0; i < pieces.piece_count(); ++i) {
    const std::vector<int>& which = pieces.piece(i).points;
    const Points bent = some_of(values, which);
    for_each_place(pieces, i, some_of(surface.mesh().points(), which),
                   [&](const auto& rows) { energy += (rows * bent).squaredNorm(); });
  }
  return energy;
}

void visit_thin_plate_forms(const surface::LimitSurface& surface,
                            const surface::PieceWeights& pieces, const std::vector<int>& some,
                            double factor, const VisitForm& visit) {
  visit_forms(surface, pieces, some, factor, visit, Bending::kAll);
}

void visit_lengthwise_forms(const surface::LimitSurface& surface,
                            const surface::PieceWeights& pieces, const std::vector<int>& some,
                            const VisitForm& visit) {
  visit_forms(surface, pieces, some, 1.0, visit, Bending::kLengthwise);
}

void visit_thin_plate_forms(const surface::LimitSurface& surface,
                            const surface::PieceWeights& pieces, double factor,
                            const VisitForm& visit) {
  std::vector<int> all(pieces.piece_count());
  std::iota(all.begin(), all.end(), 0);
  visit_thin_plate_forms(surface, pieces, all, factor, visit);
}

void add_thin_plate(const surface::LimitSurface& surface, const surface::PieceWeights& pieces,
                    const std::vector<Vector3d>& values, double factor, FitEquations& equations) {
  visit_thin_plate_forms(surface, pieces, factor,
                         [&](const auto& which, const Eigen::MatrixXd& form) {
                           equations.add_scalar(which, form, -form * some_of(values, which));
                         });
}

}  // namespace hull::modelling
