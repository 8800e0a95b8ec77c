// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/quality/measure_quality.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "conversion/quality/patch_measure.h"
#include "conversion/quality/seam_measure.h"

namespace hull::conversion {
namespace {

constexpr int kMostSamples = 16;
constexpr double kNormalReach = 1e-6;  // of the length
// How much of the time is needed for patches, the rest for seams.
constexpr double kShareOfPatches = 0.8;

void check(const surface::LimitSurface& surface, const PatchSet& set,
           const QualityOptions& options) {
  if (options.samples < 1 || options.samples > kMostSamples) {
    throw std::invalid_argument("The samples of an interval must be from 1 to " +
                                std::to_string(kMostSamples) + ", not " +
                                std::to_string(options.samples) + ".");
  }
  if (options.normal_reach && !(*options.normal_reach >= 0.0)) {
    throw std::invalid_argument("The reach of irregular points must be 0 or more, not " +
                                std::to_string(*options.normal_reach) + " m.");
  }
  if (set.blocks.size() != set.patches.size()) {
    throw std::invalid_argument(
        "It is not known which cells the patches stand for: " + std::to_string(set.patches.size()) +
        " patches, but " + std::to_string(set.blocks.size()) + " blocks of cells.");
  }
  for (std::size_t p = 0; p < set.blocks.size(); ++p) {
    for (int side : set.blocks[p].sides) {
      if (side >= 0 && side < surface.cells().half_edge_count()) continue;
      throw std::invalid_argument("Patch " + std::to_string(p) + " stands for cell " +
                                  std::to_string(side / 4) +
                                  ", which is not of this surface. Give the surface that the "
                                  "patches were made from.");
    }
  }
  if (set.source.points && *set.source.points != surface.mesh().points()) {
    throw std::invalid_argument(
        "The patches are out of date: they were made of other control points than the surface has. "
        "Convert it again, or give the surface as it was.");
  }
}

void take_patch(QualityReport& report, double& squares, double& exact, PatchQuality found) {
  report.distance.take(found.distance);
  report.area += found.area;
  report.knot_count += found.knot_count;
  report.control_point_count += found.control_point_count;
  // The mean over the whole area, not over patches, of which some are tiny.
  squares += found.area * found.rms_distance * found.rms_distance;
  exact += found.exact_area;
  report.patches.push_back(std::move(found));
}

}  // namespace

void SeamQuality::take_values(const SeamQuality& other) {
  gap.take(other.gap);
  angle.take(other.angle);
  angle_at_points.take(other.angle_at_points);
  curvature_jump.take(other.curvature_jump);
  curvature_jump_at_points.take(other.curvature_jump_at_points);
}

QualityReport measure_quality(const surface::LimitSurface& surface, const PatchSet& set,
                              const QualityOptions& options, const surface::Progress& progress) {
  check(surface, set, options);
  QualityReport report;
  report.length = surface.mesh().box().sizes().maxCoeff();
  report.normal_reach = options.normal_reach.value_or(kNormalReach * report.length);
  report.theoretical_patch_count = least_block_count(surface);
  const surface::SurfaceTree tree(surface);
  const RingedSurface ringed(surface);
  const QualityGauge gauge{surface,
                           ringed,
                           tree,
                           set,
                           analysis::gauss_rule(options.samples),
                           report.length,
                           report.normal_reach,
                           irregular_vertices(surface)};
  double points = 0.0, done = 0.0, squares = 0.0, exact = 0.0;
  for (const BSplinePatch& patch : set.patches) {
    points += static_cast<double>(patch.control_points.size());
  }
  for (std::size_t p = 0; p < set.patches.size(); ++p) {
    const double next = done + static_cast<double>(set.patches[p].control_points.size());
    // Time goes with control points, not with patches.
    const surface::Progress part = surface::part_of(progress, kShareOfPatches * done / points,
                                                    kShareOfPatches * next / points);
    take_patch(report, squares, exact, measure_patch(gauge, static_cast<int>(p), part));
    done = next;
  }
  if (report.area > 0.0) {
    report.rms_distance = std::sqrt(squares / report.area);
    report.exact_share = exact / report.area;
  }
  const std::vector<Seam> seams = seams_of(set);
  const surface::Progress rest = surface::part_of(progress, kShareOfPatches, 1.0);
  for (std::size_t i = 0; i < seams.size(); ++i) {
    surface::tell(rest, static_cast<double>(i), static_cast<double>(seams.size()));
    report.seams.push_back(measure_seam(gauge, seams[i]));
    report.worst_seams.take_values(report.seams.back());
  }
  surface::tell(progress, 1.0, 1.0);
  return report;
}

}  // namespace hull::conversion
