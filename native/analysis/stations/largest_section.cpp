// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/largest_section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace hull::analysis {
namespace {

constexpr int kScanned = 8;  // intervals
// Of the scan, whose first and last station touch a rounded end along a line.
constexpr int kDeepestScanned = 6;
constexpr double kLevelArea = 1e-12;  // of the area: parallel stations differ by rounding
constexpr double kSettled = 1e-8;     // of the area: what a step to the top of a parabola gains
// Of the range: half of the digits, as the area is flat at its maximum.
constexpr double kNarrow = 1e-5;
constexpr double kSearched = 1e-9;  // tolerance of the areas that are compared

// The immersed station at x, by a rule.
using Stations = std::function<SectionArea(double x, const ArcRule& rule)>;

// Brent's search for the maximum in (begin, end) around a higher middle: parabolas through the best
// three stations, golden sections where these do not help.
SectionArea refine_largest(const Stations& station, const SectionArea& left, SectionArea best,
                           const SectionArea& right, double tolerance, const ArcRule& rule) {
  constexpr double kGolden = 0.381966011250105;
  double begin = left.position, end = right.position;
  // The best station but one, and the one before that, carry the parabola with the best.
  const bool left_is_second = left.area > right.area;
  SectionArea second = left_is_second ? left : right, third = left_is_second ? right : left;
  double step = end - begin, before = step;
  for (int i = 0; i < 60; ++i) {
    const double x = best.position, middle = 0.5 * (begin + end);
    if (std::abs(x - middle) <= 2.0 * tolerance - 0.5 * (end - begin)) break;
    bool parabola = false;
    if (std::abs(before) > tolerance) {
      const double r = (x - second.position) * (third.area - best.area);
      double q = (x - third.position) * (second.area - best.area);
      double p = (x - third.position) * q - (x - second.position) * r;
      q = 2.0 * (q - r);
      if (q > 0.0) p = -p;
      q = std::abs(q);
      // Its top has to lie between the ends, and the step to be less than half of the last but one.
      if (std::abs(p) < std::abs(0.5 * q * before) && p > q * (begin - x) && p < q * (end - x)) {
        before = step;
        step = p / q;
        parabola = true;
      }
    }
    if (!parabola) {
      before = (x < middle ? end : begin) - x;
      step = kGolden * before;
    }
    // Nearer than the tolerance areas differ by their own errors.
    const double to = x + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step));
    const SectionArea tried = station(to, rule);
    const bool settled = parabola && std::abs(tried.area - best.area) <= kSettled * best.area;
    if (tried.area >= best.area) {
      (to < x ? end : begin) = x;
      third = second;
      second = best;
      best = tried;
    } else {
      (to < x ? begin : end) = to;
      if (tried.area >= second.area || second.position == x) {
        third = second;
        second = tried;
      } else if (tried.area >= third.area || third.position == x ||
                 third.position == second.position) {
        third = tried;
      }
    }
    if (settled) break;
  }
  return best;
}

// Of x, from the boxes of the cells that reach into the water on either side.
std::array<double, 2> immersed_range(const StationCutter& cutter, const Plane& water) {
  const CellBoxes& boxes = cutter.body().boxes();
  const Vector3d mirrored = water.normal.cwiseProduct(Vector3d(1.0, -1.0, 1.0));
  std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  for (int cell = 0; cell < boxes.size(); ++cell) {
    // The image of a cell is in the water where the cell is in the mirrored water.
    const bool wet = boxes.least(cell, water.normal) < water.offset ||
                     (cutter.body().mirrored() && boxes.least(cell, mirrored) < water.offset);
    if (!wet) continue;
    range = {std::min(range[0], boxes.low(cell).x()), std::max(range[1], boxes.high(cell).x())};
  }
  return range;
}

}  // namespace

SectionArea largest_section(const StationCutter& cutter, const Plane& water, KeptStations* kept) {
  const auto [begin, end] = immersed_range(cutter, water);
  if (!(end > begin)) return {};
  const HullBody& body = cutter.body();
  const Stations station = [&](double x, const ArcRule& rule) {
    return kept ? kept->station(cutter, x, water, rule) : immersed_station(cutter, x, water, rule);
  };
  const double size = body.surface().mesh().size();
  // Three nodes an arc, and errors that none has: nothing is halved.
  const ArcRule rough{3, size * size, size, kDeepestScanned},
      rule = arc_rule(size, std::max(kSearched, body.tolerance()));
  std::vector<SectionArea> scan;
  for (int i = 0; i <= kScanned; ++i) {
    const double x = begin + (end - begin) * i / kScanned;
    scan.push_back(station(x, rough));
  }
  // From the middle outwards, so that the nearest of equals is kept.
  int best = kScanned / 2;
  for (int k = 1; k <= kScanned / 2; ++k) {
    for (int i : {kScanned / 2 - k, kScanned / 2 + k}) {
      if (scan[i].area > scan[best].area * (1.0 + kLevelArea)) best = i;
    }
  }
  const int left = std::max(best - 1, 0), right = std::min(best + 1, kScanned);
  const bool level = scan[left].area >= scan[best].area * (1.0 - kLevelArea) &&
                     scan[right].area >= scan[best].area * (1.0 - kLevelArea);
  // Along a parallel middle body there is nothing to search for.
  if (level) return station(scan[best].position, cutter.rule());
  // Every area that is tried is compared with the best: that must not be a rough one.
  scan[best] = station(scan[best].position, rule);
  const SectionArea found =
      refine_largest(station, scan[left], scan[best], scan[right], kNarrow * (end - begin), rule);
  // The place is known well enough; its area is taken again as exactly as the body's others.
  const bool searched_coarsely = body.tolerance() < kSearched;
  return searched_coarsely ? station(found.position, cutter.rule()) : found;
}

}  // namespace hull::analysis
