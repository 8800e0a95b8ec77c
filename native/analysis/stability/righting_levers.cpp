// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/righting_levers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "analysis/stability/deck_edge.h"
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

DeckEdge deck_edge_of(const HullBody& body, const StabilityEdges& edges) {
  return edges.deck_edge_vertices.empty() ? DeckEdge(body)
                                          : DeckEdge(body, edges.deck_edge_vertices);
}

}  // namespace

HeelingPath heeling_path(const HullBody& body, const LoadCase& load, TrimMode mode, double trim) {
  const double volume = load.displaced_volume();
  if (!(std::abs(trim) < kRightAngle)) {
    throw std::invalid_argument("The trim must be below 90°.");
  }
  const double whole = greatest_volume(body, Vector3d::UnitZ());
  if (volume >= whole) {
    std::ostringstream words;
    words << "The ship sinks: she weighs " << load.mass << " t, but the whole body displaces only "
          << whole * load.water_density << " t.";
    throw std::invalid_argument(words.str());
  }
  return HeelingPath(body, volume, whole, load.centre_of_gravity, mode, trim);
}

bool can_flood(const HullBody& body, const StabilityEdges& edges) {
  return !edges.downflooding_points.empty() ||
         std::isfinite(body.lowest_opening(Vector3d::UnitZ()));
}

std::optional<double> flooding_heel(const HeelingPath& path, const HullBody& body,
                                    const StabilityEdges& edges, double to) {
  const auto lowest = [&](const Vector3d& up) {
    double least = body.lowest_opening(up);
    for (const Vector3d& p : edges.downflooding_points) least = std::min(least, up.dot(p));
    return least;
  };
  return immersion_heel(path, lowest, 0.0, to);
}

RightingLevers righting_levers(const HullBody& body, const LoadCase& load,
                               const std::vector<double>& heels,
                               const RightingLeverOptions& options) {
  check(heels, options);
  const DeckEdge deck_edge = deck_edge_of(body, options.edges);
  const Weathertight closed(body);
  const HeelingPath path = heeling_path(closed.body(), load, options.trim_mode, options.trim);
  RightingLevers result;
  for (double heel : heels) result.states.push_back(path.at(heel));
  result.curve_evaluations = path.evaluations();
  result.gm = path.at(0.0).slope;
  const double last = *std::max_element(heels.begin(), heels.end());
  result.has_deck_edge = !deck_edge.empty();
  result.has_openings = can_flood(body, options.edges);
  if (last > 0.0) {
    result.greatest = greatest_lever(path, 0.0, last);
    result.vanishing_heel = vanishing_heel(path, 0.0, last);
    if (result.has_deck_edge) {
      result.deck_edge_heel = immersion_heel(
          path, [&](const Vector3d& up) { return deck_edge.lowest(up); }, 0.0, last);
    }
    if (result.has_openings) result.flooding_heel = flooding_heel(path, body, options.edges, last);
  }
  for (const auto& [from, to] : options.area_intervals) {
    result.areas.push_back(lever_area(path, from, to, options.area_tolerance));
  }
  result.evaluations = path.evaluations();
  return result;
}

}  // namespace hull::analysis
