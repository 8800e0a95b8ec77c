// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/feature_curves.h"

#include <stdexcept>
#include <string>

namespace hull::analysis {

std::vector<FeatureCurve> feature_curves(const surface::LimitSurface& surface,
                                         int samples_per_edge) {
  if (samples_per_edge < 1 || samples_per_edge > 1024) {
    throw std::invalid_argument("Feature curves take 1 to 1024 samples per edge, not " +
                                std::to_string(samples_per_edge) + ".");
  }
  const int samples = samples_per_edge + samples_per_edge % 2;
  std::vector<FeatureCurve> curves;
  for (const surface::CreaseCurve& crease : surface::crease_curves(surface)) {
    FeatureCurve& curve =
        curves.emplace_back(FeatureCurve{crease.kind(), crease.vertices(), {}, crease.closed()});
    const int count = crease.edge_count() * samples;
    for (int i = 0; i < count; ++i) {
      curve.points.push_back(crease.evaluate(static_cast<double>(i) / samples, 0).point);
    }
    curve.points.push_back(crease.closed() ? curve.points.front()
                                           : crease.evaluate(crease.edge_count(), 0).point);
  }
  return curves;
}

}  // namespace hull::analysis
