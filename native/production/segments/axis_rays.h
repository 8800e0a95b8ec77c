// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "production/models/closed_model.h"

namespace hull::production {

// Rays along one axis against a model's triangles.
class AxisRays {
 public:
  AxisRays(const ClosedModel& model, int axis);

  // The coordinate at which a ray from `from`, towards larger coordinates if `up`, first enters the
  // model; infinity of the ray's sign where it does not.
  double first_entry(const Vector3d& from, bool up) const;

  // Whether a ray towards larger coordinates meets any triangle, from either side.
  bool meets_above(const Vector3d& from) const;

 private:
  const std::vector<int>& near(const Vector3d& from) const;

  const ClosedModel& model_;
  int axis_, u_, v_, rows_, columns_;
  double low_u_, low_v_, step_u_, step_v_;
  std::vector<std::vector<int>> bins_;
};

}  // namespace hull::production
