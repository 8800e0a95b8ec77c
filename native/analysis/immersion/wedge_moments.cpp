// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/wedge_moments.h"

#include <algorithm>
#include <array>

#include "analysis/arithmetic/small_list.h"

namespace hull::analysis {
namespace {

using surface::BicubicPoints;

constexpr int kDeepestWedge = 12;

enum class PointsSide { kBelow, kAcross, kAbove };

// Of the surface of control points, of which it is an average.
PointsSide side_of(const BicubicPoints& points, const Plane& plane, double zero) {
  double lowest = plane.height(points[0]), highest = lowest;
  for (const Vector3d& p : points) {
    lowest = std::min(lowest, plane.height(p));
    highest = std::max(highest, plane.height(p));
  }
  if (lowest > -zero) return PointsSide::kAbove;
  return highest < -zero ? PointsSide::kBelow : PointsSide::kAcross;
}

// Four control points of a uniform cubic B-spline span, `step` apart, to those of one of its
// halves: knots inserted in the middles.
void halve_line(Vector3d* p, int step, int half) {
  const Vector3d a = p[0], b = p[step], c = p[2 * step], d = p[3 * step];
  const std::array<Vector3d, 5> finer{0.5 * (a + b), 0.125 * (a + 6.0 * b + c), 0.5 * (b + c),
                                      0.125 * (b + 6.0 * c + d), 0.5 * (c + d)};
  for (int k = 0; k < 4; ++k) p[k * step] = finer[k + half];
}

// The quarter as a span of its own, over [0, 1]²: integrals are the same by any parameters.
BicubicPoints quarter_of(BicubicPoints points, int i, int j) {
  for (int row = 0; row < 4; ++row) halve_line(&points[4 * row], 1, i);
  for (int column = 0; column < 4; ++column) halve_line(&points[column], 4, j);
  return points;
}

// A corner of a polygon in a square, with its heights above both planes.
struct ShareCorner {
  double u, v;
  std::array<double, 2> height;
};

// A square loses at most one corner to each plane, and gets two for it.
using SquareShare = SmallList<ShareCorner, 8>;

SquareShare clipped(const SquareShare& polygon, int plane) {
  SquareShare kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ShareCorner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double at_a = a.height[plane], at_b = b.height[plane];
    if (at_a < 0.0) kept.push_back(a);
    if ((at_a < 0.0) == (at_b < 0.0)) continue;
    const double t = at_a / (at_a - at_b);
    kept.push_back({a.u + t * (b.u - a.u),
                    a.v + t * (b.v - a.v),
                    {a.height[0] + t * (b.height[0] - a.height[0]),
                     a.height[1] + t * (b.height[1] - a.height[1])}});
  }
  return kept;
}

// How much of a square is below both planes, by the heights of its corners.
double share_below(const BicubicPoints& points, const Plane& first, const Plane& second) {
  SquareShare polygon;
  for (const auto& [u, v] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
    const Vector3d p = surface::evaluate_bicubic(points, u, v, 0).point;
    polygon.push_back({u, v, {first.height(p), second.height(p)}});
  }
  polygon = clipped(clipped(polygon, 0), 1);
  double area = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const ShareCorner &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    area += 0.5 * (a.u * b.v - b.u * a.v);
  }
  return area;
}

ShellMoments below_both(const BicubicPoints& points, const Vector3d& origin, const Plane& first,
                        const Plane& second, const CutRules& rules, int depth) {
  const PointsSide of_first = side_of(points, first, rules.zero),
                   of_second = side_of(points, second, rules.zero);
  if (of_first == PointsSide::kAbove || of_second == PointsSide::kAbove) return {};
  // Below one plane, the other alone cuts, and exactly.
  if (of_first == PointsSide::kBelow) return wet_moments(points, origin, second, rules);
  if (of_second == PointsSide::kBelow) return wet_moments(points, origin, first, rules);
  if (depth == kDeepestWedge) {
    ShellMoments part = span_moments({points, origin}, SpanRule::kSmallest);
    part *= share_below(points, first, second);
    return part;
  }
  ShellMoments sum;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      sum += below_both(quarter_of(points, i, j), origin, first, second, rules, depth + 1);
    }
  }
  return sum;
}

}  // namespace

ShellMoments wedge_moments(const BicubicPoints& points, const Vector3d& origin,
                           std::span<const Plane> planes, const CutRules& rules) {
  if (planes.size() == 1) return wet_moments(points, origin, planes[0], rules);
  return below_both(points, origin, planes[0], planes[1], rules, 0);
}

}  // namespace hull::analysis
