// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "mesh/vectors.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {

// What a fair surface has little of.
enum class FairEnergy {
  // The same as kCurvature, but squared second derivatives to the metric of the surface as it was:
  // quadratic in the control points (thin_plate.h).
  kThinPlate,
  // Of the thin plate only what bends along the ship (visit_lengthwise_forms in thin_plate.h): the
  // sections' own bend, that of bilges above all, costs nothing. Quadratic, too.
  kLengthwise,
  // ∫ |∂⁶S/∂u³∂v³|² du dv, m², u and v along the rows of the mesh: what is not blended from rows
  // along and across (blend_energy.h). The bends that all rows have cost nothing. Quadratic, too.
  kBlend,
  // ∫ κ1² + κ2² dA: a number; a sphere has 8π.
  kCurvature,
  // ∫ |∇h|² dA, m⁻², h the second fundamental form and ∇ its covariant derivative: in an
  // orthonormal frame h111² + 3 h112² + 3 h122² + h222². Spheres, cylinders and planes have none.
  // Along the principal directions these are dκ1/de1, dκ1/de2, dκ2/de1 and dκ2/de2: it is the
  // minimum variation functional of Moreton and Séquin 1992 with the two mixed terms besides, by
  // which no frame is singled out. Flats and umbilics have no principal directions, and theirs
  // would leave the functional without a derivative there.
  kVariation
};

// A place of the quadrature over a surface, on a bicubic piece: weights of the piece's points in
// the derivatives s, t, ss, st, tt, and in the variation's case sss, sst, stt, ttt, a row each.
struct EnergyPlace {
  int piece;
  double weight;  // of the rule
  Eigen::MatrixXd rows;
};

// An energy as a sum of squares over places on some pieces of a surface. Squares at irregular knots
// are left out as by thin_plate.h, and so are places without area.
class SurfaceEnergy {
 public:
  // What a place adds to the energy is |residuals|².
  static constexpr int kMostResiduals = 4;
  struct Linear {
    Eigen::VectorXd residuals;    // none where there is no area
    Eigen::MatrixXd derivatives;  // by (x, y, z) of each of the piece's points
  };

  // Of Gauss's normal equations: derivativesᵀ · derivatives, and half the energy's gradient.
  struct Normal {
    Eigen::SparseMatrix<double> matrix;
    Eigen::VectorXd gradient;
  };

  // REQUIRES: energy is kCurvature or kVariation, the ones that are not quadratic.
  SurfaceEnergy(const surface::PieceWeights& weights, const std::vector<int>& pieces,
                FairEnergy energy);

  const std::vector<EnergyPlace>& places() const { return places_; }
  const std::vector<int>& points_of(const EnergyPlace& place) const;

  double value(const std::vector<Vector3d>& control_points) const;
  // Residuals and their exact derivatives by the control points.
  Linear linear(const EnergyPlace& place, const std::vector<Vector3d>& control_points) const;
  // By (x, y, z) of all control points; of the matrix only those for which `counts` is not 0.
  Normal normal(const std::vector<Vector3d>& control_points, const std::vector<char>& counts) const;

 private:
  const surface::PieceWeights& weights_;
  FairEnergy energy_;
  std::vector<EnergyPlace> places_;
};

// The energy of the whole surface.
double fair_energy(const surface::LimitSurface& surface, FairEnergy energy);

}  // namespace hull::modelling
