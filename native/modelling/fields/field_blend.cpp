// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/field_blend.h"

#include <algorithm>

#include "modelling/fields/falloff.h"

namespace hull::modelling {
namespace {

using Eigen::Matrix3d;

const Vector3d kMirror(1.0, -1.0, 1.0);

// Whether the point is looked at by its image. Of a base in the plane that is what is to starboard:
// by the rounding that such a base may be off, the two sides would differ.
bool is_by_image(const Vector3d& p, FieldSide side) {
  return side == FieldSide::kImage || (side == FieldSide::kBoth && p.y() < 0.0);
}

// From a rim: delta² (2 - delta) in place of delta, which goes from 0 to 1 as that does, and so
// flatly at the rim that no curvature jumps there.
Intensity rim_intensity(double delta, double kappa) {
  if (delta >= 1.0) return selection_intensity(delta, kappa);
  Intensity found = selection_intensity(delta * delta * (2.0 - delta), kappa);
  found.slope *= delta * (4.0 - 3.0 * delta);
  return found;
}

Intensity intensity_at(const ShapeField& field, const BaseFoot& foot, Vector3d& slope) {
  const ValueAlong<double> extent = field.extent.at(foot.length),
                           kappa = field.kappa.at(foot.length);
  // Distance, extent and kappa all go with the point: hence the three terms of the slope below.
  const double delta = foot.distance / extent.value;
  const double clamped = std::clamp(kappa.value, 0.0, 1.0);
  const Intensity found =
      field.base->has_rim() ? rim_intensity(delta, clamped) : selection_intensity(delta, clamped);
  slope = (found.slope / extent.value) * foot.distance_slope +
          (found.kappa_slope * kappa.slope - found.slope * delta / extent.value * extent.slope) *
              foot.length_slope;
  return found;
}

// Equation 2, without what protects.
Blended sum(const std::vector<const Share*>& shares, int axis) {
  Blended result{0.0, Vector3d::Zero()};
  for (const Share* share : shares) {
    result.value += share->intensity * share->shift[axis];
    result.slope += share->shift[axis] * share->slope +
                    share->intensity * share->shift_slope.row(axis).transpose();
  }
  return result;
}

// Where bases meet: their mean.
Blended mean_of_bases(const std::vector<const Share*>& shares, int axis) {
  Blended result{0.0, Vector3d::Zero()};
  int count = 0;
  for (const Share* share : shares) {
    if (share->rest > 0.0) continue;
    result.value += share->shift[axis];
    result.slope += share->shift_slope.row(axis).transpose();
    ++count;
  }
  return {result.value / count, result.slope / count};
}

// With the intensities f_j of the fields, each field's part in the shift is
//
//   P_j / Σ P  (1 - Π (1 - f_i)),  P_j = f_j Π_{i≠j} (1 - f_i).
//
// On the base of field j all other P vanish and the last factor is 1: the shift is that of j.
// Where only field j works its part is f_j. All of it is as smooth as the intensities, but where
// bases meet.
Blended exact(const std::vector<const Share*>& shares, int axis) {
  const std::size_t n = shares.size();
  // Products of what all fields but one, and all but two, leave.
  const auto rest_without = [&](std::size_t a, std::size_t b) {
    double product = 1.0;
    for (std::size_t i = 0; i < n; ++i) {
      if (i != a && i != b) product *= shares[i]->rest;
    }
    return product;
  };
  double parts = 0.0, sums = 0.0, rest = 1.0;
  Vector3d parts_slope = Vector3d::Zero(), sums_slope = parts_slope, rest_slope = parts_slope;
  for (std::size_t j = 0; j < n; ++j) {
    const Share& own = *shares[j];
    const double others = rest_without(j, j), part = own.intensity * others;
    Vector3d part_slope = others * own.slope;
    for (std::size_t i = 0; i < n; ++i) {
      if (i != j) part_slope -= own.intensity * rest_without(i, j) * shares[i]->slope;
    }
    parts += part;
    parts_slope += part_slope;
    sums += part * own.shift[axis];
    sums_slope += own.shift[axis] * part_slope + part * own.shift_slope.row(axis).transpose();
    rest *= own.rest;
    rest_slope -= others * own.slope;
  }
  if (!(parts > 0.0)) return mean_of_bases(shares, axis);
  const double mean = sums / parts;
  const Vector3d mean_slope = (sums_slope - mean * parts_slope) / parts;
  return {mean * (1.0 - rest), (1.0 - rest) * mean_slope - mean * rest_slope};
}

// What protecting fields leave.
Blended left(const std::vector<Share>& shares, int axis) {
  Blended result{1.0, Vector3d::Zero()};
  for (const Share& share : shares) {
    if (!share.field->protects || !share.field->axes[axis]) continue;
    result.slope = share.rest * result.slope - result.value * share.slope;
    result.value *= share.rest;
  }
  return result;
}

}  // namespace

bool varies(const ShapeField& field) {
  return field.change || !field.extent.is_constant() || !field.kappa.is_constant() ||
         !field.shift.is_constant();
}

double reach_of(const ShapeField& field) {
  return field.extent.is_constant() ? field.extent.values().front() : surface::kInfinity;
}

BaseFoot foot_of(const ShapeField& field, const Vector3d& p, FieldSide side, double within) {
  // The point is mirrored, not the base: one base serves both sides.
  const Vector3d own = is_by_image(p, side) ? Vector3d(kMirror.cwiseProduct(p)) : p;
  return field.base->foot_within(own, varies(field), within);
}

Share share_of(const ShapeField& field, const BaseFoot& foot, const Vector3d& p, FieldSide side) {
  Share share{&field, 0.0, 1.0, Vector3d::Zero(), Vector3d::Zero(), Matrix3d::Zero()};
  if (foot.distance == surface::kInfinity) return share;  // beyond what was looked for
  const Intensity found = intensity_at(field, foot, share.slope);
  share.intensity = found.value;
  share.rest = found.rest;
  if (found.value > 0.0 && !field.protects) {
    const ValueAlong<Vector3d> shift =
        field.change ? field.change->shift(foot.length) : field.shift.at(foot.length);
    share.shift = shift.value;
    share.shift_slope = shift.slope * foot.length_slope.transpose();
  }
  if (is_by_image(p, side)) {
    share.slope = kMirror.cwiseProduct(share.slope);
    share.shift = kMirror.cwiseProduct(share.shift);
    // The image's shift at p is M s(M p): M stands on both sides of its gradient.
    share.shift_slope = kMirror.asDiagonal() * share.shift_slope * kMirror.asDiagonal();
  }
  if (side == FieldSide::kBoth) {
    // A base that is its own image cannot leave the plane.
    share.shift.y() = 0.0;
    share.shift_slope.row(1).setZero();
  }
  return share;
}

Blended blend_along(const std::vector<Share>& shares, int axis, FieldBlend blend,
                    std::vector<const Share*>& working) {
  working.clear();
  for (const Share& share : shares) {
    const bool works = share.intensity > 0.0 && !share.field->protects && share.field->axes[axis];
    if (works) working.push_back(&share);
  }
  if (working.empty()) return {0.0, Vector3d::Zero()};
  const bool alone = working.size() == 1 || blend == FieldBlend::kSum;
  const Blended shift = alone ? sum(working, axis) : exact(working, axis);
  const Blended kept = left(shares, axis);
  return {kept.value * shift.value, kept.value * shift.slope + shift.value * kept.slope};
}

}  // namespace hull::modelling
