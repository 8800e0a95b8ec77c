// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/piece_lines.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "analysis/arithmetic/bezier.h"
#include "analysis/arithmetic/gauss.h"
#include "analysis/immersion/piece_moments.h"

namespace hull::analysis {
namespace {

constexpr int kStretchNodes = 8;  // exact up to degree 15, of which 11 is needed
// Lines of a piece that run along another surface; so many that touch it here and there are as one.
constexpr int kMostTouching = 400, kMostIsolated = 50, kManyTouches = 16;
constexpr double kNoStretch = 1e-13;  // of a line
constexpr double kApart = 1e-9;       // crossings nearer to each other tell nothing of the way

CubicArc side_arc(const surface::BezierPatch& patch, int first, int step) {
  return {patch.point(first), patch.point(first + step), patch.point(first + 2 * step),
          patch.point(first + 3 * step)};
}

}  // namespace

PatchLine::PatchLine(const surface::BezierPatch& patch, double v) {
  for (int i = 0; i < 4; ++i) {
    const Vector3d p[] = {patch.point(i), patch.point(4 + i), patch.point(8 + i),
                          patch.point(12 + i)};
    const double s = 1.0 - v;
    // Bernstein's polynomials of v in each column leave the cubics along u of S and of S_v.
    arc[i] = s * s * (s * p[0] + 3.0 * v * p[1]) + v * v * (3.0 * s * p[2] + v * p[3]);
    across[i] = 3.0 * (s * s * (p[1] - p[0]) + 2.0 * s * v * (p[2] - p[1]) + v * v * (p[3] - p[2]));
  }
}

Vector3d PatchLine::normal(double u) const {
  const double s = 1.0 - u;
  const Vector3d along = 3.0 * (s * s * (arc[1] - arc[0]) + 2.0 * s * u * (arc[2] - arc[1]) +
                                u * u * (arc[3] - arc[2]));
  return along.cross(arc_point(across, u));
}

void PatchLine::add_stretch(const Vector3d& origin, double begin, double size, double weight,
                            ShellMoments& sum) const {
  static const GaussRule rule = gauss_rule(kStretchNodes);
  ShellNodes nodes;
  for (int k = 0; k < kStretchNodes; ++k) {
    const double u = begin + size * rule.nodes[k];
    nodes.add(point(u) - origin, weight * size * rule.weights[k] * normal(u));
  }
  add_nodes(nodes, sum);
}

void PieceLines::transpose() {
  surface::BezierPatch other;
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) other.x[k][4 * i + j] = patch_.x[k][4 * j + i];
    }
  }
  patch_ = other;
}

void PieceLines::add_water(const CubicArc& arc, std::vector<double>& breaks) const {
  if (!water_) return;
  const BezierCubic heights{water_->height(arc[0]), water_->height(arc[1]), water_->height(arc[2]),
                            water_->height(arc[3])};
  for (double t : sign_changes(heights)) breaks.push_back(t);
}

void PieceLines::spend(int parts) const {
  // One count for all threads: whoever brings it below zero ends the whole computation.
  if (parts_left_ && (*parts_left_ -= parts) < 0) throw SurfacesInOneAnother();
}

std::vector<double> PieceLines::side_breaks(int first, int step) const {
  const CubicArc arc = side_arc(patch_, first, step);
  std::vector<double> breaks;
  std::vector<ArcCrossing> crossings;
  for (const ClosedShell* surface : surfaces_) spend(surface->find_crossings(arc, crossings));
  std::ranges::sort(crossings, {}, &ArcCrossing::t);
  for (const ArcCrossing& crossing : crossings) {
    // The corners of the piece are ends of intervals anyhow.
    if (crossing.t <= kApart || crossing.t >= 1.0 - kApart) continue;
    if (breaks.empty() || crossing.t - breaks.back() > kApart) breaks.push_back(crossing.t);
  }
  add_water(arc, breaks);
  return breaks;
}

// Of the middle of a stretch: the crossings at its ends tell, else a line to the outside.
bool PieceLines::is_inside(int surface, const PatchLine& line, double u) const {
  const std::vector<ArcCrossing>& all = crossings_[surface];
  const auto after = std::ranges::find_if(all, [&](const ArcCrossing& c) { return c.t > u; });
  const auto alone = [&](auto at) {
    return at->way != 0 && (at == all.begin() || at->t - (at - 1)->t > kApart) &&
           (at + 1 == all.end() || (at + 1)->t - at->t > kApart);
  };
  // A line is inside behind a crossing inwards, and before one outwards. Crossings that touch, or
  // that may be one found twice, tell nothing.
  if (after != all.begin() && alone(after - 1)) return (after - 1)->way < 0;
  if (after != all.end() && alone(after)) return after->way > 0;
  const bool inside = surfaces_[surface]->is_inside(line.point(u), parts_left_);
  // The line's parts are taken off already: this asks whether any are left.
  spend(0);
  return inside;
}

// Where a line crosses surfaces and the water, unsorted.
std::vector<double> PieceLines::line_breaks(const PatchLine& line) {
  std::vector<double> breaks;
  // The last one counts the water.
  counts_.assign(surfaces_.size() + 1, 0);
  for (std::size_t k = 0; k < surfaces_.size(); ++k) {
    crossings_[k].clear();
    spend(surfaces_[k]->find_crossings(line.arc, crossings_[k]));
    std::ranges::sort(crossings_[k], {}, &ArcCrossing::t);
    double before = -1.0;
    for (const ArcCrossing& crossing : crossings_[k]) {
      breaks.push_back(crossing.t);
      // A crossing at a side that two patches share is found in both, and counts once.
      counts_[k] += crossing.t - before > kApart;
      before = crossing.t;
    }
  }
  const std::size_t dry = breaks.size();
  add_water(line.arc, breaks);
  counts_.back() = static_cast<int>(breaks.size() - dry);
  return breaks;
}

const LineCounts& PieceLines::counts_at(double v) {
  line_breaks(PatchLine(patch_, v));
  return counts_;
}

// Lines by which a change is looked for come near to touching, and do not count.
void PieceLines::count_touches() {
  for (const std::vector<ArcCrossing>& crossings : crossings_) {
    const auto touching = std::ranges::count(crossings, 0, &ArcCrossing::way);
    // Along an area many parts of one line touch, at a near tangent a few: one line of the first
    // kind weighs as much as many of the other.
    touched_ += touching >= kManyTouches ? kMostIsolated : touching > 0;
  }
  if (touched_ > kMostTouching * kMostIsolated) throw SurfacesInOneAnother();
}

ShellMoments PieceLines::along(double v) {
  const PatchLine line(patch_, v);
  std::vector<double> breaks = line_breaks(line);
  count_touches();
  breaks.push_back(0.0);
  breaks.push_back(1.0);
  std::ranges::sort(breaks);
  ShellMoments sum;
  std::vector<bool> inside(surfaces_.size());
  // Between two breaks nothing changes: the middle tells for the whole stretch.
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double size = breaks[i + 1] - breaks[i], middle = breaks[i] + 0.5 * size;
    if (size < kNoStretch) continue;
    const Vector3d point = line.point(middle);
    // Zero is above, as for all that water cuts.
    if (water_ && water_->height(point) >= 0.0) continue;
    for (std::size_t k = 0; k < surfaces_.size(); ++k) {
      inside[k] = is_inside(static_cast<int>(k), line, middle);
    }
    if (takes_(inside)) line.add_stretch(origin_, breaks[i], size, 1.0, sum);
  }
  return sum;
}

}  // namespace hull::analysis
