// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/patches/region_sides.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hull::network {
namespace {

constexpr double kShortSide = 0.02;  // of the longest
constexpr double kPassing = 15.0 * std::numbers::pi / 180.0;

const CurveEdge& curve_edge(const NetworkFrame& frame, const RegionEdge& side) {
  return frame.joined.edges[static_cast<std::size_t>(side.edge)];
}

Vector3d way_in(const NetworkFrame& frame, const RegionEdge& side) {  // at its beginning, unit
  return frame.shapes[static_cast<std::size_t>(side.edge)].tangent_from(side.is_along);
}
Vector3d way_out(const NetworkFrame& frame, const RegionEdge& side) {  // at its end
  return -frame.shapes[static_cast<std::size_t>(side.edge)].tangent_from(!side.is_along);
}

bool turns(const NetworkFrame& frame, const RegionEdge& side, const RegionEdge& next) {
  const Vector3d to = way_out(frame, side), from = way_in(frame, next);
  // By sine and cosine: of small angles either alone tells less.
  return std::atan2(to.cross(from).norm(), to.dot(from)) > kPassing;
}

bool changes_curve(const NetworkFrame& frame, const RegionEdge& side, const RegionEdge& next) {
  const CurveEdge &a = curve_edge(frame, side), &b = curve_edge(frame, next);
  return a.curve != b.curve || a.piece != b.piece;
}

// A side as one curve over 0 … 1, with the normals along it.
class SideCurve {
 public:
  SideCurve(std::shared_ptr<const NetworkFrame> frame, RegionSide side)
      : frame_(std::move(frame)), side_(std::move(side)) {
    ends_ = side_ends(*frame_, side_);
  }

  struct Jet {
    Vector3d point, slope, bend;
    NormalJet normal;
  };

  Jet at(double u) const {
    // Among inner ends, so that 0 is of the first edge and 1 of the last.
    const auto above = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, u);
    const auto part = static_cast<std::size_t>(above - ends_.begin()) - 1;
    const RegionEdge& edge = side_[part];
    const auto number = static_cast<std::size_t>(edge.edge);
    const double width = ends_[part + 1] - ends_[part];
    const double share = std::clamp((u - ends_[part]) / width, 0.0, 1.0);
    const double t = edge.is_along ? share : 1.0 - share;
    // By the side's parameter the edge's runs so fast; each order takes it once more.
    const double speed = (edge.is_along ? 1.0 : -1.0) / width;
    const Points3 jet = frame_->shapes[number].evaluate(t, 2);
    NormalJet normal = (edge.is_along ? frame_->normals.left : frame_->normals.right)[number].at(t);
    normal.slope *= speed;
    return {jet.row(0), speed * jet.row(1), speed * speed * jet.row(2), normal};
  }

 private:
  std::shared_ptr<const NetworkFrame> frame_;
  RegionSide side_;
  std::vector<double> ends_;
};

// A vector made unit, with its derivative.
NormalJet unit_jet(const Vector3d& value, const Vector3d& slope) {
  const double length = value.norm();
  const Vector3d unit = value / length;
  return {unit, (slope - unit.dot(slope) * unit) / length};
}

// At an end of a side: what the neighbour's slope is in the side's directions.
struct RibbonEnd {
  double along, across;
  Vector3d shift;  // of the side's normal there to that of the two slopes
};

// Ribbons of neighbours have to be one another's slopes at a corner: so each is led from what it is
// to be at one end to what it is to be at the other, in the directions of the side's own frame.
class Ribbon {
 public:
  Ribbon(SideCurve curve, const Vector3d& start_slope, const Vector3d& end_slope)
      : curve_(std::move(curve)), start_(end_of(0.0, start_slope)), end_(end_of(1.0, end_slope)) {}

  SideJet operator()(double u) const {
    const SideCurve::Jet jet = curve_.at(u);
    const NormalJet tangent = unit_jet(jet.slope, jet.bend);
    const double h1 = u * u * (3.0 - 2.0 * u), h1_slope = 6.0 * u * (1.0 - u);
    const Vector3d normal = jet.normal.normal + (1.0 - h1) * start_.shift + h1 * end_.shift;
    const Vector3d normal_slope = jet.normal.slope + h1_slope * (end_.shift - start_.shift);
    // At right angles to both, so that the ribbon is in the tangent plane: T of (5.2).
    const NormalJet across =
        unit_jet(normal.cross(tangent.normal),
                 normal_slope.cross(tangent.normal) + normal.cross(tangent.slope));
    const double alpha = (1.0 - u) * start_.along + u * end_.along;
    const double beta = (1.0 - u) * start_.across + u * end_.across;
    // (5.2), and its derivative.
    return {jet.point, jet.slope, alpha * tangent.normal + beta * across.normal,
            alpha * tangent.slope + beta * across.slope +
                (end_.along - start_.along) * tangent.normal +
                (end_.across - start_.across) * across.normal,
            jet.bend};
  }

 private:
  RibbonEnd end_of(double u, const Vector3d& slope) const {
    const SideCurve::Jet jet = curve_.at(u);
    const Vector3d tangent = jet.slope.normalized();
    const double along = slope.dot(tangent);
    const Vector3d across = slope - along * tangent;
    const Vector3d& normal = jet.normal.normal;
    const double length = across.norm();
    // Neighbours that go on in one line have no plane with it: the normal stays.
    if (!(length > 1e-9 * slope.norm())) return {along, 0.0, Vector3d::Zero()};
    // The normal of both slopes, to that side where the side's own is.
    const Vector3d own = tangent.cross(across / length);
    // At a corner of more than half a turn the neighbour's slope is on the side's other side.
    const double sense = own.dot(normal) < 0.0 ? -1.0 : 1.0;
    return {along, sense * length, sense * own - normal};
  }

  SideCurve curve_;
  RibbonEnd start_, end_;
};

}  // namespace

std::vector<RegionSide> region_sides(const NetworkFrame& frame,
                                     const std::vector<RegionEdge>& loop) {
  const std::size_t count = loop.size();
  std::vector<std::size_t> corners;  // before these edges
  for (const auto& is_corner : {turns, changes_curve}) {
    if (corners.size() >= 2) break;
    corners.clear();
    for (std::size_t i = 0; i < count; ++i) {
      if (is_corner(frame, loop[(i + count - 1) % count], loop[i])) corners.push_back(i);
    }
  }
  if (corners.empty()) corners.push_back(0);
  std::vector<RegionSide> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = corners[(i + 1) % corners.size()];
    sides.emplace_back();
    // From a single corner once all around, to itself.
    for (std::size_t e = corners[i]; sides.back().empty() || e % count != next; ++e) {
      sides.back().push_back(loop[e % count]);
    }
  }
  return sides;
}

std::vector<RegionSide> sides_of_one_curve(const NetworkFrame& frame,
                                           const std::vector<RegionSide>& sides) {
  std::vector<RegionSide> cut;
  for (const RegionSide& side : sides) {
    cut.emplace_back();
    for (const RegionEdge& edge : side) {
      if (!cut.back().empty() && changes_curve(frame, cut.back().back(), edge)) cut.emplace_back();
      cut.back().push_back(edge);
    }
  }
  return cut;
}

namespace {

double side_length(const NetworkFrame& frame, const RegionSide& side) {
  double length = 0.0;
  for (const RegionEdge& edge : side) {
    length += frame.shapes[static_cast<std::size_t>(edge.edge)].length();
  }
  return length;
}

// The cosine of the angle by which the way turns from one side to the next.
double onwards(const NetworkFrame& frame, const RegionSide& side, const RegionSide& next) {
  return way_out(frame, side.back()).dot(way_in(frame, next.front()));
}

}  // namespace

std::vector<RegionSide> with_short_sides_joined(const NetworkFrame& frame,
                                                std::vector<RegionSide> sides) {
  // One after the other, for what is joined may be short no longer.
  while (sides.size() > 4) {
    std::vector<double> lengths;
    for (const RegionSide& side : sides) lengths.push_back(side_length(frame, side));
    const auto [least, most] = std::ranges::minmax_element(lengths);
    if (*least > kShortSide * *most) break;
    // The short side first, so that its neighbours are the next and the last.
    std::rotate(sides.begin(), sides.begin() + (least - lengths.begin()), sides.end());
    const bool is_to_next =
        onwards(frame, sides[0], sides[1]) > onwards(frame, sides.back(), sides[0]);
    if (!is_to_next) std::rotate(sides.begin(), sides.end() - 1, sides.end());
    sides[0].insert(sides[0].end(), sides[1].begin(), sides[1].end());
    sides.erase(sides.begin() + 1);
  }
  return sides;
}

std::vector<double> side_ends(const NetworkFrame& frame, const RegionSide& side) {
  const bool is_one = std::ranges::all_of(
      side, [&](const RegionEdge& other) { return !changes_curve(frame, side.front(), other); });
  std::vector<double> ends{0.0};
  for (const RegionEdge& edge : side) {
    const CurveEdge& part = curve_edge(frame, edge);
    ends.push_back(ends.back() +
                   (is_one ? part.high - part.low
                           : frame.shapes[static_cast<std::size_t>(edge.edge)].length()));
  }
  for (double& end : ends) end /= ends.back();
  ends.back() = 1.0;
  return ends;
}

std::vector<RibbonedSide> ribboned_sides(std::shared_ptr<const NetworkFrame> frame,
                                         const std::vector<RegionSide>& sides) {
  std::vector<SideCurve> curves;
  for (const RegionSide& side : sides) curves.emplace_back(frame, side);
  const std::size_t count = curves.size();
  std::vector<RibbonedSide> ribboned;
  for (std::size_t i = 0; i < count; ++i) {
    // The neighbour before runs towards the corner.
    const Vector3d before = -curves[(i + count - 1) % count].at(1.0).slope;
    const Vector3d after = curves[(i + 1) % count].at(0.0).slope;
    ribboned.emplace_back(Ribbon(curves[i], before, after));
  }
  return ribboned;
}

}  // namespace hull::network
