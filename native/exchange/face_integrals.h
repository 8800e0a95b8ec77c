// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "conversion/patches/patch_integrals.h"

namespace hull::exchange {

// The integrals over the faces of a shape in millimetres, in metres: of whole B-spline patches as
// integrals_of(), of plane faces from their borders, of others by Open CASCADE's adaptive rule to
// 1e-8. (For large faces of many spans that takes longer than reading the file, and without a
// tolerance it is wrong by up to 1e-4.)
conversion::SurfaceIntegrals integrals_of(const TopoDS_Shape& shape);
conversion::SurfaceIntegrals integrals_of_face(const TopoDS_Face& face);

}  // namespace hull::exchange
