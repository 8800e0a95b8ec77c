// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modelling/fields/shape_fields.h"

namespace hull::modelling {

// What one field, or its image, has to do with a point.
struct Share {
  const ShapeField* field;
  double intensity, rest;
  Vector3d slope;  // of the intensity
  Vector3d shift;  // of the base
  Eigen::Matrix3d shift_slope;
};

// Whether anything of a field goes by the length along the base.
bool varies(const ShapeField& field);

// Beyond it the field does nothing, m: the extent where that is constant; infinite where not.
double reach_of(const ShapeField& field);

// At a point, or for the image of the field at the point's image; within, m, as of
// FieldBase::foot_within().
BaseFoot foot_of(const ShapeField& field, const Vector3d& p, FieldSide side, double within);

// Of the foot that foot_of() found at the same point for the same side.
Share share_of(const ShapeField& field, const BaseFoot& foot, const Vector3d& p, FieldSide side);

struct Blended {
  double value;
  Vector3d slope;
};

// A coordinate of the shift that fields make together. `working`: memory for those that work along
// the axis.
Blended blend_along(const std::vector<Share>& shares, int axis, FieldBlend blend,
                    std::vector<const Share*>& working);

}  // namespace hull::modelling
