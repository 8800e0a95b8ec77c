// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/surface_places.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace hull::modelling {
namespace {

// Of the sine of the angle between the sides of a piece: below, it has no area to speak of.
constexpr double kNoArea = 1e-9;
// Of the areas of neighbouring rings: more is no geometric series.
constexpr double kSlowestDecay = 0.8;

}  // namespace

VectorRows rows_of(const std::vector<Vector3d>& vectors) {
  VectorRows rows(static_cast<Eigen::Index>(vectors.size()), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) rows.row(i) = vectors[i].transpose();
  return rows;
}

SurfacePlaces::SurfacePlaces(const surface::LimitSurface& surface, int per_side)
    : weights_(std::make_shared<PlaceWeights>(surface, per_side)) {
  measure(surface.mesh().points());
}

SurfacePlaces::SurfacePlaces(const surface::LimitSurface& surface,
                             std::shared_ptr<const PlaceWeights> weights)
    : weights_(std::move(weights)) {
  if (!weights_->fit(surface)) {
    throw std::invalid_argument(
        "The places are those of another surface: of other faces, creases, corners or scheme.");
  }
  measure(surface.mesh().points());
}

void SurfacePlaces::measure(const std::vector<Vector3d>& points) {
  const auto [at, s, t] = weights_->jets(rows_of(points));
  const auto size = static_cast<std::size_t>(count());
  positions_.reserve(size);
  normals_.reserve(size);
  areas_.reserve(size);
  for (int k = 0; k < count(); ++k) {
    const Vector3d along = s.row(k).transpose(), other = t.row(k).transpose();
    const Vector3d across = along.cross(other);
    const bool has_normal = across.norm() > kNoArea * along.norm() * other.norm();
    positions_.emplace_back(at.row(k).transpose());
    normals_.push_back(has_normal ? Vector3d(across.normalized()) : Vector3d::Zero());
    // Of knots 0, for the moment.
    areas_.push_back(weights_->share(k) * across.norm());
  }
  for (const PlaceWeights::Knot& knot : weights_->knots()) {
    const auto end = areas_.begin() + knot.place, begin = end - knot.per_ring;
    const double area = std::accumulate(begin, end, 0.0);
    const double before = std::accumulate(begin - knot.per_ring, begin, 0.0);
    const double decay = before > 0.0 ? std::min(area / before, kSlowestDecay) : 0.0;
    // The tail of the series: area * (decay + decay^2 + ...).
    *end = area * decay / (1.0 - decay);
  }
  total_area_ = std::accumulate(areas_.begin(), areas_.end(), 0.0);
}

int SurfacePlaces::first_fold(const std::vector<Vector3d>& control_points) const {
  const std::vector<int> found = folds(control_points);
  return found.empty() ? -1 : found.front();
}

std::vector<int> SurfacePlaces::folds(const std::vector<Vector3d>& control_points) const {
  const auto [s, t] = weights_->along(rows_of(control_points));
  std::vector<int> found;
  for (int k = 0; k < count(); ++k) {
    // Knots, and places without area: there is no normal that could be turned over.
    if (normals_[k].isZero(0.0)) continue;
    const Vector3d across = s.row(k).transpose().cross(Vector3d(t.row(k).transpose()));
    if (!(across.dot(normals_[k]) > 0.0)) found.push_back(k);
  }
  return found;
}

std::vector<int> SurfacePlaces::points_beyond(const std::vector<Vector3d>& shifts) const {
  if (static_cast<int>(shifts.size()) != count()) {
    throw std::invalid_argument("There must be " + std::to_string(count()) +
                                " wanted shifts, not " + std::to_string(shifts.size()) + ".");
  }
  std::vector<char> is_reached(point_count(), 0);
  for (int square = 0; square < weights_->forms().squares().count(); ++square) {
    const PlaceWeights::SquareRows own = weights_->rows(square);
    for (Eigen::Index k = 0; k < own.rows.rows(); ++k) {
      if (shifts[own.first + k].isZero(0.0)) continue;
      for (std::size_t i = 0; i < own.points.size(); ++i) {
        if (own.rows(k, static_cast<Eigen::Index>(i)) != 0.0) is_reached[own.points[i]] = 1;
      }
    }
  }
  std::vector<int> beyond;
  for (int i = 0; i < point_count(); ++i) {
    if (!is_reached[i]) beyond.push_back(i);
  }
  return beyond;
}

int first_folded(const std::vector<Eigen::Matrix3d>& gradients) {
  for (std::size_t k = 0; k < gradients.size(); ++k) {
    const double now = (Eigen::Matrix3d::Identity() + gradients[k]).determinant();
    if (!(now > 0.0)) return static_cast<int>(k);
  }
  return -1;
}

}  // namespace hull::modelling
