// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "conversion/patches/patch_integrals.h"
#include "conversion/patches/patch_set.h"
#include "exchange/cad_options.h"
#include "exchange/solids/brep_shape.h"

namespace hull::exchange {

// What goes into a CAD file, in whatever format.
struct CadModel {
  BRepShape brep;
  std::vector<std::string> regions;        // of every face
  std::vector<CadCurve> curves;            // clamped, images included
  std::vector<int> cells_left_out;         // those without area
  std::vector<std::string> warnings;       // sentences about what was probably not meant
  Eigen::AlignedBox3d box;                 // of the faces, by the points of a CadReport
  conversion::SurfaceIntegrals integrals;  // of all faces
  double size = 0.0;
};

// Throws std::invalid_argument if the patches do not fit together, all lack area, or can't be
// closed where a solid is asked for; if regions are given, but not one a patch; if a curve is
// malformed. REQUIRES: an OcctSession lives.
CadModel make_cad_model(const conversion::PatchSet& patches, const CadOptions& options);

}  // namespace hull::exchange
