// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "mesh/topology.h"
#include "surface/eigenbasis/basis_cache.h"
#include "surface/pieces/bicubic.h"

namespace hull::surface {

// What evaluates a square of the domain.
struct SurfaceNode {
  enum class Kind : std::uint8_t {
    kLeaf,    // one bicubic span: index of a leaf
    kCorner,  // one irregular knot, at corner `turn` of the square: index of a corner
    kSplit    // four squares of half the size: index of a split
  };
  Kind kind;
  std::uint8_t turn;
  int index;
};

// All of a limit surface that depends on topology, tags and scheme only: how each cell is cut into
// bicubic squares and squares with one irregular corner (the quadrants of Greshake 2021, 4.3, where
// they are needed), and which control points each takes. Immutable.
class SurfaceLayout {
 public:
  SurfaceLayout(const mesh::Topology& control_topology, Scheme scheme, BasisCache& cache);

  Scheme scheme() const { return scheme_; }
  const mesh::Topology& cells() const { return cells_; }
  const SurfaceNode& root(int cell) const { return roots_[cell]; }
  // Children (lower left, lower right, upper left, upper right) of a split.
  const std::array<SurfaceNode, 4>& split(int index) const { return splits_[index]; }
  const CornerBasis& basis(int corner) const { return *corners_[corner].basis; }

  // Which refined points a leaf takes (kNoPoint beyond creases), and a corner. A refined point is
  // one of refine(): of the once-subdivided mesh, or that at the origin of one of the half-edges of
  // the second and then the third subdivision that follow.
  const std::array<int, 16>& leaf_points(int leaf) const { return leaves_[leaf]; }
  const std::vector<int>& corner_points(int corner) const { return corners_[corner].points; }
  const std::vector<int>& second_half_edges() const { return second_; }
  const std::vector<int>& third_half_edges() const { return third_; }

  int leaf_count() const { return static_cast<int>(leaves_.size()); }
  int corner_count() const { return static_cast<int>(corners_.size()); }

  // Points of the once-subdivided mesh, then those of the second and third subdivision that
  // quadrants need, from the control points.
  std::vector<Vector3d> refine(const mesh::Topology& control_topology,
                               const std::vector<Vector3d>& control_points) const;
  // What the surface keeps of each leaf and corner, from these.
  void take_leaf(int leaf, const std::vector<Vector3d>& refined, BicubicPoints& points) const;
  void take_corner(int corner, const std::vector<Vector3d>& refined, CornerPoints& points) const;

 private:
  struct Corner {
    std::shared_ptr<const CornerBasis> basis;
    std::vector<int> points;
  };
  class Builder;

  Scheme scheme_;
  mesh::Topology cells_;
  std::vector<SurfaceNode> roots_;
  std::vector<std::array<SurfaceNode, 4>> splits_;
  std::vector<std::array<int, 16>> leaves_;  // indices of refined points, or kNoPoint
  std::vector<Corner> corners_;
  std::vector<int> second_,
      third_;  // half-edges of finer levels at whose origins points are wanted
};

}  // namespace hull::surface
