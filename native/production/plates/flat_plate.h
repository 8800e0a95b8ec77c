// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "production/plates/edge_development.h"
#include "production/plates/plate_mesh.h"
#include "production/plates/strain_energy.h"

namespace hull::production {

// How a plate became flat.
enum class Expansion {
  kDeveloped,  // isometric: the surface is developable there
  kStretched   // by the least strain energy
};

// A part of a curve that lies on a plate.
struct FlatMark {
  std::vector<Eigen::Vector2d> points;  // m
  std::vector<Vector3d> on_hull;        // the same points on the surface
};

// A line of the plane about which the two halves of a plate across the centre plane are mirror
// images.
struct FlatAxis {
  Eigen::Vector2d at, along;
  Eigen::Vector2d mirrored(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d q = p - at;
    return at + 2.0 * along.dot(q) * along - q;
  }
};

// A plate laid out on a plane, as seen from the water, its longer way along x.
struct FlatPlate {
  Expansion expansion;
  PlateMesh mesh;
  // Of the mesh, m; the box around them begins in (0, 0). Of a plate across the centre plane those
  // of the mesh's side, then as many of the other one.
  std::vector<Eigen::Vector2d> nodes;
  std::vector<PlaneFrame> frames;  // of nodes that are corners, where it was developed
  std::optional<SheetMap> map;     // to a plane that is turned and shifted by:
  Eigen::Rotation2Dd turn{0.0};
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  std::optional<FlatAxis> axis;  // of a plate across the centre plane
  double area;                   // m²
  // In triangles' corners, their middles and those of their sides, of all directions: length on the
  // hull over length on the flat plate.
  double least_stretch, largest_stretch;
  // How far these may be off, by what halving the splines' cells changed in them: the last change,
  // or where changes fell by half or more the rest of a geometric series.
  double stretch_error = 0.0;
  // By triangle, in its middle: the two principal stretches, smaller first.
  std::vector<Eigen::Vector2d> stretches;
  // Direction, from x, about which the plate is bent the most: that in which rolls lie. rad in
  // (-π/2, π/2]; 0 for a plane.
  double rolling_angle;
  // Radius of that bend, m; infinite for a plane. Mean over the plate.
  double rolling_radius;
  int iterations;  // of the least energy
  // Whether the energy is the least to rounding, and stretch_error below 0.0005.
  bool converged;
};

// Lays a plate out: isometrically, where going round each of its triangles shows no curvature to
// speak of (1e-9 of its size), otherwise so that the energy of an elastic sheet strained from the
// plane to the surface is least,
//
//   W = ∫ (ε1² + ε2² + 2 ν ε1 ε2 + 2 (1 - ν) ε12²) dA,   ε = RᵀF - I,
//
// plane stress with Poisson's ratio ν (Timoshenko and Goodier 1951), F the derivative of the
// plane's point by lengths on the exact surface and R the nearest rotation. The map is of cubic
// B-splines over a chart of the plate, whose cells are halved until the stretch no longer changes;
// seams, and the triangles that they leave, only bound what is integrated. By Gauss and Newton's
// method.
//
// Throws std::invalid_argument for a plate that is closed around the hull, or so far bent round
// that no chart has it; it may have holes. And for a Poisson's ratio outside of [0, 0.5].
FlatPlate flat_plate(const Plating& plating, const Plate& plate, double poisson = 0.3);

// A plate's sides laid out, by loop and side as Plate::loops; with the points between.
std::vector<std::vector<std::vector<Eigen::Vector2d>>> flat_sides(const FlatPlate& flat,
                                                                  const Plate& plate);

// The parts of a curve on the surface that lie within the plate; of a plate across the centre plane
// their mirror images, too.
std::vector<FlatMark> flat_marks(const FlatPlate& flat, const SurfaceCurve& curve);

// Where a place of the surface is on the flat plate; none where it is not on the plate. Of a plate
// across the centre plane the surface has one side.
std::optional<Eigen::Vector2d> flat_place(const FlatPlate& flat, const CellPlace& place);

}  // namespace hull::production
