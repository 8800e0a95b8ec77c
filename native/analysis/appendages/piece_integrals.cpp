// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/piece_integrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analysis/appendages/piece_lines.h"
#include "analysis/arithmetic/gauss.h"

namespace hull::analysis {
namespace {

constexpr int kPatchLines = 8;  // exact up to degree 15, of which 11 is needed
constexpr int kAlong = 10;
constexpr int kMostHalves = 26, kMostAreaHalves = 8;
constexpr double kNoRange = 1e-13;  // of what lines cover
// Of an interval: how near its ends a line looks for what changes before the first node.
constexpr double kNearEnd = 1e-8;
// Of an interval: where its ends are looked at. A line at the end itself may run along an edge.
constexpr double kAtEnd = 1e-6;
constexpr int kFoldSteps = 36;  // halves that find where a curve turns back

// Of v, with what happens at its ends: where a curve turns back there, lines have the square root
// of the distance from it, and an integral by w, v = w², of what is analytic.
struct LineRange {
  double begin, width;
  bool folds_at_begin = false, folds_at_end = false;

  // v and dv at a share s of the interval.
  std::array<double, 2> at(double s) const {
    double share = s, slope = 1.0;
    if (folds_at_begin && folds_at_end) {
      // The cubic that is level at both ends.
      share = s * s * (3.0 - 2.0 * s);
      slope = 6.0 * s * (1.0 - s);
    } else if (folds_at_begin) {
      share = s * s;
      slope = 2.0 * s;
    } else if (folds_at_end) {
      share = s * (2.0 - s);
      slope = 2.0 * (1.0 - s);
    }
    return {begin + width * share, width * slope};
  }
};

// The lines at an interval's nodes.
struct Sampled {
  ShellMoments sum;
  double volume_error = 0.0, area_error = 0.0;
  std::vector<double> places;
  std::vector<LineCounts> counts;
};

int sum_of(const LineCounts& counts) { return std::accumulate(counts.begin(), counts.end(), 0); }

// How much the rule may be off. Between the patches of the other surface the integrand's higher
// derivatives jump, and its Legendre series falls like a power only. What EstimatingRule takes for
// granted, that it falls geometrically, must show between degrees 4 and 8.
class CarefulRule {
 public:
  CarefulRule() : rule_(gauss_rule(kAlong)) {
    for (int i = 0; i < kAlong; ++i) {
      for (int degree = 0; degree < kAlong; ++degree) {
        const double x = 2.0 * rule_.nodes[i] - 1.0;
        weights_[degree][i] = rule_.weights[i] * (2 * degree + 1) * std::legendre(degree, x);
      }
    }
  }
  double node(int i) const { return rule_.nodes[i]; }
  double weight(int i) const { return rule_.weights[i]; }
  // ends: the values at both. What happens between an end and the node next to it no node knows.
  double error(const std::array<double, kAlong>& values, const std::array<double, 2>& ends) const {
    std::array<double, kAlong> sizes{};
    double begin = 0.0, end = 0.0;  // there, of the polynomial through the nodes' values
    for (int degree = 0; degree < kAlong; ++degree) {
      for (int i = 0; i < kAlong; ++i) sizes[degree] += weights_[degree][i] * values[i];
      // Legendre polynomials of odd degree change sign with their argument.
      begin += sizes[degree] * std::legendre(degree, 1.0 - 2.0 * kAtEnd) * (degree % 2 ? -1 : 1);
      end += sizes[degree] * std::legendre(degree, 1.0 - 2.0 * kAtEnd);
    }
    const double low = std::abs(sizes[4]) + std::abs(sizes[5]),
                 top = std::abs(sizes[8]) + std::abs(sizes[9]);
    // Of four degrees, 4 and 5 to 8 and 9, in pairs as even or odd ones alone may vanish.
    const double fall = low > 0.0 ? top / low : 1.0;
    const double missed = std::abs(ends[0] - begin) + std::abs(ends[1] - end);
    // To degree 20, of which the error is, it falls by 11 more.
    return top * (fall > kPowerFall ? kPowerShare : std::pow(fall, 11.0 / 4.0)) +
           0.5 * node(0) * missed;
  }

 private:
  static constexpr double kPowerFall = 0.02, kPowerShare = 0.3;

  GaussRule rule_;
  std::array<std::array<double, kAlong>, kAlong> weights_{};
};

class PieceIntegral {
 public:
  PieceIntegral(const PieceLines& lines, const PieceRule& rule) : lines_(lines), rule_(rule) {}

  ShellMoments compute() {
    const std::vector<double> u0 = lines_.side_breaks(0, 4), u1 = lines_.side_breaks(3, 4),
                              v0 = lines_.side_breaks(0, 1), v1 = lines_.side_breaks(12, 1);
    // Where the curve comes in and goes out by the same side, lines along that side would meet it
    // twice or not at all. Else the direction with fewer breaks has lines at larger angles to it.
    const bool back_u = u0.size() > 1 || u1.size() > 1, back_v = v0.size() > 1 || v1.size() > 1;
    if (back_u == back_v ? u0.size() + u1.size() > v0.size() + v1.size() : back_v) {
      // With u and v exchanged the normal S_u x S_v is turned round: fluxes have to change sign,
      // areas and errors not.
      lines_.transpose();
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
      add({breaks[i], breaks[i + 1] - breaks[i]}, true, 0, sum);
    }
    return sum;
  }

  Sampled sampled(const LineRange& interval) {
    static const CarefulRule along;
    std::array<std::array<double, kAlong>, 4> values{};
    Sampled found;
    for (int i = 0; i < kAlong; ++i) {
      const auto [v, dv] = interval.at(along.node(i));
      ShellMoments line = lines_.along(v);
      found.places.push_back(v);
      found.counts.push_back(lines_.counts());
      // The three fluxes of the volume, x n_x, y n_y and z n_z: which of them is hard to integrate
      // depends on how the piece lies.
      for (int k = 0; k < 3; ++k) values[k][i] = dv * line.first(k, k);
      values[3][i] = dv * line.area;
      line *= dv * along.weight(i);
      found.sum += line;
    }
    std::array<std::array<double, 2>, 4> ends{};
    for (int j = 0; j < 2; ++j) {
      const auto [v, dv] = interval.at(j == 0 ? kAtEnd : 1.0 - kAtEnd);
      const ShellMoments line = lines_.along(v);
      for (int k = 0; k < 3; ++k) ends[k][j] = dv * line.first(k, k);
      ends[3][j] = dv * line.area;
    }
    for (int k = 0; k < 3; ++k) {
      found.volume_error = std::max(found.volume_error, along.error(values[k], ends[k]));
    }
    found.area_error = along.error(values[3], ends[3]);
    return found;
  }

  // Between a line that crosses surfaces as often as told, and one that does not: where that ends.
  double turning(double same, double other, const LineCounts& counts) {
    for (int step = 0; step < kFoldSteps; ++step) {
      const double middle = 0.5 * (same + other);
      (lines_.counts_at(middle) == counts ? same : other) = middle;
    }
    return 0.5 * (same + other);
  }

  // The parts of an interval on which lines cross as often; one where all do. is_new: what is near
  // its ends is not known: a curve that leaves the patch there may come from beyond, and turn back
  // before the first node.
  std::vector<LineRange> parts_of(const LineRange& interval, Sampled& found, bool is_new) {
    std::vector<LineRange> parts{interval};
    if (!is_new) return parts;
    const double near = kNearEnd * interval.width, end = interval.begin + interval.width;
    found.places.insert(found.places.begin(), interval.begin + near);
    found.counts.insert(found.counts.begin(), lines_.counts_at(found.places.front()));
    found.places.push_back(end - near);
    found.counts.push_back(lines_.counts_at(end - near));
    for (std::size_t i = 0; i + 1 < found.places.size(); ++i) {
      const LineCounts &before = found.counts[i], &after = found.counts[i + 1];
      if (before == after) continue;
      // Between the two places, as along an edge that lines are all but parallel to, the counts may
      // be others still.
      const double at = turning(found.places[i], found.places[i + 1], before),
                   beyond = std::max(at, turning(found.places[i + 1], found.places[i], after));
      // Where crossings begin at `beyond`, or end at `at`, the curve turns back there.
      LineRange& last = parts.back();
      const LineRange next{beyond, last.begin + last.width - beyond, sum_of(after) > sum_of(before),
                           last.folds_at_end};
      last.width = at - last.begin;
      last.folds_at_end = sum_of(before) > sum_of(after);
      parts.push_back({at, beyond - at});
      parts.push_back(next);
    }
    return parts;
  }

  void add(const LineRange& interval, bool is_new, int depth, ShellMoments& sum) {
    if (interval.width <= kNoRange) return;
    Sampled found = sampled(interval);
    if (depth < kMostHalves) {
      const std::vector<LineRange> parts = parts_of(interval, found, is_new);
      if (parts.size() > 1) {
        for (const LineRange& part : parts) add(part, false, depth + 1, sum);
        return;
      }
      if (found.volume_error > rule_.volume || found.area_error > rule_.area) {
        const double half = 0.5 * interval.width;
        add({interval.begin, half, interval.folds_at_begin, false}, false, depth + 1, sum);
        add({interval.begin + half, half, false, interval.folds_at_end}, false, depth + 1, sum);
        return;
      }
    }
    found.sum.volume_error = found.volume_error;
    found.sum.area_error = found.area_error;
    sum += found.sum;
  }

  PieceLines lines_;
  const PieceRule& rule_;
};

ShellMoments by_lines(const surface::BezierPatch& patch, const Vector3d& origin) {
  static const GaussRule rule = gauss_rule(kPatchLines);
  ShellMoments sum;
  for (int k = 0; k < kPatchLines; ++k) {
    PatchLine(patch, rule.nodes[k]).add_stretch(origin, 0.0, 1.0, rule.weights[k], sum);
  }
  return sum;
}

ShellMoments by_halves(const surface::BezierPatch& patch, const ShellMoments& whole,
                       const PieceRule& rule, int depth) {
  surface::BezierPatch half[2];
  // Across u and v by turns.
  patch.split(depth % 2, half[0], half[1]);
  ShellMoments parts[] = {by_lines(half[0], rule.origin), by_lines(half[1], rule.origin)};
  const double error = std::abs(parts[0].area + parts[1].area - whole.area);
  if (error > rule.area && depth < kMostAreaHalves) {
    for (int k = 0; k < 2; ++k) parts[k] = by_halves(half[k], parts[k], rule, depth + 1);
  } else {
    // Of the whole, not the halves, whose error is smaller: an estimate on the safe side.
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
  return PieceIntegral(PieceLines(patch, surfaces, takes, water, rule), rule).compute();
}

}  // namespace hull::analysis
