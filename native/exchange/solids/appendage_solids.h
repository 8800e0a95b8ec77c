// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

#include "analysis/appendages/appendage.h"

namespace hull::exchange {

// The solid of a shape in millimetres: cylinders and cones with their own surfaces, foils by ruled
// B-spline surfaces between the outlines that shell_of() has, bulbs by the four quarters of its
// surface. Throws std::invalid_argument as shell_of() does.
TopoDS_Shape solid_of(const analysis::AppendageShape& shape);

}  // namespace hull::exchange
