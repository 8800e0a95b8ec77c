// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/families/local_weights.h"

#include <stdexcept>

#include "morphing/limit_points.h"

namespace hull::morphing {
namespace {

using modelling::ShapeField;
using modelling::ShapeFields;

}  // namespace

Eigen::MatrixXd local_weights(const HullFamily& family, const std::vector<double>& weights,
                              const std::vector<LocalWeights>& local, bool mirrored) {
  family.check_weights(weights);
  for (const LocalWeights& each : local) {
    if (!each.field.protects) family.check_weights(each.weights);
  }
  modelling::FieldPlaces places(limit_points(family.parents()[0]));
  Eigen::MatrixXd found(family.point_count(), family.parent_count());
  for (int k = 0; k < family.parent_count(); ++k) {
    // What the weight of this parent changes by, as a shift along x: a coordinate that mirroring
    // leaves alone.
    std::vector<ShapeField> fields;
    for (const LocalWeights& each : local) {
      ShapeField field = each.field;
      if (!field.base) throw std::invalid_argument("The field of local weights has no base.");
      field.change = nullptr;
      field.axes = {true, true, true};
      const double gain = each.field.protects ? 0.0 : each.weights[k] - weights[k];
      field.shift = modelling::AlongBase<Vector3d>(Vector3d(gain, 0.0, 0.0));
      fields.push_back(std::move(field));
    }
    // As gains of a field sum to zero over the parents, weights still sum to 1 wherever it fades.
    found.col(k).setConstant(weights[k]);
    if (fields.empty()) continue;
    const std::vector<modelling::FieldShift> gains =
        ShapeFields(std::move(fields), mirrored, modelling::FieldBlend::kExact).at(places);
    for (int i = 0; i < family.point_count(); ++i) found(i, k) += gains[i].shift.x();
  }
  return found;
}

}  // namespace hull::morphing
