// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "analysis/arithmetic/estimating_rule.h"
#include "analysis/derivatives/span_nodes.h"
#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// What is below the water of a column across a square that the water cuts: from … to of its
// parameter across.
struct WetColumn {
  double from = 0.0, to = 1.0;
  bool any, crosses;
  bool low;  // whether the end at 0 is below the water

  WetColumn(const CutSquare& square, double along) {
    const BezierCubic column = square.height.along_v(along);
    const bool high = column[3] < 0.0;
    low = column[0] < 0.0;
    any = low || high;
    crosses = low != high;
    if (crosses) (low ? to : from) = crossing(column);
  }

  // The end of the part below the water that is on its surface, which may be exactly at 0 or 1, as
  // where a row of control points is. REQUIRES: crosses.
  double at_water() const { return low ? to : from; }
};

// Where a square's parameters (along the cut, across it) are in its span.
inline SpanNode node_of(const surface::BicubicPoints& points, const CutSquare& square, double along,
                        double across) {
  const double a = square.size * along, b = square.size * across;
  return {points, square.u + (square.swapped ? b : a), square.v + (square.swapped ? a : b)};
}

// How fast a span's height above the water changes across the cut, |h_v|.
inline double slope_across(const CutSquare& square, const SpanNode& at, const Plane& water) {
  return std::abs(water.normal.dot(square.swapped ? at.along_u : at.along_v));
}

// Nodes along the water's surface, in an interval.
inline constexpr int kWetColumns = 10;

// Divides the parameter along a square that the water cuts into intervals where so many nodes are
// enough, by the area of what is wet and by the waterplane's share of it, and calls visit(begin,
// width) for each.
template <class Visit>
class WetIntervals {
 public:
  WetIntervals(const surface::BicubicPoints& points, const Plane& water, const Visit& visit)
      : points_(points),
        water_(water),
        visit_(visit),
        size_((points[10] - points[5]).squaredNorm() + (points[9] - points[6]).squaredNorm()) {}

  void divide(const CutSquare& square) const {
    const Breaks breaks = crossing_breaks(square.height);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      add_interval(square, breaks[k], breaks[k + 1] - breaks[k], 0);
    }
  }

 private:
  static constexpr int kMostHalvings = 5;
  static constexpr double kSettled = 1e-12;  // of a span's own area: what an interval may be off

  void add_interval(const CutSquare& square, double begin, double width, int depth) const {
    if (depth == kMostHalvings || is_settled(square, begin, width)) return visit_(begin, width);
    add_interval(square, begin, 0.5 * width, depth + 1);
    add_interval(square, begin + 0.5 * width, 0.5 * width, depth + 1);
  }

  bool is_settled(const CutSquare& square, double begin, double width) const {
    const EstimatingRule& rule = EstimatingRule::of(kWetColumns);
    EstimatingRule::Values widths{}, shares{};
    for (int i = 0; i < rule.count(); ++i) {
      const double u = begin + width * rule.node(i);
      const WetColumn wet(square, u);
      if (!wet.crosses) continue;
      widths[i] = wet.to - wet.from;
      const SpanNode at = node_of(points_, square, u, wet.at_water());
      const double slope = slope_across(square, at, water_);
      shares[i] = slope > 0.0 ? at.normal.norm() * std::sqrt(size_) / slope : 0.0;
    }
    return width * rule.error(widths) <= kSettled && width * rule.error(shares) <= kSettled * size_;
  }

  const surface::BicubicPoints& points_;
  const Plane& water_;
  const Visit& visit_;
  double size_;  // the span's, m²
};

}  // namespace hull::analysis
