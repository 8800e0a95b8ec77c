// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patch_gauge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "conversion/near_point.h"

namespace hull {
namespace {

constexpr double kNegligible = 1e-9;  // of the surface's size

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
      const CellPoint start{patch.cell, nodes_[i], nodes_[j]};
      const double gap = near_point(surface_, point, start, negligible_).distance;
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

}  // namespace hull
