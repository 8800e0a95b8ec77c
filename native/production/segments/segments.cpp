// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/segments/segments.h"

#include <cmath>
#include <stdexcept>

#include "production/models/model_cut.h"
#include "production/segments/dowel_holes.h"
#include "production/segments/segment_search.h"

namespace hull::production {
namespace {

void check_dowels(const Dowels& dowels) {
  if (dowels.radius == 0.0) return;
  if (dowels.radius > 0.0 && dowels.depth > 0.0 && std::isfinite(dowels.radius + dowels.depth)) {
    return;
  }
  throw std::invalid_argument("Holes for dowels have a positive radius and depth, or no radius.");
}

void cut_up(const ClosedModel& model, const SegmentBox& box, const SegmentGrid& grid,
            const SegmentSearch& search, std::vector<ModelSegment>& segments) {
  if (model.triangles.empty() || search.is_empty(box)) return;
  const SegmentSearch::Cut found = search.best_cut(box);
  if (found.axis < 0) {
    ModelSegment segment{model, grid.judged(box), {}};
    for (int a = 0; a < 3; ++a) {
      segment.box[0][a] = grid.planes()[a][box.low[a]];
      segment.box[1][a] = grid.planes()[a][box.high[a]];
    }
    segments.push_back(std::move(segment));
    return;
  }
  const CutModel parts = cut(model, found.axis, grid.planes()[found.axis][found.plane]);
  SegmentBox below = box, above = box;
  // The search has both parts, as it was through all boxes before anything was cut.
  below.high[found.axis] = above.low[found.axis] = found.plane;
  cut_up(parts.below, below, grid, search, segments);
  cut_up(parts.above, above, grid, search, segments);
}

}  // namespace

ModelSegments segmented(const ClosedModel& model, const SegmentRules& rules, const Dowels& dowels,
                        const surface::Progress& progress) {
  check_dowels(dowels);
  const SegmentGrid grid(model, rules, surface::part_of(progress, 0.0, 0.5));
  const SegmentSearch search(grid, surface::part_of(progress, 0.5, 0.9));
  ModelSegments result;
  cut_up(model, search.whole(), grid, search, result.segments);
  if (dowels.radius > 0.0) add_dowel_holes(result, dowels);
  return result;
}

}  // namespace hull::production
