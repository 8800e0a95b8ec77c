// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/sections.h"

#include <cmath>

#include "analysis/sections/cell_boxes.h"
#include "analysis/sections/cell_cutter.h"
#include "analysis/sections/plane_sides.h"
#include "analysis/sections/section_curves.h"
#include "surface/parallel_for.h"

namespace hull::analysis {

Plane plane_across(Axis axis, double position) {
  return {Vector3d::Unit(static_cast<int>(axis)), position};
}

Plane diagonal_plane(double height, double angle) {
  return {Vector3d(0.0, std::sin(angle), std::cos(angle)), height * std::cos(angle)};
}

std::vector<std::vector<SectionCurve>> sections(const surface::LimitSurface& surface,
                                                const std::vector<Plane>& planes,
                                                const SectionOptions& options) {
  check_planes(planes);
  const SectionRules rules = section_rules(surface, options);
  const CellBoxes boxes(surface);
  std::vector<std::vector<SectionCurve>> result(planes.size());
  surface::parallel_for(
      planes.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        // One for a range of planes, whose lists keep their memory from one to the next.
        CellCutter cutter(surface, rules);
        SectionParts parts;
        for (std::size_t i = begin; i < end; ++i) {
          parts.clear();
          PlaneSides sides(surface, planes[i]);
          for (int cell = 0; cell < surface.cell_count(); ++cell) {
            if (!cutter.may_have_part(boxes, cell, planes[i])) continue;
            cutter.add_parts(cell, planes[i], sides, parts);
          }
          if (!sides.empty()) sides.add_arcs(rules.chord, parts);
          result[i] = section_curves(surface, parts);
        }
      },
      kSectionGrain);
  return result;
}

std::vector<SectionCurve> section(const surface::LimitSurface& surface, const Plane& plane,
                                  const SectionOptions& options) {
  return std::move(sections(surface, {plane}, options).front());
}

std::vector<SectionCurve> section(const surface::LimitSurface& surface, const Plane& plane,
                                  double chord_tolerance) {
  return section(surface, plane, SectionOptions{chord_tolerance, {}});
}

std::vector<SectionCurve> section(const surface::LimitSurface& surface, Axis axis, double position,
                                  double chord_tolerance) {
  return section(surface, plane_across(axis, position), chord_tolerance);
}

}  // namespace hull::analysis
