// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/quality/sample_line.h"

#include <algorithm>

namespace hull::conversion {
namespace {

constexpr double kRounding = 1e-14;
constexpr int kHalvings = 4;

}  // namespace

std::vector<double> breaks_between(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  std::vector<double> breaks{0.0};
  for (double number : numbers) {
    if (number > breaks.back() + kRounding && number < 1.0 - kRounding) breaks.push_back(number);
  }
  breaks.push_back(1.0);
  return breaks;
}

void refine_ends(std::vector<double>& breaks, bool at_begin, bool at_end) {
  const double first = breaks[1], last = 1.0 - breaks[breaks.size() - 2];
  double share = 0.5;
  for (int i = 0; i < kHalvings; ++i, share *= 0.5) {
    // Shares of the interval as it was.
    if (at_begin) breaks.push_back(share * first);
    if (at_end) breaks.push_back(1.0 - share * last);
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
}

SampleLine sample_line(const std::vector<double>& breaks, const analysis::GaussRule& rule) {
  SampleLine line;
  const auto add = [&line](double at, double weight, int interval) {
    line.at.push_back(at);
    line.weights.push_back(weight);
    line.intervals.push_back(interval);
  };
  line.interval_count = static_cast<int>(breaks.size()) - 1;
  // Ends belong to the intervals beside them, and to no integral.
  add(0.0, 0.0, 0);
  for (int k = 0; k < line.interval_count; ++k) {
    const double size = breaks[k + 1] - breaks[k];
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      add(breaks[k] + rule.nodes[i] * size, rule.weights[i] * size, k);
    }
  }
  add(1.0, 0.0, line.interval_count - 1);
  return line;
}

}  // namespace hull::conversion
