// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <optional>
#include <vector>

#include "conversion/caps/caps.h"
#include "conversion/patches/patch_set.h"

namespace hull::exchange {

// A boundary representation of patches in millimetres, Open CASCADE's own unit.
struct BRepShape {
  // A solid where the faces enclose one and their normals point out of it, otherwise a shell; a
  // compound of these if the faces fall into several parts that share no edge.
  TopoDS_Shape shape;
  std::vector<TopoDS_Face> faces;  // number p is that of patch p, then those of the caps
  int free_edges = 0;              // edges with one face, those of no length not counted
  int parts = 0;                   // that share no edge
  int solids = 0;                  // those that are solids
  // m: in the middle of a free edge, and of a face of a part that is no solid; where there are
  // such.
  std::optional<Vector3d> at_free_edge, at_no_solid;
};

// Faces carry the patches as they are. Joined faces share one edge object, whose curve is the
// border curve of both; so there is nothing to sew, and no tolerance beyond rounding. A side of no
// length (all its control points within kNoLength of the set's size) becomes a degenerated edge,
// its ends one vertex. Caps are faces like the others; edges of plane faces have as tolerance their
// distance from the plane.
//
// Throws std::invalid_argument if set.check() does. REQUIRES: at least one patch, none without area
// (see without_flat_patches).
BRepShape make_brep_shape(const conversion::PatchSet& set, const conversion::Closing& closing = {});

}  // namespace hull::exchange
