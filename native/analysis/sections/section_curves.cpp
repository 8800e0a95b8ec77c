// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/section_curves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "analysis/sections/section_chains.h"

namespace hull::analysis {
namespace {

// Of the mesh's size.
constexpr double kSameEnd = 1e-8, kGap = 1e-4;  // JoinTolerances
constexpr double kSamePoint = 1e-9;             // points nearer to each other are given once
constexpr double kOnPlane = 1e-10;              // knots that branches are led through
constexpr double kShortestCurve = 1e-6;
// Tangents that turn by more make a knuckle, radians.
constexpr double kTurn = 1e-5;
constexpr double kTurnAtSpot = 1e-2;  // where the course was not followed to the end

// Whether a place is on a side of its cell for which is_such(half-edge) holds.
template <class IsSuch>
bool on_side(int cell, const Eigen::Vector2d& uv, const IsSuch& is_such) {
  const int h = 4 * cell;
  return (uv.y() == 0.0 && is_such(h)) || (uv.x() == 1.0 && is_such(h + 1)) ||
         (uv.y() == 1.0 && is_such(h + 2)) || (uv.x() == 0.0 && is_such(h + 3));
}

bool on_crease(const mesh::Topology& cells, int cell, const Eigen::Vector2d& uv) {
  return on_side(cell, uv, [&](int h) { return cells.is_crease(h); });
}

bool on_border(const mesh::Topology& cells, int cell, const Eigen::Vector2d& uv) {
  return on_side(cell, uv, [&](int h) { return cells.twin(h) < 0; });
}

class CurveBuilder {
 public:
  CurveBuilder(const SectionShell& shell, const SectionParts& parts)
      : shell_(shell), parts_(parts), size_(shell.size) {}

  SectionCurve build(const SectionChain& chain);
  // Of the curve built last.
  double length() const { return length_; }

 private:
  SectionPoint oriented(const SectionChain::Link& link, int k) const {
    const SectionArc& arc = parts_.arcs[link.arc];
    SectionPoint p = parts_.points[link.reversed ? arc.last - 1 - k : arc.first + k];
    if (link.reversed) {
      p.tangent = -p.tangent;
      p.curvature = -p.curvature;
    }
    return p;
  }
  int size_of(const SectionChain::Link& link) const {
    return parts_.arcs[link.arc].last - parts_.arcs[link.arc].first;
  }
  void add(const SectionPoint& p);
  // Goes on from the last point to where the link's arc starts. False if that is a point more.
  bool meet(const SectionChain::Link& last, const SectionChain::Link& next);
  void close(const SectionChain::Link& last, const SectionChain::Link& first);
  void start_at_knuckle();

  const SectionShell& shell_;
  const SectionParts& parts_;
  double size_;
  SectionCurve curve_;
  double length_ = 0.0;
};

SectionCurve CurveBuilder::build(const SectionChain& chain) {
  curve_ = {};
  curve_.closed = chain.closed;
  length_ = 0.0;
  std::size_t count = 1;
  for (const auto& link : chain.links) count += static_cast<std::size_t>(size_of(link));
  curve_.points.reserve(count);
  curve_.cells.reserve(count);
  curve_.uv.reserve(count);
  curve_.tangents.reserve(count);
  curve_.curvatures.reserve(count);
  const SectionChain::Link* last = nullptr;
  for (const auto& link : chain.links) {
    const bool joined = last && meet(*last, link);
    for (int k = joined ? 1 : 0; k < size_of(link); ++k) add(oriented(link, k));
    last = &link;
  }
  if (curve_.closed) {
    close(*last, chain.links.front());
    start_at_knuckle();
  }
  return std::move(curve_);
}

void CurveBuilder::add(const SectionPoint& p) {
  if (!curve_.points.empty()) length_ += (p.point - curve_.points.back()).norm();
  curve_.points.push_back(p.point);
  curve_.cells.push_back(p.cell);
  curve_.uv.push_back(p.uv);
  curve_.tangents.push_back(p.tangent);
  curve_.curvatures.push_back(p.curvature);
}

bool CurveBuilder::meet(const SectionChain::Link& last, const SectionChain::Link& next) {
  const SectionPoint start = oriented(next, 0);
  double turn = shell_.turn;
  if (last.spot >= 0) {
    turn = kTurnAtSpot;
    const SectionSpot& spot = parts_.spots[last.spot];
    // Branches are led through the knot itself if it is in the plane; otherwise a chord passes it.
    const bool apart = (spot.knot.point - curve_.points.back()).norm() > kSamePoint * size_;
    if (apart && std::abs(spot.height) <= kOnPlane * size_) {
      SectionPoint knot = spot.knot;
      knot.tangent = curve_.tangents.back();
      knot.curvature = curve_.curvatures.back();
      add(knot);
    }
  }
  const bool joined = (start.point - curve_.points.back()).norm() <= kSamePoint * size_;
  // Across a gap the course is not known better than that.
  if (!joined) turn = kTurnAtSpot;
  // What runs along a crease from arc to arc does not cross it.
  const bool crosses = !parts_.arcs[last.arc].along_side || !parts_.arcs[next.arc].along_side;
  const Vector3d& before = curve_.tangents.back();
  // By the sine, which keeps its digits near zero, and is small for opposite tangents, too.
  const bool turns = before.dot(start.tangent) <= 0.0 || before.cross(start.tangent).norm() > turn;
  if (turns || (crosses && shell_.is_crease(curve_.cells.back(), curve_.uv.back()))) {
    curve_.knuckles.push_back(static_cast<int>(curve_.points.size()) - 1);
    curve_.knuckle_tangents.push_back(start.tangent);
    curve_.knuckle_curvatures.push_back(start.curvature);
  }
  return joined;
}

void CurveBuilder::close(const SectionChain::Link& last, const SectionChain::Link& first) {
  if (!meet(last, first)) {
    SectionPoint end = oriented(first, 0);
    // The course across the gap is not known to break.
    if (!curve_.knuckles.empty() &&
        curve_.knuckles.back() == static_cast<int>(curve_.points.size()) - 1) {
      curve_.knuckles.back() += 1;
      end.tangent = curve_.tangents.back();
      end.curvature = curve_.curvatures.back();
    }
    add(end);
    return;
  }
  // The repeated first point is the same to the last bit.
  curve_.points.back() = curve_.points.front();
  curve_.cells.back() = curve_.cells.front();
  curve_.uv.back() = curve_.uv.front();
  const bool knuckle = !curve_.knuckles.empty() &&
                       curve_.knuckles.back() == static_cast<int>(curve_.points.size()) - 1;
  if (!knuckle) {
    curve_.tangents.back() = curve_.tangents.front();
    curve_.curvatures.back() = curve_.curvatures.front();
  }
}

void CurveBuilder::start_at_knuckle() {
  std::vector<int>& knuckles = curve_.knuckles;
  const int end = static_cast<int>(curve_.points.size()) - 1;
  if (knuckles.empty() || knuckles.back() == end) return;
  const int start = knuckles.front();
  const auto turn = [&](auto& values) {
    // The repeated first point is left out while they turn.
    values.pop_back();
    std::rotate(values.begin(), values.begin() + start, values.end());
    values.push_back(values.front());
  };
  turn(curve_.points);
  turn(curve_.cells);
  turn(curve_.uv);
  turn(curve_.tangents);
  turn(curve_.curvatures);
  // The course before the knuckle stays at its repetition, the last point.
  curve_.tangents.front() = curve_.knuckle_tangents.front();
  curve_.curvatures.front() = curve_.knuckle_curvatures.front();
  const auto first_to_end = [](auto& values) {
    std::rotate(values.begin(), values.begin() + 1, values.end());
  };
  for (int& knuckle : knuckles) knuckle -= start;
  knuckles.front() = end;
  first_to_end(knuckles);
  first_to_end(curve_.knuckle_tangents);
  first_to_end(curve_.knuckle_curvatures);
}

}  // namespace

std::vector<SectionCurve> section_curves(const SectionShell& shell, const SectionParts& parts) {
  const auto at_border = [&](const SectionPoint& p) { return shell.is_border(p.cell, p.uv); };
  std::vector<SectionCurve> curves;
  CurveBuilder builder(shell, parts);
  const JoinTolerances tolerances{kSameEnd * shell.size, kGap * shell.size};
  for (const SectionChain& chain : join_arcs(parts, tolerances, at_border)) {
    SectionCurve curve = builder.build(chain);
    if (builder.length() > kShortestCurve * shell.size) curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<SectionCurve> section_curves(const surface::LimitSurface& surface,
                                         const SectionParts& parts) {
  const mesh::Topology& cells = surface.cells();
  const SectionShell shell{
      surface.mesh().size(), kTurn,
      [&cells](int cell, const Eigen::Vector2d& uv) { return on_crease(cells, cell, uv); },
      [&cells](int cell, const Eigen::Vector2d& uv) { return on_border(cells, cell, uv); }};
  return section_curves(shell, parts);
}

std::vector<SmoothStretch> smooth_stretches(const SectionCurve& curve) {
  std::vector<SmoothStretch> stretches;
  const int last = static_cast<int>(curve.points.size()) - 1;
  int first = 0;
  Vector3d tangent = curve.tangents.front();
  double curvature = curve.curvatures.front();
  for (std::size_t k = 0; k < curve.knuckles.size(); ++k) {
    stretches.push_back({first, curve.knuckles[k], tangent, curvature});
    first = curve.knuckles[k];
    tangent = curve.knuckle_tangents[k];
    curvature = curve.knuckle_curvatures[k];
  }
  if (first < last) stretches.push_back({first, last, tangent, curvature});
  return stretches;
}

}  // namespace hull::analysis
