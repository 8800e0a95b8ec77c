// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/cylinder_field.h"

#include <algorithm>
#include <cmath>

namespace hull::production {
namespace {

constexpr double kCubicBinomial[] = {1.0, 3.0, 3.0, 1.0};
constexpr double kSexticBinomial[] = {1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0};

}  // namespace

CylinderFrame::CylinderFrame(const Cylinder& cylinder)
    : origin_(cylinder.point), radius_(cylinder.radius) {
  axes_.col(2) = cylinder.direction;
  axes_.col(0) = cylinder.direction.unitOrthogonal();
  axes_.col(1) = axes_.col(2).cross(axes_.col(0));
}

surface::BezierPatch CylinderFrame::seen(const surface::BicubicPoints& points) const {
  surface::BicubicPoints turned;
  for (std::size_t i = 0; i < points.size(); ++i) turned[i] = seen(points[i]);
  return surface::BezierPatch::from_bspline(turned);
}

std::array<double, 2> CylinderFrame::distances(const Eigen::AlignedBox2d& box) const {
  const Eigen::Vector2d far = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs());
  return {std::sqrt(box.squaredExteriorDistance(Eigen::Vector2d::Zero())), far.norm()};
}

CylinderField::CylinderField(const surface::BezierPatch& seen, double radius, double zero) {
  double weighted[2][16];
  for (int k = 0; k < 2; ++k) {
    // With their binomials Bernstein coefficients multiply as those of powers do; the product's own
    // binomials are taken out below.
    for (int n = 0; n < 16; ++n) {
      weighted[k][n] = kCubicBinomial[n % 4] * kCubicBinomial[n / 4] * seen.x[k][n];
    }
  }
  for (int m = 0; m < 16; ++m) {
    for (int n = 0; n < 16; ++n) {
      c_[kOrder * (m / 4 + n / 4) + m % 4 + n % 4] +=
          weighted[0][m] * weighted[0][n] + weighted[1][m] * weighted[1][n];
    }
  }
  for (int n = 0; n < kOrder * kOrder; ++n) {
    c_[n] = c_[n] / (kSexticBinomial[n % kOrder] * kSexticBinomial[n / kOrder]) - radius * radius;
    if (std::abs(c_[n]) < zero) c_[n] = 0.0;
  }
}

double CylinderField::lowest() const { return *std::min_element(c_.begin(), c_.end()); }
double CylinderField::highest() const { return *std::max_element(c_.begin(), c_.end()); }

std::array<double, 2> CylinderField::slopes(int axis) const {
  // The differences are the derivative's coefficients but for the degree as a factor.
  const int step = axis == 0 ? 1 : kOrder;
  std::array<double, 2> range{c_[step] - c_[0], c_[step] - c_[0]};
  for (int n = 0; n + step < kOrder * kOrder; ++n) {
    if (axis == 0 && n % kOrder == kOrder - 1) continue;
    const double d = c_[n + step] - c_[n];
    range = {std::min(range[0], d), std::max(range[1], d)};
  }
  return range;
}

std::array<double, CylinderField::kOrder> CylinderField::side(int axis, int end) const {
  const int first = end == 0 ? 0 : (kOrder - 1) * (axis == 0 ? 1 : kOrder);
  std::array<double, kOrder> side;
  for (int k = 0; k < kOrder; ++k) side[k] = c_[first + k * (axis == 0 ? kOrder : 1)];
  return side;
}

}  // namespace hull::production
