// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/sections/height_net.h"
#include "analysis/sections/net_cut.h"
#include "analysis/sections/section_point.h"

namespace hull::analysis {

// The tangent and the signed curvature of a section where it runs in direction (w_u, w_v) of the
// parameters, along which g(u, v) = 0 to second order; g is the height, or what is left of it. With
// w = (g_v, -g_u) what is above is on the left. Sets both in `p`; leaves them zero where the
// surface or g has no direction there.
void set_course(const surface::SurfaceJet& jet, const HeightJet& g, const Vector3d& plane_normal,
                SectionPoint& p);

// Adds the arcs of a piece but for sides that lie in the plane, sampled so that no chord is further
// than `chord_tolerance` from the curve. Lengths of about `zero` are rounding. `cut` is room to
// work in.
void add_section_arcs(const surface::SurfacePiece& piece, const HeightNet& height,
                      const Plane& plane, double chord_tolerance, double zero, NetCut& cut,
                      SectionParts& parts);

}  // namespace hull::analysis
