// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/plane_fit.h"

#include <cmath>

#include "mesh/dense_solvers.h"

namespace hull::analysis {

PlaneFit fit_plane(const std::vector<Vector3d>& points, const std::vector<double>& weights) {
  Vector3d centre = Vector3d::Zero();
  double total = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    centre += weights[i] * points[i];
    total += weights[i];
  }
  centre /= total;
  // At least three rows, so that there are three directions.
  Eigen::MatrixXd offsets =
      Eigen::MatrixXd::Zero(std::max<Eigen::Index>(3, static_cast<Eigen::Index>(points.size())), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Squares have the weight itself.
    offsets.row(static_cast<Eigen::Index>(i)) =
        std::sqrt(weights[i]) * (points[i] - centre).transpose();
  }
  const Eigen::MatrixXd v = mesh::singular_values(offsets).v;
  // Singular values fall: the points spread least along the last direction.
  Vector3d normal = v.col(2);
  Eigen::Index largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  if (normal[largest] < 0.0) normal = -normal;
  return {{normal, normal.dot(centre)}, v.col(0), v.col(1)};
}

PlaneFit fit_plane(const std::vector<Vector3d>& points) {
  return fit_plane(points, std::vector<double>(points.size(), 1.0));
}

}  // namespace hull::analysis
