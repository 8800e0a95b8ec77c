// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/own_overlaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "analysis/appendages/hull_members.h"
#include "surface/parallel_for.h"

namespace hull::analysis {
namespace {

constexpr double kShared = 1e-9;  // of the smaller box: what boxes and bodies share by rounding
constexpr double kTolerance = 1e-9;
constexpr int kSamples = 1024;
constexpr std::size_t kSampleGrain = 16;  // samples that a thread takes at a time
// Parts of lines of all pairs together, what two processors take half a second and more for, and
// what samples count for.
constexpr int kMostPairParts = 6000000, kPartsOfSamples = 500000;

using Box = Eigen::AlignedBox3d;

double space_in(const Box& box) { return box.isEmpty() ? 0.0 : box.volume(); }

bool share_space(const Box& a, const Box& b) {
  return space_in(a.intersection(b)) > kShared * std::min(space_in(a), space_in(b));
}

// By pairs of bodies (i < j) whose boxes have space in common.
template <class Visit>
void for_each_near(const std::vector<Box>& boxes, const Visit& visit) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (share_space(boxes[i], boxes[j])) visit(static_cast<int>(i), static_cast<int>(j));
    }
  }
}

// Of the modelled side, closings included, as their points are the cells'.
std::vector<Box> boxes_of_bodies(const HullBody& body) {
  const Bodies& bodies = body.bodies();
  std::vector<Box> boxes(bodies.first_cell.size());
  if (boxes.size() < 2) return {};
  for (std::size_t cell = 0; cell < bodies.of_cell.size(); ++cell) {
    const int k = static_cast<int>(cell);
    boxes[bodies.of_cell[cell]].extend(Box(body.boxes().low(k), body.boxes().high(k)));
  }
  if (body.mirrored()) {
    // Closings of a half reach from the border to the centre plane.
    for (Box& box : boxes) box.extend(Vector3d(box.min().x(), 0.0, box.min().z()));
  }
  return boxes;
}

// None where surfaces lie in one another, or parts_left are not enough.
std::optional<double> exact_overlap(const JoinedMember& a, const JoinedMember& b,
                                    PartsLeft& parts_left) {
  try {
    const JoinedShells joined({a, b}, a.shell.box().center(), kTolerance, &parts_left);
    // What both have in common counts once less: the change is its volume, negative.
    return -joined.whole_change().first.trace() / 3.0;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// Points that are spread evenly and are in no plane of the box: multiples of powers of an
// irrational number, modulo 1.
std::vector<Vector3d> samples_of(const Box& box) {
  // The root of x^4 = x + 1, for three dimensions what the golden ratio is for one.
  constexpr double kRoot = 1.2207440846057596;
  Vector3d at = Vector3d::Constant(0.5);
  const Vector3d step(1.0 / kRoot, 1.0 / (kRoot * kRoot), 1.0 / (kRoot * kRoot * kRoot));
  std::vector<Vector3d> points(kSamples);
  for (Vector3d& point : points) {
    at += step;
    at = at.unaryExpr([](double x) { return x - std::floor(x); });
    point = box.min() + at.cwiseProduct(box.sizes());
  }
  return points;
}

double sampled_overlap(const ClosedShell& a, const ClosedShell& b) {
  const Box box = a.box().intersection(b.box());
  const std::vector<Vector3d> points = samples_of(box);
  std::atomic<int> both = 0;
  const auto count = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      // A count does not depend on the threads' order.
      if (a.is_inside(points[i]) && b.is_inside(points[i])) ++both;
    }
  };
  surface::parallel_for(points.size(), surface::kAllProcessors, count, kSampleGrain);
  return space_in(box) * both / kSamples;
}

}  // namespace

bool may_overlap(const HullBody& body) {
  bool is_near = false;
  for_each_near(boxes_of_bodies(body), [&](int, int) { is_near = true; });
  return is_near;
}

std::vector<OwnOverlap> own_overlaps(const HullBody& body) {
  std::vector<OwnOverlap> found;
  if (!may_overlap(body)) return found;
  const std::vector<JoinedMember> members = hull_members(body);
  std::vector<Box> boxes;
  for (const JoinedMember& member : members) {
    const bool is_sheet = enclosed_share(member.shell) <= kSheetShare;
    boxes.push_back(is_sheet ? Box() : member.shell.box());
  }
  int parts_left = kMostPairParts;
  for_each_near(boxes, [&](int i, int j) {
    if (parts_left < 0) return;
    const ClosedShell &a = members[i].shell, &b = members[j].shell;
    // So that one pair of many does not take it all.
    PartsLeft own_left = std::max(kPartsOfSamples, parts_left / 4 * 3);
    parts_left -= own_left;
    const std::optional<double> exact = exact_overlap(members[i], members[j], own_left);
    // What was not needed comes back; how far below zero a refused pair ended depends on the
    // threads.
    parts_left += std::max(own_left.load(), 0);
    if (!exact) parts_left -= kPartsOfSamples;
    const double volume = exact ? *exact : sampled_overlap(a, b);
    if (volume > kShared * std::min(space_in(a.box()), space_in(b.box()))) {
      found.push_back({i, j, volume, exact.has_value()});
    }
  });
  return found;
}

}  // namespace hull::analysis
