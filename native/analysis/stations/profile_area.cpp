// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/profile_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/arithmetic/gauss.h"
#include "mesh/tolerances.h"

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

// One body of the ship and the plane of its profile.
struct Profile {
  int body;
  bool is_half;  // of the port half, whose border is closed in the plane
  Plane plane;
};

Profile profile_of(const HullBody& ship, int body) {
  const CellBoxes& boxes = ship.boxes();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int cell = 0; cell < boxes.size(); ++cell) {
    if (ship.bodies().of_cell[cell] != body) continue;
    low = std::min(low, boxes.low(cell).y());
    high = std::max(high, boxes.high(cell).y());
  }
  const double reach = kOnCentrePlane * ship.surface().mesh().size();
  const bool beside = low > reach || high < -reach;
  return {body, ship.mirrored() && !beside, {Vector3d::UnitY(), beside ? 0.5 * (low + high) : 0.0}};
}

// The border, seen athwartships: of a half, what closes it lies in the centre plane; of a whole
// body, that of the port side.
void add_border(const HullBody& ship, const Profile& profile, const SectionFrame& frame,
                SectionIntegrals& sum) {
  for (const BorderEdge& edge : ship.border()) {
    if (ship.bodies().of_cell[edge.half_edge / 4] != profile.body) continue;
    BezierCubic y{};
    if (!profile.is_half) y = edge.along(profile.plane.normal, profile.plane.offset);
    add_cubic(edge.along(frame.across, frame.across.dot(frame.origin)),
              edge.along(frame.up, frame.up.dot(frame.origin)), y, sum);
  }
}

// Sides of a port piece that lie in the centre plane, run through with the piece on their left.
void add_sides_in_plane(const ArcPiece& piece, const SectionFrame& frame, SectionIntegrals& sum) {
  constexpr int kSides[4][4] = {{0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}};
  const surface::BicubicPoints& points = piece.piece.points;
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

// Where a whole body crosses the plane, with the port side on the left. Seams in the plane are not
// left to the cutting of squares: at the ends of the keel it would meet saddles.
void add_seams_and_arcs(const StationCutter& cutter, const Profile& profile,
                        const SectionFrame& frame, SectionIntegrals& sum) {
  const HullBody& ship = cutter.body();
  for_each_arc_piece(ship.surface(), ship.boxes(), frame, 0.0, [&](const ArcPiece& piece) {
    if (ship.bodies().of_cell[piece.piece.cell] != profile.body) return;
    if (lowest(piece.h) >= 0.0) return add_sides_in_plane(piece, frame, sum);
    if (highest(piece.h) <= 0.0) return;
    for_each_arc_of(piece, frame, 0.0,
                    [&](const ArcSquare& square) { add_arcs(square, 0.0, cutter.rule(), sum); });
  });
}

}  // namespace

ProfileArea profile_area(const StationCutter& cutter, const Plane& water) {
  // At 90° of heel the water is parallel to the centre plane.
  if (water.normal.cross(Vector3d::UnitY()).norm() < 1e-12) return {};
  const HullBody& ship = cutter.body();
  ProfileArea result;
  Vector3d moment = Vector3d::Zero();
  for (std::size_t body = 0; body < ship.bodies().first_cell.size(); ++body) {
    const Profile profile = profile_of(ship, static_cast<int>(body));
    const SectionFrame frame = SectionFrame::above_water(profile.plane, water);
    SectionIntegrals sum;
    add_border(ship, profile, frame, sum);
    if (!profile.is_half) add_seams_and_arcs(cutter, profile, frame, sum);
    if (!(sum.area > 0.0)) continue;
    result.area += sum.area;
    moment += sum.area * frame.point(sum.moment_a / sum.area, sum.moment_b / sum.area);
  }
  if (result.area > 0.0) result.centre = {moment.x() / result.area, 0.0, moment.z() / result.area};
  return result;
}

}  // namespace hull::analysis
