// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/derivatives/gradient.h"
#include "surface/limit_surface.h"
#include "surface/pieces/surface_squares.h"

namespace hull::analysis {

// The way back from the points that a surface is evaluated from, those of its spans, of its squares
// at irregular knots and of its borders, to its control points: all of them are sums of control
// points with weights that depend on topology, tags and scheme alone.
//
// Immutable: queries are thread-safe.
class SurfaceAdjoint {
 public:
  explicit SurfaceAdjoint(const surface::LimitSurface& surface);

  int point_count() const { return static_cast<int>(refined_.cols()); }

  // Derivatives by control points of numbers that are known by their derivatives by the surface's
  // own points.
  class Sum {
   public:
    // `numbers`: how many. `adjoint` must outlive the sum.
    Sum(const SurfaceAdjoint& adjoint, int numbers);

    // By the 16 points of a leaf, and by the outer points of a corner, as LimitSurface has them: of
    // all numbers, or of the first ones.
    void add_leaf(int leaf, PointColumns by_points);
    void add_corner(int corner, const PointColumns& by_points);
    // By the four Bézier points of a border edge, counted as border_edges() has them.
    void add_border(int edge, const PointColumns& by_points);

    // control points x 3 numbers
    PointColumns by_control_points() const;

   private:
    // A point's numbers side by side: products with sparse matrices go through these once.
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    const SurfaceAdjoint& adjoint_;
    Rows refined_, border_;
  };

  // Of a point of the surface: the weights of control points, times a direction.
  Gradient at(int cell, const Eigen::Vector2d& uv, const Vector3d& direction) const;

 private:
  const surface::LimitSurface* surface_;
  // Refined points, and four of each border edge, by control points.
  surface::WeightRows refined_, border_;
};

}  // namespace hull::analysis
