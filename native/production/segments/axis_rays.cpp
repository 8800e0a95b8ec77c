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
  // In this order what is no number, as of a model too large for sums of its coordinates, is 0.
  return static_cast<int>(std::min(std::max(0.0, bin), count - 1.0));
}

int bin_count(double wanted) {
  return static_cast<int>(std::min(std::max(1.0, std::ceil(wanted)), 4096.0));  // as in bin_of()
}

// Where the line along an axis through a point meets a triangle; area: twice the triangle's, as it
// is seen, positive where it faces up, 0 where the line does not meet it.
struct RayCrossing {
  double area, at;
};

RayCrossing crossing_of(const ClosedModel& model, int triangle, const Vector3d& from, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto& [ia, ib, ic] = model.triangles[triangle];
  const Vector3d &a = model.points[ia], &b = model.points[ib], &c = model.points[ic];
  const auto across = [&](const Vector3d& p, const Vector3d& q) {
    return (p[u] - from[u]) * (q[v] - from[v]) - (p[v] - from[v]) * (q[u] - from[u]);
  };
  // Areas of the triangles with the line's point at their tips: of one sign where it is inside, and
  // the weights of the corners (barycentric coordinates). Borders count, so that no ray slips
  // through.
  const double wa = across(b, c), wb = across(c, a), wc = across(a, b);
  const double sum = wa + wb + wc, sign = sum > 0.0 ? 1.0 : -1.0;
  if (sum == 0.0 || sign * wa < 0.0 || sign * wb < 0.0 || sign * wc < 0.0) return {0.0, 0.0};
  return {sum, (wa * a[axis] + wb * b[axis] + wc * c[axis]) / sum};
}

}  // namespace

AxisRays::AxisRays(const ClosedModel& model, int axis)
    : model_(model), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : model.points) box.extend(p);
  // About as many bins as triangles, as square as that goes: a line then looks at few triangles but
  // those that it meets.
  const double wide = std::max(box.sizes()[u_], 1e-300), high = std::max(box.sizes()[v_], 1e-300);
  const double side = std::sqrt(wide * high / std::max<double>(1.0, model.triangles.size()));
  columns_ = bin_count(wide / side), rows_ = bin_count(high / side);
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
  double best =
      up ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  for (const int t : near(from)) {
    const RayCrossing crossing = crossing_of(model_, t, from, axis_);
    // A ray leaves the model where it is seen from the other side.
    if (up ? !(crossing.area < 0.0) : !(crossing.area > 0.0)) continue;
    const double at = crossing.at;
    if (up ? at > from[axis_] && at < best : at < from[axis_] && at > best) best = at;
  }
  return best;
}

bool AxisRays::meets_above(const Vector3d& from) const {
  const std::vector<int>& own = near(from);
  return std::any_of(own.begin(), own.end(), [&](int t) {
    const RayCrossing crossing = crossing_of(model_, t, from, axis_);
    return crossing.area != 0.0 && crossing.at > from[axis_];
  });
}

const std::vector<int>& AxisRays::near(const Vector3d& from) const {
  // Beside the model's box this is a bin of its border, none of whose triangles is met.
  const int i = bin_of(from[u_], low_u_, step_u_, columns_);
  const int j = bin_of(from[v_], low_v_, step_v_, rows_);
  return bins_[static_cast<std::size_t>(j) * columns_ + i];
}

}  // namespace hull::production
