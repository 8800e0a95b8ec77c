// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "modelling/reshape/place_weights.h"
#include "surface/limit_surface.h"

namespace hull::modelling {

// Places all over a surface, each with the area that it stands for: sums over them are integrals
// over the surface. The square that is left at an irregular knot is one place, with what the areas
// of the rings around it tend to.
//
// Position and derivatives there are sums over control points whose weights depend on topology,
// tags and scheme alone. Areas and normals are those of the surface as given.
class SurfacePlaces {
 public:
  explicit SurfacePlaces(const surface::LimitSurface& surface, int per_side = 3);
  // With weights made before, of a surface that differs in its points only: much sooner done.
  // Throws std::invalid_argument where it differs otherwise.
  SurfacePlaces(const surface::LimitSurface& surface, std::shared_ptr<const PlaceWeights> weights);

  int count() const { return weights_->count(); }
  int cell(int place) const { return weights_->cell(place); }
  const Vector3d& position(int place) const { return positions_[place]; }  // m
  double area(int place) const { return areas_[place]; }                   // m²
  // Of length 1; zero at irregular knots and where there is no area.
  const Vector3d& normal(int place) const { return normals_[place]; }
  double total_area() const { return total_area_; }
  int point_count() const { return weights_->point_count(); }

  const std::shared_ptr<const PlaceWeights>& weights() const { return weights_; }

  // The first place where the normal of the surface with these control points is turned by a right
  // angle or more against what it was, as where a fold came into being; -1: none.
  int first_fold(const std::vector<Vector3d>& control_points) const;
  // All such places, rising.
  std::vector<int> folds(const std::vector<Vector3d>& control_points) const;

  // The control points on which no place depends where a shift is wanted (any that is not zero to
  // the last bit), rising: the extent of the wanted shift ends before them. Locked, they and the
  // surface around them stay bit by bit, and nothing is wanted of them. Throws
  // std::invalid_argument unless there is a shift for each place.
  std::vector<int> points_beyond(const std::vector<Vector3d>& shifts) const;

 private:
  void measure(const std::vector<Vector3d>& points);

  std::shared_ptr<const PlaceWeights> weights_;
  std::vector<Vector3d> positions_, normals_;
  std::vector<double> areas_;
  double total_area_ = 0.0;
};

// The first of the gradients ∇s of a wanted shift s (rows: components, columns: by x, y, z) by
// which space itself is folded, det(I + ∇s) <= 0, or that is no number; -1: none. Where every place
// of a surface has its gradient no surface could follow without a fold there.
int first_folded(const std::vector<Eigen::Matrix3d>& gradients);

// Vectors as the rows of a matrix.
VectorRows rows_of(const std::vector<Vector3d>& vectors);
// Coordinates of vectors one after the other, seen as the rows of a matrix.
inline Eigen::Map<const VectorRows> as_rows(const Eigen::VectorXd& coordinates) {
  return {coordinates.data(), coordinates.size() / 3, 3};
}

}  // namespace hull::modelling
