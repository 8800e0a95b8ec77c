// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/point_weights.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "mesh/refined_view.h"
#include "surface/eigenbasis/subdivision_rules.h"
#include "surface/place_in_cell.h"

namespace hull::surface {
namespace {

// Rounding leaves such weights to points without influence.
constexpr double kNoWeight = 1e-16;

// How far each of 16 or more points of a leaf or corner counts: `evaluate` gives the surface point
// for any places of these; it is linear, and is asked with three of them at unit places at a time.
template <class Evaluate>
std::vector<double> probe(std::size_t count, const Evaluate& evaluate) {
  // Three at a time, as a position has three coordinates: coordinate k of the answer is the weight
  // of the point that is at unit k.
  std::vector<double> weights(count);
  std::vector<Vector3d> places(count, Vector3d::Zero());
  for (std::size_t first = 0; first < count; first += 3) {
    const std::size_t some = std::min<std::size_t>(3, count - first);
    for (std::size_t k = 0; k < some; ++k) places[first + k] = Vector3d::Unit(k);
    const Vector3d point = evaluate(places);
    for (std::size_t k = 0; k < some; ++k) {
      weights[first + k] = point[static_cast<Eigen::Index>(k)];
      places[first + k].setZero();
    }
  }
  return weights;
}

}  // namespace

const WeightRow& PointWeights::refined(int point) {
  const auto known = refined_.find(point);
  if (known != refined_.end()) return known->second;
  const SurfaceLayout& layout = surface_.layout();
  const mesh::Topology& cells = layout.cells();
  const int in_second = point - cells.vertex_count();
  const int in_third = in_second - static_cast<int>(layout.second_half_edges().size());
  WeightRow row;
  if (in_second < 0) {
    const mesh::Topology& control = surface_.mesh().topology();
    row = refined_value<WeightRow>(control, layout.scheme(), cells.outgoing(point),
                                   [&](int h) { return WeightRow(control.origin(h)); });
  } else if (in_third < 0) {
    row = second(layout.second_half_edges()[in_second]);
  } else {
    const mesh::RefinedView<mesh::Topology> level2(cells);
    row = refined_value<WeightRow>(level2, layout.scheme(), layout.third_half_edges()[in_third],
                                   [&](int h) { return second(h); });
  }
  // Looked up anew, as the rules may have added other rows; references to rows stay good, as maps
  // of nodes do not move them.
  return refined_.emplace(point, std::move(row)).first->second;
}

const WeightRow& PointWeights::second(int half_edge) {
  const mesh::Topology& cells = surface_.layout().cells();
  // Numbered as in the whole second subdivision: the layout knows only those that nodes take.
  const int point = mesh::RefinedView<mesh::Topology>(cells).origin(half_edge);
  const auto known = second_.find(point);
  if (known != second_.end()) return known->second;
  WeightRow row = refined_value<WeightRow>(cells, surface_.layout().scheme(), half_edge,
                                           [&](int h) { return refined(cells.origin(h)); });
  return second_.emplace(point, std::move(row)).first->second;
}

WeightRow PointWeights::leaf_row(int leaf, double u, double v) {
  const std::array<int, 16>& points = surface_.layout().leaf_points(leaf);
  const std::vector<double> weights = probe(points.size(), [&](const std::vector<Vector3d>& at) {
    BicubicPoints span;
    std::copy(at.begin(), at.end(), span.begin());
    // Ghost points follow the real ones, whose weights so count for both.
    fill_ghosts(span, points);
    return evaluate_bicubic(span, u, v, 0).point;
  });
  WeightRow row;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i] != kNoPoint) row.add(refined(points[i]), weights[i]);
  }
  return row;
}

WeightRow PointWeights::corner_row(int corner, double u, double v) {
  const std::vector<int>& points = surface_.layout().corner_points(corner);
  const CornerBasis& basis = surface_.layout().basis(corner);
  const std::vector<double> weights = probe(points.size(), [&](const std::vector<Vector3d>& at) {
    CornerPoints square;
    square.outer = at;
    basis.prepare(square);
    SurfaceJet jet;
    basis.evaluate(square, u, v, 0, jet);
    return jet.point;
  });
  WeightRow row;
  for (std::size_t i = 0; i < points.size(); ++i) row.add(refined(points[i]), weights[i]);
  return row;
}

std::vector<PointWeight> PointWeights::at(int cell, double u, double v) {
  assert(cell >= 0 && cell < surface_.cell_count());
  assert(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0);
  const PlaceInCell place = find_place(surface_.layout(), cell, u, v);
  WeightRow row;
  if (place.node.kind == SurfaceNode::Kind::kLeaf) {
    row = leaf_row(place.node.index, place.u, place.v);
  } else {
    const Eigen::Vector2d uv = turned(place.node.turn, place.u, place.v);
    row = corner_row(place.node.index, uv.x(), uv.y());
  }
  std::vector<PointWeight> weights;
  for (const PointWeight& entry : row.entries()) {
    if (std::abs(entry.weight) > kNoWeight) weights.push_back(entry);
  }
  return weights;
}

}  // namespace hull::surface
