// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace hull {

constexpr int kBoxSteps = 8;

// What Open CASCADE finds in a STEP file after translating all of it. Lengths in metres whatever
// the file's own unit is.
struct StepReport {
  bool valid = false;  // BRepCheck_Analyzer finds no fault in any face, edge, vertex or shell
  int solids = 0;
  int shells = 0;  // those of solids included
  int faces = 0;
  int edges = 0;       // edges of no length (at a face's collapsed side) are not counted
  int free_edges = 0;  // edges with one face only: none where the shell is closed
  double free_edge_length = 0.0;
  double area = 0.0;
  // The volume enclosed; positive where the normals point outwards. Only where no edge is free.
  std::optional<double> volume;
  // Smallest box around (kBoxSteps + 1)^2 points of each face, equally spaced in its parameters,
  // borders included: never larger than the true one.
  Eigen::Vector3d box_min = Eigen::Vector3d::Zero(), box_max = Eigen::Vector3d::Zero();
  std::string product;              // name of the first product
  std::vector<int> cells_left_out;  // write_step only: cells without area, which make no face
};

// Throws FileError if the file can't be read or holds no shape Open CASCADE can translate.
StepReport read_step_report(const std::string& path);

// The same for the text of a STEP file; `name` is what messages call it.
StepReport read_step_report(std::istream& text, const std::string& name);

}  // namespace hull
