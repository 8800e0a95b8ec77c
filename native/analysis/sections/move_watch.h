// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/sections/cell_boxes.h"
#include "analysis/sections/plane_cut.h"
#include "surface/surface_stamp.h"

namespace hull::analysis {

// Where a surface was and is that has moved last: sections by planes that do not come near need not
// be cut again. They are what a new cut would give, as long as it is cut to the same tolerances.
class MoveWatch {
 public:
  // Nothing has moved yet. `surface` must outlive the watch.
  explicit MoveWatch(const surface::LimitSurface& surface);

  // After surface.set_points(): what has moved since the last update, or the beginning, is what
  // counts from now on. Until then the queries throw std::invalid_argument.
  void update();

  // Whether a cell that has moved comes, or came, nearer to the plane than `margin`, m. True of all
  // planes where the size of the mesh has changed, of which the rounding of a section is a part.
  bool comes_near(const Plane& plane, double margin) const;

  // The cells that have moved, in order.
  const std::vector<int>& cells() const {
    stamp_.require_current("The watch");
    return cells_;
  }

 private:
  struct Box {
    Vector3d middle, half;
  };

  surface::SurfaceStamp stamp_;
  CellBoxes boxes_;
  std::vector<int> cells_;
  std::vector<Box> moved_;  // around each of these before and after
  double size_;             // of the mesh
  bool has_other_size_ = false;
};

}  // namespace hull::analysis
