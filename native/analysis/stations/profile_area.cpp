// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/profile_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "analysis/arithmetic/gauss.h"
#include "analysis/stations/profile_plane.h"
#include "analysis/stations/profile_sides.h"

namespace hull::analysis {
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
    // Between two changes of sign its middle tells for a stretch.
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

// The border, seen athwartships: of a half, what closes it lies in the centre plane; of a whole
// body, that of the port side.
void add_border(const HullBody& ship, const ProfilePlane& profile, const SectionFrame& frame,
                SectionIntegrals& sum) {
  for (const BorderEdge& edge : ship.border()) {
    if (ship.bodies().of_cell[edge.half_edge / 4] != profile.body) continue;
    BezierCubic y{};
    if (!profile.is_half) y = edge.along(profile.plane.normal, profile.plane.offset);
    add_cubic(edge.along(frame.across, frame.across.dot(frame.origin)),
              edge.along(frame.up, frame.up.dot(frame.origin)), y, sum);
  }
}

// Where a whole body crosses the plane, with the port side on the left. Seams in the plane are not
// left to the cutting of squares: at the ends of the keel it would meet saddles.
void add_seams_and_arcs(const StationCutter& cutter, const ProfilePlane& profile,
                        const SectionFrame& frame, SectionIntegrals& sum) {
  const HullBody& ship = cutter.body();
  for_each_arc_piece(ship.surface(), ship.boxes(), frame, 0.0, [&](const ArcPiece& piece) {
    if (ship.bodies().of_cell[piece.piece.cell] != profile.body) return;
    if (lowest(piece.h) >= 0.0) {
      return for_each_side_in_plane(
          piece, frame.across, frame.up, frame.origin,
          [&](const BezierCubic& a, const BezierCubic& b) { add_cubic(a, b, {}, sum); });
    }
    // A piece of starboard whose side lies in the plane: the port piece beside it has that seam.
    if (highest(piece.h) <= 0.0) return;
    for_each_arc_of(piece, frame, 0.0,
                    [&](const ArcSquare& square) { add_arcs(square, 0.0, cutter.rule(), sum); });
  });
}

// What of a trapezoid is below the water, in the centre plane.
void add_below(const ProfilePart& part, const Plane& water, double& area, Vector3d& moment) {
  const std::array<Vector3d, 4> corners{
      Vector3d(part.x[0], 0.0, part.low[0]), Vector3d(part.x[1], 0.0, part.low[1]),
      Vector3d(part.x[1], 0.0, part.high[1]), Vector3d(part.x[0], 0.0, part.high[0])};
  // Clipped side by side (Sutherland & Hodgman); what is convex stays so, and is a fan of
  // triangles.
  std::vector<Vector3d> wet;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3d &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double above_a = water.height(a), above_b = water.height(b);
    if (above_a < 0.0) wet.push_back(a);
    if ((above_a < 0.0) != (above_b < 0.0)) {
      wet.push_back(a + (b - a) * (above_a / (above_a - above_b)));
    }
  }
  for (std::size_t i = 1; i + 1 < wet.size(); ++i) {
    const Vector3d p = wet[i] - wet[0], q = wet[i + 1] - wet[0];
    const double triangle = 0.5 * part.times * (p.x() * q.z() - p.z() * q.x());
    area += triangle;
    moment += triangle / 3.0 * (wet[0] + wet[i] + wet[i + 1]);
  }
}

}  // namespace

ProfileArea profile_area(const StationCutter& cutter, const Plane& water) {
  // At 90° of heel the water is parallel to the centre plane.
  if (water.normal.cross(Vector3d::UnitY()).norm() < 1e-12) return {};
  const HullBody& ship = cutter.body();
  ProfileArea result;
  Vector3d moment = Vector3d::Zero();
  for (std::size_t body = 0; body < ship.bodies().first_cell.size(); ++body) {
    const ProfilePlane profile = profile_plane(ship, static_cast<int>(body));
    const SectionFrame frame = SectionFrame::above_water(profile.plane, water);
    SectionIntegrals sum;
    add_border(ship, profile, frame, sum);
    if (!profile.is_half) add_seams_and_arcs(cutter, profile, frame, sum);
    if (!(sum.area > 0.0)) continue;
    // The line b = 0 that closes the figure adds nothing to ∫ a db.
    result.area += sum.area;
    moment += sum.area * frame.point(sum.moment_a / sum.area, sum.moment_b / sum.area);
  }
  if (const std::vector<ProfilePart>* parts = ship.joined_profile()) {
    for (const ProfilePart& part : *parts) add_below(part, water, result.area, moment);
  }
  if (result.area > 0.0) result.centre = {moment.x() / result.area, 0.0, moment.z() / result.area};
  return result;
}

}  // namespace hull::analysis
