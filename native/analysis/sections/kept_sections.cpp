// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/kept_sections.h"

#include "analysis/sections/kept_cells.h"
#include "analysis/sections/section_curves.h"
#include "surface/parallel_for.h"

namespace hull::analysis {
namespace {

// Appends points, arcs and spots of other parts.
void append(const SectionParts& from, const std::array<int, 3>& begin,
            const std::array<int, 3>& end, SectionParts& to) {
  const int shift = static_cast<int>(to.points.size()) - begin[0];
  to.points.insert(to.points.end(), from.points.begin() + begin[0], from.points.begin() + end[0]);
  for (int i = begin[1]; i < end[1]; ++i) {
    SectionArc arc = from.arcs[i];
    arc.first += shift;
    arc.last += shift;
    to.arcs.push_back(arc);
  }
  to.spots.insert(to.spots.end(), from.spots.begin() + begin[2], from.spots.begin() + end[2]);
}

std::array<int, 3> counts(const SectionParts& parts) {
  return {static_cast<int>(parts.points.size()), static_cast<int>(parts.arcs.size()),
          static_cast<int>(parts.spots.size())};
}

}  // namespace

std::vector<std::vector<SectionCurve>> KeptSections::sections(const std::vector<Plane>& planes,
                                                              const SectionOptions& options) {
  check_planes(planes);
  const SectionRules rules = section_rules(*surface_, options);
  if (rules_ != rules) kept_.clear();
  rules_ = rules;
  boxes_.update(*surface_);
  const std::vector<KeptParts*> kept = kept_.of(keys_of(planes));
  std::vector<std::vector<SectionCurve>> result(planes.size());
  surface::parallel_for(
      planes.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        CellCutter cutter(*surface_, rules);
        for (std::size_t i = begin; i < end; ++i) result[i] = cut(planes[i], cutter, *kept[i]);
      },
      kSectionGrain);
  return result;
}

std::vector<SectionCurve> KeptSections::cut(const Plane& plane, CellCutter& cutter,
                                            KeptParts& kept) const {
  KeptParts now{surface_->revision(), {}, {}};
  PlaneSides sides(*surface_, plane);
  std::array<int, 3> begin{}, last{};
  const auto take = [&](int cell, const CellEnds* known, bool has_moved) {
    if (has_moved) {
      if (cutter.may_have_part(boxes_, cell, plane)) {
        cutter.add_parts(cell, plane, sides, now.parts);
      }
    } else {
      append(kept.parts, begin, known->ends, now.parts);
    }
    if (known) begin = known->ends;
    const std::array<int, 3> so_far = counts(now.parts);
    if (so_far != last) now.cells.push_back({cell, so_far});
    last = so_far;
  };
  for_each_moved_or_kept(
      surface_->cells_moved_since(kept.revision), kept.cells,
      [](const CellEnds& known) { return known.cell; }, take);
  const bool keeps = sides.empty();
  if (!keeps) sides.add_arcs(rules_->chord, now.parts);
  std::vector<SectionCurve> curves = section_curves(*surface_, now.parts);
  // What lies along sides is seen of all cells together.
  kept = keeps ? std::move(now) : KeptParts{};
  return curves;
}

}  // namespace hull::analysis
