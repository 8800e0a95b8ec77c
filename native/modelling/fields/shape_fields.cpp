// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/shape_fields.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "modelling/fields/falloff.h"
#include "surface/parallel_for.h"

namespace hull::modelling {
namespace {

using Eigen::Matrix3d;

// Of the extent: a base so near the centre plane is its own image.
constexpr double kInPlane = 1e-9;
// What varies along a base is looked at in so many places between two of its values.
constexpr int kLooked = 32;
constexpr int kAllProcessors = 0;

const Vector3d kMirror(1.0, -1.0, 1.0);

// What one field, or its image, has to do with a point.
struct Share {
  const ShapeField* field;
  double intensity, rest;
  Vector3d slope;  // of the intensity
  Vector3d shift;  // of the base
  Matrix3d shift_slope;
};

void check_all(const AlongBase<double>& along, const std::function<bool(double)>& is_good,
               const std::string& message) {
  for (double value : along.values()) {
    if (!is_good(value)) throw std::invalid_argument(message);
  }
  const std::vector<double>& at = along.lengths();
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    for (int k = 1; k < kLooked; ++k) {
      const double length = at[i] + (at[i + 1] - at[i]) * k / kLooked;
      if (!is_good(along.at(length).value)) {
        throw std::invalid_argument(message + " It is not so between two of the values given.");
      }
    }
  }
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
  const double delta = foot.distance / extent.value;
  const double clamped = std::clamp(kappa.value, 0.0, 1.0);
  const Intensity found =
      field.base->has_rim() ? rim_intensity(delta, clamped) : selection_intensity(delta, clamped);
  slope = (found.slope / extent.value) * foot.distance_slope +
          (found.kappa_slope * kappa.slope - found.slope * delta / extent.value * extent.slope) *
              foot.length_slope;
  return found;
}

// Whether anything of it goes by the length along the base.
bool varies(const ShapeField& field) {
  return field.change || !field.extent.is_constant() || !field.kappa.is_constant() ||
         !field.shift.is_constant();
}

// At a point, or for the image of the field at the point's image.
BaseFoot foot_of(const ShapeField& field, const Vector3d& p, bool is_image) {
  return field.base->foot(is_image ? Vector3d(kMirror.cwiseProduct(p)) : p, varies(field));
}

Share share_of(const ShapeField& field, const BaseFoot& foot, bool is_image, bool stays_in_plane) {
  Share share{&field, 0.0, 1.0, Vector3d::Zero(), Vector3d::Zero(), Matrix3d::Zero()};
  const Intensity found = intensity_at(field, foot, share.slope);
  share.intensity = found.value;
  share.rest = found.rest;
  if (found.value > 0.0 && !field.protects) {
    const ValueAlong<Vector3d> shift =
        field.change ? field.change->shift(foot.length) : field.shift.at(foot.length);
    share.shift = shift.value;
    share.shift_slope = shift.slope * foot.length_slope.transpose();
  }
  if (is_image) {
    share.slope = kMirror.cwiseProduct(share.slope);
    share.shift = kMirror.cwiseProduct(share.shift);
    share.shift_slope = kMirror.asDiagonal() * share.shift_slope * kMirror.asDiagonal();
  } else if (stays_in_plane) {
    share.shift.y() = 0.0;
    share.shift_slope.row(1).setZero();
  }
  return share;
}

struct Blended {
  double value;
  Vector3d slope;
};

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

Blended along_axis(const std::vector<Share>& shares, int axis, FieldBlend blend) {
  std::vector<const Share*> working;
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

// On all processors.
template <class Work>
void for_all(std::size_t count, const Work& work) {
  constexpr std::size_t kGrain = 256;
  surface::parallel_for(
      count, kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) work(i);
      },
      kGrain);
}

}  // namespace

ShapeFields::ShapeFields(std::vector<ShapeField> fields, bool mirrored, FieldBlend blend)
    : fields_(std::move(fields)), blend_(blend), mirrored_(mirrored) {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    ShapeField& field = fields_[i];
    const std::string name = "Field " + std::to_string(i);
    if (field.change && !field.base) field.base = curve_base(field.change->curve());
    if (!field.base) throw std::invalid_argument(name + " has no base.");
    check_all(
        field.extent, [](double v) { return v > 0.0 && std::isfinite(v); },
        name + ": the extent must be positive.");
    check_all(
        field.kappa, [](double v) { return v >= 0.0 && v <= 1.0; },
        name + ": the falloff must be from 0 to 1.");
    for (const Vector3d& shift : field.shift.values()) {
      if (!shift.allFinite()) throw std::invalid_argument(name + ": the shift is no number.");
    }
    const double extent = *std::ranges::min_element(field.extent.values());
    is_in_plane_.push_back(mirrored && field.base->is_in_centre_plane(kInPlane * extent));
    sides_.push_back({i, false});
    if (mirrored_ && !is_in_plane_[i]) sides_.push_back({i, true});
  }
}

// By the foot of each side.
FieldShift ShapeFields::blended(const std::vector<BaseFoot>& feet) const {
  std::vector<Share> shares;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const auto [field, is_image] = sides_[i];
    shares.push_back(share_of(fields_[field], feet[i], is_image, is_in_plane_[field]));
  }
  FieldShift result;
  for (int axis = 0; axis < 3; ++axis) {
    const Blended found = along_axis(shares, axis, blend_);
    result.shift[axis] = found.value;
    result.gradient.row(axis) = found.slope.transpose();
  }
  return result;
}

FieldShift ShapeFields::at(const Vector3d& p) const {
  std::vector<BaseFoot> feet;
  for (const auto& [field, is_image] : sides_) feet.push_back(foot_of(fields_[field], p, is_image));
  return blended(feet);
}

std::vector<FieldShift> ShapeFields::at(const std::vector<Vector3d>& points) const {
  std::vector<FieldShift> result(points.size());
  for_all(points.size(), [&](std::size_t i) { result[i] = at(points[i]); });
  return result;
}

std::vector<FieldShift> ShapeFields::at(FieldPlaces& places) const {
  std::vector<std::shared_ptr<const FieldPlaces::Feet>> own;
  for (const auto& [index, is_image] : sides_) {
    const ShapeField& field = fields_[index];
    const auto known = std::ranges::find_if(places.known_, [&](const auto& feet) {
      return feet->is_image == is_image && feet->with_length >= varies(field) &&
             feet->base->is_same(*field.base);
    });
    if (known != places.known_.end()) {
      own.push_back(*known);
      continue;
    }
    auto feet = std::make_shared<FieldPlaces::Feet>(
        FieldPlaces::Feet{field.base, is_image, varies(field), {}});
    feet->feet.resize(places.points_.size());
    for_all(places.points_.size(),
            [&](std::size_t i) { feet->feet[i] = foot_of(field, places.points_[i], is_image); });
    own.push_back(std::move(feet));
  }
  std::vector<FieldShift> result(places.points_.size());
  for_all(result.size(), [&](std::size_t i) {
    std::vector<BaseFoot> feet;
    for (const auto& of_side : own) feet.push_back(of_side->feet[i]);
    result[i] = blended(feet);
  });
  places.known_ = std::move(own);
  return result;
}

double ShapeFields::delta(int field, const Vector3d& p) const {
  const auto of = [&](const Vector3d& at) {
    const BaseFoot foot = foot_of(fields_[field], at, false);
    return foot.distance / fields_[field].extent.at(foot.length).value;
  };
  const double own = of(p);
  return mirrored_ && !is_in_plane_[field] ? std::min(own, of(kMirror.cwiseProduct(p))) : own;
}

}  // namespace hull::modelling
