// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "bindings/arrays.h"
#include "modelling/transformation/longitudinal_reshape.h"

namespace hull::bindings {

// What Python calls TransformLimits: checked when it is made.
class LimitArguments {
 public:
  LimitArguments() = default;
  explicit LimitArguments(modelling::TransformLimits limits) : limits_(std::move(limits)) {}
  const modelling::TransformLimits& limits() const { return limits_; }

 private:
  modelling::TransformLimits limits_;
};

void bind_transform_limits(py::module_& module);

}  // namespace hull::bindings
