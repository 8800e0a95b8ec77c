// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/segments/axis_rays.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hull::production {
namespace {

int bin_of(double place, double low, double step, int count) {
  const double bin = std::floor((place - low) / step);
  return static_cast<int>(std::clamp(bin, 0.0, count - 1.0));
}

}  // namespace

AxisRays::AxisRays(const ClosedModel& model, int axis)
    : model_(model), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : model.points) box.extend(p);
  // About as many bins as triangles, as square as that goes.
  const double wide = std::max(box.sizes()[u_], 1e-300), high = std::max(box.sizes()[v_], 1e-300);
  const double side = std::sqrt(wide * high / std::max<double>(1.0, model.triangles.size()));
  columns_ = static_cast<int>(std::clamp(std::ceil(wide / side), 1.0, 4096.0));
  rows_ = static_cast<int>(std::clamp(std::ceil(high / side), 1.0, 4096.0));
  low_u_ = box.min()[u_], low_v_ = box.min()[v_];
  step_u_ = wide / columns_, step_v_ = high / rows_;
  bins_.resize(static_cast<std::size_t>(columns_) * rows_);
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    Eigen::AlignedBox3d own;
    for (const int corner : model.triangles[t]) own.extend(model.points[corner]);
    const int j0 = bin_of(own.min()[v_], low_v_, step_v_, rows_);
    const int j1 = bin_of(own.max()[v_], low_v_, step_v_, rows_);
    const int i0 = bin_of(own.min()[u_], low_u_, step_u_, columns_);
    const int i1 = bin_of(own.max()[u_], low_u_, step_u_, columns_);
    for (int j = j0; j <= j1; ++j) {
      for (int i = i0; i <= i1; ++i) {
        bins_[static_cast<std::size_t>(j) * columns_ + i].push_back(static_cast<int>(t));
      }
    }
  }
}

double AxisRays::first_entry(const Vector3d& from, bool up) const {
  double best = up ? std::numeric_limits<double>::infinity()
                   : -std::numeric_limits<double>::infinity();
  const int i = bin_of(from[u_], low_u_, step_u_, columns_);
  const int j = bin_of(from[v_], low_v_, step_v_, rows_);
  for (const int t : bins_[static_cast<std::size_t>(j) * columns_ + i]) {
    const auto& [ia, ib, ic] = model_.triangles[t];
    const Vector3d &a = model_.points[ia], &b = model_.points[ib], &c = model_.points[ic];
    const auto across = [&](const Vector3d& p, const Vector3d& q) {
      return (p[u_] - from[u_]) * (q[v_] - from[v_]) - (p[v_] - from[v_]) * (q[u_] - from[u_]);
    };
    const double wa = across(b, c), wb = across(c, a), wc = across(a, b);
    const double sum = wa + wb + wc;  // twice the area seen, positive where it faces up
    if (up ? !(sum < 0.0) : !(sum > 0.0)) continue;  // a ray leaves the model there
    const double sign = sum > 0.0 ? 1.0 : -1.0;
    if (sign * wa < 0.0 || sign * wb < 0.0 || sign * wc < 0.0) continue;
    const double at = (wa * a[axis_] + wb * b[axis_] + wc * c[axis_]) / sum;
    if (up ? at > from[axis_] && at < best : at < from[axis_] && at > best) best = at;
  }
  return best;
}

}  // namespace hull::production
