// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/righting_levers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "analysis/stability/water_at_volume.h"
#include "analysis/stability/weathertight.h"

namespace hull::analysis {
namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;

void check(const std::vector<double>& heels, const RightingLeverOptions& options) {
  if (heels.empty()) throw std::invalid_argument("No heels are given: righting levers need some.");
  for (double heel : heels) {
    if (!std::isfinite(heel)) throw std::invalid_argument("Heels must be finite numbers.");
  }
  for (const auto& [from, to] : options.area_intervals) {
    if (!std::isfinite(from) || !std::isfinite(to)) {
      throw std::invalid_argument("Areas must be between finite angles.");
    }
  }
  if (!(options.area_tolerance > 0.0)) {
    throw std::invalid_argument("The tolerance of areas must be positive.");
  }
}

}  // namespace

HeelingPath heeling_path(const HullBody& body, const LoadCase& load, TrimMode mode, double trim) {
  const double volume = load.displaced_volume();
  if (!(std::abs(trim) < kRightAngle)) {
    throw std::invalid_argument("The trim must be below 90°.");
  }
  // In any direction the same: all of the body is under water.
  const double whole = greatest_volume(body, Vector3d::UnitZ());
  if (volume >= whole) {
    std::ostringstream words;
    words << "The ship sinks: she weighs " << load.mass_t
          << " t, but the whole body displaces only " << whole * load.water_density << " t.";
    throw std::invalid_argument(words.str());
  }
  return HeelingPath(body, volume, whole, load.centre_of_gravity, mode, trim);
}

RightingLevers righting_levers(const HullBody& body, const LoadCase& load,
                               const std::vector<double>& heels,
                               const RightingLeverOptions& options) {
  check(heels, options);
  const DeckEdge deck_edge = deck_edge_of(body, options.edges);
  // Levers are those of the closed body beyond flooding too; `body` itself tells where she floods.
  const Weathertight closed(body);
  HeelingPath path = heeling_path(closed.body(), load, options.trim_mode, options.trim);
  RightingLevers result;
  for (double heel : heels) result.states.push_back(path.at(heel));
  // Before anything else is asked of the path: features need states between those asked for.
  result.curve_evaluations = path.evaluations();
  result.gm = path.at(0.0).slope;
  const double last = *std::max_element(heels.begin(), heels.end());
  result.has_deck_edge = !deck_edge.empty();
  result.can_flood = can_flood(body, options.edges);
  // Features are those of heels to starboard, whatever is asked for to port.
  if (last > 0.0) {
    const std::vector<double> looked_at = heels_between(heels, 0.0, last);
    result.greatest = greatest_lever(path, looked_at);
    result.vanishing_heel = vanishing_heel(path, looked_at);
    result.deck_edge_heel = deck_edge_heel(path, deck_edge, looked_at);
    if (result.can_flood) {
      result.downflooding_heel = downflooding_heel(path, body, options.edges, looked_at);
    }
  }
  for (const auto& [from, to] : options.area_intervals) {
    result.areas.push_back(lever_area(path, from, to, options.area_tolerance));
  }
  result.evaluations = path.evaluations();
  return result;
}

}  // namespace hull::analysis
