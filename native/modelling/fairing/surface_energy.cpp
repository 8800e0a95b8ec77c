// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/surface_energy.h"

#include <Eigen/Geometry>
#include <cassert>
#include <cmath>
#include <numeric>
#include <unsupported/Eigen/AutoDiff>
#include <utility>

#include "analysis/arithmetic/gauss.h"
#include "modelling/fairing/blend_energy.h"
#include "modelling/fairing/quadratic_energy.h"
#include "modelling/thin_plate.h"
#include "surface/pieces/bicubic.h"

namespace hull::modelling {
namespace {

// Sine of the angle between the sides of a piece: below, it has no area to speak of.
constexpr double kNoArea = 1e-6;

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

// The first and second fundamental forms at a place, and the frame e1 = a ∂s, e2 = b ∂s + c ∂t.
template <class T>
struct Forms {
  Vector3<T> s, t, normal;
  std::array<Vector3<T>, 3> second;  // ss, st, tt
  std::array<T, 3> h;                // ss, st, tt
  T E, F, G, area, a, b, c;

  explicit Forms(const Vector3<T>* d) : s(d[0]), t(d[1]), second{d[2], d[3], d[4]} {
    using std::sqrt;
    normal = s.cross(t);
    area = sqrt(T(normal.dot(normal)));
    normal = normal / area;
    for (int k = 0; k < 3; ++k) h[k] = second[k].dot(normal);
    E = s.dot(s), F = s.dot(t), G = t.dot(t);
    // From t what runs along s is taken off for e2; what is left of its length is area / √E.
    a = T(1.0) / sqrt(E);
    b = -F / (sqrt(E) * area);
    c = sqrt(E) / area;
  }
};

// h in the frame: 11, √2 · 12, 22.
template <class T>
std::array<T, 3> curvature(const Forms<T>& f) {
  return {f.a * f.a * f.h[0], std::sqrt(2.0) * (f.a * f.b * f.h[0] + f.a * f.c * f.h[1]),
          f.b * f.b * f.h[0] + 2.0 * f.b * f.c * f.h[1] + f.c * f.c * f.h[2]};
}

// ∇h in the frame: 111, √3 · 112, √3 · 122, 222. By Codazzi it is symmetric in all three:
// ∇c hab = Xabc · n - Γd_ab hdc - Γd_ca hdb - Γd_bc hda.
template <class T>
std::array<T, 4> variation(const Forms<T>& f, const Vector3<T>* third) {
  // Christoffel symbols of ss, st and tt: their parts along s and t.
  std::array<std::array<T, 2>, 3> symbols;
  const T determinant = f.area * f.area;
  for (int k = 0; k < 3; ++k) {
    const T along_s = f.second[k].dot(f.s), along_t = f.second[k].dot(f.t);
    symbols[k] = {(f.G * along_s - f.F * along_t) / determinant,
                  (f.E * along_t - f.F * along_s) / determinant};
  }
  // Σd Γd_ab hdc, where ab is 0 (ss), 1 (st) or 2 (tt) and c is 0 (s) or 1 (t).
  const auto turned = [&](int ab, int c) -> T {
    return symbols[ab][0] * f.h[c] + symbols[ab][1] * f.h[c + 1];
  };
  const T sss = third[0].dot(f.normal) - 3.0 * turned(0, 0);
  const T sst = third[1].dot(f.normal) - turned(0, 1) - 2.0 * turned(1, 0);
  const T stt = third[2].dot(f.normal) - turned(2, 0) - 2.0 * turned(1, 1);
  const T ttt = third[3].dot(f.normal) - 3.0 * turned(2, 1);
  // For each index 1 stands a, for each 2 the b of s and c of t; √3 for three components that are
  // equal.
  const T &a = f.a, &b = f.b, &c = f.c;
  return {a * a * a * sss, std::sqrt(3.0) * a * a * (b * sss + c * sst),
          std::sqrt(3.0) * a * (b * b * sss + 2.0 * b * c * sst + c * c * stt),
          b * b * b * sss + 3.0 * b * b * c * sst + 3.0 * b * c * c * stt + c * c * c * ttt};
}

template <class T, std::size_t N>
void scale(std::array<T, N>& values, const T& factor) {
  for (T& value : values) value = value * factor;
}

// Residuals of a place, from its derivatives; T a number or one with its derivatives.
template <class T>
std::array<T, 3> curvature_residuals(const Vector3<T>* derivatives, double weight) {
  using std::sqrt;
  const Forms<T> forms(derivatives);
  std::array<T, 3> found = curvature(forms);
  // The root of dA, so that squares sum to the integral.
  scale(found, T(sqrt(T(weight * forms.area))));
  return found;
}

template <class T>
std::array<T, 4> variation_residuals(const Vector3<T>* derivatives, double weight) {
  using std::sqrt;
  const Forms<T> forms(derivatives);
  std::array<T, 4> found = variation(forms, derivatives + 5);
  scale(found, T(sqrt(T(weight * forms.area))));
  return found;
}

// The uniform cubic B-spline basis, or a derivative of it.
surface::Basis basis(double t, int order) {
  switch (order) {
    case 0:
      return surface::cubic_basis(t);
    case 1:
      return surface::cubic_basis_d1(t);
    case 2:
      return surface::cubic_basis_d2(t);
    default:
      return kThirdDerivative;
  }
}

// Weights of a piece's points in the third derivatives sss, sst, stt and ttt, a row each.
Eigen::Matrix<double, 4, Eigen::Dynamic> third_rows(const surface::PieceWeights& weights,
                                                    const surface::PieceWeights::Place& place) {
  Eigen::Matrix<double, 4, 16> of_spline;
  for (int order = 0; order < 4; ++order) {
    const surface::Basis along = basis(place.s, 3 - order), across = basis(place.t, order);
    for (int i = 0; i < 16; ++i) of_spline(order, i) = along[i % 4] * across[i / 4];
  }
  return of_spline * weights.piece(place.piece).rows;
}

Eigen::MatrixX3d points_of_piece(const std::vector<int>& which,
                                 const std::vector<Vector3d>& control_points) {
  Eigen::MatrixX3d points(static_cast<Eigen::Index>(which.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    points.row(i) = control_points[which[i]].transpose();
  }
  return points;
}

bool has_area(const Eigen::MatrixX3d& derivatives) {
  const Vector3d s = derivatives.row(0), t = derivatives.row(1);
  return s.cross(t).norm() > kNoArea * s.norm() * t.norm();
}

// residuals(derivatives, weight) with exact derivatives by the `Rows` derivatives' coordinates.
template <int Rows, class Residuals>
SurfaceEnergy::Linear differentiated(const Eigen::MatrixX3d& at, const Eigen::MatrixXd& rows,
                                     double weight, const Residuals& residuals) {
  using Number = Eigen::AutoDiffScalar<Eigen::Matrix<double, 3 * Rows, 1>>;
  std::array<Vector3<Number>, Rows> derivatives;
  for (int k = 0; k < Rows; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      // By the few coordinates of the derivatives, whatever the piece's points: these come by the
      // chain rule, as the derivatives are linear in them.
      derivatives[k][axis] = Number(at(k, axis), 3 * Rows, 3 * k + axis);
    }
  }
  const auto found = residuals(derivatives.data(), weight);
  const auto count = static_cast<Eigen::Index>(found.size());
  SurfaceEnergy::Linear linear{Eigen::VectorXd(count), Eigen::MatrixXd(count, 3 * rows.cols())};
  for (Eigen::Index r = 0; r < count; ++r) {
    linear.residuals[r] = found[r].value();
    // Column k: x, y and z of derivative k.
    const Eigen::Map<const Eigen::Matrix<double, 3, Rows>> slopes(found[r].derivatives().data());
    const Eigen::Matrix3Xd by_point = slopes * rows;
    linear.derivatives.row(r) =
        Eigen::Map<const Eigen::RowVectorXd>(by_point.data(), by_point.size());
  }
  return linear;
}

std::vector<int> all_pieces(const surface::PieceWeights& weights) {
  std::vector<int> pieces(weights.piece_count());
  std::iota(pieces.begin(), pieces.end(), 0);
  return pieces;
}

}  // namespace

SurfaceEnergy::SurfaceEnergy(const surface::PieceWeights& weights, const std::vector<int>& pieces,
                             FairEnergy energy)
    : weights_(weights), energy_(energy) {
  assert(energy == FairEnergy::kCurvature || energy == FairEnergy::kVariation);
  const auto& [count, places, shares] = analysis::kThreeNodes;
  for (int piece : pieces) {
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        const surface::PieceWeights::Place place{piece, places[i], places[j]};
        const surface::PieceWeights::Jet jet = weights.jet(place);
        Eigen::MatrixXd rows(energy == FairEnergy::kVariation ? 9 : 5, jet.ds.size());
        rows.topRows(5) << jet.ds.transpose(), jet.dt.transpose(), jet.dss.transpose(),
            jet.dst.transpose(), jet.dtt.transpose();
        if (rows.rows() == 9) rows.bottomRows(4) = third_rows(weights, place);
        places_.push_back({piece, shares[i] * shares[j], std::move(rows)});
      }
    }
  }
}

const std::vector<int>& SurfaceEnergy::points_of(const EnergyPlace& place) const {
  return weights_.piece(place.piece).points;
}

double SurfaceEnergy::value(const std::vector<Vector3d>& control_points) const {
  double sum = 0.0;
  for (const EnergyPlace& place : places_) {
    const Eigen::MatrixX3d at = place.rows * points_of_piece(points_of(place), control_points);
    // Frames divide by the area.
    if (!has_area(at)) continue;
    std::array<Vector3d, 9> derivatives;
    for (Eigen::Index k = 0; k < at.rows(); ++k) derivatives[k] = at.row(k).transpose();
    if (energy_ == FairEnergy::kCurvature) {
      for (double r : curvature_residuals<double>(derivatives.data(), place.weight)) sum += r * r;
    } else {
      for (double r : variation_residuals<double>(derivatives.data(), place.weight)) sum += r * r;
    }
  }
  return sum;
}

SurfaceEnergy::Linear SurfaceEnergy::linear(const EnergyPlace& place,
                                            const std::vector<Vector3d>& control_points) const {
  const Eigen::MatrixX3d at = place.rows * points_of_piece(points_of(place), control_points);
  if (!has_area(at)) return {};
  if (energy_ == FairEnergy::kCurvature) {
    return differentiated<5>(at, place.rows, place.weight, [](const auto* d, double weight) {
      return curvature_residuals(d, weight);
    });
  }
  return differentiated<9>(at, place.rows, place.weight, [](const auto* d, double weight) {
    return variation_residuals(d, weight);
  });
}

SurfaceEnergy::Normal SurfaceEnergy::normal(const std::vector<Vector3d>& points,
                                            const std::vector<char>& counts) const {
  const auto size = 3 * static_cast<Eigen::Index>(points.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
  Eigen::MatrixXd form;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const std::vector<int>& which = points_of(places_[k]);
    // Places of a piece follow one another: their forms are summed before they are spread.
    const bool is_first = k == 0 || places_[k].piece != places_[k - 1].piece;
    if (is_first) form.setZero(3 * which.size(), 3 * which.size());
    const Linear linear = this->linear(places_[k], points);
    if (linear.residuals.size() > 0) {
      // Gauss's: without the residuals' own second derivatives, hence never negative.
      form.noalias() += linear.derivatives.transpose() * linear.derivatives;
      const Eigen::VectorXd slopes = linear.derivatives.transpose() * linear.residuals;
      for (std::size_t i = 0; i < which.size(); ++i) {
        gradient.segment<3>(3 * which[i]) += slopes.segment<3>(3 * static_cast<Eigen::Index>(i));
      }
    }
    if (k + 1 < places_.size() && places_[k].piece == places_[k + 1].piece) continue;
    for (Eigen::Index i = 0; i < form.rows(); ++i) {
      if (!counts[which[i / 3]]) continue;
      for (Eigen::Index j = 0; j < form.cols(); ++j) {
        if (!counts[which[j / 3]]) continue;
        entries.emplace_back(3 * which[i / 3] + i % 3, 3 * which[j / 3] + j % 3, form(i, j));
      }
    }
  }
  Normal normal{Eigen::SparseMatrix<double>(size, size), std::move(gradient)};
  normal.matrix.setFromTriplets(entries.begin(), entries.end());
  return normal;
}

double fair_energy(const surface::LimitSurface& surface, FairEnergy energy) {
  const surface::PieceWeights weights(surface);
  const std::vector<Vector3d>& points = surface.mesh().points();
  if (energy == FairEnergy::kThinPlate) return thin_plate_energy(surface, weights, points);
  if (energy == FairEnergy::kCurvature || energy == FairEnergy::kVariation) {
    return SurfaceEnergy(weights, all_pieces(weights), energy).value(points);
  }
  double sum = 0.0;
  visit_energy_forms(surface, weights, all_pieces(weights), energy,
                     [&](const std::vector<int>& which, const Eigen::MatrixXd& form) {
                       Eigen::MatrixX3d at(form.rows(), 3);
                       for (Eigen::Index i = 0; i < form.rows(); ++i) {
                         at.row(i) = points[which[i]].transpose();
                       }
                       sum += (form * at).cwiseProduct(at).sum();
                     });
  return sum;
}

}  // namespace hull::modelling
