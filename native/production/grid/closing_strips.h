// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "production/grid/hull_grid.h"

namespace hull::production {

// What the straight lines that close a border lead to: the centre plane of a half hull, the plane
// parallel to it in which the border folds onto itself, or one point.
enum class ClosingKind { kToCentrePlane, kToOwnPlane, kToPoint };

// A border's points in the order of the border, which has the surface on its left.
struct BorderLoop {
  std::vector<int> points;
  ClosingKind kind;
  Vector3d end;  // where lines lead: a point of the plane, or the point
};

// As the closing surface of one of the border's edges tells.
BorderLoop loop_closed_by(const analysis::ClosingPatch& closing, bool mirrored, double size);

// Closes loops of a grid by quadrilaterals between straight lines.
class ClosingStrips {
 public:
  // no_length: what is no longer is a point, m.
  ClosingStrips(HullGrid& grid, const GridOptions& options, double no_length)
      : grid_(grid), options_(options), no_length_(no_length) {}

  // To the points' images in the centre plane, or, if `images` are given (by point), to these.
  void close_to_centre_plane(const BorderLoop& loop, const std::vector<int>* images);
  void close_to_own_plane(const BorderLoop& loop);
  void close_to_point(const BorderLoop& loop);

 private:
  struct Line {
    int from, to;
    std::vector<int> points;  // of the line in order, its ends among them
  };

  int add_point(const Vector3d& p);
  void add_quad(int a, int b, int c, int d);
  int parts_of(const std::vector<Line>& lines) const;
  void divide(std::vector<Line>& lines);
  void add_strip(const Line& line, const Line& next);
  // Between the border's own side from `to` to `from` of an undivided line and the next line.
  void add_end(const Line& line, const Line& next);
  void close_ring(std::vector<Line> lines);

  HullGrid& grid_;
  const GridOptions& options_;
  double no_length_;
};

}  // namespace hull::production
