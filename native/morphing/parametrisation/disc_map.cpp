// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/parametrisation/disc_map.h"

#include <Eigen/SparseLU>
#include <stdexcept>
#include <string>
#include <utility>

namespace hull::morphing {

DiscMap::DiscMap(const TriangleDisc& disc, std::vector<int> corners, ConvexPolygon polygon,
                 WeightKind kind)
    : corners_(std::move(corners)),
      polygon_(std::move(polygon)),
      split_(split_chords(disc, corners_)),
      border_(border_points(split_.disc, corners_)),
      places_(split_.disc.points().size()) {
  if (polygon_.side_count() != static_cast<int>(corners_.size())) {
    throw std::invalid_argument("The border has " + std::to_string(corners_.size()) +
                                " corners, the polygon " + std::to_string(polygon_.side_count()) +
                                ": give it as many.");
  }
  // Lengths along a side are shares of it: the border keeps its proportions.
  for (const BorderPoint& at : border_) places_[at.point] = polygon_.on_side(at.side, at.along);
  place_inner_points(kind);
  check_triangles();
}

void DiscMap::place_inner_points(WeightKind kind) {
  const int count = static_cast<int>(places_.size());
  std::vector<int> unknown(count, -1), inner;
  for (int point = 0; point < count; ++point) {
    if (disc().is_border_point(point)) continue;
    unknown[point] = static_cast<int>(inner.size());
    inner.push_back(point);
  }
  if (inner.empty()) return;
  const int size = static_cast<int>(inner.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(size, 2);
  for (int row = 0; row < size; ++row) {
    entries.emplace_back(row, row, 1.0);
    // A point less the mean of its neighbours is zero; neighbours on the border are known.
    for (const NeighbourWeight& of : neighbour_weights(disc(), inner[row], kind)) {
      if (unknown[of.point] >= 0) {
        entries.emplace_back(row, unknown[of.point], -of.weight);
      } else {
        right.row(row) += of.weight * places_[of.point].transpose();
      }
    }
  }
  // What i is to j is not what j is to i: the matrix is not symmetric.
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) {
    throw std::invalid_argument(
        "Inner points hang together with the border by triangles without area alone: mend these.");
  }
  // Both coordinates with one factorisation.
  const Eigen::MatrixX2d solution = factors.solve(right);
  for (int row = 0; row < size; ++row) places_[inner[row]] = solution.row(row).transpose();
}

void DiscMap::check_triangles() const {
  for (int t = 0; t < disc().triangle_count(); ++t) {
    const Triangle corners = disc().triangle(t);
    // In exact arithmetic none turns over (Tutte 1963; Floater 1997): one that does is too thin for
    // doubles.
    const auto& [a, b, c] = corners;
    if (orientation(places_[a], places_[b], places_[c]) > 0.0) continue;
    throw std::invalid_argument(
        "The triangle of points " + std::to_string(a) + ", " + std::to_string(b) + " and " +
        std::to_string(c) +
        " has no area left in the plane: it has none in space, or lies too far from the border. "
        "Mend it, or cut the surface into more parts.");
  }
}

}  // namespace hull::morphing
