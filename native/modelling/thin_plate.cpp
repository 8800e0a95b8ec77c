// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/thin_plate.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "analysis/arithmetic/gauss.h"
#include "surface/pieces/bicubic_basis.h"

namespace hull::modelling {
namespace {

using Span = Eigen::Matrix<double, 16, 1>;        // of something at the B-spline points of a piece
using SpanPoints = Eigen::Matrix<double, 16, 3>;  // themselves
using SpanForm = Eigen::Matrix<double, 16, 16>;
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

// Values at a piece's control points, from the first one: only derivatives are wanted, and places
// far from the origin would take their last digits.
Points local_values(const surface::PieceWeights::Piece& piece,
                    const std::vector<Vector3d>& values) {
  Points some = some_of(values, piece.points);
  some.rowwise() -= Eigen::RowVector3d(some.row(0));
  return some;
}

SpanPoints span_of(const surface::PieceWeights::Piece& piece, const std::vector<Vector3d>& values) {
  return piece.rows * local_values(piece, values);
}

// A place of the quadrature: the derivatives there as sums of the span's points.
struct SpanPlace {
  double weight;
  Span ds, dt, dss, dst, dtt;
};

std::vector<SpanPlace> make_span_places() {
  using surface::bicubic_basis, surface::cubic_basis, surface::cubic_basis_d1,
      surface::cubic_basis_d2;
  const auto& [count, places, weights] = analysis::kThreeNodes;
  std::vector<SpanPlace> result;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const double s = places[i], t = places[j];
      result.push_back({weights[i] * weights[j], bicubic_basis(cubic_basis_d1(s), cubic_basis(t)),
                        bicubic_basis(cubic_basis(s), cubic_basis_d1(t)),
                        bicubic_basis(cubic_basis_d2(s), cubic_basis(t)),
                        bicubic_basis(cubic_basis_d1(s), cubic_basis_d1(t)),
                        bicubic_basis(cubic_basis(s), cubic_basis_d2(t))});
    }
  }
  return result;
}

const std::vector<SpanPlace>& span_places() {
  static const std::vector<SpanPlace> places = make_span_places();
  return places;
}

enum class Bending { kAll, kLengthwise };

// Up to three rows whose products with a span's points are the components of the second derivatives
// in orthonormal directions of the tangent plane, times the square root of dA: the energy is the
// sum of their squares. The mixed one counts twice, by its factor. Lengthwise: one row, the second
// derivative along the part of the x axis in the tangent plane. None where there is no area.
using BendingRows = Eigen::Matrix<double, Eigen::Dynamic, 16, Eigen::RowMajor, 3, 16>;

BendingRows bending_rows(const SpanPlace& place, const SpanPoints& points, Bending bending) {
  const Vector3d s = points.transpose() * place.ds, t = points.transpose() * place.dt;
  // Relative to the sides, so that small pieces are pieces. The negation below takes NaN, and sides
  // of no length, for no area.
  const double area = s.cross(t).norm();
  if (!(area > kNoArea * s.norm() * t.norm())) return BendingRows(0, 16);
  Eigen::Matrix2d metric;
  metric << s.dot(s), s.dot(t), s.dot(t), t.dot(t);
  const Eigen::Matrix2d inverse = metric.inverse();
  // Second derivatives without their part along the surface, which the parameters make.
  const auto covariant = [&](const Span& second) -> Span {
    const Vector3d along = points.transpose() * second;
    // Christoffel's symbols of this pair of parameters.
    const Eigen::Vector2d symbols = inverse * Eigen::Vector2d(along.dot(s), along.dot(t));
    return second - symbols[0] * place.ds - symbols[1] * place.dt;
  };
  const Span ss = covariant(place.dss), st = covariant(place.dst), tt = covariant(place.dtt);
  const double root = std::sqrt(place.weight * area);
  if (bending == Bending::kLengthwise) {
    // In (s, t): the part of the x axis in the tangent plane, whose products with both sides are
    // the x of these.
    const Eigen::Vector2d along = inverse * Eigen::Vector2d(s.x(), t.x());
    BendingRows row(1, 16);
    row.row(0) = root * (along[0] * along[0] * ss + 2.0 * along[0] * along[1] * st +
                         along[1] * along[1] * tt)
                            .transpose();
    return row;
  }
  // (s, t) per metre along e1 ∥ s and e2 square to it.
  const double a = 1.0 / s.norm();
  const double c = s.norm() / area, b = -s.dot(t) / (s.norm() * area);
  BendingRows rows(3, 16);
  rows.row(0) = root * a * a * ss.transpose();
  rows.row(1) = root * std::sqrt(2.0) * (a * b * ss + a * c * st).transpose();
  rows.row(2) = root * (b * b * ss + 2.0 * b * c * st + c * c * tt).transpose();
  return rows;
}

SpanForm span_form(const SpanPoints& points, Bending bending) {
  SpanForm form = SpanForm::Zero();
  for (const SpanPlace& place : span_places()) {
    const BendingRows rows = bending_rows(place, points, bending);
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
      form.noalias() += rows.row(k).transpose() * rows.row(k);
    }
  }
  return form;
}

// All bending rows of a piece, for its control points. Their squares are the form: that of the 16
// points, taken to the control points from both sides, would lose the digits that second
// differences of a small piece lose, twice.
Eigen::MatrixXd piece_rows(const surface::LimitSurface& surface,
                           const surface::PieceWeights::Piece& piece, Bending bending) {
  const SpanPoints points = span_of(piece, surface.mesh().points());
  Eigen::MatrixXd all(3 * static_cast<Eigen::Index>(span_places().size()), 16);
  Eigen::Index count = 0;
  for (const SpanPlace& place : span_places()) {
    const BendingRows rows = bending_rows(place, points, bending);
    // Fewer than three where a place has no area.
    all.middleRows(count, rows.rows()) = rows;
    count += rows.rows();
  }
  return all.topRows(count) * piece.rows;
}

void visit_forms(const surface::LimitSurface& surface, const surface::PieceWeights& pieces,
                 const std::vector<int>& some, double factor, const VisitForm& visit,
                 Bending bending) {
  for (int i : some) {
    const surface::PieceWeights::Piece& piece = pieces.piece(i);
    const Eigen::MatrixXd rows = piece_rows(surface, piece, bending);
    const Eigen::MatrixXd form = factor * rows.transpose() * rows;
    visit(piece.points, form);
  }
}

// Of a sparse matrix, before equal ones are summed: 32 MB.
constexpr std::size_t kEntriesAtOnce = 2'000'000;

}  // namespace

Eigen::Matrix<double, 16, 16> thin_plate_of_span(const surface::BicubicPoints& points) {
  SpanPoints rows;
  for (int i = 0; i < 16; ++i) rows.row(i) = points[i].transpose();
  return span_form(rows, Bending::kAll);
}

double thin_plate_energy(const surface::LimitSurface& surface, const surface::PieceWeights& pieces,
                         const std::vector<Vector3d>& values) {
  double energy = 0.0;
  for (int i = 0; i < pieces.piece_count(); ++i) {
    const surface::PieceWeights::Piece& piece = pieces.piece(i);
    const SpanPoints points = span_of(piece, surface.mesh().points());
    const SpanPoints bent = span_of(piece, values);
    for (const SpanPlace& place : span_places()) {
      const BendingRows rows = bending_rows(place, points, Bending::kAll);
      for (Eigen::Index row = 0; row < rows.rows(); ++row) {
        energy += Eigen::RowVector3d(rows.row(row) * bent).squaredNorm();
      }
    }
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
  for (int i = 0; i < pieces.piece_count(); ++i) {
    const surface::PieceWeights::Piece& piece = pieces.piece(i);
    const Eigen::MatrixXd rows = piece_rows(surface, piece, Bending::kAll);
    const Points bent = rows * local_values(piece, values);
    // Equations are of what is added: the slope of what is bent already goes to the right, with its
    // sign turned.
    equations.add_scalar(piece.points, factor * rows.transpose() * rows,
                         -factor * rows.transpose() * bent);
  }
}

Eigen::SparseMatrix<double> thin_plate_matrix(const surface::LimitSurface& surface,
                                              const surface::PieceWeights& pieces) {
  const int count = surface.mesh().topology().vertex_count();
  Eigen::SparseMatrix<double> matrix(count, count);
  std::vector<Eigen::Triplet<double>> entries;
  const auto add_entries = [&] {
    Eigen::SparseMatrix<double> some(count, count);
    some.setFromTriplets(entries.begin(), entries.end());
    matrix += some;
    entries.clear();
  };
  visit_thin_plate_forms(surface, pieces, 1.0,
                         [&](const std::vector<int>& points, const Eigen::MatrixXd& form) {
                           for (std::size_t a = 0; a < points.size(); ++a) {
                             for (std::size_t b = 0; b < points.size(); ++b) {
                               entries.emplace_back(points[a], points[b], form(a, b));
                             }
                           }
                           if (entries.size() > kEntriesAtOnce) add_entries();
                         });
  add_entries();
  return matrix;
}

}  // namespace hull::modelling
