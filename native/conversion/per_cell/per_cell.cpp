// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/per_cell/per_cell.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "conversion/blocks/block_places.h"
#include "conversion/centre_line.h"
#include "conversion/patches/control_faces.h"
#include "conversion/per_cell/uniform_fit.h"

namespace hull::conversion {
namespace {

// Enough data for the fit to be a good average (the section leaves the number open).
int data_intervals(int control_points) { return 2 * control_points + 2; }

// The control points of one edge in the direction of its half-edge h.
std::vector<Vector3d> edge_curve(const surface::LimitSurface& surface, const UniformFit& fit, int h,
                                 const std::vector<Vector3d>& vertices) {
  const mesh::Topology& cells = surface.cells();
  // Not computed along h: its ends are shared with other edges bit for bit.
  std::vector<Vector3d> data{vertices[cells.origin(h)]};
  for (int i = 1; i < fit.intervals(); ++i) {
    data.push_back(point_on_half_edge(surface, h, static_cast<double>(i) / fit.intervals()));
  }
  data.push_back(vertices[cells.origin(cells.next(h))]);
  return fit.curve(data);
}

std::vector<Vector3d> inner_data(const surface::LimitSurface& surface, int cell, int intervals) {
  const int rows = intervals + 1;
  std::vector<Vector3d> data(rows * rows, Vector3d::Zero());
  for (int i = 1; i < intervals; ++i) {
    for (int j = 1; j < intervals; ++j) {
      data[i * rows + j] = surface.position(cell, static_cast<double>(i) / intervals,
                                            static_cast<double>(j) / intervals);
    }
  }
  return data;
}

}  // namespace

PatchSet fit_per_cell(const surface::LimitSurface& given, int control_points) {
  if (control_points < kMinControlPoints || control_points > kMaxControlPoints) {
    throw std::invalid_argument("control_points must be from " + std::to_string(kMinControlPoints) +
                                " to " + std::to_string(kMaxControlPoints) + ", not " +
                                std::to_string(control_points));
  }
  const std::optional<surface::LimitSurface> centred = with_centre_line(given);
  const surface::LimitSurface& surface = centred ? *centred : given;
  const int n = control_points;
  const UniformFit fit(n, data_intervals(n));
  const mesh::Topology& cells = surface.cells();
  const std::vector<Vector3d> vertices = vertex_points(surface);

  // Each edge's curve and the half-edge it was computed along.
  std::vector<std::pair<int, std::vector<Vector3d>>> curves(cells.edge_count(), {-1, {}});

  PatchSet set;
  set.vertex_count = cells.vertex_count();
  set.edge_count = cells.edge_count();
  set.source = source_of(given);
  set.cell_faces = faces_of_cells(surface);
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    BSplinePatch patch{3, 3, open_uniform_knots(3, n), open_uniform_knots(3, n), n, n, {}, cell};
    patch.control_points.assign(n * n, Vector3d::Zero());
    std::array<int, 4> corners{};
    std::array<PatchSide, 4> sides;
    for (int k = 0; k < 4; ++k) {
      const int h = 4 * cell + k;
      corners[k] = cells.origin(h);
      const int edge = cells.edge(h);
      sides[k] = whole_side(edge, corners[k], cells.origin(cells.next(h)));
      auto& [along, points] = curves[edge];
      if (along < 0) {
        along = h;
        points = edge_curve(surface, fit, h, vertices);
      }
      for (int i = 0; i < n; ++i) {
        // The neighbour's curve read backwards.
        patch.control_points[patch.side_index(k, i)] = points[along == h ? i : n - 1 - i];
      }
    }
    fit.interior(inner_data(surface, cell, fit.intervals()), patch.control_points);
    set.patches.push_back(std::move(patch));
    set.corners.push_back(corners);
    set.sides.push_back(std::move(sides));
    set.blocks.push_back({1, 1, {4 * cell}});
  }
  return set;
}

}  // namespace hull::conversion
