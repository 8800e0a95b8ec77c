// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/move_watch.h"

#include <algorithm>
#include <cmath>

namespace hull::analysis {

MoveWatch::MoveWatch(const surface::LimitSurface& surface)
    : stamp_(surface), boxes_(surface), size_(surface.mesh().size()) {}

void MoveWatch::update() {
  const surface::LimitSurface& surface = stamp_.surface();
  cells_ = surface.cells_moved_since(stamp_.revision());
  moved_.clear();
  // For now low and high: where the cell was counts as well as where it is.
  for (const int cell : cells_) moved_.push_back({boxes_.low(cell), boxes_.high(cell)});
  boxes_.update(surface);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Vector3d low = moved_[i].middle.cwiseMin(boxes_.low(cells_[i]));
    const Vector3d high = moved_[i].half.cwiseMax(boxes_.high(cells_[i]));
    moved_[i] = {0.5 * (low + high), 0.5 * (high - low)};
  }
  has_other_size_ = surface.mesh().size() != size_;
  size_ = surface.mesh().size();
  stamp_.renew();
}

bool MoveWatch::comes_near(const Plane& plane, double margin) const {
  stamp_.require_current("The watch");
  if (has_other_size_) return true;
  const Vector3d extent = plane.normal.cwiseAbs();
  return std::any_of(moved_.begin(), moved_.end(), [&](const Box& box) {
    return std::abs(plane.height(box.middle)) <= extent.dot(box.half) + margin;
  });
}

}  // namespace hull::analysis
