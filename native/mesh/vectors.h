// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

// Points and directions in all layers.
namespace hull {

using Eigen::Vector3d;

}  // namespace hull
