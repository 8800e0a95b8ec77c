// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "conversion/patches/patch_set.h"

namespace hull::conversion {

// Whether a curve of a set of this size lies in the centre plane y = 0 but for rounding, within
// kNoLength: the centre line's control points are put there before anything is converted.
bool lies_in_centre_plane(const BSplineCurve& curve, double size);

// The patches with the seam of with_mirror_image() put on the centre plane exactly.
PatchSet with_seam_in_plane(const PatchSet& half);

// The patches of a half hull together with their mirror image on the centre plane y = 0, joined
// along the seam. The patches given come first, then their images in the same order with the same
// cell numbers; in an image u and v are exchanged, so that its normal points outwards as well.
//
// The seam is every edge with one patch that lies in the centre plane; its control points are put
// on it exactly. Patches or inner edges lying in the plane (a thin skeg) get images of their own
// and are not joined: they are the two sides of something thin.
//
// Images have blocks without sides.
//
// REQUIRES: half.check() does not throw.
PatchSet with_mirror_image(const PatchSet& half);

}  // namespace hull::conversion
