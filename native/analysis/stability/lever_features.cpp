// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/lever_features.h"

#include <vector>

#include "analysis/arithmetic/bracketed_root.h"

namespace hull::analysis {
namespace {

constexpr double kAngleTolerance = 1e-12;

// The solved heels from one to another, both of these included.
std::vector<double> heels_between(const HeelingPath& path, double from, double to) {
  path.at(from);
  path.at(to);
  std::vector<double> heels;
  const auto end = path.solved().upper_bound(to);
  for (auto i = path.solved().lower_bound(from); i != end; ++i) heels.push_back(i->first);
  return heels;
}

// The first heel at which a function of the state, positive before, is so no more.
std::optional<double> first_fall(const HeelingPath& path, double from, double to,
                                 const std::function<double(const HeeledState&)>& value) {
  const std::vector<double> heels = heels_between(path, from, to);
  for (std::size_t i = 1; i < heels.size(); ++i) {
    const double before = value(path.at(heels[i - 1])), after = value(path.at(heels[i]));
    if (before <= 0.0 || after > 0.0) continue;
    return bracketed_root([&](double heel) { return value(path.at(heel)); }, heels[i - 1], before,
                          heels[i], after, kAngleTolerance);
  }
  return std::nullopt;
}

}  // namespace

GreatestLever greatest_lever(const HeelingPath& path, double from, double to) {
  const std::vector<double> heels = heels_between(path, from, to);
  GreatestLever best{from, path.at(from).righting_lever, true};
  const auto consider = [&](double heel, bool at_end) {
    const double lever = path.at(heel).righting_lever;
    if (lever > best.lever) best = {heel, lever, at_end};
  };
  consider(to, true);
  for (std::size_t i = 1; i < heels.size(); ++i) {
    const double before = path.at(heels[i - 1]).slope, after = path.at(heels[i]).slope;
    if (before <= 0.0 || after > 0.0) continue;
    consider(bracketed_root([&](double heel) { return path.at(heel).slope; }, heels[i - 1], before,
                            heels[i], after, kAngleTolerance),
             false);
  }
  return best;
}

std::optional<double> vanishing_heel(const HeelingPath& path, double from, double to) {
  return first_fall(path, from, to, [](const HeeledState& s) { return s.righting_lever; });
}

std::optional<double> immersion_heel(const HeelingPath& path, const LowestPoint& lowest,
                                     double from, double to) {
  const auto clearance = [&](const HeeledState& s) {
    return lowest(s.immersion.water.normal) - s.immersion.water.offset;
  };
  if (clearance(path.at(from)) <= 0.0) return from;
  return first_fall(path, from, to, clearance);
}

}  // namespace hull::analysis
