// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "network/splines/region_quads.h"

namespace hull::network {

// A region's surface over some plane domain, before it is splines.
struct StarTarget {
  std::function<PatchPoint(const Vector2d&)> at;
  std::function<Vector2d(std::size_t, double)> border;  // of a side, by its parameter
  Vector2d centre;
};

// Quads around the centre of a region: each at the corner where a side begins, between halves of
// that side and of the one before.
class QuadStar {
 public:
  // `input` and `sides` must outlive it. has_normals: whether the network's along the border count.
  QuadStar(const RegionInput& input, const std::vector<SideSpline>& sides, StarTarget target,
           bool has_normals);

  // Whether the quads cover their domain without folds.
  bool is_regular() const;
  // Of the domain: the centre, and four in each quad.
  std::vector<Vector2d> inner_places() const;
  RegionQuads quads();

 private:
  std::size_t before(std::size_t i) const { return (i + sides_.size() - 1) % sides_.size(); }
  Vector2d place(std::size_t i, double u, double v) const;
  Vector2d on_spoke(std::size_t i, double t) const;
  Vector3d middle_place(std::size_t i) const;
  FittedSpline spoke(std::size_t i) const;
  QuadSide spoke_side(std::size_t i, bool is_inwards) const;
  void add_quad(RegionQuads& made, std::size_t i) const;

  const RegionInput& input_;
  const std::vector<SideSpline>& sides_;
  StarTarget target_;
  bool has_normals_;
  std::vector<double> middles_;
  std::vector<FittedSpline> spokes_;
};

}  // namespace hull::network
