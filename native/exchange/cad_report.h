// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exchange/cad_options.h"
#include "surface/progress.h"

class TopoDS_Shape;

namespace hull::exchange {

constexpr int kBoxSteps = 8;

// The faces of a layer.
struct CadRegion {
  std::string name;
  std::optional<analysis::Colour> colour;  // of its first face
  int faces = 0;
  double area = 0.0;
};

// What Open CASCADE finds in a STEP or IGES file after translating all of it. Lengths in metres
// whatever the file's own unit is.
struct CadReport {
  std::string format;   // "STEP AP214", "STEP AP242", "STEP" (another schema), "IGES 5.3", "IGES"
  std::string unit;     // as CadOptions knows it; "" for another one
  std::string product;  // name of the first product
  bool valid = false;   // BRepCheck_Analyzer finds no fault in any face, edge, vertex or shell
  bool closed = false;  // there are faces, and no edge is free
  int solids = 0;
  int shells = 0;  // those of solids included
  int faces = 0;
  int edges = 0;       // of faces; those of no length (at a collapsed side) are not counted
  int free_edges = 0;  // edges with one face only: none where the shell is closed
  double free_edge_length = 0.0;
  // m: in the middle of one of these, and of a face that is not valid; where there are such.
  std::optional<Vector3d> at_free_edge, at_fault;
  double area = 0.0;
  // The volume enclosed; positive where the normals point outwards. Only where it is closed.
  std::optional<double> volume;
  // Smallest box around (kBoxSteps + 1)^2 points of each B-spline face, equally spaced in its
  // parameters, borders included: never larger than the true one.
  Eigen::Vector3d box_min = Eigen::Vector3d::Zero(), box_max = Eigen::Vector3d::Zero();
  int curves = 0;                     // edges of no face
  std::vector<CadRegion> regions;     // layers with faces, by name
  std::vector<std::string> layers;    // all, by name
  std::vector<int> cells_left_out;    // writing only: cells without area, which make no face
  std::vector<std::string> warnings;  // writing only: what was probably not meant, in sentences
  std::uintmax_t bytes = 0;
};

// Tells the formats apart by what is in the file. `name` is what messages call it.
//
// Throws FileError if the file can't be read, is of neither format, or holds no shape Open CASCADE
// can translate.
CadReport read_cad_report(const std::string& path, const std::string& name,
                          const surface::Progress& progress = {});
inline CadReport read_cad_report(const std::string& path) { return read_cad_report(path, path); }

// Box of a shape in millimetres as a report has it, m; empty where there are no B-spline faces.
Eigen::AlignedBox3d box_of(const TopoDS_Shape& shape);

}  // namespace hull::exchange
