// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "analysis/appendages/profile_union.h"

namespace hull::analysis {
namespace {

constexpr int kSideParts = 16;         // of each side of a patch
constexpr double kAcrossShip = 0.999;  // cosine of the angle to the ship's transverse axis

Vector2d seen(const Vector3d& p) { return {p.x(), p.z()}; }

// Andrew's monotone chain (1979), counter-clockwise.
std::vector<Vector2d> convex_hull(std::vector<Vector2d> points) {
  const auto before = [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), before);
  std::vector<Vector2d> chain;
  // Points on a straight side go, too: they are not to its left.
  const auto extend = [&](const Vector2d& p, std::size_t first) {
    while (chain.size() >= first + 2 &&
           cross(chain.end()[-1] - chain.end()[-2], p - chain.end()[-2]) <= 0.0) {
      chain.pop_back();
    }
    chain.push_back(p);
  };
  for (const Vector2d& p : points) extend(p, 0);
  // The lower side is done; the upper one begins at its end and must not take from it.
  const std::size_t first = chain.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) extend(*p, first);
  chain.pop_back();
  return chain;
}

std::vector<Vector2d> sampled(const ClosedShell& shell) {
  std::vector<Vector2d> points;
  for (const surface::BezierPatch& patch : shell.patches()) {
    for (int i = 0; i <= kSideParts; ++i) {
      for (int j = 0; j <= kSideParts; ++j) {
        const double u = static_cast<double>(i) / kSideParts,
                     v = static_cast<double>(j) / kSideParts;
        points.push_back(seen(evaluate(patch, u, v).point));
      }
    }
  }
  return points;
}

// Along one side from the tail to the nose, and back along the other.
std::vector<Vector2d> meridian(const BulbShape& bulb) {
  const double length = (bulb.tail - bulb.nose).norm();
  const Vector2d nose = seen(bulb.nose), along = seen((bulb.tail - bulb.nose) / length);
  // `along` is shorter than one where the axis runs athwartships as well, and so is the bulb as
  // seen; its breadth is not.
  const Vector2d across = Vector2d(-along.y(), along.x()).normalized();
  std::vector<Vector2d> points, others;
  for (const auto& part : outline_of(SectionForm(bulb.section), bulb.diameter / length, true)) {
    for (int i = 0; i <= kSideParts; ++i) {
      const double t = static_cast<double>(i) / kSideParts, s = 1.0 - t;
      const Vector2d p =
          s * s * s * part[0] + 3.0 * s * t * (s * part[1] + t * part[2]) + t * t * t * part[3];
      const Vector2d on_axis = nose + length * p.x() * along;
      points.push_back(on_axis + length * p.y() * across);
      others.push_back(on_axis - length * p.y() * across);
    }
  }
  points.insert(points.end(), others.rbegin(), others.rend());
  return points;
}

bool is_across_ship(const AppendageShape& shape) {
  const auto* cylinder = std::get_if<CylinderShape>(&shape);
  if (!cylinder) return false;
  return std::abs((cylinder->end - cylinder->start).normalized().y()) > kAcrossShip;
}

}  // namespace

ProfileOutline profile_outline(const Appendage& appendage) {
  ProfileOutline outline{appendage.is_cut ? MemberRole::kCut : MemberRole::kAdded, {}};
  if (appendage.is_cut && !is_across_ship(appendage.shape)) return outline;
  const auto* bulb = std::get_if<BulbShape>(&appendage.shape);
  // Seen end on a bulb has no meridian, but is convex.
  const bool lengthwise = bulb && seen(bulb->tail - bulb->nose).norm() > 0.0;
  const std::vector<Vector2d> points =
      lengthwise ? meridian(*bulb) : convex_hull(sampled(shell_of(appendage.shape)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    outline.lines.push_back({points[i], points[(i + 1) % points.size()]});
  }
  return outline;
}

}  // namespace hull::analysis
