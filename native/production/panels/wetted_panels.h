// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "analysis/immersion/floating_position.h"
#include "analysis/immersion/hull_body.h"
#include "production/panels/panel_sizes.h"
#include "surface/progress.h"

namespace hull::production {

// The wetted hull as flat panels for programs that compute waves and motions. Coordinates are those
// of the water: z up from its surface, x forward along it, y to port.
struct PanelMesh {
  std::vector<Vector3d> points;  // m
  // Counter-clockwise seen from the water, so that normals point into it; the last corner of a
  // triangle is there twice.
  std::vector<std::array<int, 4>> panels;
  // By point: in the water's surface, where z is exactly 0; such points are exactly on the hull's
  // waterline, but for those on closings, which are straight between two of the hull's points.
  std::vector<char> at_water;
  bool half = false;  // the port half alone, the plane y = 0 being one of symmetry
  // A point p of the ship is at axes · (p - origin).
  Vector3d origin = Vector3d::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  // Exact, m³: of both sides of the hull's own surface, which is what has panels, without bodies
  // that are joined to it; its own bodies add up.
  double displaced_volume = 0.0;

  // ∫ x n_x, ∫ y n_y, ∫ z n_z over all panels, both halves, m³: with the water's surface they
  // close a body, so that all three are its volume. Of a panel with four corners that are not in a
  // plane the mean of both ways to cut it in triangles.
  Vector3d volumes() const;
  double area() const;  // of both halves, m²
};

// Panels of the hull's own surface below the water, closings included where they are in the water;
// what is joined to the body has none (HullBody::join()). A half hull
// that does not heel is one half with its symmetry, else all of it is there. `origin_x`: the origin
// is the water's nearest point to (origin_x, 0, 0) of the ship.
//
// Sides of panels that pass the water's surface end where the exact surface does; corners near it
// are moved there, along lines of the surface. Where a border runs athwartships, as above a
// transom, closing lines run along it: what lies between them has no area and is left out. Volumes
// are off by the square of the panels' size.
//
// Throws std::invalid_argument for sizes that are none, for a hull out of the water, and as
// HullBody::immersion().
PanelMesh wetted_panels(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                        const PanelSizes& sizes, double origin_x = 0.0,
                        const surface::Progress& progress = {});

}  // namespace hull::production
