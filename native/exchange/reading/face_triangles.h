// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Poly_Triangulation.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>

#include "exchange/reading/cad_geometry.h"

namespace hull::exchange {

// The triangles of a face as Open CASCADE has made them (`mesh` at `location`), in metres, those
// finer that are farther than `chord` (mm) from it at their middles or the middles of their sides:
// its own estimate of that falls short at irregular places. A side is cut for both triangles that
// it is of. After kMostCuts halvings what is still farther stays.
CadFace face_triangles(const TopoDS_Face& face, const Poly_Triangulation& mesh,
                       const TopLoc_Location& location, double chord);

}  // namespace hull::exchange
