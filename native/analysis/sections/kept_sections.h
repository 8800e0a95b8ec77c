// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/sections/cell_boxes.h"
#include "analysis/sections/cell_cutter.h"
#include "analysis/sections/kept_entries.h"
#include "analysis/sections/plane_keys.h"
#include "analysis/sections/section_point.h"
#include "analysis/sections/sections.h"

namespace hull::analysis {

// Sections of a surface whose points are moved. Of each plane that was asked for the parts are
// kept, cell by cell, and only cells that have moved since are cut again; sections that run along
// sides of cells are cut anew as a whole.
class KeptSections {
 public:
  // `surface` must outlive the sections.
  explicit KeptSections(const surface::LimitSurface& surface)
      : surface_(&surface), boxes_(surface) {}

  // The same as analysis::sections() of the surface as it is, to the last bit.
  std::vector<std::vector<SectionCurve>> sections(const std::vector<Plane>& planes,
                                                  const SectionOptions& options);

  // Of how many planes parts are kept.
  std::size_t plane_count() const { return kept_.size(); }

 private:
  // The points, arcs and spots of one cell end before these numbers.
  struct CellEnds {
    int cell;
    std::array<int, 3> ends;
  };
  struct KeptParts {
    int revision = -1;  // of the surface that they were cut of: cells that moved later are not
    std::vector<CellEnds> cells;
    SectionParts parts;
  };
  std::vector<SectionCurve> cut(const Plane& plane, CellCutter& cutter, KeptParts& kept) const;

  const surface::LimitSurface* surface_;
  CellBoxes boxes_;
  std::optional<SectionRules> rules_;
  // More planes than a ship's lines have: forgotten are those of lines that were moved.
  KeptEntries<PlaneKey, KeptParts> kept_{1000};
};

}  // namespace hull::analysis
