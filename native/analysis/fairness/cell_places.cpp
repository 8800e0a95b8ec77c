// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/cell_places.h"

namespace hull::analysis {
namespace {

constexpr double kCornerU[] = {0.0, 1.0, 1.0, 0.0};
constexpr double kCornerV[] = {0.0, 0.0, 1.0, 1.0};

// Of a cell: how near to a side a place is taken for being on it.
constexpr double kOnSide = 1e-9;

double snapped(double t) {
  if (t <= kOnSide) return 0.0;
  return t >= 1.0 - kOnSide ? 1.0 : t;
}

// A side's place `t` of the way along its half-edge.
surface::CellPlace on_side(int h, double t) {
  switch (h % 4) {
    case 0:
      return {h / 4, t, 0.0};
    case 1:
      return {h / 4, 1.0, t};
    case 2:
      return {h / 4, 1.0 - t, 1.0};
    default:
      return {h / 4, 0.0, 1.0 - t};
  }
}

void add_fan(const mesh::Topology& cells, int h, CellPlaces& places) {
  const auto add = [&](int at) { places.push_back({at / 4, kCornerU[at % 4], kCornerV[at % 4]}); };
  int at = h;
  do {
    at = cells.twin(cells.prev(at));
    if (at < 0 || at == h) break;
    add(at);
  } while (true);
  if (at == h) return;
  // A border ends the fan: the rest of it lies the other way round.
  for (at = cells.twin(h); at >= 0; at = cells.twin(at)) {
    at = cells.next(at);
    add(at);
  }
}

}  // namespace

CellPlaces cell_places(const mesh::Topology& cells, int cell, const Eigen::Vector2d& uv) {
  CellPlaces places{{cell, uv.x(), uv.y()}};
  const double u = snapped(uv.x()), v = snapped(uv.y());
  const int h = 4 * cell;
  for (int k = 0; k < 4; ++k) {
    if (u != kCornerU[k] || v != kCornerV[k]) continue;
    add_fan(cells, h + k, places);
    return places;
  }
  const auto add_twin = [&](int side, double t) {
    const int twin = cells.twin(h + side);
    // It runs the other way.
    if (twin >= 0) places.push_back(on_side(twin, 1.0 - t));
  };
  if (v == 0.0) add_twin(0, u);
  if (u == 1.0) add_twin(1, v);
  if (v == 1.0) add_twin(2, 1.0 - u);
  if (u == 0.0) add_twin(3, 1.0 - v);
  return places;
}

bool is_inside_cell(const Eigen::Vector2d& uv) {
  return uv.minCoeff() > kOnSide && uv.maxCoeff() < 1.0 - kOnSide;
}

}  // namespace hull::analysis
