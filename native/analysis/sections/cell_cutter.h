// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/cell_boxes.h"
#include "analysis/sections/height_net.h"
#include "analysis/sections/net_cut.h"
#include "analysis/sections/plane_sides.h"
#include "analysis/sections/section_point.h"
#include "analysis/sections/sections.h"
#include "surface/pieces/pieces.h"

namespace hull::analysis {

// A section takes some 100 microseconds: so many are worth a thread.
inline constexpr std::size_t kSectionGrain = 2;

// How finely a surface is cut, in m: all that a section's parts depend on but the surface's cells
// and the plane.
struct SectionRules {
  double chord;  // tolerance
  HeightTolerances heights;
  double smallest;  // squares at irregular knots that are smaller are not looked into

  bool operator==(const SectionRules&) const = default;
};

// For a surface of its size. Throws std::invalid_argument as section() does.
SectionRules section_rules(const surface::LimitSurface& surface, const SectionOptions& options);

// Throws std::invalid_argument unless the normals are of unit length and the offsets finite.
void check_planes(const std::vector<Plane>& planes);

// Cuts cells of one surface by planes.
class CellCutter {
 public:
  // `surface` must outlive the cutter.
  CellCutter(const surface::LimitSurface& surface, const SectionRules& rules)
      : surface_(surface), rules_(rules) {}

  // Whether a cell's box leaves room for a part of the section.
  bool may_have_part(const CellBoxes& boxes, int cell, const Plane& plane) const {
    return boxes.least(cell, plane.normal) <= plane.offset + rules_.heights.flat &&
           boxes.most(cell, plane.normal) >= plane.offset - rules_.heights.flat;
  }
  // Adds a cell's parts of the section, and what of its sides lies in the plane.
  void add_parts(int cell, const Plane& plane, PlaneSides& sides, SectionParts& parts);

 private:
  // A side's line within a cell: u or v = at.
  struct Line {
    bool along_v;
    double at;
    bool operator==(const Line&) const = default;
  };
  static Line line_of(const surface::DomainSquare& square, int side);
  bool wants(const surface::CornerSquare& square, const Plane& plane, PlaneSides& sides,
             SectionParts& parts) const;
  void add_piece(const surface::SurfacePiece& piece, const Plane& plane, PlaneSides& sides,
                 SectionParts& parts);
  SideFlags sides_that_may_lie(const surface::SurfacePiece& piece) const;
  void add_spot(const surface::CornerSquare& square, const Plane& plane, double radius,
                SectionParts& parts) const;

  const surface::LimitSurface& surface_;
  SectionRules rules_;
  NetCut net_cut_;           // room to work in
  std::vector<Line> lines_;  // in the plane, of the cell's smaller pieces so far
};

}  // namespace hull::analysis
