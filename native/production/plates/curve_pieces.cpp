// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/tolerances.h"
#include "production/plates/surface_curve.h"

namespace hull::production {

namespace {

// Where step a passes step b, as a's parameter.
std::optional<double> crossing(const CurveStep& a, const CurveStep& b) {
  const Vector2d along = a.to - a.from, other = b.to - b.from, apart = b.from - a.from;
  const double turn = cross(along, other);
  if (std::abs(turn) <= 1e-12 * along.norm() * other.norm()) return std::nullopt;
  const double t = cross(apart, other) / turn, s = cross(apart, along) / turn;
  // Ends count, within what is put onto sides and corners.
  const double near_t = kOnCellSide / along.norm(), near_s = kOnCellSide / other.norm();
  if (t < -near_t || t > 1.0 + near_t || s < -near_s || s > 1.0 + near_s) return std::nullopt;
  return std::clamp(t, 0.0, 1.0);
}

// Of a closed curve that begins between two crossings: its last piece goes on in its first one.
void join_around(const surface::LimitSurface& surface, std::vector<SurfaceCurve>& pieces) {
  if (pieces.size() < 2) return;
  const SurfaceCurve& first = pieces.front();
  SurfaceCurve& last = pieces.back();
  const double near = kNoLength * surface.mesh().size();
  if ((last.points.back() - first.points.front()).norm() > near) return;
  last.points.insert(last.points.end(), first.points.begin() + 1, first.points.end());
  last.steps.insert(last.steps.end(), first.steps.begin(), first.steps.end());
  pieces.erase(pieces.begin());
}

}  // namespace

std::vector<SurfaceCurve> pieces_between(const surface::LimitSurface& surface,
                                         const SurfaceCurve& curve,
                                         const std::vector<SurfaceCurve>& others) {
  require_on(surface, curve);
  for (const SurfaceCurve& other : others) require_on(surface, other);
  // By cells: a step is compared with few others.
  std::vector<std::vector<CurveStep>> in_cell(surface.cell_count());
  for (const SurfaceCurve& other : others) {
    for (const CurveStep& step : other.steps) {
      for (const CurveStep& seen : in_all_cells(surface.cells(), step)) {
        in_cell[seen.cell].push_back(seen);
      }
    }
  }
  std::vector<SurfaceCurve> pieces(1);
  bool is_cut_at_start = false;
  const auto begin = [&](const Vector3d& p) {
    if (!pieces.back().empty()) pieces.emplace_back();
    pieces.back().name = curve.name;
    pieces.back().points = {p};
  };
  if (!curve.points.empty()) begin(curve.points.front());
  for (std::size_t k = 0; k < curve.steps.size(); ++k) {
    const CurveStep& step = curve.steps[k];
    std::vector<double> cuts;
    // Along a side curves in the other cell pass the step, too.
    for (const CurveStep& seen : in_all_cells(surface.cells(), step)) {
      for (const CurveStep& other : in_cell[seen.cell]) {
        if (const auto t = crossing(seen, other)) cuts.push_back(*t);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    // The step's end, at which no piece begins.
    cuts.push_back(2.0);
    const double shortest = kOnCellSide / (step.to - step.from).norm();
    double last = 0.0;
    const auto at = [&step](double t) { return Vector2d(step.from + t * (step.to - step.from)); };
    for (const double cut : cuts) {
      const double end = std::min(cut, 1.0);
      const Vector2d uv = end == 1.0 ? step.to : at(end);
      const Vector3d p =
          end == 1.0 ? curve.points[k + 1] : surface.position(step.cell, uv.x(), uv.y());
      // What is shorter than places are told apart by is no step.
      if (end - last > shortest) {
        // The step's own ends exactly, as other cells have them.
        pieces.back().steps.push_back({step.cell, last == 0.0 ? step.from : at(last), uv});
        pieces.back().points.push_back(p);
        last = end;
      }
      if (cut > 1.0) continue;
      is_cut_at_start = is_cut_at_start || (pieces.size() == 1 && pieces.back().empty());
      begin(p);
    }
  }
  if (pieces.back().empty()) {
    // A closed curve's end is its start.
    is_cut_at_start = true;
    pieces.pop_back();
  }
  if (!is_cut_at_start) join_around(surface, pieces);
  return pieces;
}

}  // namespace hull::production
