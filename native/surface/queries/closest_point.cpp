// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/queries/closest_point.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "surface/eigenbasis/deep_rings.h"
#include "surface/queries/infinity.h"
#include "surface/queries/patch_minimum.h"
#include "surface/wide_code.h"

namespace hull::surface {
namespace {

// Of the size: what is nearer by less than the rounding of positions is not looked for.
constexpr double kGap = 1e-14;
// Parts that are looked at before the gap is doubled, and from then on between doublings.
constexpr int kFreeParts = 2000, kPartsPerDoubling = 500;
// Sine of the angle to the tangent plane: a point beyond a border, beside the surface, is on
// neither side.
constexpr double kNoSide = 1e-9;

// A rectangle of a piece's (u, v).
using Part = PatchPart;

// Squared distances to the four boxes of a node.
inline void box_distances(const SurfaceTree::Node& node, const Vector3d& p, double* squares) {
  for (int k = 0; k < 4; ++k) squares[k] = 0.0;
  for (int a = 0; a < 3; ++a) {
    for (int k = 0; k < 4; ++k) {
      const double below = node.low[a][k] - p[a], above = p[a] - node.high[a][k];
      // Without branches, so that the four boxes go side by side.
      const double outside = below > above ? below : above;
      const double d = outside > 0.0 ? outside : 0.0;
      squares[k] += d * d;
    }
  }
}

// The least of direction · (p - control point): a lower bound of the distance from p when the
// direction is a unit vector.
inline double plane_bound(const BezierPatch& patch, const Vector3d& p, const Vector3d& direction) {
  double least[4] = {kInfinity, kInfinity, kInfinity, kInfinity};
  for (int j = 0; j < 16; j += 4) {
    for (int k = 0; k < 4; ++k) {
      const double t = direction[0] * (p[0] - patch.x[0][j + k]) +
                       direction[1] * (p[1] - patch.x[1][j + k]) +
                       direction[2] * (p[2] - patch.x[2][j + k]);
      least[k] = t < least[k] ? t : least[k];
    }
  }
  return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

// Lower bound of the distance by the box around the control points.
inline double box_bound(const BezierPatch& patch, const Vector3d& p) {
  double square = 0.0;
  for (int a = 0; a < 3; ++a) {
    double low[4], high[4];
    for (int k = 0; k < 4; ++k) low[k] = high[k] = patch.x[a][k];
    for (int j = 4; j < 16; j += 4) {
      for (int k = 0; k < 4; ++k) {
        const double x = patch.x[a][j + k];
        low[k] = x < low[k] ? x : low[k];
        high[k] = x > high[k] ? x : high[k];
      }
    }
    const double least = std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
    const double most = std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
    const double outside = std::max({least - p[a], p[a] - most, 0.0});
    square += outside * outside;
  }
  return std::sqrt(square);
}

HULL_WIDE double lower_bound(const BezierPatch& patch, const PatchShape& shape, const Vector3d& p) {
  const Vector3d from = p - shape.centre;
  const double distance = from.norm();
  const double box = box_bound(patch, p);
  if (!(distance > 0.0)) return box;
  // A plane across the way to the middle is the sharper one where the patch lies slanting in its
  // box.
  return std::max(box, plane_bound(patch, p, from / distance));
}

class Search {
 public:
  Search(const SurfaceTree& tree, const Vector3d& p, double radius)
      : tree_(tree), p_(p), scale_(tree.error_size()), gap_(kGap * scale_), reach_(radius) {}

  ClosestPoint run() {
    descend();
    for (int item : later_) visit_later(item);
    if (best_.cell < 0) return best_;
    best_.gap = gap_;
    describe();
    return best_;
  }

 private:
  struct Waiting {
    double square;
    std::int32_t child;
  };

  // No piece farther than this can matter.
  double limit() const { return reach_ - gap_; }
  // What is no farther than the radius by less than `gap` is looked for until that is much work.
  bool is_out(double bound) const {
    return bound > reach_ || ((best_.cell >= 0 || parts_ > kFreeParts) && bound >= limit());
  }

  void count_part() {
    // About the centre of a sphere every part is as near as any other: the accuracy asked for is
    // given up step by step, and the gap that was reached is told with the result.
    if (++parts_ > kFreeParts && (parts_ - kFreeParts) % kPartsPerDoubling == 1) gap_ *= 2.0;
  }

  HULL_WIDE void descend() {
    // Each node leaves at most three behind on the way down.
    // The median halves items twice a node, so the tree is as deep as its items have digits to the
    // base four.
    std::array<Waiting, 256> stack;
    int height = 0;
    stack[height++] = {0.0, 0};
    while (height > 0) {
      const Waiting at = stack[--height];
      if (is_out(std::sqrt(at.square))) continue;
      if (at.child < 0) {
        visit_item(SurfaceTree::item(at.child));
        continue;
      }
      const SurfaceTree::Node& node = tree_.nodes()[at.child];
      double squares[4];
      box_distances(node, p_, squares);
      // The nearest goes on top; ties in the order of the children.
      Waiting* const first = stack.data() + height;
      int count = 0;
      for (int k = 0; k < 4; ++k) {
        if (node.child[k] == SurfaceTree::kNoChild) continue;
        // Insertion from the far end: four entries, sorted with the least on top of the stack.
        int i = count++;
        for (; i > 0 && first[i - 1].square <= squares[k]; --i) first[i] = first[i - 1];
        first[i] = {squares[k], node.child[k]};
      }
      height += count;
      assert(height + 4 <= static_cast<int>(stack.size()));
    }
  }

  // Tries all pieces near enough first, so that the best foot is known well when those that were
  // not settled are cut to parts.
  void visit_item(int item) {
    if (item >= tree_.piece_count()) {
      later_.push_back(item);
      return;
    }
    count_part();
    if (!settle(tree_.patch(item), tree_.shape(item), tree_.place(item), Part{})) {
      later_.push_back(item);
    }
  }

  void visit_later(int item) {
    if (item >= tree_.piece_count()) {
      visit_deep_corner(item - tree_.piece_count());
    } else if (!is_beyond(tree_.patch(item), tree_.shape(item))) {
      split(tree_.patch(item), tree_.shape(item), tree_.place(item), Part{});
    }
  }

  // True when nothing nearer is left in the patch, after its foot was offered where need be.
  bool settle(const BezierPatch& patch, const PatchShape& shape, const PiecePlace& place,
              const Part& part) {
    if (is_beyond(patch, shape)) return true;
    const Eigen::Vector2d guess = first_guess(patch, p_);
    const PatchMinimum minimum = minimise(patch, p_, guess.x(), guess.y(), scale_);
    offer(minimum, place, part);
    return minimum.settled && is_least(patch, shape, p_ - minimum.jet.point);
  }

  // Whether a plane between the patch and p, at the best foot or across the way to the patch's
  // middle, proves that nothing nearer lies in the patch.
  bool is_beyond(const BezierPatch& patch, const PatchShape& shape) const {
    if (has_direction_ && plane_bound(patch, p_, direction_) >= limit()) return true;
    return is_out(lower_bound(patch, shape, p_));
  }

  // A patch that was not settled: by its halves, the nearer one first.
  void split(const BezierPatch& patch, const PatchShape& shape, const PiecePlace& place,
             const Part& part) {
    // Across the longer side.
    const int axis = shape.su >= shape.sv ? 0 : 1;
    // What cannot be halved any more is a point.
    if ((axis == 0 ? part.du : part.dv) < 0x1p-50) return;
    BezierPatch halves[2];
    patch.split(axis, halves[0], halves[1]);
    const PatchShape shapes[2] = {shape_of(halves[0]), shape_of(halves[1])};
    const int nearer =
        (shapes[1].centre - p_).squaredNorm() < (shapes[0].centre - p_).squaredNorm();
    // A half that is cut itself is done with before the other one, which its foot may leave out.
    for (int i : {nearer, 1 - nearer}) {
      count_part();
      const Part half = part.half(axis, i);
      if (!settle(halves[i], shapes[i], place, half)) split(halves[i], shapes[i], place, half);
    }
  }

  void visit_deep_corner(int index) {
    DeepRings rings(tree_, index);
    // The knot first: no piece holds it.
    offer_knot(rings);
    while (!rings.is_down_to_knot()) {
      count_part();
      if (is_square_out(rings.square())) return;
      rings.next_ring([this](const BezierPatch& patch, const PiecePlace& place) {
        const PatchShape shape = shape_of(patch);
        if (!settle(patch, shape, place, Part{})) split(patch, shape, place, Part{});
      });
    }
  }

  bool is_square_out(const std::vector<Vector3d>& square) const {
    Eigen::AlignedBox3d box;
    for (const Vector3d& q : square) box.extend(q);
    if (is_out(box.exteriorDistance(p_))) return true;
    if (!has_direction_) return false;
    double least = kInfinity;
    // The plane behind the best foot, as in is_beyond().
    for (const Vector3d& q : square) least = std::min(least, direction_.dot(p_ - q));
    return least >= limit();
  }

  bool take(double distance, const Vector3d& point, const Eigen::Vector2d& uv, int cell) {
    // A foot right at the search radius counts, and the first of equal ones.
    if (!(distance <= reach_) || (best_.cell >= 0 && distance == reach_)) return false;
    reach_ = distance;
    best_.cell = cell;
    best_.u = uv.x();
    best_.v = uv.y();
    best_.point = point;
    best_.distance = distance;
    has_direction_ = distance > 0.0;
    if (has_direction_) direction_ = (p_ - point) / distance;
    return true;
  }

  void offer(const PatchMinimum& minimum, const PiecePlace& place, const Part& part) {
    if (!(minimum.distance < reach_) && best_.cell >= 0) return;
    const Eigen::Vector2d uv =
        place.in_cell(part.u + part.du * minimum.u, part.v + part.dv * minimum.v);
    if (take(minimum.distance, minimum.jet.point, uv, place.cell)) {
      // A turned piece runs the same way around its cell: so does its normal.
      normal_ = unit_normal(minimum.jet.du, minimum.jet.dv);
      knot_ = -1;
    }
  }

  void offer_knot(const DeepRings& rings) {
    const double distance = (rings.knot() - p_).norm();
    const PiecePlace& place = rings.place();
    if (take(distance, rings.knot(), place.in_cell(0.0, 0.0), place.cell)) {
      knot_ = rings.index();
    }
  }

  // What the foot is like, once it is known.
  void describe() {
    const mesh::Topology& cells = tree_.layout().cells();
    const int h = 4 * best_.cell;
    const bool on_side[4] = {best_.v == 0.0, best_.u == 1.0, best_.v == 1.0, best_.u == 0.0};
    for (int k = 0; k < 4; ++k) {
      // Exactly on the side: coordinates at a bound are kept there by minimise(), and places are
      // dyadic.
      if (on_side[k] && cells.is_crease(h + k)) best_.kind = FootKind::kCrease;
      const mesh::VertexKind vertex = cells.kind_at(h + k);
      if (on_side[k] && on_side[(k + 3) % 4] &&
          (vertex == mesh::VertexKind::kCorner || vertex == mesh::VertexKind::kCone)) {
        knot_here_ = true;
      }
    }
    Vector3d normal = normal_;
    if (knot_ >= 0) {
      const DeepCorner& deep = tree_.deep_corner(knot_);
      const Vector3d along = tree_.layout().basis(deep.corner).corner_normal(deep.points);
      normal = along.norm() > 0.0 ? Vector3d(along.normalized()) : Vector3d::Zero();
    }
    if (knot_ >= 0 || knot_here_) best_.kind = FootKind::kKnot;
    const double height = normal.dot(p_ - best_.point);
    // A distance that is rounding only has no side.
    if (std::abs(height) > kNoSide * best_.distance && best_.distance > 1e-15 * scale_) {
      best_.side = height > 0.0 ? 1 : -1;
    }
  }

  const SurfaceTree& tree_;
  const Vector3d p_;
  const double scale_;
  double gap_;
  double reach_;  // the least distance known, or the search radius
  int parts_ = 0;
  std::vector<int> later_;  // items
  ClosestPoint best_;
  bool has_direction_ = false, knot_here_ = false;
  Vector3d direction_ = Vector3d::Zero(), normal_ = Vector3d::Zero();
  int knot_ = -1;  // the deep corner at whose knot the best foot is
};

void check_radius(double max_distance) {
  if (max_distance >= 0.0) return;
  std::ostringstream words;
  words << "max_distance must not be negative, but is " << max_distance << ".";
  throw std::invalid_argument(words.str());
}

}  // namespace

ClosestPoint closest_point(const SurfaceTree& tree, const Vector3d& p, double max_distance) {
  check_radius(max_distance);
  if (!p.allFinite()) throw std::invalid_argument("the point is not finite.");
  return Search(tree, p, max_distance).run();
}

std::vector<ClosestPoint> closest_points(const SurfaceTree& tree,
                                         const std::vector<Vector3d>& points, double max_distance) {
  check_radius(max_distance);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite()) continue;
    throw std::invalid_argument("points[" + std::to_string(i) + "] is not finite.");
  }
  std::vector<ClosestPoint> result;
  result.reserve(points.size());
  // Points to an entry of the result, which was reserved and so does not move.
  const ClosestPoint* known = nullptr;
  for (const Vector3d& p : points) {
    double radius = max_distance;
    // The foot of the point before is no nearer than that of this one.
    if (known) {
      const double slack = 1e-12 * tree.error_size();
      radius = std::min(radius, (known->point - p).norm() * (1.0 + 1e-12) + slack);
    }
    result.push_back(Search(tree, p, radius).run());
    if (result.back().cell >= 0) known = &result.back();
  }
  return result;
}

}  // namespace hull::surface
