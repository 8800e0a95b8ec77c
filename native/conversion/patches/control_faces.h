// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "conversion/patches/patch_set.h"
#include "surface/limit_surface.h"

namespace hull::conversion {

// PatchSet::cell_faces of patches of a surface.
std::vector<int> faces_of_cells(const surface::LimitSurface& surface);

// The face of the control mesh that is nearest to a point, as far as samples of the patches tell:
// the middles of their cells. -1 where PatchSet::cell_faces is empty.
int nearest_control_face(const PatchSet& set, const Vector3d& point);

}  // namespace hull::conversion
