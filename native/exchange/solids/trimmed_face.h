// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <optional>

#include "conversion/patches/patch_integrals.h"

namespace hull::exchange {

// The integrals over a face of any surface within any borders, holes among them, m² and m³, of the
// face as oriented FORWARD: ∫∫ F du dv = ∮ (∫ F du) dv along its borders (Green's theorem), by
// Gauss' rules in the surface's spans and along the border curves' lines in (u, v). Pieces of these
// begin and end where they cross spans, and are halved until the sum no longer changes by 1e-11 of
// the whole. None where an edge has no line in (u, v).
//
// (Open CASCADE's own integrals with a tolerance leave out faces that have holes, and those without
// a tolerance are wrong by up to 1e-4 where surfaces have many spans.)
std::optional<conversion::SurfaceIntegrals> of_trimmed_face(const TopoDS_Face& face);

}  // namespace hull::exchange
