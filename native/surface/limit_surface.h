// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "mesh/control_mesh.h"
#include "surface/eigenbasis/basis_cache.h"
#include "surface/pieces/bicubic.h"
#include "surface/scheme.h"
#include "surface/surface_layout.h"

namespace hull::surface {

// The exact limit surface of a control mesh under crease-tagged Catmull–Clark subdivision
// (Greshake 2021, chapters 4 and 5): a function of a cell and (u, v) in [0, 1]^2.
//
// Cells are the faces of the once-subdivided mesh, in the order (face of the control mesh, corner
// of that face): (0, 0) is at the corner's limit point, (1, 0) halfway along the edge to the next
// corner, (1, 1) at the face's centre. Normals point to the side from which faces run
// counter-clockwise; a hull's faces are turned so that this is the water.
//
// Errors: positions to about 1e-14 of the mesh's size. All queries are thread-safe among
// themselves.
class LimitSurface {
 public:
  explicit LimitSurface(mesh::ControlMesh mesh, Scheme scheme = Scheme::kBiermann,
                        std::shared_ptr<BasisCache> cache = std::make_shared<BasisCache>());

  // Moves the control points; nothing that depends on topology alone is done again, nor anything
  // of cells that stay as they are: the surface is the same as if it were made anew. Throws
  // std::invalid_argument unless there are as many points as before, all finite.
  void set_points(std::vector<Vector3d> points);

  // How often set_points() was called, and at which of these calls a cell was moved last (0:
  // never): by these, what is computed of cells can be kept as long as they stay.
  int revision() const { return revision_; }
  int moved_at(int cell) const { return moved_at_[cell]; }
  // In order; all cells since -1.
  std::vector<int> cells_moved_since(int revision) const;

  const mesh::ControlMesh& mesh() const { return mesh_; }
  Scheme scheme() const { return layout_->scheme(); }
  // Topology of the once-subdivided mesh: face c is cell c, its half-edges 4c … 4c+3 are the sides
  // v = 0, u = 1, v = 1, u = 0.
  const mesh::Topology& cells() const { return layout_->cells(); }
  int cell_count() const { return cells().face_count(); }

  // REQUIRES of all: 0 <= cell < cell_count(), u and v in [0, 1].
  Vector3d position(int cell, double u, double v) const;
  // Position and derivatives up to `order` (0, 1, 2) with respect to the cell's (u, v). Derivatives
  // do not exist at irregular corners; there they are zero.
  SurfaceJet evaluate(int cell, double u, double v, int order) const;
  // The same into `jet`, whose derivatives of higher order are undefined afterwards.
  void evaluate(int cell, double u, double v, int order, SurfaceJet& jet) const;
  // Unit normal; the zero vector where there is no tangent plane (cone tips, cusps).
  Vector3d normal(int cell, double u, double v) const;

  // Whether (u, v) is a corner of the cell where the surface is only C¹.
  bool is_irregular_knot(int cell, double u, double v) const;

  const SurfaceLayout& layout() const { return *layout_; }
  const std::shared_ptr<const SurfaceLayout>& shared_layout() const { return layout_; }
  const BicubicPoints& leaf(int index) const { return leaves_[index]; }
  const CornerPoints& corner(int index) const { return corners_[index]; }

 private:
  void take_points();
  bool take_node(const SurfaceNode& node, const std::vector<Vector3d>& refined,
                 const std::vector<char>& moved);

  mesh::ControlMesh mesh_;
  std::shared_ptr<const SurfaceLayout> layout_;
  std::vector<BicubicPoints> leaves_;
  std::vector<CornerPoints> corners_;
  std::vector<Vector3d> refined_;  // what leaves and corners were taken from
  int revision_ = 0;
  std::vector<int> moved_at_;  // by cell
};

}  // namespace hull::surface
