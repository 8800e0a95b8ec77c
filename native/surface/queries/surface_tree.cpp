// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/queries/surface_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "surface/queries/infinity.h"

namespace hull::surface {
namespace {

// Splits items at the median of their centres along the longest side of the box around these.
int* halve(int* begin, int* end, const std::vector<Eigen::AlignedBox3d>& boxes) {
  Eigen::AlignedBox3d centres;
  for (int* i = begin; i != end; ++i) centres.extend(boxes[*i].center());
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  int* middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](int a, int b) {
    const double x = boxes[a].center()[axis], y = boxes[b].center()[axis];
    // By number among equal ones: the same tree everywhere.
    return x < y || (x == y && a < b);
  });
  return middle;
}

std::vector<int> all_cells(const LimitSurface& surface) {
  std::vector<int> cells(surface.shared_layout()->cells().face_count());
  std::iota(cells.begin(), cells.end(), 0);
  return cells;
}

}  // namespace

SurfaceTree::SurfaceTree(const LimitSurface& surface) : SurfaceTree(surface, all_cells(surface)) {}

SurfaceTree::SurfaceTree(const LimitSurface& surface, const std::vector<int>& cells)
    : layout_(surface.shared_layout()) {
  if (cells.empty()) throw std::invalid_argument("a tree needs one cell at least.");
  for (int cell : cells) {
    if (cell < 0 || cell >= cell_count()) {
      throw std::invalid_argument("cell " + std::to_string(cell) + " is none of the surface's " +
                                  std::to_string(cell_count()) + " cells.");
    }
    collect(cell, layout_->root(cell), {0.0, 0.0, 1.0});
  }
  take_pieces(surface);
  const int pieces = piece_count(), items = pieces + static_cast<int>(deep_corners_.size());
  std::vector<Eigen::AlignedBox3d> boxes(items);
  for (int i = 0; i < items; ++i) boxes[i] = box_of(i);
  std::vector<int> order(items);
  std::iota(order.begin(), order.end(), 0);
  build(order.data(), order.data() + items, boxes);

  // Neighbours in space become neighbours in memory.
  std::vector<int> now(items);
  std::iota(now.begin(), now.end(), 0);
  std::vector<Source> sources;
  std::vector<BezierPatch> patches;
  std::vector<PatchShape> shapes;
  for (int i : order) {
    if (i >= pieces) continue;
    now[i] = static_cast<int>(sources.size());
    sources.push_back(sources_[i]);
    patches.push_back(patches_[i]);
    shapes.push_back(shapes_[i]);
  }
  sources_ = std::move(sources);
  patches_ = std::move(patches);
  shapes_ = std::move(shapes);
  for (Node& node : nodes_) {
    for (std::int32_t& child : node.child) {
      // Deep corners keep their numbers, as they follow all pieces.
      if (child < kNoChild) child = -2 - now[item(child)];
    }
  }
  fit_boxes();
}

void SurfaceTree::refit(const LimitSurface& surface) {
  // One layout is one topology with its tags and scheme, and so the same pieces.
  if (surface.shared_layout() != layout_) {
    throw std::invalid_argument(
        "the tree was made of another surface; refit it to that one after moving its points, or "
        "make a new tree.");
  }
  take_pieces(surface);
  fit_boxes();
}

void SurfaceTree::collect(int cell, const SurfaceNode& node, const DomainSquare& square) {
  switch (node.kind) {
    case SurfaceNode::Kind::kLeaf:
      sources_.push_back({{cell, 0, square, {0.0, 0.0, 1.0}}, node.index, -1});
      break;
    case SurfaceNode::Kind::kCorner: {
      const CornerBasis& basis = layout_->basis(node.index);
      for (int ring = 0; ring < kPlainRings; ++ring) {
        for (int s = 0; s < basis.segment_count(); ++s) {
          const RingSegment& segment = basis.segments()[s];
          const DomainSquare seen{std::ldexp(segment.u, -ring), std::ldexp(segment.v, -ring),
                                  std::ldexp(segment.size, -ring)};
          // Numbered as CornerPoints::segments has them, ring after ring.
          sources_.push_back(
              {{cell, node.turn, square, seen}, node.index, ring * basis.segment_count() + s});
        }
      }
      CornerPoints points;
      // Their points are taken with those of the pieces, now and at each refit().
      points.limit.setZero();
      deep_corners_.push_back({{cell, node.turn, square, {0.0, 0.0, 1.0}}, node.index, points});
      break;
    }
    case SurfaceNode::Kind::kSplit:
      for (int i = 0; i < 4; ++i) {
        collect(cell, layout_->split(node.index)[i],
                pieces_internal::within(square, {0.5 * (i & 1), 0.5 * (i >> 1), 0.5}));
      }
      break;
  }
}

void SurfaceTree::take_pieces(const LimitSurface& surface) {
  patches_.resize(sources_.size());
  shapes_.resize(sources_.size());
  for (int i = 0; i < piece_count(); ++i) {
    const Source& source = sources_[i];
    patches_[i] = BezierPatch::from_bspline(
        source.segment < 0 ? surface.leaf(source.index)
                           : surface.corner(source.index).segments[source.segment]);
    shapes_[i] = shape_of(patches_[i]);
  }
  for (DeepCorner& deep : deep_corners_) {
    const CornerPoints& points = surface.corner(deep.corner);
    deep.points.inner = points.inner;
    deep.points.limit = points.limit;
  }
}

Eigen::AlignedBox3d SurfaceTree::box_of(int item) const {
  if (item < piece_count()) return patches_[item].box();
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : deep_corners_[item - piece_count()].points.inner) {
    box.extend(p);
  }
  return box;
}

std::int32_t SurfaceTree::build(int* begin, int* end,
                                const std::vector<Eigen::AlignedBox3d>& boxes) {
  const std::int32_t index = static_cast<std::int32_t>(nodes_.size());
  nodes_.emplace_back();
  int* middle = halve(begin, end, boxes);
  // Two halvings give four children; a node of three items or fewer leaves some without any.
  int* cuts[] = {begin, begin == middle ? begin : halve(begin, middle, boxes), middle,
                 halve(middle, end, boxes), end};
  for (int k = 0; k < 4; ++k) {
    const auto count = cuts[k + 1] - cuts[k];
    // The vector of nodes may move while children are built.
    const std::int32_t child = count == 0   ? kNoChild
                               : count == 1 ? -2 - *cuts[k]
                                            : build(cuts[k], cuts[k + 1], boxes);
    nodes_[index].child[k] = child;
  }
  return index;
}

void SurfaceTree::fit_boxes() {
  box_.setEmpty();
  // Children have larger numbers than their parents, so backwards they come first.
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    for (int k = 0; k < 4; ++k) {
      // An empty box is never near, and never hit.
      Eigen::AlignedBox3d box(Vector3d::Constant(kInfinity), Vector3d::Constant(-kInfinity));
      if (node.child[k] < kNoChild) {
        box = box_of(item(node.child[k]));
      } else if (node.child[k] >= 0) {
        const Node& below = nodes_[node.child[k]];
        for (int a = 0; a < 3; ++a) {
          box.min()[a] = *std::min_element(below.low[a], below.low[a] + 4);
          box.max()[a] = *std::max_element(below.high[a], below.high[a] + 4);
        }
      }
      for (int a = 0; a < 3; ++a) {
        node.low[a][k] = box.min()[a];
        node.high[a][k] = box.max()[a];
      }
      if (n == 0 && node.child[k] != kNoChild) box_.extend(box);
    }
  }
}

}  // namespace hull::surface
