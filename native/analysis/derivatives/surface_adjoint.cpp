// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/derivatives/surface_adjoint.h"

#include <array>

#include "analysis/sections/border_edges.h"
#include "surface/pieces/point_weights.h"
#include "surface/place_in_cell.h"

namespace hull::analysis {
namespace {

using Entries = std::vector<Eigen::Triplet<double>>;

template <class Weights>
void add_entries(int row, const Weights& weights, double factor, Entries& entries) {
  for (const surface::PointWeight& w : weights) {
    entries.emplace_back(row, w.point, factor * w.weight);
  }
}

// Bézier points of a cubic from its places at 0, 1/3, 2/3 and 1, as border_edges() has them.
constexpr double kBezierFromPlaces[4][4] = {{1.0, 0.0, 0.0, 0.0},
                                            {-5.0 / 6.0, 3.0, -1.5, 1.0 / 3.0},
                                            {1.0 / 3.0, -1.5, 3.0, -5.0 / 6.0},
                                            {0.0, 0.0, 0.0, 1.0}};

// What fill_ghosts() does to points, run through backwards: derivatives by ghosts become those by
// the points that they are reflections of.
void take_back_ghosts(PointColumns& by_points, const std::array<int, 16>& present) {
  const auto missing = [&present](int index) { return present[index] == surface::kNoPoint; };
  const auto take_back = [&by_points](int from, int step) {
    // A ghost is 2 p - q.
    by_points.row(from + step) += 2.0 * by_points.row(from);
    by_points.row(from + 2 * step) -= by_points.row(from);
    by_points.row(from).setZero();
  };
  const bool west = missing(4), east = missing(7), south = missing(1), north = missing(13);
  // fill_ghosts() fills rows first: columns come back first, since they were made of the rows'
  // ghosts.
  for (int column = 3; column >= 0; --column) {
    if (north) take_back(12 + column, -4);
    if (south) take_back(column, 4);
  }
  for (int row = (north ? 3 : 4) - 1; row >= (south ? 1 : 0); --row) {
    if (east) take_back(4 * row + 3, -1);
    if (west) take_back(4 * row, 1);
  }
}

}  // namespace

SurfaceAdjoint::SurfaceAdjoint(const surface::LimitSurface& surface)
    : surface_(&surface), refined_(surface::refined_weights(surface)) {
  const auto points = static_cast<Eigen::Index>(surface.mesh().points().size());
  surface::PointWeights weights(surface);
  Entries entries;
  const std::vector<BorderEdge> edges = border_edges(surface);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (int place = 0; place < 4; ++place) {
      const int side = edges[i].half_edge % 4;
      const Eigen::Vector2d uv = surface::on_square_side(side, place == 3 ? 1.0 : place / 3.0);
      // Places are sums of control points with known weights, and Bézier points sums of four
      // places.
      const auto row = weights.at(edges[i].half_edge / 4, uv.x(), uv.y());
      for (int k = 0; k < 4; ++k) {
        const double factor = kBezierFromPlaces[k][place];
        if (factor != 0.0) add_entries(4 * static_cast<int>(i) + k, row, factor, entries);
      }
    }
  }
  border_.resize(4 * static_cast<Eigen::Index>(edges.size()), points);
  border_.setFromTriplets(entries.begin(), entries.end());
}

Gradient SurfaceAdjoint::at(int cell, const Eigen::Vector2d& uv, const Vector3d& direction) const {
  Gradient gradient = Gradient::Zero(point_count(), 3);
  surface::PointWeights weights(*surface_);
  for (const surface::PointWeight& w : weights.at(cell, uv.x(), uv.y())) {
    gradient.row(w.point) = w.weight * direction.transpose();
  }
  return gradient;
}

SurfaceAdjoint::Sum::Sum(const SurfaceAdjoint& adjoint, int numbers)
    : adjoint_(adjoint),
      refined_(Rows::Zero(adjoint.refined_.rows(), 3 * numbers)),
      border_(Rows::Zero(adjoint.border_.rows(), 3 * numbers)) {}

void SurfaceAdjoint::Sum::add_leaf(int leaf, PointColumns by_points) {
  const std::array<int, 16>& points = adjoint_.surface_->layout().leaf_points(leaf);
  take_back_ghosts(by_points, points);
  for (int i = 0; i < 16; ++i) {
    if (points[i] == surface::kNoPoint) continue;
    refined_.row(points[i]).head(by_points.cols()) += by_points.row(i);
  }
}

void SurfaceAdjoint::Sum::add_corner(int corner, const PointColumns& by_points) {
  const std::vector<int>& points = adjoint_.surface_->layout().corner_points(corner);
  for (std::size_t i = 0; i < points.size(); ++i) {
    refined_.row(points[i]).head(by_points.cols()) += by_points.row(static_cast<Eigen::Index>(i));
  }
}

void SurfaceAdjoint::Sum::add_border(int edge, const PointColumns& by_points) {
  border_.middleRows(4 * static_cast<Eigen::Index>(edge), 4) += by_points;
}

PointColumns SurfaceAdjoint::Sum::by_control_points() const {
  return adjoint_.refined_.transpose() * refined_ + adjoint_.border_.transpose() * border_;
}

}  // namespace hull::analysis
