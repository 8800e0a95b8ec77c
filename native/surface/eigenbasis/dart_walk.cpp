// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/eigenbasis/dart_walk.h"

#include <Eigen/Geometry>
#include <cassert>
#include <limits>

#include "surface/eigenbasis/subdivision_rules.h"

namespace hull::surface {

DartWalk::DartWalk(const LimitSurface& surface, int h)
    : extent_(std::numeric_limits<double>::infinity()) {
  const SurfaceLayout& layout = surface.layout();
  // Cell h has the dart at its (0, 0).
  const SurfaceNode* node = &layout.root(h);
  for (; node->kind == SurfaceNode::Kind::kSplit; ++depth_) {
    node = &layout.split(node->index)[0];
  }
  assert(node->kind == SurfaceNode::Kind::kCorner && node->turn == 0 && depth_ < 3);
  ring_.emplace(layout.basis(node->index), surface.corner(node->index));

  const mesh::Topology& t = surface.mesh().topology();
  const Scheme scheme = surface.scheme();
  const auto level0 = [&](int g) -> const Vector3d& {
    return surface.mesh().points()[t.origin(g)];
  };
  const auto level1 = [&](int g) -> Vector3d {
    return refined_value<Vector3d>(t, scheme, g, level0);
  };
  // Control points of the levels above the square that the corner's basis begins with.
  first_[0] = level0(h);
  first_[1] = level1(4 * h);
  // Of the second level only the dart itself, by the rule on the cells' topology.
  first_[2] = vertex_point<Vector3d>(layout.cells(), 4 * h, level1);
  point_ = first_[0];
}

void DartWalk::advance() {
  ++level_;
  if (level_ <= depth_) {
    point_ = first_[level_];
    return;
  }
  // Level depth_ + 1 is the ring's first square as it is.
  if (level_ > depth_ + 1) ring_->advance();
  take_ring();
}

void DartWalk::take_ring() {
  // The ring's first point is the corner; the square is half a control edge long.
  const std::vector<Vector3d> points = ring_->points();
  point_ = points.front();
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points) box.extend(p);
  extent_ = box.diagonal().norm();
}

}  // namespace hull::surface
