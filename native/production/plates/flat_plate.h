// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "production/plates/edge_development.h"
#include "production/plates/plate_mesh.h"

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

// A plate laid out on a plane, as seen from the water, its longer way along x.
struct FlatPlate {
  Expansion expansion;
  PlateMesh mesh;
  std::vector<Eigen::Vector2d> nodes;  // of the mesh, m; the box around them begins in (0, 0)
  std::vector<PlaneFrame> frames;      // of nodes that are corners, where it was developed
  double area;                         // m²
  // In the middles of triangles and of their sides, of all directions: length on the hull over
  // length on the flat plate. Triangles thinner than thin_height() are left out.
  double least_stretch, largest_stretch;
  // By triangle, in its middle: the two principal stretches, smaller first.
  std::vector<Eigen::Vector2d> stretches;
  // Direction, from x, about which the plate is bent the most: that in which rolls lie. rad in
  // (-π/2, π/2]; 0 for a plane.
  double rolling_angle;
  // Radius of that bend, m; infinite for a plane. Mean over the plate.
  double rolling_radius;
  int iterations;  // of the least energy
  bool converged;
};

// Lays a plate out: isometrically, where going round each of its triangles shows no curvature to
// speak of (1e-9 of its size), otherwise so that the energy of an elastic sheet strained from the
// plane to the surface is least,
//
//   W = ∫ (ε1² + ε2² + 2 ν ε1 ε2 + 2 (1 - ν) ε12²) dA,   ε = RᵀF - I,
//
// plane stress with Poisson's ratio ν (Timoshenko and Goodier 1951), F the derivative of the
// plane's point by lengths on the exact surface and R the nearest rotation, in quadratic elements,
// by Gauss and Newton's method.
//
// Throws std::invalid_argument for a plate that is not a disc: with a hole, or closed around the
// hull; and for a Poisson's ratio outside of [0, 0.5].
FlatPlate flat_plate(const Plating& plating, const Plate& plate, double poisson = 0.3);

// A plate's sides laid out, by loop and side as Plate::loops; with the points between.
std::vector<std::vector<std::vector<Eigen::Vector2d>>> flat_sides(const FlatPlate& flat,
                                                                  const Plate& plate);

// The parts of a curve on the surface that lie within the plate.
std::vector<FlatMark> flat_marks(const FlatPlate& flat, const SurfaceCurve& curve);

// Where a place of the surface is on the flat plate; none where it is not on the plate.
std::optional<Eigen::Vector2d> flat_place(const FlatPlate& flat, const CellPlace& place);

}  // namespace hull::production
