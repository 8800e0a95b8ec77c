// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "mesh/vectors.h"
#include "surface/progress.h"

namespace hull::exchange {

// A curve of a file as a B-spline, exactly, but for offset curves, which Open CASCADE approximates.
// Lines, circles and other conics become rational ones.
struct CadSpline {
  std::string name, layer;  // "" where the file gives none
  int faces = 0;            // that have it as an edge: none for a curve by itself, 1 on a border
  int degree = 1;
  std::vector<double> knots;     // degree + 1 more than points
  std::vector<double> weights;   // of the points; none where all are 1
  std::vector<Vector3d> points;  // m
};

// A face as triangles; its own points, not shared with its neighbours. Turned as the file has it.
struct CadFace {
  std::string name, layer;
  std::vector<Vector3d> points;  // m
  std::vector<std::array<int, 3>> triangles;
};

// What a STEP or IGES file holds, in metres whatever the file's own unit is.
struct CadGeometry {
  std::string format, unit, product;  // as in a CadReport
  std::vector<CadSpline> curves;
  std::vector<CadFace> faces;
  std::vector<Vector3d> points;  // that are ends of no curve, m
  // How many curves and faces Open CASCADE could make nothing of.
  int curves_left_out = 0, faces_left_out = 0;
};

// Triangles are within `chord_share` of the diagonal of the box around all from their face, at
// their middles and those of their sides: Open CASCADE's estimate is measured, and made finer where
// it falls short.
//
// Foreign files may end or stop Open CASCADE itself, so what isn't trusted is to be read in a
// process of its own. Throws FileError as read_cad_report() does, and for shapes without end.
// REQUIRES: chord_share > 0.
CadGeometry read_cad_geometry(const std::string& path, double chord_share,
                              const surface::Progress& progress = {});

}  // namespace hull::exchange
