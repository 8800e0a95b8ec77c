// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/bonjean.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/stations/station_cutter.h"

namespace hull::analysis {
namespace {

void check_finite(const std::vector<double>& values, const char* what) {
  for (double value : values) {
    if (!std::isfinite(value)) throw std::invalid_argument(what);
  }
}

}  // namespace

BonjeanCurves bonjean(const HullBody& body, std::vector<double> stations,
                      std::vector<double> drafts) {
  check_finite(stations, "The position of a station must be a finite number.");
  check_finite(drafts, "A draft must be a finite number.");
  BonjeanCurves curves{std::move(stations), std::move(drafts), {}};
  if (curves.drafts.empty()) return curves;
  const double deepest = *std::max_element(curves.drafts.begin(), curves.drafts.end());
  body.refuse_flooding({Vector3d::UnitZ(), deepest});
  const StationCutter cutter(body);
  for (double station : curves.stations) {
    StationViews views(cutter, station, {Vector3d::UnitZ(), 0.0}, deepest, cutter.rule());
    // What is wholly below a draft was integrated once; a draft costs only the arcs it cuts.
    views.prepare();
    for (double draft : curves.drafts) curves.sections.push_back(views.below(draft));
  }
  return curves;
}

}  // namespace hull::analysis
