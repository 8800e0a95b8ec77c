// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_layout.h"

#include <cassert>
#include <unordered_map>

#include "mesh/refined_view.h"
#include "surface/eigenbasis/neighbourhood.h"

namespace hull::surface {
namespace {

using Level1 = mesh::Topology;
using Level2 = mesh::RefinedView<Level1>;
using Level3 = mesh::RefinedView<Level2>;

// Whether the corner of h, a neighbour along one of the two rays of an irregular corner, has no
// modified edge but those rays. The ring structure around the irregular corner allows for these.
template <class T>
bool touches_only_ray(const T& t, Scheme scheme, int h, int ray) {
  if (scheme != Scheme::kBiermann || !is_smooth_at(t, h)) return true;
  // Counter-clockwise around the corner, until round or at the end of an open fan.
  int i = h;
  do {
    if (t.edge(i) != t.edge(ray) && is_modified_edge(t, scheme, i)) return false;
    i = t.twin(t.prev(i));
  } while (i >= 0 && i != h);
  return true;
}

// Whether CornerBasis serves the cell with its irregular corner at the origin of h.
template <class T>
bool is_corner_cell(const T& t, Scheme scheme, int h) {
  const int right = t.next(h), opposite = t.next(right), left = t.next(opposite);
  for (int i : {right, opposite, left}) {
    if (!is_regular_corner(t, i)) return false;
  }
  // Creases may run along the two rays only.
  // A crease at a far side is none of the child's at the corner: the child's neighbourhood would be
  // another one, and A would not map the cell's to itself.
  if (t.is_crease(right) || t.is_crease(opposite)) return false;
  if (t.kind_at(opposite) != mesh::VertexKind::kSmooth) return false;
  if (t.kind_at(right) != mesh::VertexKind::kSmooth && !t.is_crease(h)) return false;
  if (t.kind_at(left) != mesh::VertexKind::kSmooth && !t.is_crease(left)) return false;
  // The rays are the edges of h and of left, the half-edge that ends at the irregular corner.
  return touches_only_ray(t, scheme, right, h) && touches_only_ray(t, scheme, left, left) &&
         !touches_modified_edge(t, scheme, opposite);
}

std::vector<Vector3d> refined_points(const mesh::Topology& control_topology, Scheme scheme,
                                     const mesh::Topology& cells,
                                     const std::vector<Vector3d>& control_points) {
  std::vector<Vector3d> points(cells.vertex_count(), Vector3d::Zero());
  const auto get = [&](int h) -> const Vector3d& {
    return control_points[control_topology.origin(h)];
  };
  for (int v = 0; v < cells.vertex_count(); ++v) {
    const int h = cells.outgoing(v);
    if (h >= 0) points[v] = refined_value<Vector3d>(control_topology, scheme, h, get);
  }
  return points;
}

}  // namespace

// Collects nodes and the finer points they need.
class SurfaceLayout::Builder {
 public:
  Builder(SurfaceLayout& layout, BasisCache& cache)
      : layout_(layout), cache_(cache), level2_(layout.cells_), level3_(level2_) {}

  void build() {
    const int count = layout_.cells_.face_count();
    layout_.roots_.reserve(count);
    for (int cell = 0; cell < count; ++cell) {
      layout_.roots_.push_back(node(layout_.cells_, 4 * cell));
    }
    // Third-level points follow the second-level ones, whose number is known only now.
    const int offset = layout_.cells_.vertex_count() + static_cast<int>(layout_.second_.size());
    const auto settle = [offset](int& point) {
      if (point < kNoPoint) point = offset + kThirdLevel - point;
    };
    for (auto& leaf : layout_.leaves_) {
      for (int& point : leaf) settle(point);
    }
    for (Corner& corner : layout_.corners_) {
      for (int& point : corner.points) settle(point);
    }
  }

 private:
  static constexpr int kThirdLevel = kNoPoint - 1;  // point i of the third level: kThirdLevel - i

  // The number of a refined point, which is noted as wanted the first time. Of third-level points
  // the number is a stand-in below kNoPoint until build() settles it.
  int point(const Level1& t, int h) { return t.origin(h); }
  int point(const Level2& t, int h) {
    const auto [it, is_new] =
        second_.try_emplace(t.origin(h), static_cast<int>(layout_.second_.size()));
    if (is_new) layout_.second_.push_back(h);
    return layout_.cells_.vertex_count() + it->second;
  }
  int point(const Level3& t, int h) {
    const auto [it, is_new] =
        third_.try_emplace(t.origin(h), static_cast<int>(layout_.third_.size()));
    if (is_new) layout_.third_.push_back(h);
    return kThirdLevel - it->second;
  }

  // The node of the cell whose lower left corner is the origin of h.
  template <class T>
  SurfaceNode node(const T& t, int h) {
    if (is_regular_cell(t, layout_.scheme_, h)) return leaf(t, h);
    int corner = h;
    for (int turn = 0; turn < 4; ++turn, corner = t.next(corner)) {
      // At most one: a cell with two irregular corners is split first.
      if (!is_regular_corner(t, corner) && is_corner_cell(t, layout_.scheme_, corner)) {
        return corner_node(t, corner, turn);
      }
    }
    return split(t, h);
  }

  template <class T>
  SurfaceNode leaf(const T& t, int h) {
    std::array<int, 16> points = grid_points(t, h);
    for (int& p : points) {
      if (p != kNoPoint) p = point(t, p);
    }
    layout_.leaves_.push_back(points);
    return {SurfaceNode::Kind::kLeaf, 0, static_cast<int>(layout_.leaves_.size()) - 1};
  }

  template <class T>
  SurfaceNode corner_node(const T& t, int h, int turn) {
    const CornerFan fan = corner_fan(t, h);
    Corner corner{basis(corner_key(layout_.scheme_, fan)), {}};
    for (int p : ring_points(t, fan)) corner.points.push_back(point(t, p));
    for (int p : outer_points(t, h)) corner.points.push_back(point(t, p));
    // The order of points is that in which local_matrices() built the basis: ring, then outer
    // points.
    assert(static_cast<int>(corner.points.size()) == corner.basis->point_count());
    layout_.corners_.push_back(std::move(corner));
    return {SurfaceNode::Kind::kCorner, static_cast<std::uint8_t>(turn),
            static_cast<int>(layout_.corners_.size()) - 1};
  }

  template <class T>
  SurfaceNode split(const T& t, int h) {
    const int index = static_cast<int>(layout_.splits_.size());
    // Kept free first: children may split again, and move the vector.
    layout_.splits_.emplace_back();
    // Each child begins its own half-edges at a control vertex of the split face; these are the
    // ones at its lower left corner, along u, so that all children have the cell's (u, v).
    const int children[4] = {4 * h, 4 * t.next(h) + 3, 4 * t.prev(h) + 1,
                             4 * t.next(t.next(h)) + 2};
    for (int i = 0; i < 4; ++i) {
      const SurfaceNode child = child_node(t, children[i]);
      layout_.splits_[index][i] = child;
    }
    return {SurfaceNode::Kind::kSplit, 0, index};
  }

  SurfaceNode child_node(const Level1&, int h) { return node(level2_, h); }
  SurfaceNode child_node(const Level2&, int h) { return node(level3_, h); }
  SurfaceNode child_node(const Level3&, int) {
    // Two subdivisions isolate every irregular knot and pass every modified edge (docs/surface.md,
    // trap 2).
    assert(false);
    return {};
  }

  std::shared_ptr<const CornerBasis> basis(const CornerKey& key) {
    // The shared cache takes a lock for each question; a mesh has few keys, and many cells.
    std::shared_ptr<const CornerBasis>& known = bases_[key];
    if (!known) known = cache_.get(key);
    return known;
  }

  SurfaceLayout& layout_;
  BasisCache& cache_;
  Level2 level2_;
  Level3 level3_;
  std::unordered_map<int, int> second_, third_;
  std::map<CornerKey, std::shared_ptr<const CornerBasis>> bases_;
};

SurfaceLayout::SurfaceLayout(const mesh::Topology& control_topology, Scheme scheme,
                             BasisCache& cache)
    : scheme_(scheme), cells_(control_topology.refined()) {
  Builder(*this, cache).build();
}

std::vector<Vector3d> SurfaceLayout::refine(const mesh::Topology& control_topology,
                                            const std::vector<Vector3d>& control_points) const {
  std::vector<Vector3d> points = refined_points(control_topology, scheme_, cells_, control_points);
  points.reserve(points.size() + second_.size() + third_.size());
  const auto first = [&](int h) -> const Vector3d& { return points[cells_.origin(h)]; };
  for (int h : second_) points.push_back(refined_value<Vector3d>(cells_, scheme_, h, first));
  const Level2 level2(cells_);
  std::unordered_map<int, Vector3d> known;
  const auto second = [&](int h) -> Vector3d {
    const auto [it, is_new] = known.try_emplace(level2.origin(h));
    // Several third-level points use the same second-level one, which may be no node's own.
    if (is_new) it->second = refined_value<Vector3d>(cells_, scheme_, h, first);
    return it->second;
  };
  for (int h : third_) points.push_back(refined_value<Vector3d>(level2, scheme_, h, second));
  return points;
}

void SurfaceLayout::take_leaf(int leaf, const std::vector<Vector3d>& refined,
                              BicubicPoints& points) const {
  const std::array<int, 16>& indices = leaves_[leaf];
  bool complete = true;
  for (int i = 0; i < 16; ++i) {
    if (indices[i] == kNoPoint) {
      complete = false;
    } else {
      points[i] = refined[indices[i]];
    }
  }
  if (!complete) fill_ghosts(points, indices);
}

void SurfaceLayout::take_corner(int corner, const std::vector<Vector3d>& refined,
                                CornerPoints& points) const {
  const Corner& from = corners_[corner];
  points.outer.clear();
  points.outer.reserve(from.points.size());
  for (int i : from.points) points.outer.push_back(refined[i]);
  // The rings follow from the outer square.
  from.basis->prepare(points);
}

}  // namespace hull::surface
