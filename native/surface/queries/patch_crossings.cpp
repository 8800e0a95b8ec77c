// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/queries/patch_crossings.h"

#include <algorithm>
#include <cmath>

#include "surface/queries/infinity.h"
#include "surface/wide_code.h"

namespace hull::surface {
namespace {

// Parts of a piece that are looked at before the extent of what touches is doubled, and from then
// on between doublings.
constexpr int kFreeCrossings = 4000, kCrossingsPerDoubling = 500;
// Derivatives near the unit matrix need a few; what has not settled then is cut.
constexpr int kNewtonSteps = 12;

struct Range {
  double low, high;
};

inline Range range(const double* x) {
  double low[4], high[4];
  for (int k = 0; k < 4; ++k) low[k] = high[k] = x[k];
  for (int j = 4; j < 16; j += 4) {
    for (int k = 0; k < 4; ++k) {
      low[k] = x[j + k] < low[k] ? x[j + k] : low[k];
      high[k] = x[j + k] > high[k] ? x[j + k] : high[k];
    }
  }
  return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
          std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
}

inline Range slopes_u(const double* x) {
  Range r{kInfinity, -kInfinity};
  for (int j = 0; j < 16; j += 4) {
    for (int i = 0; i < 3; ++i) {
      const double d = 3.0 * (x[j + i + 1] - x[j + i]);
      r = {std::min(r.low, d), std::max(r.high, d)};
    }
  }
  return r;
}

inline Range slopes_v(const double* x) {
  double low[4] = {kInfinity, kInfinity, kInfinity, kInfinity};
  double high[4] = {-kInfinity, -kInfinity, -kInfinity, -kInfinity};
  for (int j = 0; j < 12; j += 4) {
    for (int i = 0; i < 4; ++i) {
      const double d = 3.0 * (x[j + i + 4] - x[j + i]);
      low[i] = d < low[i] ? d : low[i];
      high[i] = d > high[i] ? d : high[i];
    }
  }
  return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
          std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
}

inline double magnitude(const Range& r) { return std::max(-r.low, r.high); }

double extent(const BezierPatch& patch) { return patch.box().diagonal().norm(); }

// A cubic along one side of a patch, h across the axis within a plane through it and z along it.
struct Side {
  double h[4], z[4];
};

double cubic(const double* c, double t) {
  const double s = 1.0 - t;
  return s * s * (s * c[0] + 3.0 * t * c[1]) + t * t * (3.0 * s * c[2] + t * c[3]);
}

// Calls visit(t) where h changes sign or is zero at an end, by cutting until it is monotone.
template <class Visit>
void roots(const double* h, double from, double to, double tolerance, const Visit& visit) {
  const auto [low, high] = std::minmax({h[0], h[1], h[2], h[3]});
  if (low > tolerance || high < -tolerance) return;
  // Monotone control points make a monotone cubic.
  const bool rises = h[1] >= h[0] && h[2] >= h[1] && h[3] >= h[2];
  const bool falls = h[1] <= h[0] && h[2] <= h[1] && h[3] <= h[2];
  const double width = to - from;
  if (rises || falls || width < 0x1p-40) {
    // The same place may be told by both parts beside it: only the first and the last one count.
    if (std::abs(h[0]) <= tolerance) visit(from);
    if (std::abs(h[3]) <= tolerance) visit(to);
    if ((h[0] < 0.0) == (h[3] < 0.0)) return;
    // Bisection: it needs no derivative, which may vanish at a root.
    double a = 0.0, b = 1.0;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (a + b);
      ((cubic(h, middle) < 0.0) == (h[0] < 0.0) ? a : b) = middle;
    }
    visit(from + width * 0.5 * (a + b));
    return;
  }
  const double ab = 0.5 * (h[0] + h[1]), bc = 0.5 * (h[1] + h[2]), cd = 0.5 * (h[2] + h[3]);
  const double abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
  const double first[] = {h[0], ab, abc, middle}, second[] = {middle, bcd, cd, h[3]};
  roots(first, from, from + 0.5 * width, tolerance, visit);
  roots(second, from + 0.5 * width, to, tolerance, visit);
}

}  // namespace

void PatchCrossings::find(const BezierPatch& patch) {
  parts_ = 0;
  find(patch, Part{});
}

HULL_WIDE bool PatchCrossings::is_passed(const BezierPatch& patch) const {
  for (int k = 0; k < 2; ++k) {
    const Range r = range(patch.x[k]);
    if (r.low > tolerance_ || r.high < -tolerance_) return true;
  }
  const Range z = range(patch.x[2]);
  return z.low > z_max_ || z.high < z_min_;
}

void PatchCrossings::find(const BezierPatch& patch, const Part& part) {
  ++parts_;
  if (parts_ > kFreeCrossings && (parts_ - kFreeCrossings) % kCrossingsPerDoubling == 1)
    touching_ *= 2.0;
  if (is_passed(patch)) return;
  if (try_single(patch, part) != Outcome::kUnknown) return;
  if (try_stretch(patch, part)) return;
  // Below this a touching axis could only be followed by cutting without end.
  if (extent(patch) <= touching_ || std::max(part.du, part.dv) < 0x1p-45) {
    try_touching(patch, part);
    return;
  }
  split(patch, part);
}

// With the inverse W of the mean derivative of g = (x, y), F = W g has derivatives near the unit
// matrix. Where bounds show all of them to be P-matrices (positive principal minors), there is
// exactly one place in the square that solves F = 0 or, at the sides, is held back there (F points
// outwards): a variational inequality with a P-function. The axis is met there or nowhere.
HULL_WIDE PatchCrossings::Outcome PatchCrossings::try_single(const BezierPatch& patch,
                                                             const Part& part) {
  const double* x = patch.x[0];
  const double* y = patch.x[1];
  const auto mean_u = [](const double* c) {
    return 0.25 * ((c[3] - c[0]) + (c[7] - c[4]) + (c[11] - c[8]) + (c[15] - c[12]));
  };
  const auto mean_v = [](const double* c) {
    return 0.25 * ((c[12] - c[0]) + (c[13] - c[1]) + (c[14] - c[2]) + (c[15] - c[3]));
  };
  const double xu = mean_u(x), xv = mean_v(x), yu = mean_u(y), yv = mean_v(y);
  const double determinant = xu * yv - xv * yu;
  const double lengths = std::sqrt((xu * xu + yu * yu) * (xv * xv + yv * yv));
  if (!(std::abs(determinant) > 1e-9 * lengths)) return Outcome::kUnknown;
  const double w[2][2] = {{yv / determinant, -xv / determinant},
                          {-yu / determinant, xu / determinant}};
  alignas(32) double f[2][16];
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 16; ++i) f[k][i] = w[k][0] * x[i] + w[k][1] * y[i];
    const Range r = range(f[k]);
    // How far a length of the tolerance can move a component of W g.
    const double allowed = tolerance_ * std::hypot(w[k][0], w[k][1]);
    if (r.low > allowed || r.high < -allowed) return Outcome::kNone;
  }
  // The matrix [[a, ±b], [±c, d]]: positive diagonal, and a d > b c for whatever signs.
  const double a = slopes_u(f[0]).low, d = slopes_v(f[1]).low;
  const double b = magnitude(slopes_v(f[0])), c = magnitude(slopes_u(f[1]));
  if (!(a > 0.0 && d > 0.0 && a * d > 1.0001 * b * c)) return Outcome::kUnknown;

  SurfaceJet jet;
  double u = 0.5, v = 0.5;
  for (int step = 0; step < kNewtonSteps; ++step) {
    evaluate_first(patch, u, v, jet);
    const double fu = w[0][0] * jet.point[0] + w[0][1] * jet.point[1];
    const double fv = w[1][0] * jet.point[0] + w[1][1] * jet.point[1];
    // The component whose step would lead outwards is held; the other one takes its own Newton
    // step.
    const bool hold_u = (u <= 0.0 && fu >= 0.0) || (u >= 1.0 && fu <= 0.0);
    const bool hold_v = (v <= 0.0 && fv >= 0.0) || (v >= 1.0 && fv <= 0.0);
    const double j11 = w[0][0] * jet.du[0] + w[0][1] * jet.du[1];
    const double j12 = w[0][0] * jet.dv[0] + w[0][1] * jet.dv[1];
    const double j21 = w[1][0] * jet.du[0] + w[1][1] * jet.du[1];
    const double j22 = w[1][0] * jet.dv[0] + w[1][1] * jet.dv[1];
    double du = 0.0, dv = 0.0;
    if (hold_u || hold_v) {
      if (!hold_u) du = -fu / j11;
      if (!hold_v) dv = -fv / j22;
    } else {
      const double minor = j11 * j22 - j12 * j21;
      du = (j12 * fv - j22 * fu) / minor;
      dv = (j21 * fu - j11 * fv) / minor;
    }
    const double to_u = std::clamp(u + du, 0.0, 1.0), to_v = std::clamp(v + dv, 0.0, 1.0);
    const bool settled = std::abs(to_u - u) <= 1e-15 && std::abs(to_v - v) <= 1e-15;
    if (settled) {
      const double off = std::hypot(jet.point[0], jet.point[1]);
      if (off > tolerance_) {
        // Held back at a side, F is at its least, g not: off can be more than the least by the
        // condition of W.
        const double condition = (xu * xu + xv * xv + yu * yu + yv * yv) / std::abs(determinant);
        if (off > 4.0 * condition * tolerance_ || !find_on_sides(patch, u, v, jet)) {
          return Outcome::kNone;
        }
      }
      // dz along the ray per distance from it: (z_u, z_v) J⁻¹.
      const double xy = jet.du[0] * jet.dv[1] - jet.dv[0] * jet.du[1];
      const double zx = (jet.du[2] * jet.dv[1] - jet.dv[2] * jet.du[1]) / xy;
      const double zy = (jet.dv[2] * jet.du[0] - jet.du[2] * jet.dv[0]) / xy;
      crossings_.push_back({jet.point[2], part.u + part.du * u, part.v + part.dv * v,
                            tolerance_ * (1.0 + std::hypot(zx, zy))});
      return Outcome::kOne;
    }
    u = to_u;
    v = to_v;
  }
  return Outcome::kUnknown;
}

// A part that lies in one plane with the axis: it is met from the first to the last crossing of its
// sides.
bool PatchCrossings::try_stretch(const BezierPatch& patch, const Part& part) {
  int farthest = 0;
  double largest = 0.0;
  for (int i = 0; i < 16; ++i) {
    const double square = patch.x[0][i] * patch.x[0][i] + patch.x[1][i] * patch.x[1][i];
    if (square > largest) largest = square, farthest = i;
  }
  largest = std::sqrt(largest);
  // The plane through the axis and the point farthest from it is the only one that can hold all.
  const double cosine = largest > 0.0 ? patch.x[0][farthest] / largest : 1.0;
  const double sine = largest > 0.0 ? patch.x[1][farthest] / largest : 0.0;
  for (int i = 0; i < 16; ++i) {
    if (std::abs(cosine * patch.x[1][i] - sine * patch.x[0][i]) > tolerance_) return false;
  }
  AxisStretch stretch{{kInfinity, 0.0, 0.0, tolerance_}, {-kInfinity, 0.0, 0.0, tolerance_}};
  constexpr int kFirstPoint[] = {0, 3, 12, 0}, kStep[] = {1, 4, 1, 4};
  for (int k = 0; k < 4; ++k) {
    Side side;
    for (int i = 0; i < 4; ++i) {
      const int at = kFirstPoint[k] + i * kStep[k];
      side.h[i] = cosine * patch.x[0][at] + sine * patch.x[1][at];
      side.z[i] = patch.x[2][at];
    }
    roots(side.h, 0.0, 1.0, tolerance_, [&](double t) {
      const double u = k == 0 || k == 2 ? t : k == 1 ? 1.0 : 0.0;
      const double v = k == 1 || k == 3 ? t : k == 2 ? 1.0 : 0.0;
      const Crossing at{cubic(side.z, t), part.u + part.du * u, part.v + part.dv * v, tolerance_};
      if (at.z < stretch.begin.z) stretch.begin = at;
      if (at.z > stretch.end.z) stretch.end = at;
    });
  }
  if (stretch.begin.z <= stretch.end.z) stretches_.push_back(stretch);
  return true;
}

// The place on a side that is nearest to the axis, looked for from (u, v): whether it is within the
// tolerance. Then that is (u, v), and `jet` the one there.
bool PatchCrossings::find_on_sides(const BezierPatch& patch, double& u, double& v,
                                   SurfaceJet& jet) const {
  for (int side = 0; side < 4; ++side) {
    const bool along_u = side < 2;
    const double fixed = side & 1;
    double t = along_u ? u : v;
    for (int step = 0; step < kNewtonSteps; ++step) {
      evaluate_first(patch, along_u ? t : fixed, along_u ? fixed : t, jet);
      const Eigen::Vector2d g = jet.point.head<2>();
      if (g.norm() <= tolerance_) {
        u = along_u ? t : fixed;
        v = along_u ? fixed : t;
        return true;
      }
      const Eigen::Vector2d d = (along_u ? jet.du : jet.dv).head<2>();
      const double to = std::clamp(t - g.dot(d) / d.squaredNorm(), 0.0, 1.0);
      if (!(std::abs(to - t) > 1e-15)) break;  // nor go on where d vanishes
      t = to;
    }
  }
  return false;
}

// The place of a small part that is nearest to the axis, by Gauss–Newton steps with some damping;
// counts if it is within the tolerance.
void PatchCrossings::try_touching(const BezierPatch& patch, const Part& part) {
  double u = 0.5, v = 0.5;
  SurfaceJet jet;
  for (int step = 0; step < 40; ++step) {
    evaluate_first(patch, u, v, jet);
    if (std::hypot(jet.point[0], jet.point[1]) <= tolerance_) {
      crossings_.push_back({jet.point[2], part.u + part.du * u, part.v + part.dv * v, kInfinity});
      return;
    }
    const Eigen::Vector2d g = jet.point.head<2>(), gu = jet.du.head<2>(), gv = jet.dv.head<2>();
    // Where the axis touches, the derivative of g is singular.
    const double damping = 1e-10 * (gu.squaredNorm() + gv.squaredNorm());
    const double e = gu.squaredNorm() + damping, f = gu.dot(gv), h = gv.squaredNorm() + damping;
    const double determinant = e * h - f * f, a = g.dot(gu), b = g.dot(gv);
    if (!(determinant > 0.0)) return;
    u = std::clamp(u + (f * b - h * a) / determinant, 0.0, 1.0);
    v = std::clamp(v + (f * a - e * b) / determinant, 0.0, 1.0);
  }
  // Steps that end at a side need not end at its nearest place.
  if (find_on_sides(patch, u, v, jet)) {
    crossings_.push_back({jet.point[2], part.u + part.du * u, part.v + part.dv * v, kInfinity});
  }
}

void PatchCrossings::split(const BezierPatch& patch, const Part& part) {
  // Across the axis, where it is not a point there: a piece that the axis runs along is cut into
  // strips.
  double along_u = 0.0, along_v = 0.0;
  for (int k = 0; k < 2; ++k) {
    along_u += magnitude(slopes_u(patch.x[k]));
    along_v += magnitude(slopes_v(patch.x[k]));
  }
  const int axis = along_u >= along_v ? 0 : 1;
  BezierPatch halves[2];
  patch.split(axis, halves[0], halves[1]);
  for (int i = 0; i < 2; ++i) {
    find(halves[i], part.half(axis, i));
  }
}

}  // namespace hull::surface
