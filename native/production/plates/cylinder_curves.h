// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/sections/sections.h"
#include "production/plates/cylinder_field.h"

namespace hull::production {

// Where a cylinder cuts a surface, branch by branch, as sections are: points are on the surface,
// and off the cylinder by rounding, 1e-12 of the mesh's size; no chord is further than
// `chord_tolerance` from the curve. No branch is missed but those shorter than 1e-6 of the size:
// parts of the surface are left out only where the coefficients of its distance from the cylinder
// prove that they are on one side, and others divided until each has at most one point of the curve
// for each u, or for each v. Outside of the cylinder is on the left, seen from the water.
//
// Throws std::invalid_argument, with `name`, where the surface touches the cylinder within 1e-6 of
// the size without being cut there, or branches cross: which way curves go is not certain then.
std::vector<analysis::SectionCurve> cylinder_curves(const surface::LimitSurface& surface,
                                                    const Cylinder& cylinder,
                                                    double chord_tolerance,
                                                    const std::string& name);

}  // namespace hull::production
