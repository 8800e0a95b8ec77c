// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "production/plates/surface_curve.h"

namespace hull::production {

// The place at `girth` metres along the surface from `base`, in the plane through it with the given
// unit normal, on the side to which the section sets out with a part along `towards`. None where
// the surface ends before.
//
// The length is that of the section, by the cubics that have its tangents at points no further from
// chords than `chord_tolerance`: relative errors are of the fourth order in the angle between them.
std::optional<CellPlace> girth_point(const surface::LimitSurface& surface, const CellPlace& base,
                                     const Vector3d& normal, const Vector3d& towards, double girth,
                                     double chord_tolerance);

}  // namespace hull::production
