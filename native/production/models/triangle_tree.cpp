// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/models/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hull::production {
namespace {

constexpr int kInLeaf = 4;

struct OnTriangle {
  Vector3d point;
  bool within;
};

// Ericson 2005, 5.1.5; triangles that are a line or a point, too.
OnTriangle nearest_on(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, false};
  const Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {b, false};
  const double vc = d1 * d4 - d3 * d2;
  // With d1 > d3 nothing is divided by zero on a side without length; likewise below.
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3) return {a + d1 / (d1 - d3) * ab, false};
  const Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {c, false};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6) return {a + d2 / (d2 - d6) * ac, false};
  const double va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
  if (va <= 0.0 && along >= 0.0 && back >= 0.0 && along + back > 0.0) {
    return {b + along / (along + back) * (c - b), false};
  }
  const double sum = va + vb + vc;
  if (!(sum > 0.0)) return {a, false};
  return {a + vb / sum * ab + vc / sum * ac, true};
}

}  // namespace

TriangleTree::TriangleTree(const ClosedModel& model)
    : model_(model), order_(model.triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::vector<Vector3d> centres;
  centres.reserve(order_.size());
  for (const auto& [a, b, c] : model.triangles) {
    centres.push_back((model.points[a] + model.points[b] + model.points[c]) / 3.0);
  }
  nodes_.reserve(order_.size());
  build(0, static_cast<int>(order_.size()), centres);
}

int TriangleTree::build(int begin, int end, const std::vector<Vector3d>& centres) {
  // Before its children, so that the root is node 0.
  const int number = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox3d box, inner;
  for (int i = begin; i < end; ++i) {
    for (const int corner : model_.triangles[order_[i]]) box.extend(model_.points[corner]);
    inner.extend(centres[order_[i]]);
  }
  nodes_[number].box = box;
  nodes_[number].begin = begin;
  nodes_[number].end = end;
  if (end - begin <= kInLeaf) return number;
  int axis = 0;
  inner.sizes().maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  // Halves of equal number: the tree is as deep as its logarithm, and a query's stack can't run
  // full.
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int a, int b) { return centres[a][axis] < centres[b][axis]; });
  const int left = build(begin, middle, centres), right = build(middle, end, centres);
  nodes_[number].left = left;
  nodes_[number].right = right;
  return number;
}

TriangleTree::Nearest TriangleTree::nearest(const Vector3d& p, double no_further) const {
  // Rounding must not exclude the point that the distance is known from.
  Nearest best{p, no_further * (1.0 + 1e-12), -1, false};
  double squared = best.distance * best.distance;
  std::array<std::pair<int, double>, 128> stack;
  int depth = 0;
  stack[depth++] = {0, nodes_[0].box.squaredExteriorDistance(p)};
  while (depth > 0) {
    const auto [number, away] = stack[--depth];
    if (away > squared) continue;
    const Node& node = nodes_[number];
    if (node.left >= 0) {
      // The nearer half is looked at first, and lowers the bound for the other one.
      const double left = nodes_[node.left].box.squaredExteriorDistance(p);
      const double right = nodes_[node.right].box.squaredExteriorDistance(p);
      const bool left_first = left <= right;
      stack[depth++] = left_first ? std::pair(node.right, right) : std::pair(node.left, left);
      stack[depth++] = left_first ? std::pair(node.left, left) : std::pair(node.right, right);
      continue;
    }
    for (int i = node.begin; i < node.end; ++i) {
      const auto& [a, b, c] = model_.triangles[order_[i]];
      const OnTriangle found = nearest_on(p, model_.points[a], model_.points[b], model_.points[c]);
      const double distance = (found.point - p).squaredNorm();
      // A tie with the bound itself is taken; of triangles that tie the first one stays.
      if (distance > squared || (distance == squared && best.triangle >= 0)) continue;
      squared = distance;
      best = {found.point, std::sqrt(distance), order_[i], found.within};
    }
  }
  return best;
}

bool TriangleTree::encloses(const Vector3d& p) const {
  double sum = 0.0;  // of solid angles (Oosterom and Strackee 1983)
  for (const auto& [ia, ib, ic] : model_.triangles) {
    const Vector3d a = model_.points[ia] - p, b = model_.points[ib] - p, c = model_.points[ic] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2.0 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  // All of it is 4 pi inside and 0 outside.
  return sum > 2.0 * M_PI;
}

}  // namespace hull::production
