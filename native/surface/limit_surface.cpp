// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/limit_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "surface/place_in_cell.h"

namespace hull::surface {
namespace {

// At the corner itself: what lies beside it, by kAtCorner or more, is in a ring and has
// derivatives.
bool is_knot(const PlaceInCell& place) {
  return place.node.kind == SurfaceNode::Kind::kCorner &&
         turned(place.node.turn, place.u, place.v).maxCoeff() < kAtCorner;
}

}  // namespace

LimitSurface::LimitSurface(mesh::ControlMesh mesh, Scheme scheme, std::shared_ptr<BasisCache> cache)
    : mesh_(std::move(mesh)),
      layout_(std::make_shared<const SurfaceLayout>(mesh_.topology(), scheme, *cache)) {
  leaves_.resize(layout_->leaf_count());
  corners_.resize(layout_->corner_count());
  moved_at_.assign(cell_count(), 0);
  take_points();
}

void LimitSurface::set_points(std::vector<Vector3d> points) {
  mesh_ = mesh_.with_points(std::move(points));
  ++revision_;
  take_points();
}

void LimitSurface::take_points() {
  std::vector<Vector3d> refined = layout_->refine(mesh_.topology(), mesh_.points());
  // All of them at first, when there is nothing to compare with.
  std::vector<char> moved(refined.size(), 1);
  if (refined_.size() == refined.size()) {
    // Bitwise: a point dragged reaches two rings of cells only, all others keep what was derived.
    for (std::size_t i = 0; i < refined.size(); ++i) moved[i] = refined[i] != refined_[i];
  }
  for (int cell = 0; cell < cell_count(); ++cell) {
    if (take_node(layout_->root(cell), refined, moved)) moved_at_[cell] = revision_;
  }
  refined_ = std::move(refined);
}

std::vector<int> LimitSurface::cells_moved_since(int revision) const {
  std::vector<int> cells;
  for (int cell = 0; cell < cell_count(); ++cell) {
    if (moved_at_[cell] > revision) cells.push_back(cell);
  }
  return cells;
}

// Takes the points of a node that has moved ones; whether it has.
bool LimitSurface::take_node(const SurfaceNode& node, const std::vector<Vector3d>& refined,
                             const std::vector<char>& moved) {
  const auto has_moved = [&moved](const auto& points) {
    return std::any_of(points.begin(), points.end(),
                       [&](int point) { return point != kNoPoint && moved[point]; });
  };
  switch (node.kind) {
    case SurfaceNode::Kind::kLeaf:
      if (!has_moved(layout_->leaf_points(node.index))) return false;
      layout_->take_leaf(node.index, refined, leaves_[node.index]);
      return true;
    case SurfaceNode::Kind::kCorner:
      if (!has_moved(layout_->corner_points(node.index))) return false;
      layout_->take_corner(node.index, refined, corners_[node.index]);
      return true;
    case SurfaceNode::Kind::kSplit:
      break;
  }
  bool any = false;
  for (const SurfaceNode& child : layout_->split(node.index)) {
    // The call first: every child has to take its points.
    any = take_node(child, refined, moved) || any;
  }
  return any;
}

SurfaceJet LimitSurface::evaluate(int cell, double u, double v, int order) const {
  SurfaceJet jet;
  evaluate(cell, u, v, order, jet);
  return jet;
}

void LimitSurface::evaluate(int cell, double u, double v, int order, SurfaceJet& jet) const {
  assert(cell >= 0 && cell < cell_count());
  assert(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0);
  // A corner's basis knows only squares with the knot at (0, 0): the place is turned there, and its
  // derivatives back.
  const PlaceInCell place = find_place(*layout_, cell, u, v);
  if (place.node.kind == SurfaceNode::Kind::kLeaf) {
    evaluate_bicubic(leaves_[place.node.index], place.u, place.v, order, jet);
  } else {
    const int turn = place.node.turn;
    const Eigen::Vector2d uv = turned(turn, place.u, place.v);
    const CornerBasis& basis = layout_->basis(place.node.index);
    basis.evaluate(corners_[place.node.index], uv.x(), uv.y(), order, jet);
    if (turn != 0) turn_back(turn, jet);
  }
  // From the parameters of a quadrant to those of the cell (docs/surface.md: 4.23).
  scale_derivatives(jet, place.scale, order);
}

Vector3d LimitSurface::position(int cell, double u, double v) const {
  SurfaceJet jet;
  evaluate(cell, u, v, 0, jet);
  return jet.point;
}

bool LimitSurface::is_irregular_knot(int cell, double u, double v) const {
  return is_knot(find_place(*layout_, cell, u, v));
}

Vector3d LimitSurface::normal(int cell, double u, double v) const {
  const PlaceInCell place = find_place(*layout_, cell, u, v);
  // At a knot the tangent plane is that of the leading modes, as derivatives are zero.
  if (is_knot(place)) {
    const Vector3d direction =
        layout_->basis(place.node.index).corner_normal(corners_[place.node.index]);
    const double length = direction.norm();
    return length > 0.0 ? Vector3d(direction / length) : Vector3d::Zero();
  }
  const SurfaceJet jet = evaluate(cell, u, v, 1);
  return unit_normal(jet.du, jet.dv);
}

}  // namespace hull::surface
