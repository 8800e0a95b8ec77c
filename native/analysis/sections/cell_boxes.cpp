// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/cell_boxes.h"

#include <limits>

namespace hull::analysis {

CellBoxes::CellBoxes(const surface::LimitSurface& surface)
    : low_(surface.cell_count()), high_(surface.cell_count()), revision_(surface.revision()) {
  for (int cell = 0; cell < surface.cell_count(); ++cell) take(surface, cell);
}

void CellBoxes::update(const surface::LimitSurface& surface) {
  for (const int cell : surface.cells_moved_since(revision_)) take(surface, cell);
  revision_ = surface.revision();
}

void CellBoxes::take(const surface::LimitSurface& surface, int cell) {
  low_[cell].setConstant(std::numeric_limits<double>::infinity());
  high_[cell].setConstant(-std::numeric_limits<double>::infinity());
  add(surface, surface.layout().root(cell), cell);
}

void CellBoxes::add(const surface::LimitSurface& surface, const surface::SurfaceNode& node,
                    int cell) {
  Vector3d low = low_[cell], high = high_[cell];
  const auto extend = [&](const auto& points) {
    for (const Vector3d& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  };
  switch (node.kind) {
    case surface::SurfaceNode::Kind::kLeaf:
      extend(surface.leaf(node.index));
      break;
    case surface::SurfaceNode::Kind::kCorner:
      // All spans of the rings around an irregular corner are affine combinations of these with
      // weights that are not negative: their hull holds the square.
      extend(surface.corner(node.index).outer);
      break;
    case surface::SurfaceNode::Kind::kSplit:
      for (const surface::SurfaceNode& child : surface.layout().split(node.index)) {
        add(surface, child, cell);
      }
      return;
  }
  low_[cell] = low;
  high_[cell] = high;
}

}  // namespace hull::analysis
