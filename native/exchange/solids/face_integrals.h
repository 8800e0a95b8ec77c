// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "conversion/patches/patch_integrals.h"

namespace hull::exchange {

// The integrals over the faces of a shape in millimetres, in metres: of whole B-spline patches as
// integrals_of(), of plane faces from their borders, of others as of_trimmed_face(), and where a
// file has no lines in (u, v), by Open CASCADE's adaptive rule to 1e-8.
conversion::SurfaceIntegrals integrals_of(const TopoDS_Shape& shape);
conversion::SurfaceIntegrals integrals_of_face(const TopoDS_Face& face);

}  // namespace hull::exchange
