// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/piece_integrals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "analysis/arithmetic/bezier.h"
#include "analysis/arithmetic/estimating_rule.h"
#include "analysis/immersion/piece_moments.h"

namespace hull::analysis {
namespace {

constexpr int kNodes = 8;  // exact up to degree 15, of which 11 is needed
constexpr int kAlong = 10;
constexpr int kMostHalves = 26, kMostAreaHalves = 8;
// Lines of a piece that run along another surface; so many that touch it here and there are as one.
constexpr int kMostTouching = 400, kMostIsolated = 50;
constexpr double kShort = 1e-13;  // of a line, or of what lines cover
constexpr double kApart = 1e-9;   // crossings nearer to each other tell nothing of the way
// Of an interval: how near its ends a line looks for curves that turn back before the first node.
constexpr double kNearEnd = 1e-6;
constexpr int kTurningSteps = 40, kManyTouches = 16;

// The line u -> S(u, v), and S_v along it.
struct PatchLine {
  CubicArc arc, across;

  PatchLine(const surface::BezierPatch& patch, double v) {
    for (int i = 0; i < 4; ++i) {
      const Vector3d p[] = {patch.point(i), patch.point(4 + i), patch.point(8 + i),
                            patch.point(12 + i)};
      const double s = 1.0 - v;
      arc[i] = s * s * (s * p[0] + 3.0 * v * p[1]) + v * v * (3.0 * s * p[2] + v * p[3]);
      across[i] =
          3.0 * (s * s * (p[1] - p[0]) + 2.0 * s * v * (p[2] - p[1]) + v * v * (p[3] - p[2]));
    }
  }

  Vector3d point(double u) const { return arc_point(arc, u); }
  Vector3d normal(double u) const {
    const double s = 1.0 - u;
    const Vector3d along = 3.0 * (s * s * (arc[1] - arc[0]) + 2.0 * s * u * (arc[2] - arc[1]) +
                                  u * u * (arc[3] - arc[2]));
    return along.cross(arc_point(across, u));
  }
};

void add_stretch(const PatchLine& line, const Vector3d& origin, double begin, double size,
                 double weight, ShellMoments& sum) {
  static const GaussRule rule = gauss_rule(kNodes);
  ShellNodes nodes;
  for (int k = 0; k < kNodes; ++k) {
    const double u = begin + size * rule.nodes[k];
    nodes.add(line.point(u) - origin, weight * size * rule.weights[k] * line.normal(u));
  }
  add_nodes(nodes, sum);
}

CubicArc side_arc(const surface::BezierPatch& patch, int first, int step) {
  return {patch.point(first), patch.point(first + step), patch.point(first + 2 * step),
          patch.point(first + 3 * step)};
}

surface::BezierPatch transposed(const surface::BezierPatch& patch) {
  surface::BezierPatch other;
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) other.x[k][4 * i + j] = patch.x[k][4 * j + i];
    }
  }
  return other;
}

class PieceIntegral {
 public:
  PieceIntegral(const surface::BezierPatch& patch, const std::vector<const ClosedShell*>& surfaces,
                const Takes& takes, const Plane* water, const PieceRule& rule)
      : patch_(patch), surfaces_(surfaces), takes_(takes), water_(water), rule_(rule) {
    crossings_.resize(surfaces.size());
  }

  ShellMoments compute() {
    const std::vector<double> u0 = side_breaks(0, 4), u1 = side_breaks(3, 4),
                              v0 = side_breaks(0, 1), v1 = side_breaks(12, 1);
    // Where the curve comes in and goes out by the same side, lines along that side would meet it
    // twice or not at all. Else the direction with fewer breaks has lines at larger angles to it.
    const bool back_u = u0.size() > 1 || u1.size() > 1, back_v = v0.size() > 1 || v1.size() > 1;
    if (back_u == back_v ? u0.size() + u1.size() > v0.size() + v1.size() : back_v) {
      patch_ = transposed(patch_);
      ShellMoments sum = over(v0, v1);
      const double area = sum.area, area_error = sum.area_error, volume_error = sum.volume_error;
      sum *= -1.0;
      sum.area = area;
      sum.area_error = area_error;
      sum.volume_error = volume_error;
      return sum;
    }
    return over(u0, u1);
  }

 private:
  ShellMoments over(std::vector<double> breaks, const std::vector<double>& others) {
    breaks.insert(breaks.end(), others.begin(), others.end());
    breaks.push_back(0.0);
    breaks.push_back(1.0);
    std::ranges::sort(breaks);
    ShellMoments sum;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      if (breaks[i + 1] - breaks[i] > kShort) add(breaks[i], breaks[i + 1] - breaks[i], 0, sum);
    }
    return sum;
  }

  void add_water(const CubicArc& arc, std::vector<double>& breaks) const {
    if (!water_) return;
    const BezierCubic heights{water_->height(arc[0]), water_->height(arc[1]),
                              water_->height(arc[2]), water_->height(arc[3])};
    for (double t : sign_changes(heights)) breaks.push_back(t);
  }

  std::vector<double> side_breaks(int first, int step) const {
    const CubicArc arc = side_arc(patch_, first, step);
    std::vector<double> breaks;
    std::vector<ArcCrossing> crossings;
    for (const ClosedShell* surface : surfaces_) surface->find_crossings(arc, crossings);
    std::ranges::sort(crossings, {}, &ArcCrossing::t);
    for (const ArcCrossing& crossing : crossings) {
      if (crossing.t <= kApart || crossing.t >= 1.0 - kApart) continue;
      if (breaks.empty() || crossing.t - breaks.back() > kApart) breaks.push_back(crossing.t);
    }
    add_water(arc, breaks);
    return breaks;
  }

  // Of the middle of a stretch: the crossings at its ends tell, else a line to the outside.
  bool is_inside(int surface, const PatchLine& line, double u) const {
    const std::vector<ArcCrossing>& all = crossings_[surface];
    const auto after = std::ranges::find_if(all, [&](const ArcCrossing& c) { return c.t > u; });
    const auto alone = [&](auto at) {
      return at->way != 0 && (at == all.begin() || at->t - (at - 1)->t > kApart) &&
             (at + 1 == all.end() || (at + 1)->t - at->t > kApart);
    };
    if (after != all.begin() && alone(after - 1)) return (after - 1)->way < 0;
    if (after != all.end() && alone(after)) return after->way > 0;
    return surfaces_[surface]->is_inside(line.point(u));
  }

  // Where a line crosses surfaces and the water, unsorted; how often each of them is in counts_.
  std::vector<double> line_breaks(const PatchLine& line) {
    std::vector<double> breaks;
    counts_.assign(surfaces_.size() + 1, 0);
    for (std::size_t k = 0; k < surfaces_.size(); ++k) {
      crossings_[k].clear();
      surfaces_[k]->find_crossings(line.arc, crossings_[k]);
      std::ranges::sort(crossings_[k], {}, &ArcCrossing::t);
      double before = -1.0;
      for (const ArcCrossing& crossing : crossings_[k]) {
        breaks.push_back(crossing.t);
        counts_[k] += crossing.t - before > kApart;
        before = crossing.t;
      }
      const auto touching = std::ranges::count(crossings_[k], 0, &ArcCrossing::way);
      touched_ += touching >= kManyTouches ? kMostIsolated : touching > 0;
    }
    if (touched_ > kMostTouching * kMostIsolated) throw SurfacesInOneAnother();
    const std::size_t dry = breaks.size();
    add_water(line.arc, breaks);
    counts_.back() = static_cast<int>(breaks.size() - dry);
    return breaks;
  }

  std::vector<int> counts_at(double v) {
    line_breaks(PatchLine(patch_, v));
    return counts_;
  }

  // Between a line that crosses as often as told, and one that does not: where a curve turns back.
  double turning(double same, double other, const std::vector<int>& counts) {
    for (int step = 0; step < kTurningSteps; ++step) {
      const double middle = 0.5 * (same + other);
      (counts_at(middle) == counts ? same : other) = middle;
    }
    return same;
  }

  ShellMoments along_line(double v) {
    const PatchLine line(patch_, v);
    std::vector<double> breaks = line_breaks(line);
    breaks.push_back(0.0);
    breaks.push_back(1.0);
    std::ranges::sort(breaks);
    ShellMoments sum;
    std::vector<bool> inside(surfaces_.size());
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const double size = breaks[i + 1] - breaks[i], middle = breaks[i] + 0.5 * size;
      if (size < kShort) continue;
      const Vector3d point = line.point(middle);
      if (water_ && water_->height(point) >= 0.0) continue;
      for (std::size_t k = 0; k < surfaces_.size(); ++k) {
        inside[k] = is_inside(static_cast<int>(k), line, middle);
      }
      if (takes_(inside)) add_stretch(line, rule_.origin, breaks[i], size, 1.0, sum);
    }
    return sum;
  }

  // A curve that goes out of the patch at an end of the interval may come from beyond it, and turn
  // back before the nodes that are nearest: where it does so is an end, too.
  bool add_by_turnings(double begin, double width, const std::vector<int>& first,
                       const std::vector<int>& last, ShellMoments& sum) {
    const EstimatingRule& along = EstimatingRule::of(kAlong);
    std::vector<double> ends{begin};
    const double low = begin + kNearEnd * width, high = begin + (1.0 - kNearEnd) * width;
    const std::vector<int> lowest = counts_at(low), highest = counts_at(high);
    if (lowest != first) ends.push_back(turning(low, begin + width * along.node(0), lowest));
    if (highest != last) {
      ends.push_back(turning(high, begin + width * along.node(along.count() - 1), highest));
    }
    if (ends.size() == 1) return false;
    ends.push_back(begin + width);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) add(ends[i], ends[i + 1] - ends[i], 1, sum);
    return true;
  }

  void add(double begin, double width, int depth, ShellMoments& sum) {
    const EstimatingRule& along = EstimatingRule::of(kAlong);
    std::array<EstimatingRule::Values, 4> values{};
    ShellMoments part;
    std::vector<int> first;
    for (int i = 0; i < along.count(); ++i) {
      ShellMoments line = along_line(begin + width * along.node(i));
      if (i == 0) first = counts_;
      for (int k = 0; k < 3; ++k) values[k][i] = width * line.first(k, k);
      values[3][i] = width * line.area;
      line *= width * along.weight(i);
      part += line;
    }
    if (depth == 0 && add_by_turnings(begin, width, first, std::vector<int>(counts_), sum)) return;
    double volume_error = 0.0;
    for (int k = 0; k < 3; ++k) volume_error = std::max(volume_error, along.error(values[k]));
    const double area_error = along.error(values[3]);
    if ((volume_error > rule_.volume || area_error > rule_.area) && depth < kMostHalves) {
      add(begin, 0.5 * width, depth + 1, sum);
      add(begin + 0.5 * width, 0.5 * width, depth + 1, sum);
      return;
    }
    part.volume_error = volume_error;
    part.area_error = area_error;
    sum += part;
  }

  surface::BezierPatch patch_;
  const std::vector<const ClosedShell*>& surfaces_;
  const Takes& takes_;
  const Plane* water_;
  const PieceRule& rule_;
  std::vector<std::vector<ArcCrossing>> crossings_;
  std::vector<int> counts_;
  int touched_ = 0;
};

ShellMoments by_lines(const surface::BezierPatch& patch, const Vector3d& origin) {
  static const GaussRule rule = gauss_rule(kNodes);
  ShellMoments sum;
  for (int k = 0; k < kNodes; ++k) {
    add_stretch(PatchLine(patch, rule.nodes[k]), origin, 0.0, 1.0, rule.weights[k], sum);
  }
  return sum;
}

ShellMoments by_halves(const surface::BezierPatch& patch, const ShellMoments& whole,
                       const PieceRule& rule, int depth) {
  surface::BezierPatch half[2];
  patch.split(depth % 2, half[0], half[1]);
  ShellMoments parts[] = {by_lines(half[0], rule.origin), by_lines(half[1], rule.origin)};
  const double error = std::abs(parts[0].area + parts[1].area - whole.area);
  if (error > rule.area && depth < kMostAreaHalves) {
    for (int k = 0; k < 2; ++k) parts[k] = by_halves(half[k], parts[k], rule, depth + 1);
  } else {
    parts[0].area_error += error;
  }
  parts[0] += parts[1];
  return parts[0];
}

}  // namespace

ShellMoments whole_patch_moments(const surface::BezierPatch& patch, const PieceRule& rule) {
  return by_halves(patch, by_lines(patch, rule.origin), rule, 0);
}

ShellMoments cut_patch_moments(const surface::BezierPatch& patch,
                               const std::vector<const ClosedShell*>& surfaces, const Takes& takes,
                               const Plane* water, const PieceRule& rule) {
  return PieceIntegral(patch, surfaces, takes, water, rule).compute();
}

}  // namespace hull::analysis
