// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "production/developable/ruled_warp.h"
#include "surface/limit_surface.h"

namespace hull::production {

// Faces of a control mesh between two chains of creases or borders. By the crease rule the surface
// of each is just (1 - v) a(t) + v b(t), a and b being the curves of its creases, where the mesh
// beside is as regular as the row, and where all is flat.
class RuledRow {
 public:
  // Of one face. Control points by their places in points().
  struct Span {
    int face;
    std::vector<int> points;
    Eigen::MatrixXd a, b;  // 4 x points: Bézier points from control points
  };

  // Throws std::invalid_argument without faces, for one that is not of four points, for one without
  // creases or borders along two opposite sides, naming it and the remedy; for darts at these; and
  // where the surface is not ruled, unless it is flat: at a corner at which it has another face, at
  // a point of a crease at which it has not just two, and beside a face that is not of four points.
  // Where all sides are creases, rulings run across the longer ones, or as in the face beside.
  RuledRow(const surface::LimitSurface& surface, const std::vector<int>& faces);

  // All control points that the curves depend on, rising.
  const std::vector<int>& points() const { return points_; }
  // Those of the chains themselves, by their places in points(); the others are ends beyond.
  const std::vector<char>& is_own() const { return is_own_; }
  int span_count() const { return static_cast<int>(spans_.size()); }
  const Span& span(int k) const { return spans_[k]; }

  // `control`: all of the mesh's points.
  BezierSpan curve(int k, bool second, const std::vector<Vector3d>& control) const;

 private:
  std::vector<int> points_;
  std::vector<char> is_own_;
  std::vector<Span> spans_;
};

}  // namespace hull::production
