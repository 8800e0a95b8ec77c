// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "surface/limit_surface.h"

namespace hull::modelling {

// Places all over a surface, each with the area that it stands for: sums over them are integrals
// over the surface (Gauss's rule in each bicubic piece, fewer points in the rings around irregular
// knots; the innermost square there is one place, at the knot, with what the areas of the rings
// tend to).
//
// Position and derivatives there are sums over control points whose weights depend on topology,
// tags and scheme alone (point_weights.h). Areas and normals are those of the surface as given.
class SurfacePlaces {
 public:
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  explicit SurfacePlaces(const surface::LimitSurface& surface);

  int count() const { return static_cast<int>(cells_.size()); }
  int cell(int place) const { return cells_[place]; }
  const Vector3d& position(int place) const { return positions_[place]; }  // m
  double area(int place) const { return areas_[place]; }                   // m²
  double total_area() const { return total_area_; }

  // Places x control points: weights of positions, and of two derivatives along the surface (of
  // lengths that mean nothing; empty rows at irregular knots and where there is no area).
  const Rows& rows() const { return rows_; }

  // The first place where the normal of the surface with these control points is turned by a right
  // angle or more against what it was, as where a fold came into being; -1: none.
  int first_fold(const std::vector<Vector3d>& control_points) const;

 private:
  class Builder;

  std::vector<int> cells_;
  std::vector<Vector3d> positions_, normals_;
  std::vector<double> areas_;
  double total_area_ = 0.0;
  Rows rows_, along_s_, along_t_;
};

}  // namespace hull::modelling
