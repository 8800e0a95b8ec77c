// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/lever_features.h"

#include <algorithm>

#include "analysis/arithmetic/bracketed_root.h"

namespace hull::analysis {
namespace {

constexpr double kAngleTolerance = 1e-12;

// The first heel at which a function of the state, positive before, is so no more.
std::optional<double> first_fall(HeelingPath& path, const std::vector<double>& heels,
                                 const std::function<double(const HeeledState&)>& value) {
  for (std::size_t i = 1; i < heels.size(); ++i) {
    const double before = value(path.at(heels[i - 1])), after = value(path.at(heels[i]));
    // Zero at once is no fall, as upright; zero at the end of an interval is one.
    if (before <= 0.0 || after > 0.0) continue;
    return bracketed_root([&](double heel) { return value(path.at(heel)); }, heels[i - 1], before,
                          heels[i], after, kAngleTolerance);
  }
  return std::nullopt;
}

}  // namespace

std::vector<double> heels_between(const std::vector<double>& heels, double from, double to) {
  std::vector<double> between{from, to};
  for (double heel : heels) {
    if (heel > from && heel < to) between.push_back(heel);
  }
  std::sort(between.begin(), between.end());
  between.erase(std::unique(between.begin(), between.end()), between.end());
  return between;
}

GreatestLever greatest_lever(HeelingPath& path, const std::vector<double>& heels) {
  // Both ends first: a top within counts only where it is higher.
  GreatestLever best{heels.front(), path.at(heels.front()).righting_lever, true};
  const auto consider = [&](double heel, bool at_end) {
    const double lever = path.at(heel).righting_lever;
    if (lever > best.lever) best = {heel, lever, at_end};
  };
  consider(heels.back(), true);
  for (std::size_t i = 1; i < heels.size(); ++i) {
    // A top is where the slope, exact along the path, falls through zero.
    const double before = path.at(heels[i - 1]).slope, after = path.at(heels[i]).slope;
    if (before <= 0.0 || after > 0.0) continue;
    consider(bracketed_root([&](double heel) { return path.at(heel).slope; }, heels[i - 1], before,
                            heels[i], after, kAngleTolerance),
             false);
  }
  return best;
}

std::optional<double> vanishing_heel(HeelingPath& path, const std::vector<double>& heels) {
  return lever_falls_to(path, heels, 0.0);
}

std::optional<double> lever_rises_to(HeelingPath& path, const std::vector<double>& heels,
                                     double heeling_lever) {
  // What the heeling lever is above GZ falls to zero.
  return first_fall(path, heels, [heeling_lever](const HeeledState& s) {
    return heeling_lever - s.righting_lever;
  });
}

std::optional<double> lever_falls_to(HeelingPath& path, const std::vector<double>& heels,
                                     double heeling_lever) {
  return first_fall(path, heels, [heeling_lever](const HeeledState& s) {
    return s.righting_lever - heeling_lever;
  });
}

std::optional<double> immersion_heel(HeelingPath& path, const std::vector<double>& heels,
                                     const LowestPoint& lowest) {
  const auto clearance = [&](const HeeledState& s) {
    return lowest(s.immersion.water.normal) - s.immersion.water.offset;
  };
  if (clearance(path.at(heels.front())) <= 0.0) return heels.front();
  return first_fall(path, heels, clearance);
}

}  // namespace hull::analysis
