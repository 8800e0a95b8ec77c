// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "surface/limit_surface.h"
#include "surface/pieces/bezier_patch.h"
#include "surface/pieces/pieces.h"

namespace hull::surface {

// Where a piece lies: a square of a node of a cell, the node seen from one of its corners.
struct PiecePlace {
  int cell;
  int turn;
  DomainSquare node;  // within the cell
  DomainSquare seen;  // within the node, as seen from corner `turn`

  // (u, v) of the cell from the piece's own (u, v).
  Eigen::Vector2d in_cell(double u, double v) const {
    const DomainSquare at =
        pieces_internal::turned_square(turn, {seen.u + seen.size * u, seen.v + seen.size * v, 0.0});
    return {node.u + node.size * at.u, node.v + node.size * at.v};
  }
};

// The square [0, 2^-kPlainRings]² at an irregular knot, within which rings of pieces shrink towards
// it without end; they are computed when a query gets there. The square of the place is the node.
struct DeepCorner {
  PiecePlace place;
  int corner;           // of the layout
  CornerPoints points;  // the innermost square and the limit only
};

// A hierarchy of boxes over all bicubic pieces of a limit surface, for queries that look for the
// nearest point (closest_point.h) or for crossings with a ray (ray_hits.h).
//
// It keeps its own copy of the pieces and shares what depends on topology alone: it needs the
// surface no longer, and does not follow set_points() until refit(). About 0.5 kB a piece; a
// regular cell is one piece. Queries are thread-safe among themselves.
class SurfaceTree {
 public:
  explicit SurfaceTree(const LimitSurface& surface);
  // Of these cells alone, as if the others were not there. Throws std::invalid_argument for none,
  // and for cells that the surface does not have.
  SurfaceTree(const LimitSurface& surface, const std::vector<int>& cells);

  // Takes the pieces of a surface of the same layout: that of the construction after set_points(),
  // or a copy of it. Nothing is sorted again, so that boxes overlap more when points have moved by
  // more than a few cells. Throws std::invalid_argument for any other surface.
  void refit(const LimitSurface& surface);

  int cell_count() const { return layout_->cells().face_count(); }
  const SurfaceLayout& layout() const { return *layout_; }
  // Diagonal of the box around the pieces' control points, m; and the size that errors refer to,
  // which is more than that far from the origin, where doubles are coarser.
  double size() const { return box_.diagonal().norm(); }
  double error_size() const { return size() + box_.min().cwiseAbs().cwiseMax(box_.max()).norm(); }
  const Eigen::AlignedBox3d& box() const { return box_; }

  // Up to four boxes side by side. A child is a node (>= 0), or an item (below -1, see item()).
  struct Node {
    alignas(32) double low[3][4];
    alignas(32) double high[3][4];
    std::int32_t child[4];
  };
  static constexpr std::int32_t kNoChild = -1;
  // Item i of a child: a piece if i < piece_count(), else the deep corner i - piece_count().
  static int item(std::int32_t child) { return -2 - child; }

  // nodes()[0] is the root.
  const std::vector<Node>& nodes() const { return nodes_; }
  int piece_count() const { return static_cast<int>(patches_.size()); }
  const BezierPatch& patch(int piece) const { return patches_[piece]; }
  const PatchShape& shape(int piece) const { return shapes_[piece]; }
  const PiecePlace& place(int piece) const { return sources_[piece].place; }
  const DeepCorner& deep_corner(int index) const { return deep_corners_[index]; }

 private:
  struct Source {
    PiecePlace place;
    int index, segment;  // of a leaf, segment -1; or of a corner and one of its plain segments
  };
  void collect(int cell, const SurfaceNode& node, const DomainSquare& square);
  void take_pieces(const LimitSurface& surface);
  Eigen::AlignedBox3d box_of(int item) const;
  std::int32_t build(int* begin, int* end, const std::vector<Eigen::AlignedBox3d>& boxes);
  void fit_boxes();

  std::shared_ptr<const SurfaceLayout> layout_;
  std::vector<Node> nodes_;  // parents before children
  std::vector<Source> sources_;
  std::vector<BezierPatch> patches_;
  std::vector<PatchShape> shapes_;
  std::vector<DeepCorner> deep_corners_;
  Eigen::AlignedBox3d box_;
};

}  // namespace hull::surface
