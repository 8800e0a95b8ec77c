// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patch_gauge.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hull {
namespace {

constexpr double kNegligible = 1e-9;  // of the surface's size
constexpr int kMaxSteps = 12;
constexpr double kWorthwhile = 0.99;  // a step that gains less than 1 % is the last one

}  // namespace

PatchGauge::PatchGauge(const LimitSurface& surface, const std::vector<double>& knots, int intervals)
    : surface_(surface), negligible_(kNegligible * surface.mesh().size()) {
  basis_.setZero(intervals + 1, static_cast<int>(knots.size()) - 4);
  for (int i = 0; i <= intervals; ++i) {
    nodes_.push_back(0.5 - 0.5 * std::cos(std::numbers::pi * i / intervals));
    const BasisValues values = basis_values(knots, 3, nodes_[i]);
    basis_.block(i, values.first, 1, 4) = values.rows.row(0);
  }
}

void PatchGauge::measure(const BSplinePatch& patch, FitReport& report) {
  const int rows = static_cast<int>(nodes_.size());
  std::array<Eigen::MatrixXd, 3> points;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::MatrixXd grid(patch.count_u, patch.count_v);
    for (int i = 0; i < patch.count_u; ++i) {
      for (int j = 0; j < patch.count_v; ++j) grid(i, j) = patch.control_point(i, j)(axis);
    }
    points[axis] = basis_ * grid * basis_.transpose();
  }
  double largest = 0.0;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Vector3d point(points[0](i, j), points[1](i, j), points[2](i, j));
      const double gap = distance(point, patch.cell, nodes_[i], nodes_[j]);
      sum_of_squares_ += gap * gap;
      largest = std::max(largest, gap);
      if (report.cell < 0 || gap > report.largest_distance) {
        report.largest_distance = gap;
        report.cell = patch.cell;
        report.uv = {nodes_[i], nodes_[j]};
      }
    }
  }
  report.cell_largest.push_back(largest);
  report.samples_per_cell = rows * rows;
  const double samples = static_cast<double>(report.cell_largest.size()) * rows * rows;
  report.rms_distance = std::sqrt(sum_of_squares_ / samples);
}

// Gauss-Newton from the same (u, v), kept within the cell. Every point of the surface gives an
// upper bound, so it does not matter how far the search comes.
double PatchGauge::distance(const Vector3d& point, int cell, double u, double v) const {
  double gap = (point - surface_.position(cell, u, v)).norm();
  for (int step = 0; step < kMaxSteps && gap > negligible_; ++step) {
    const SurfaceJet jet = surface_.evaluate(cell, u, v, 1);
    Eigen::Matrix<double, 3, 2> slope;
    slope << jet.du, jet.dv;
    Eigen::Matrix2d normal = slope.transpose() * slope;
    if (!(normal.trace() > 0.0)) break;  // an irregular corner has no derivatives
    normal.diagonal().array() += 1e-12 * normal.trace();
    const Eigen::Vector2d move = normal.inverse() * slope.transpose() * (point - jet.point);
    const double next_u = std::clamp(u + move.x(), 0.0, 1.0);
    const double next_v = std::clamp(v + move.y(), 0.0, 1.0);
    const double next = (point - surface_.position(cell, next_u, next_v)).norm();
    if (!(next < gap)) break;
    const bool worthwhile = next < kWorthwhile * gap;
    gap = next;
    u = next_u;
    v = next_v;
    if (!worthwhile) break;
  }
  return gap;
}

}  // namespace hull
