// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/arc_crossings.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace hull::analysis {
namespace {

constexpr int kMostParts = 2000;
constexpr int kMostSteps = 12;
constexpr double kBeyond = 1e-9;  // of a parameter's range: roots at sides belong to both patches

struct Range {
  double low = 0.0, size = 1.0;
  double middle() const { return low + 0.5 * size; }
  // How far x is outside.
  double beyond(double x) const { return std::max(low - x, x - low - size); }
};

// What vectors have in common, and how far they are from that at most.
struct Spread {
  Vector3d mean = Vector3d::Zero();
  double reach = 0.0;

  template <class Vectors>
  explicit Spread(const Vectors& vectors) {
    for (const Vector3d& v : vectors) mean += v;
    mean /= static_cast<double>(vectors.size());
    for (const Vector3d& v : vectors) reach = std::max(reach, (v - mean).squaredNorm());
    reach = std::sqrt(reach);
  }
};

void halve_arc(const CubicArc& arc, CubicArc& low, CubicArc& high) {
  const Vector3d ab = 0.5 * (arc[0] + arc[1]), bc = 0.5 * (arc[1] + arc[2]),
                 cd = 0.5 * (arc[2] + arc[3]);
  const Vector3d abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
  low = {arc[0], ab, abc, middle};
  high = {middle, bcd, cd, arc[3]};
}

struct Interval {
  double low, high;
};

Interval shadow(const CubicArc& arc, const Vector3d& on) {
  Interval interval{on.dot(arc[0]), on.dot(arc[0])};
  for (int i = 1; i < 4; ++i) {
    const double x = on.dot(arc[i]);
    interval = {std::min(interval.low, x), std::max(interval.high, x)};
  }
  return interval;
}

Interval shadow(const surface::BezierPatch& patch, const Vector3d& on) {
  double low = on.dot(patch.point(0)), high = low;
  for (int i = 1; i < 16; ++i) {
    const double x = on[0] * patch.x[0][i] + on[1] * patch.x[1][i] + on[2] * patch.x[2][i];
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return {low, high};
}

// The equations arc(t) = S(u, v) by bisection of (t, u, v) and Newton's method. Parts carry Bezier
// points of their own over [0, 1]; ranges say where they are in the whole arc and patch.
class ArcSearch {
 public:
  ArcSearch(const CubicArc& arc, const ArcFrame& frame, const surface::BezierPatch& patch,
            double touching, std::vector<ArcCrossing>& found)
      : arc_(arc), frame_(frame), patch_(patch), touching_(touching), found_(found) {
    // Rounding of a shadow goes with the coordinates, not with the part's size.
    for (const Vector3d& p : arc) scale_ = std::max(scale_, p.cwiseAbs().maxCoeff());
  }

  void search(const CubicArc& arc, const surface::BezierPatch& patch, Range t, Range u, Range v) {
    ++parts_;
    if (are_apart(arc, patch)) return;
    // Derivatives of a Bezier form lie in the convex hull of its differences, but for the factor
    // three, which all of them have.
    const std::array<Vector3d, 3> steps{arc[1] - arc[0], arc[2] - arc[1], arc[3] - arc[2]};
    std::array<Vector3d, 12> along_u, along_v;
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 3; ++i) {
        along_u[3 * j + i] = patch.point(4 * j + i + 1) - patch.point(4 * j + i);
        along_v[3 * j + i] = patch.point(4 * (i + 1) + j) - patch.point(4 * i + j);
      }
    }
    const Spread dt(steps), du(along_u), dv(along_v);
    const Vector3d normal = du.mean.cross(dv.mean);
    // Along its normal a part is thin, where an arc runs beside it for long.
    if (normal.norm() > 0.0 && are_apart_along(arc, patch, normal.normalized())) return;
    const double det = normal.dot(dt.mean);
    const double a = dt.mean.norm(), b = du.mean.norm(), c = dv.mean.norm();
    // No linear combination of derivatives within their bounds is singular.
    // By Hadamard's inequality for all terms of the determinant but that of the means.
    const double off = (a + dt.reach) * (b + du.reach) * (c + dv.reach) - a * b * c;
    if (std::abs(det) > off && take_only_root(t, u, v, det > 0.0 ? 1 : -1)) return;
    // The longest is halved, so that the parts of arc and patch shrink to one size.
    const double sizes[] = {a + dt.reach, b + du.reach, c + dv.reach};
    const int longest = static_cast<int>(std::max_element(sizes, sizes + 3) - sizes);
    // Beyond the limit nothing is halved any more: each part still waiting is left out or touches.
    if (3.0 * sizes[longest] < touching_ || parts_ > kMostParts) {
      found_.push_back({t.middle(), 0});
      return;
    }
    halve(arc, patch, t, u, v, longest);
  }

  int parts() const { return parts_; }

 private:
  bool are_apart(const CubicArc& arc, const surface::BezierPatch& patch) const {
    // Across the arc first, where its shadow is shortest.
    const Vector3d axes[] = {frame_.first, frame_.second, Vector3d::UnitX(), Vector3d::UnitY(),
                             Vector3d::UnitZ()};
    return std::ranges::any_of(
        axes, [&](const Vector3d& axis) { return are_apart_along(arc, patch, axis); });
  }

  bool are_apart_along(const CubicArc& arc, const surface::BezierPatch& patch,
                       const Vector3d& axis) const {
    const double slack = 1e-13 * scale_;
    const Interval a = shadow(arc, axis), b = shadow(patch, axis);
    return a.low > b.high + slack || b.low > a.high + slack;
  }

  // Newton's method from the middle. False where it says nothing.
  bool take_only_root(Range t, Range u, Range v, int way) {
    // In the whole arc and patch, not the part's own points, so that a root is the same to rounding
    // from whichever part it is found.
    double x = t.middle(), y = u.middle(), z = v.middle();
    surface::SurfaceJet jet;
    for (int step = 0; step < kMostSteps; ++step) {
      const CubicArc& p = arc_;
      const double s = 1.0 - x;
      const Vector3d slope =
          3.0 * (s * s * (p[1] - p[0]) + 2.0 * s * x * (p[2] - p[1]) + x * x * (p[3] - p[2]));
      surface::evaluate_first(patch_, y, z, jet);
      const Vector3d rest = jet.point - arc_point(p, x);
      Eigen::Matrix3d jacobian;
      jacobian << slope, -jet.du, -jet.dv;
      const Vector3d move = jacobian.partialPivLu().solve(rest);
      x += move[0], y += move[1], z += move[2];
      // Some way beyond the part is allowed: a step may come back from there.
      if (t.beyond(x) > t.size || u.beyond(y) > u.size || v.beyond(z) > v.size) return false;
      if (!move.allFinite()) return false;
      if (move.cwiseAbs().maxCoeff() > 1e-12) continue;
      // A root beside this part is that of another part, or beyond the whole arc or patch.
      if (t.beyond(x) > kBeyond || u.beyond(y) > kBeyond || v.beyond(z) > kBeyond) return false;
      found_.push_back({std::clamp(x, 0.0, 1.0), way});
      return true;
    }
    return false;
  }

  void halve(const CubicArc& arc, const surface::BezierPatch& patch, Range t, Range u, Range v,
             int axis) {
    Range& halved = axis == 0 ? t : axis == 1 ? u : v;
    halved.size *= 0.5;
    if (axis == 0) {
      CubicArc low, high;
      halve_arc(arc, low, high);
      search(low, patch, t, u, v);
      halved.low += halved.size;
      search(high, patch, t, u, v);
      return;
    }
    surface::BezierPatch low, high;
    patch.split(axis - 1, low, high);
    search(arc, low, t, u, v);
    halved.low += halved.size;
    search(arc, high, t, u, v);
  }

  const CubicArc& arc_;
  const ArcFrame& frame_;
  const surface::BezierPatch& patch_;
  double touching_, scale_ = 0.0;
  std::vector<ArcCrossing>& found_;
  int parts_ = 0;
};

}  // namespace

Vector3d arc_point(const CubicArc& p, double t) {
  const double s = 1.0 - t;
  return s * s * (s * p[0] + 3.0 * t * p[1]) + t * t * (3.0 * s * p[2] + t * p[3]);
}

ArcFrame::ArcFrame(const CubicArc& arc) {
  Vector3d along = arc[3] - arc[0];
  // A closed arc, or one that is a point, as the side of a patch where it ends in a pole.
  if (!(along.norm() > 0.0)) along = arc[1] - arc[0];
  if (!(along.norm() > 0.0)) along = Vector3d::UnitX();
  along.normalize();
  first = along.unitOrthogonal();
  second = along.cross(first);
}

int find_arc_crossings(const CubicArc& arc, const ArcFrame& frame,
                       const surface::BezierPatch& patch, double touching,
                       std::vector<ArcCrossing>& crossings) {
  ArcSearch search(arc, frame, patch, touching, crossings);
  search.search(arc, patch, {}, {}, {});
  return search.parts();
}

}  // namespace hull::analysis
