// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "conversion/patches/patch_set.h"
#include "surface/limit_surface.h"

namespace hull::conversion {

// What is converted in place of a surface whose centre line is in the centre plane but for noise:
// the same surface with it in the plane (mesh/centre_plane.h), so that all patches agree on where
// it is. None where it is there already.
std::optional<surface::LimitSurface> with_centre_line(const surface::LimitSurface& surface);

// Of the surface itself, not of that in its place.
PatchSource source_of(const surface::LimitSurface& surface);

// Throws a PlaceError that says where points near the centre line are and what to do with them, if
// there are any.
void refuse_near_centre_line(const PatchSource& source, double size);

// A sentence that tells where the centre line has gaps, as the two sides are not joined there;
// empty where it has none.
std::string gap_warning(const PatchSource& source);

}  // namespace hull::conversion
