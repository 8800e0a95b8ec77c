// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/corner_grading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "conversion/blocks/block_places.h"
#include "conversion/blocks/near_surface.h"
#include "conversion/exact/seam_fit.h"

namespace hull::conversion {
namespace {

// Of the fit: more where squares come too far off the surface, and time was spent already.
constexpr std::array<double, 3> kNormalStiffness{0.03, 0.3, 3.0};
constexpr double kUsefulGrading = 0.97;  // of an error: what is more is no gain
constexpr int kHopeless = 12;            // as many halvings without a gain are enough
constexpr int kLongestJump = 4;          // halvings at once
constexpr double kMuchLess = 0.25;
// Of the corner square and of those within that its knots cut off at the corner, along the side
// v = 0 and off it; the side u = 0 is the next one's.
constexpr std::array<double, 6> kPlacesAlong{0.04, 0.12, 0.25, 0.4, 0.6, 0.8};
constexpr std::array<double, 4> kPlacesAcross{0.0, 0.12, 0.3, 0.7};

// The largest diagonal of a square of the fan, m.
double extent(const SquareFan& fan) {
  double largest = 0.0;
  for (int i = 0; i < fan.count(); ++i) {
    if (!fan.graded[i]) continue;
    const CornerNet& net = fan.nets[i];
    largest = std::max(largest, (net.evaluate(1.0, 1.0).point - net.at(0, 0)).norm());
  }
  return largest;
}

// How many halvings it will take from an error above 1 to below, when they fall by the same factor
// with each, as they do once squares are small; `before` is what it was one jump earlier.
int jump_from(double before, double now) {
  const double halvings = now > 1.0 && now < before ? std::log(now) / std::log(before / now) : 1.0;
  return std::clamp(static_cast<int>(halvings), 1, kLongestJump);
}

// An upper bound of the distance of the squares from the surface, m, at samples. Below `enough` it
// is not looked for closer.
double fan_distance(const surface::LimitSurface& surface, const GradedFan& graded, double enough) {
  const SquareFan& fan = graded.fan;
  const RingedSurface ringed(surface);
  const double size = std::exp2(-graded.grading.halvings);
  double largest = 0.0;
  const auto take = [&](int i, double a, double b) {
    // The square is 2^-halvings of its cell: its own place in the surface is known, and close by.
    const CellPoint start = place_beside_half_edge(fan.half_edges[i], a * size, b * size);
    const Vector3d point = fan.nets[i].evaluate(a, b).point;
    largest = std::max(largest, near_surface(ringed, point, start, enough).distance);
  };
  for (int i = 0; i < fan.count(); ++i) {
    if (!fan.graded[i]) continue;
    for (int k = 0; k < graded.grading.inner; ++k) {
      for (double a : kPlacesAlong) {
        for (double b : kPlacesAcross) take(i, std::ldexp(a, -k), std::ldexp(b, -k));
      }
    }
  }
  return largest;
}

}  // namespace

bool GradedFan::is_better_than(const GradedFan& other) const {
  if (distance > 1.0 || other.distance > 1.0) return distance < kUsefulGrading * other.distance;
  return angle < kUsefulGrading * other.angle;
}

GradedFan graded_fan(const surface::LimitSurface& surface, int vertex, const Grading& grading,
                     const CornerLimits& limits) {
  const bool has_tangent_plane = surface.cells().kind(vertex) != mesh::VertexKind::kCone;
  const auto measure = [&](GradedFan& graded, double angle) {
    // Measured anew for each fit, as the squares move.
    const bool counts = has_tangent_plane && extent(graded.fan) >= limits.distance;
    graded.angle = counts ? angle / limits.angle : 0.0;
    // Distances far below the limit need not be known any closer.
    graded.distance = fan_distance(surface, graded, kMuchLess * limits.distance) / limits.distance;
    graded.outlook = graded.excess();
  };
  GradedFan result{grading, square_fan(surface, vertex, grading)};
  const double angle = seam_angle(result.fan);
  measure(result, angle);
  // Fits are for what is near the limit or above it.
  if (!(angle > kMuchLess * limits.angle)) return result;
  if (moved_points(result.fan.count(), grading.inner) > kMostMoved) return result;
  for (double normal_stiffness : kNormalStiffness) {
    GradedFan fitted = result;
    measure(fitted, fit_seams(fitted.fan, limits.angle, normal_stiffness));
    // No angle is worth a distance that is not allowed.
    if (fitted.distance <= std::max(1.0, result.distance)) return fitted;
    result.outlook = std::min(fitted.outlook, result.outlook);
    if (grading.inner == 1) break;
  }
  return result;
}

GradedFan least_graded_fan(const surface::LimitSurface& surface, int vertex,
                           const CornerLimits& limits, const Grading& first, int last) {
  GradedFan best = graded_fan(surface, vertex, first, limits);
  double before = best.outlook, least = before, now = before;
  // `useful`: the last number of halvings that made an error less.
  int halvings = first.halvings, useful = halvings;
  while (best.excess() > 1.0 && halvings < last && halvings - useful < kHopeless) {
    halvings = std::min(halvings + jump_from(before, now), last);
    before = now;
    GradedFan next = graded_fan(surface, vertex, {halvings, first.inner}, limits);
    now = next.outlook;
    const bool is_better = next.is_better_than(best);
    if (now < kUsefulGrading * least || is_better) useful = halvings;
    least = std::min(least, now);
    if (is_better) best = std::move(next);
  }
  return best;
}

}  // namespace hull::conversion
