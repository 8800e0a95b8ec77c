// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "production/plates/shell_mesh.h"

namespace hull::production {

// The surface outside of which seams lie between its plates.
struct PlatedShell {
  surface::LimitSurface surface;
  std::vector<SurfaceCurve> curves;
  ShellMesh mesh;
};

// A stretch of a plate's border along one curve, or along the surface's own border.
struct PlateSide {
  int curve;                // of the shell's curves; -1: a border of the surface
  std::vector<int> points;  // of the mesh, in order, with the plate on the left
  bool mirrored = false;    // about y = 0
};

// A region of the exact surface between seams.
struct Plate {
  std::vector<int> triangles;  // of the mesh
  double area = 0.0;           // m²
  Vector3d centre;             // of the area, m
  Eigen::AlignedBox3d box;     // around its triangles' points
  // Closed loops, each as its sides; the first is the longest.
  std::vector<std::vector<PlateSide>> loops;
  // Whether the plate goes on across the centre plane: triangles are those of one side, all else is
  // of both.
  bool across = false;
  // By how much it and its mirror image are bent in the centre plane, rad, where they could be one.
  std::optional<double> centre_knuckle;
};

// The points of a side, m.
std::vector<Vector3d> side_points(const PlatedShell& shell, const PlateSide& side);

// Of a knuckle, rad: what a plate may be bent by along a line, where nothing else is asked for.
inline constexpr double kLargestKnuckle = 0.5 * 0.017453292519943295;

struct PlatingOptions {
  double size;             // of triangles, m
  double largest_knuckle;  // rad; plates may bend by so much along a line, but not more
  // Of half a hull: plates that end in the centre plane without a knuckle there, and face up, down
  // or along the ship rather than to the side, are one with their mirror image.
  bool across_centre = false;
  // Stretches of curves that end within a plate are left out, in place of refused; not those along
  // a knuckle that no plate may go over.
  bool leave_out_loose = false;
  surface::Progress progress;
};

// What was left out of a curve.
struct LooseStretch {
  int curve;                           // of the shell's curves
  double length = 0.0;                 // m
  Vector3d middle = Vector3d::Zero();  // of its longest part, m
};

struct Plating {
  std::shared_ptr<const PlatedShell> shell;
  std::vector<Plate> plates;        // from aft to forward by their centres
  std::vector<LooseStretch> loose;  // at most one of a curve
};

// The plates between curves, creases and borders. Their areas are those of the regions to 1e-12 of
// the surface's.
//
// Throws std::invalid_argument for a size that is not positive; for a plate that goes over a
// knuckle, naming the place; for a curve that has the same plate on both sides, as one that ends
// within a plate, unless these are left out; and as require_on() of the curves.
Plating plating(const surface::LimitSurface& surface, std::vector<SurfaceCurve> curves,
                const PlatingOptions& options);

}  // namespace hull::production
