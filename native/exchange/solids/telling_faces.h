// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace hull::exchange {

// The same solids, with another face first in those whose outside Open CASCADE takes for the
// inside.
//
// Its readers find out which is which by a line from a point of the first face, and are wrong where
// that face lies close to others. Solids of which every face misleads it stay as they are.
//
// REQUIRES: solids and shells alone, or a compound of them; normals of solids point outwards.
TopoDS_Shape with_telling_first_faces(const TopoDS_Shape& shape);

}  // namespace hull::exchange
