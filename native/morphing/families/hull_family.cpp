// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/families/hull_family.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "morphing/families/agreement.h"

namespace hull::morphing {
namespace {

// A coordinate of a member; where all parents have the same it is that, whatever rounding of the
// weights' sum would make of it.
template <class Coordinate, class Weight>
double blended(int count, const Coordinate& coordinate, const Weight& weight) {
  double sum = 0.0;
  bool is_common = true;
  for (int k = 0; k < count; ++k) {
    sum += weight(k) * coordinate(k);
    is_common = is_common && coordinate(k) == coordinate(0);
  }
  return is_common ? coordinate(0) : sum;
}

}  // namespace

HullFamily::HullFamily(std::vector<surface::LimitSurface> parents) : parents_(std::move(parents)) {
  if (parents_.size() < 2) throw std::invalid_argument("A family needs two parents or more.");
  const std::vector<std::string> differing = differences(parents_);
  if (!differing.empty()) throw std::invalid_argument(differing.front());
  // Of the topology, which all parents share.
  const auto weights = std::make_shared<const modelling::PlaceWeights>(parents_[0]);
  for (const surface::LimitSurface& parent : parents_) places_.emplace_back(parent, weights);
}

void HullFamily::check_weights(const std::vector<double>& weights) const {
  if (static_cast<int>(weights.size()) != parent_count()) {
    throw std::invalid_argument("There must be a weight for each of " +
                                std::to_string(parent_count()) + " parents, not " +
                                std::to_string(weights.size()) + ".");
  }
  double sum = 0.0;
  for (double weight : weights) sum += weight;
  // Written so that NaN fails too.
  if (std::abs(sum - 1.0) <= kWeightSum) return;
  throw std::invalid_argument("The weights of parents must sum to 1; they sum to " +
                              std::to_string(sum) + ".");
}

std::vector<Vector3d> HullFamily::points(const std::vector<double>& weights) const {
  check_weights(weights);
  const Eigen::Map<const Eigen::RowVectorXd> row(weights.data(), parent_count());
  return points(Eigen::MatrixXd(row.replicate(point_count(), 1)));
}

std::vector<Vector3d> HullFamily::points(const Eigen::MatrixXd& weights) const {
  if (weights.rows() != point_count() || weights.cols() != parent_count()) {
    throw std::invalid_argument("There must be weights of " + std::to_string(point_count()) +
                                " points for " + std::to_string(parent_count()) + " parents.");
  }
  std::vector<Vector3d> points(point_count());
  for (int i = 0; i < point_count(); ++i) {
    // Where sums are off 1 members would be drawn towards the origin, or from it.
    if (!(std::abs(weights.row(i).sum() - 1.0) <= kWeightSum)) {
      throw std::invalid_argument("The weights of point " + std::to_string(i) + " sum to " +
                                  std::to_string(weights.row(i).sum()) + "; they must sum to 1.");
    }
    for (int axis = 0; axis < 3; ++axis) {
      points[i][axis] = blended(
          parent_count(), [&](int k) { return parents_[k].mesh().points()[i][axis]; },
          [&](int k) { return weights(i, k); });
    }
  }
  return points;
}

std::optional<Vector3d> HullFamily::first_fold(const std::vector<Vector3d>& points) const {
  if (static_cast<int>(points.size()) != point_count()) {
    throw std::invalid_argument("There must be " + std::to_string(point_count()) + " points, not " +
                                std::to_string(points.size()) + ".");
  }
  // Parents may be turned against one another by much where both are right: a member is folded
  // where it is so against all of them.
  std::vector<int> folded = places_[0].folds(points);
  for (std::size_t k = 1; k < places_.size() && !folded.empty(); ++k) {
    const std::vector<int> others = places_[k].folds(points);
    std::vector<int> both;
    std::set_intersection(folded.begin(), folded.end(), others.begin(), others.end(),
                          std::back_inserter(both));
    folded = std::move(both);
  }
  if (folded.empty()) return std::nullopt;
  return places_[0].position(folded.front());
}

}  // namespace hull::morphing
