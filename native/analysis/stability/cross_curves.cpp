// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/cross_curves.h"

#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "analysis/stability/water_at_volume.h"
#include "analysis/stability/weathertight.h"

namespace hull::analysis {
namespace {

void check(const std::vector<double>& volumes, const std::vector<double>& heels,
           const CrossCurveOptions& options, double whole) {
  for (double volume : volumes) {
    if (volume > 0.0 && volume < whole) continue;
    std::ostringstream words;
    words << "A displaced volume must be between 0 and that of the whole body, " << whole
          << " m³; it is " << volume << " m³.";
    throw std::invalid_argument(words.str());
  }
  for (double heel : heels) {
    if (!std::isfinite(heel)) throw std::invalid_argument("Heels must be finite numbers.");
  }
  if (!(std::abs(options.trim) < 0.5 * std::numbers::pi)) {
    throw std::invalid_argument("The trim must be below 90°.");
  }
  if (!std::isfinite(options.assumed_kg)) {
    throw std::invalid_argument("The height of the centre of gravity must be a finite number.");
  }
}

}  // namespace

std::vector<CrossCurve> cross_curves(const HullBody& body, const std::vector<double>& volumes,
                                     const std::vector<double>& heels,
                                     const CrossCurveOptions& options) {
  const Weathertight closed(body);
  const double whole = greatest_volume(closed.body(), Vector3d::UnitZ());
  check(volumes, heels, options, whole);
  std::vector<CrossCurve> curves;
  for (double volume : volumes) {
    surface::tell(options.progress, static_cast<double>(curves.size()),
                  static_cast<double>(volumes.size()));
    // Upright and level: the centre of buoyancy does not depend on a centre of gravity there.
    HeelingPath upright(closed.body(), volume, whole, Vector3d::Zero(), TrimMode::kFixed, 0.0);
    CrossCurve curve;
    curve.volume = volume;
    curve.lcg = upright.at(0.0).immersion.centre_of_buoyancy.x();
    // Above the buoyancy, so that with free trim the upright ship stays level.
    const Vector3d gravity(curve.lcg, 0.0, options.assumed_kg);
    HeelingPath path(closed.body(), volume, whole, gravity, options.trim_mode, options.trim);
    for (double heel : heels) {
      const HeeledState& state = path.at(heel);
      // Starboard is (0, -cos, sin) whatever the trim.
      curve.levers.push_back(state.righting_lever + options.assumed_kg * std::sin(heel));
      curve.trims.push_back(state.trim);
    }
    curve.evaluations = upright.evaluations() + path.evaluations();
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace hull::analysis
