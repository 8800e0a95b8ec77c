// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/deck_edge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

bool runs_along_the_ship(const surface::CreaseCurve& curve, double size) {
  // The control points' box holds the curve.
  const std::vector<Vector3d>& points = curve.spline().points();
  Vector3d low = points.front(), high = low;
  for (const Vector3d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3d extent = high - low;
  const bool in_centre_plane =
      std::max(std::abs(low.y()), std::abs(high.y())) <= kOnCentrePlane * size;
  return !in_centre_plane && extent.x() > kNoLength * size && extent.x() >= extent.z();
}

// The least value over [0, 1] of the cubic with these values and slopes at the ends.
double least_of_cubic(double h0, double d0, double h1, double d1) {
  const double rise = h1 - h0;
  const double a = d0 + d1 - 2.0 * rise, b = 3.0 * rise - 2.0 * d0 - d1;
  const auto value = [&](double t) { return h0 + t * (d0 + t * (b + t * a)); };
  double least = std::min(h0, h1);
  // The minimum is where 3 a t² + 2 b t + d0 rises through zero.
  const double root = b * b - 3.0 * a * d0;
  if (root < 0.0) return least;
  const double q = std::sqrt(root);
  // Of the two forms of the root the one without a difference of nearly equal numbers; for b <= 0
  // and no cubic term it is infinite or no number, and there is no minimum within.
  const double t = b > 0.0 ? -d0 / (b + q) : (q - b) / (3.0 * a);
  if (t > 0.0 && t < 1.0) least = std::min(least, value(t));
  return least;
}

double lowest_of(const surface::CubicSpline& spline, const Vector3d& up) {
  double least = std::numeric_limits<double>::infinity();
  const std::vector<double>& knots = spline.knots();
  // Between two knots the spline is one cubic, which values and slopes at the ends give exactly.
  for (std::size_t k = 3; k + 4 < knots.size(); ++k) {
    const double width = knots[k + 1] - knots[k];
    const surface::CurveJet from = spline.evaluate(knots[k], 1),
                            to = spline.evaluate(knots[k + 1], 1);
    least = std::min(least, least_of_cubic(up.dot(from.point), width * up.dot(from.d1),
                                           up.dot(to.point), width * up.dot(to.d1)));
  }
  return least;
}

}  // namespace

DeckEdge::DeckEdge(const HullBody& body) : mirrored_(body.mirrored()) {
  const double size = body.surface().mesh().size();
  for (surface::CreaseCurve& curve : surface::crease_curves(body.surface())) {
    if (curve.kind() == surface::CreaseKind::kBorder && runs_along_the_ship(curve, size)) {
      curves_.push_back(std::move(curve));
    }
  }
}

DeckEdge::DeckEdge(const HullBody& body, const std::vector<int>& vertices)
    : mirrored_(body.mirrored()) {
  const int count = body.surface().mesh().topology().vertex_count();
  for (int v : vertices) {
    if (v >= 0 && v < count) continue;
    throw std::invalid_argument("The deck edge has the point " + std::to_string(v) +
                                ", but the mesh has points 0 to " + std::to_string(count - 1) +
                                " only.");
  }
  const std::set<int> given(vertices.begin(), vertices.end());
  for (surface::CreaseCurve& curve : surface::crease_curves(body.surface())) {
    const std::vector<int>& chain = curve.vertices();
    // All of its points, or a crease that only ends at the deck's edge would belong to it.
    if (std::all_of(chain.begin(), chain.end(), [&](int v) { return given.count(v) > 0; })) {
      curves_.push_back(std::move(curve));
    }
  }
  if (curves_.empty()) {
    throw std::invalid_argument(
        "The points given for the deck edge hold no whole crease or border: give all the points "
        "of one, from end to end.");
  }
}

double DeckEdge::lowest(const Vector3d& up) const {
  double least = std::numeric_limits<double>::infinity();
  const Vector3d other_side(up.x(), -up.y(), up.z());
  for (const surface::CreaseCurve& curve : curves_) {
    least = std::min(least, lowest_of(curve.spline(), up));
    if (mirrored_) least = std::min(least, lowest_of(curve.spline(), other_side));
  }
  return least;
}

}  // namespace hull::analysis
