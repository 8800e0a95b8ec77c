// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/profile_plane.h"

#include <algorithm>
#include <limits>

#include "analysis/stations/profile_sides.h"
#include "analysis/stations/section_integrals.h"
#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

constexpr int kBorderChords = 32, kArcChords = 16;

// Chords of a curve between two parameters; at(t) gives (x, z).
template <class Curve>
void add_chords(const Curve& at, double begin, double end, int count, ProfileOutline& outline) {
  Vector2d last = at(begin);
  for (int i = 1; i <= count; ++i) {
    const Vector2d next = at(begin + (end - begin) * i / count);
    outline.lines.push_back({last, next});
    last = next;
  }
}

void add_cubic(const BezierCubic& x, const BezierCubic& z, const BezierCubic& y,
               ProfileOutline& outline) {
  const auto at = [&](double t) { return Vector2d(evaluate(x, t), evaluate(z, t)); };
  std::vector<double> breaks{0.0};
  for (double t : sign_changes(y)) breaks.push_back(t);
  breaks.push_back(1.0);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    // The port side's alone; of a half y is given as zero, and all counts.
    if (evaluate(y, 0.5 * (breaks[k] + breaks[k + 1])) < 0.0) continue;
    add_chords(at, breaks[k], breaks[k + 1], kBorderChords, outline);
  }
}

void add_border(const HullBody& ship, const ProfilePlane& profile, ProfileOutline& outline) {
  for (const BorderEdge& edge : ship.border()) {
    if (ship.bodies().of_cell[edge.half_edge / 4] != profile.body) continue;
    BezierCubic y{};
    if (!profile.is_half) y = edge.along(profile.plane.normal, profile.plane.offset);
    add_cubic(edge.along(Vector3d::UnitX(), 0.0), edge.along(Vector3d::UnitZ(), 0.0), y, outline);
  }
}

void add_arc(const ArcSquare& square, const SectionFrame& frame, ProfileOutline& outline) {
  const auto at = [&](double u) {
    const ArcPoint p = arc_point(square, u);
    const Vector3d point = frame.point(p.a, p.b);
    return Vector2d(point.x(), point.z());
  };
  for_each_stretch(square, [&](double begin, double end) {
    // With the body on the left.
    if (square.sign < 0.0) std::swap(begin, end);
    add_chords(at, begin, end, kArcChords, outline);
  });
}

void add_seams_and_arcs(const HullBody& ship, const ProfilePlane& profile,
                        ProfileOutline& outline) {
  // Without a level: all of the section, and the frame's water only turns its axes.
  constexpr double kAll = std::numeric_limits<double>::infinity();
  const SectionFrame frame = SectionFrame::above_water(profile.plane, {Vector3d::UnitZ(), 0.0});
  for_each_arc_piece(ship.surface(), ship.boxes(), frame, kAll, [&](const ArcPiece& piece) {
    if (ship.bodies().of_cell[piece.piece.cell] != profile.body) return;
    if (lowest(piece.h) >= 0.0) {
      return for_each_side_in_plane(
          piece, Vector3d::UnitX(), Vector3d::UnitZ(), Vector3d::Zero(),
          [&](const BezierCubic& x, const BezierCubic& z) { add_cubic(x, z, {}, outline); });
    }
    if (highest(piece.h) <= 0.0) return;
    for_each_arc_of(piece, frame, kAll,
                    [&](const ArcSquare& square) { add_arc(square, frame, outline); });
  });
}

}  // namespace

ProfilePlane profile_plane(const HullBody& ship, int body) {
  const CellBoxes& boxes = ship.boxes();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int cell = 0; cell < boxes.size(); ++cell) {
    if (ship.bodies().of_cell[cell] != body) continue;
    low = std::min(low, boxes.low(cell).y());
    high = std::max(high, boxes.high(cell).y());
  }
  const double reach = kOnCentrePlane * ship.surface().mesh().size();
  // The centre line of a half may be off the plane by so much.
  const bool beside = low > reach || high < -reach;
  return {body, ship.mirrored() && !beside, {Vector3d::UnitY(), beside ? 0.5 * (low + high) : 0.0}};
}

std::vector<ProfileOutline> hull_outlines(const HullBody& ship) {
  std::vector<ProfileOutline> outlines;
  for (std::size_t body = 0; body < ship.bodies().first_cell.size(); ++body) {
    const ProfilePlane profile = profile_plane(ship, static_cast<int>(body));
    ProfileOutline outline{MemberRole::kHull, {}};
    add_border(ship, profile, outline);
    if (!profile.is_half) add_seams_and_arcs(ship, profile, outline);
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

std::shared_ptr<const std::vector<ProfilePart>> joined_profile(
    const HullBody& ship, const std::vector<Appendage>& appendages) {
  std::vector<ProfileOutline> outlines = hull_outlines(ship);
  for (const Appendage& appendage : appendages) outlines.push_back(profile_outline(appendage));
  return std::make_shared<const std::vector<ProfilePart>>(profile_union(outlines));
}

}  // namespace hull::analysis
