// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/profile_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "analysis/arithmetic/gauss.h"

namespace hull {
namespace {

// Exact for the polynomials of degree 8 along a cubic.
constexpr int kNodes = 5;

double derivative(const BezierCubic& c, double t) {
  const double s = 1.0 - t;
  return 3.0 * (s * s * (c[1] - c[0]) + 2.0 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
}

// Adds the stretches of a cubic (a, b) that are below b = 0 and on the port side, y >= 0.
void add_cubic(const BezierCubic& a, const BezierCubic& b, const BezierCubic& y,
               SectionIntegrals& sum) {
  static const GaussRule rule = gauss_rule(kNodes);
  std::vector<double> breaks{0.0, 1.0};
  for (double t : sign_changes(b)) breaks.push_back(t);
  for (double t : sign_changes(y)) breaks.push_back(t);
  std::sort(breaks.begin(), breaks.end());
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double begin = breaks[k], width = breaks[k + 1] - begin;
    const double middle = begin + 0.5 * width;
    if (evaluate(b, middle) >= 0.0 || evaluate(y, middle) < 0.0) continue;
    for (int i = 0; i < kNodes; ++i) {
      const double t = begin + width * rule.nodes[i];
      const double at_a = evaluate(a, t), weight = width * rule.weights[i] * derivative(b, t);
      sum.area += weight * at_a;
      sum.moment_a += weight * 0.5 * at_a * at_a;
      sum.moment_b += weight * at_a * evaluate(b, t);
    }
  }
}

// The border of the port half, seen athwartships: what closes it lies in the centre plane.
void add_border(const StationCutter& cutter, const SectionFrame& frame, SectionIntegrals& sum) {
  const bool whole = !cutter.body().mirrored();
  for (const BorderEdge& edge : cutter.body().border()) {
    BezierCubic y{};
    if (whole) y = edge.along(Vector3d::UnitY(), 0.0);
    add_cubic(edge.along(frame.across, frame.across.dot(frame.origin)),
              edge.along(frame.up, frame.up.dot(frame.origin)), y, sum);
  }
}

// Sides of a port piece that lie in the centre plane, run through with the piece on their left.
void add_sides_in_plane(const ArcPiece& piece, const SectionFrame& frame, SectionIntegrals& sum) {
  constexpr int kSides[4][4] = {{0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}};
  const BicubicPoints& points = piece.piece.points;
  for (const auto& side : kSides) {
    const auto in_plane = [&](int k) { return piece.h[k] == 0.0; };
    if (!std::all_of(side, side + 4, in_plane)) continue;
    const BezierNet a = bezier_net(points, frame.across, frame.across.dot(frame.origin));
    const BezierNet b = bezier_net(points, frame.up, frame.up.dot(frame.origin));
    BezierCubic side_a, side_b;
    for (int i = 0; i < 4; ++i) {
      side_a[i] = a[side[i]];
      side_b[i] = b[side[i]];
    }
    add_cubic(side_a, side_b, {}, sum);
  }
}

// Where a whole body crosses the centre plane, with the port side on the left. Seams in the plane
// are not left to the cutting of squares: at the ends of the keel it would meet saddles.
void add_seams_and_arcs(const StationCutter& cutter, const SectionFrame& frame,
                        SectionIntegrals& sum) {
  const LimitSurface& surface = cutter.body().surface();
  for_each_arc_piece(surface, cutter.body().boxes(), frame, 0.0, [&](const ArcPiece& piece) {
    if (lowest(piece.h) >= 0.0) return add_sides_in_plane(piece, frame, sum);
    if (highest(piece.h) <= 0.0) return;
    for_each_arc_of(piece, frame, 0.0,
                    [&](const ArcSquare& square) { add_arcs(square, 0.0, cutter.rule(), sum); });
  });
}

}  // namespace

ProfileArea profile_area(const StationCutter& cutter, const Plane& water) {
  const Plane centre_plane{Vector3d::UnitY(), 0.0};
  // At 90° of heel the water is parallel to the centre plane.
  if (water.normal.cross(centre_plane.normal).norm() < 1e-12) return {};
  const SectionFrame frame = SectionFrame::above_water(centre_plane, water);
  SectionIntegrals sum;
  add_border(cutter, frame, sum);
  if (!cutter.body().mirrored()) add_seams_and_arcs(cutter, frame, sum);
  ProfileArea result;
  result.area = sum.area;
  if (sum.area > 0.0) {
    result.centre = frame.point(sum.moment_a / sum.area, sum.moment_b / sum.area);
  }
  return result;
}

}  // namespace hull
