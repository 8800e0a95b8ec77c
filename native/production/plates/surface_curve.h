// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "surface/creases/crease_curves.h"
#include "surface/queries/surface_tree.h"

namespace hull::production {

using surface::CellPlace;

// A part of a curve on the surface within one cell: what the surface makes of a straight line in
// (u, v).
struct CurveStep {
  int cell;
  Eigen::Vector2d from, to;
};

// A curve on the surface. It lies on the surface all along; where it was made by a rule its points
// obey that, and the steps between depart from it by the chord tolerance it was made with.
struct SurfaceCurve {
  std::string name;
  std::vector<Vector3d> points;  // m, in order, one more than steps; a closed curve's first is
                                 // repeated at the end
  std::vector<CurveStep> steps;

  bool empty() const { return steps.empty(); }
};

// Parameters nearer to a cell's side than this are on it.
inline constexpr double kOnCellSide = 4e-9;

// A place of the surface as all cells that share it have it; sides and corners exactly.
std::vector<CellPlace> places_of(const mesh::Topology& cells, const CellPlace& place);

// The step, and where it runs along a side the same as the cell beyond has it.
std::vector<CurveStep> in_all_cells(const mesh::Topology& cells, const CurveStep& step);

// The curve through places that follow one another, with the points at which it passes from cell to
// cell: those nearest to the chord. Places at the same point are one.
SurfaceCurve joined(const surface::LimitSurface& surface, const surface::SurfaceTree& tree,
                    const std::vector<CellPlace>& places, std::string name);

// Whether a curve is on the surface as it is: one of another surface is not, nor one of this
// surface before its points were set. require_on() throws std::invalid_argument then.
bool is_on(const surface::LimitSurface& surface, const SurfaceCurve& curve);
void require_on(const surface::LimitSurface& surface, const SurfaceCurve& curve);

// The pieces of a curve between its crossings with others, in order; a closed curve has none that
// ends in its start, unless that is a crossing. Ends lie on these to rounding.
// Throws std::invalid_argument as require_on(), of all of them.
std::vector<SurfaceCurve> pieces_between(const surface::LimitSurface& surface,
                                         const SurfaceCurve& curve,
                                         const std::vector<SurfaceCurve>& others);

}  // namespace hull::production
