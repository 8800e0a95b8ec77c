// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/limit_surface.h"
#include "surface/sampling/grid_samples.h"
#include "surface/surface_stamp.h"

namespace hull::surface {

// The points of tessellate(surface, n) as programs that show them keep them: in single precision,
// in units of their own, of both sides where only one is modelled. They follow a surface whose
// points move, and only those of cells that have moved are computed again.
//
// First come the points of the tessellation, in its order, then the mirror images (x, -y, z) of
// those that are off the centre plane. Points within kOnCentrePlane of the hull's present size of
// it are put on it, and both sides share them.
class ShownPoints {
 public:
  // `surface` must outlive this. Throws std::invalid_argument as tessellate() does, and unless
  // metres_per_unit is positive.
  ShownPoints(const LimitSurface& surface, int n, bool mirrored, double metres_per_unit);

  // After surface.set_points(). Whether both sides share the same points as before; if not, the
  // images are numbered anew. Until then the queries tell what was shown last.
  bool update();

  // x, y, z of point after point.
  const std::vector<float>& coordinates() const { return coordinates_; }
  // Per point of the tessellation, whether both sides share it; all of them where nothing is
  // mirrored.
  const std::vector<char>& shared() const { return shared_; }

 private:
  // A sample of a cell's grid and the point that is taken from it.
  struct Taken {
    int sample, point;
  };

  bool follow_size();
  void take_cells(const std::vector<int>& cells);
  void take_point(int point, const Vector3d& position);
  void number_images();

  SurfaceStamp stamp_;
  int n_;
  bool mirrored_;
  double metres_per_unit_, centre_plane_;
  // From the centre plane: no shared point is farther, no other one nearer.
  double farthest_shared_ = 0.0, nearest_other_ = 0.0;
  std::vector<int> first_;    // of the cell in taken_, which each cell's points follow
  std::vector<Taken> taken_;  // each point is taken from one cell
  std::vector<float> coordinates_;
  std::vector<char> shared_;
  std::vector<int> images_;  // by point: number of its mirror image, itself where it is shared
  bool sharing_changed_ = false;
  GridSamples samples_;
};

}  // namespace hull::surface
