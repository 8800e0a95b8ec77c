// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/closed_shell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hull::analysis {
namespace {

constexpr int kMostInLeaf = 2;
constexpr double kTouching = 1e-9;  // of the box's diagonal
// Of a line's parameter: crossings nearer to each other may be one, at a common side of patches.
constexpr double kTogether = 1e-9;

// Directions along which nothing that is built lies.
const std::array<Vector3d, 4> kRays{
    Vector3d(0.4179, 0.5911, 0.6898), Vector3d(-0.6173, 0.3049, 0.7252),
    Vector3d(0.2237, -0.8101, 0.5419), Vector3d(-0.7793, -0.1913, 0.5967)};

// Whether the arc's shadows on the frame's planes and on the axes meet those of the box.
struct ArcShadow {
  Vector3d low, high;
  std::array<Vector3d, 2> axes;
  std::array<double, 2> middle{}, half{};

  ArcShadow(const CubicArc& arc, const ArcFrame& frame) : axes{frame.first, frame.second} {
    low = high = arc[0];
    for (const Vector3d& p : arc) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    for (int k = 0; k < 2; ++k) {
      // The frame's axes are across the arc: its shadows there are short where its box is not, as
      // of a long line aslant.
      double least = axes[k].dot(arc[0]), most = least;
      for (const Vector3d& p : arc) {
        least = std::min(least, axes[k].dot(p));
        most = std::max(most, axes[k].dot(p));
      }
      middle[k] = 0.5 * (least + most);
      half[k] = 0.5 * (most - least);
    }
  }

  bool meets(const Eigen::AlignedBox3d& box) const {
    if ((low.array() > box.max().array()).any() || (high.array() < box.min().array()).any()) {
      return false;
    }
    const Vector3d centre = 0.5 * (box.min() + box.max()), reach = 0.5 * (box.max() - box.min());
    for (int k = 0; k < 2; ++k) {
      // Half of a box's shadow on an axis is the sum of its half sides by the axis' absolute
      // components.
      const double most = axes[k].cwiseAbs().dot(reach) + half[k];
      if (std::abs(axes[k].dot(centre) - middle[k]) > most) return false;
    }
    return true;
  }
};

// False where it cannot be told by this line.
bool count_crossings(std::vector<ArcCrossing>& crossings, int& outwards) {
  std::ranges::sort(crossings, {}, &ArcCrossing::t);
  outwards = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    if (crossings[i].way == 0) return false;
    // One crossing at a common side, found in both patches, or two at a sharp edge: either guess
    // could be wrong, and another line costs little.
    if (i > 0 && crossings[i].t - crossings[i - 1].t < kTogether) return false;
    outwards += crossings[i].way;
  }
  return true;
}

}  // namespace

ClosedShell::ClosedShell(std::vector<surface::BezierPatch> patches, double least_width)
    : patches_(std::move(patches)), least_width_(least_width), order_(patches_.size()) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const surface::BezierPatch& patch : patches_) boxes.push_back(patch.box());
  std::iota(order_.begin(), order_.end(), 0);
  build(0, static_cast<int>(order_.size()), boxes);
  // What lies in a box only to rounding, as patches that are plane, must not be missed.
  const double rounding = 1e-14 * (box().diagonal().norm() + box().max().cwiseAbs().maxCoeff());
  for (Eigen::AlignedBox3d& own : boxes_) {
    own.min().array() -= rounding;
    own.max().array() += rounding;
  }
  touching_ = kTouching * box().diagonal().norm();
}

int ClosedShell::build(int begin, int end, const std::vector<Eigen::AlignedBox3d>& boxes) {
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back({begin, end});
  // Halved along the axis on which the patches' centres are spread most.
  Eigen::AlignedBox3d box, centres;
  for (int i = begin; i < end; ++i) {
    box.extend(boxes[order_[i]]);
    centres.extend(boxes[order_[i]].center());
  }
  boxes_.push_back(box);
  if (end - begin <= kMostInLeaf) return number;
  Eigen::Index axis = 0;
  centres.diagonal().maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](int a, int b) { return boxes[a].center()[axis] < boxes[b].center()[axis]; });
  // By number, not by reference: the nodes have moved when these return.
  const int left = build(begin, middle, boxes), right = build(middle, end, boxes);
  nodes_[number].left = left;
  nodes_[number].right = right;
  return number;
}

template <class Meets, class Visit>
void ClosedShell::visit(const Meets& meets, const Visit& act) const {
  // Nodes are halved by number, so that the tree is no deeper than 32 and the stack never full.
  std::array<int, 64> stack{};
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const int number = stack[--depth];
    if (!meets(boxes_[number])) continue;
    const Node& node = nodes_[number];
    if (node.left >= 0) {
      stack[depth++] = node.left;
      stack[depth++] = node.right;
      continue;
    }
    for (int i = node.begin; i < node.end; ++i) {
      if (act(patches_[order_[i]])) return;
    }
  }
}

bool ClosedShell::comes_near(const Eigen::AlignedBox3d& box) const {
  bool found = false;
  visit([&](const Eigen::AlignedBox3d& own) { return own.intersects(box); },
        [&](const surface::BezierPatch& patch) { return found = patch.box().intersects(box); });
  return found;
}

int ClosedShell::find_crossings(const CubicArc& arc, std::vector<ArcCrossing>& crossings) const {
  int parts = 0;
  const ArcFrame frame(arc);
  const ArcShadow shadow(arc, frame);
  visit([&](const Eigen::AlignedBox3d& own) { return shadow.meets(own); },
        [&](const surface::BezierPatch& patch) {
          parts += find_arc_crossings(arc, frame, patch, touching_, crossings);
          return false;
        });
  return parts;
}

bool ClosedShell::is_inside(const Vector3d& point, PartsLeft* parts_left) const {
  if (!box().contains(point)) return false;
  const double length = 2.0 * box().diagonal().norm();
  std::vector<ArcCrossing> crossings;
  int outwards = 0;
  for (const Vector3d& ray : kRays) {
    const Vector3d third = ray * (length / 3.0);
    crossings.clear();
    const int parts =
        find_crossings({point, point + third, point + 2.0 * third, point + 3.0 * third}, crossings);
    if (parts_left) *parts_left -= parts;
    if (count_crossings(crossings, outwards)) break;
  }
  // Not "one": bodies of a shell that overlap are left one by one.
  return outwards > 0;
}

}  // namespace hull::analysis
