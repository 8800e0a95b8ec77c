// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/queries/patch_minimum.h"

#include <algorithm>
#include <cmath>

namespace hull::surface {
namespace {

constexpr int kMostSteps = 30;

}  // namespace

PatchMinimum minimise(const BezierPatch& patch, const Vector3d& p, double u, double v,
                      double scale) {
  PatchMinimum at{u, v, evaluate(patch, u, v), 0.0, false};
  Vector3d r = at.jet.point - p;
  at.distance = r.norm();
  // What rounding leaves of lengths here.
  const double noise = 4e-16 * scale;
  for (int step = 0; step < kMostSteps; ++step) {
    const SurfaceJet& s = at.jet;
    const double gu = r.dot(s.du), gv = r.dot(s.dv);
    const double e = s.du.squaredNorm(), f = s.du.dot(s.dv), g = s.dv.squaredNorm();
    const bool hold_u = (at.u <= 0.0 && gu >= 0.0) || (at.u >= 1.0 && gu <= 0.0);
    const bool hold_v = (at.v <= 0.0 && gv >= 0.0) || (at.v >= 1.0 && gv <= 0.0);
    // A foot is found where what is left along the surface is rounding: of r · S_u / |S_u|, which
    // is a length.
    const double residual = noise + 4e-16 * at.distance;
    if ((hold_u || std::abs(gu) <= residual * std::sqrt(e)) &&
        (hold_v || std::abs(gv) <= residual * std::sqrt(g))) {
      at.settled = true;
      return at;
    }
    // The Hessian of half of the squared distance.
    double huu = e + r.dot(s.duu), huv = f + r.dot(s.duv), hvv = g + r.dot(s.dvv);
    double du = 0.0, dv = 0.0;
    if (hold_u || hold_v) {
      // Where the square hardly rises, or falls, Newton's step would lead far away, or uphill.
      if (!hold_u) du = -gu / (huu > 1e-3 * e ? huu : e);
      if (!hold_v) dv = -gv / (hvv > 1e-3 * g ? hvv : g);
    } else {
      double determinant = huu * hvv - huv * huv;
      if (!(huu > 0.0 && determinant > 1e-6 * e * g)) {
        // Not a minimum's Hessian, or nearly: that of the tangent plane, made definite.
        huu = e * (1.0 + 1e-6), huv = f, hvv = g * (1.0 + 1e-6);
        determinant = huu * hvv - huv * huv;
      }
      du = (huv * gv - hvv * gu) / determinant;
      dv = (huv * gu - huu * gv) / determinant;
    }
    if (!std::isfinite(du) || !std::isfinite(dv)) return at;
    // Halved until the distance does not grow, but for rounding.
    for (int halving = 0;; ++halving) {
      const double to_u = std::clamp(at.u + du, 0.0, 1.0), to_v = std::clamp(at.v + dv, 0.0, 1.0);
      if (to_u == at.u && to_v == at.v) {
        at.settled = halving == 0;
        return at;
      }
      const SurfaceJet there = evaluate(patch, to_u, to_v);
      const Vector3d r_there = there.point - p;
      const double distance = r_there.norm();
      if (distance <= at.distance + residual) {
        // Of the step, m.
        const double length =
            std::abs(to_u - at.u) * std::sqrt(e) + std::abs(to_v - at.v) * std::sqrt(g);
        at = {to_u, to_v, there, distance, false};
        r = r_there;
        if (length <= residual) {
          at.settled = true;
          return at;
        }
        break;
      }
      // No way down that rounding can tell.
      if (halving == 20) return at;
      du *= 0.5;
      dv *= 0.5;
    }
  }
  return at;
}

Eigen::Vector2d first_guess(const BezierPatch& patch, const Vector3d& p) {
  SurfaceJet jet;
  evaluate_first(patch, 0.5, 0.5, jet);
  const Vector3d r = p - jet.point;
  const double e = jet.du.squaredNorm(), f = jet.du.dot(jet.dv), g = jet.dv.squaredNorm();
  const double determinant = e * g - f * f;
  // Parallel parameter lines, as where a side has shrunk to a point.
  if (!(determinant > 1e-6 * e * g)) return {0.5, 0.5};
  const double a = r.dot(jet.du), b = r.dot(jet.dv);
  return {std::clamp(0.5 + (a * g - b * f) / determinant, 0.0, 1.0),
          std::clamp(0.5 + (b * e - a * f) / determinant, 0.0, 1.0)};
}

}  // namespace hull::surface
