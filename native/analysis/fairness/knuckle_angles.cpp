// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/knuckle_angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "surface/creases/knuckle_angle.h"

namespace hull::analysis {
namespace {

constexpr int kMostOfEdge = 1000;  // of one edge

// Simpson's rule: the curve's speed is smooth between knots, and steps are parts of these.
double simpson_length(const surface::CreaseCurve& curve, double from, double to) {
  const auto speed = [&curve](double t) { return curve.evaluate(t, 1).d1.norm(); };
  constexpr int kParts = 4;
  const double step = (to - from) / kParts;
  double sum = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double a = from + i * step;
    sum += (speed(a) + 4.0 * speed(a + 0.5 * step) + speed(a + step)) * step / 6.0;
  }
  return sum;
}

void add_range(KnuckleAngles& result) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::infinity(), high = -low, area = 0.0, width = 0.0;
  for (std::size_t i = 0; i < result.angles.size(); ++i) {
    const double angle = result.angles[i];
    if (std::isnan(angle)) continue;
    low = std::min(low, angle);
    high = std::max(high, angle);
    if (i == 0 || std::isnan(result.angles[i - 1])) continue;
    const double step = result.arc_lengths[i] - result.arc_lengths[i - 1];
    // Between edges that do not follow one another the step is zero.
    area += 0.5 * step * (angle + result.angles[i - 1]);
    width += step;
  }
  const bool has_any = low <= high;
  result.least = has_any ? low : none;
  result.largest = has_any ? high : none;
  result.mean = width > 0.0 ? area / width : result.least;
}

}  // namespace

KnuckleAngles knuckle_angles(const surface::LimitSurface& surface,
                             const surface::CreaseCurve& curve, const std::vector<int>& edges,
                             int samples_per_edge) {
  if (samples_per_edge < 1 || samples_per_edge > kMostOfEdge) {
    throw std::invalid_argument("An edge takes 1 to 1000 samples, not " +
                                std::to_string(samples_per_edge) + ".");
  }
  KnuckleAngles result{};
  // No edge follows it, not even edge 0.
  int before = -2;
  for (int edge : surface::knuckle_edges(curve, edges)) {
    for (int i = edge == before + 1 ? 1 : 0; i <= samples_per_edge; ++i) {
      const double t = edge + static_cast<double>(i) / samples_per_edge;
      if (i > 0) {
        result.length += simpson_length(curve, edge + (i - 1.0) / samples_per_edge, t);
      }
      result.t.push_back(t);
      result.arc_lengths.push_back(result.length);
      result.angles.push_back(surface::knuckle_angle(surface, curve, t));
    }
    before = edge;
  }
  add_range(result);
  return result;
}

}  // namespace hull::analysis
