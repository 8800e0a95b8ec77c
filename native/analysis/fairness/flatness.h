// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// How flat a part of the surface is that is meant to be.
struct Flatness {
  Plane plane;
  double surface_distance = 0.0;              // largest, of the part's surface, m …
  Vector3d surface_point = Vector3d::Zero();  // … and where
  double control_distance = 0.0;              // largest, of the part's control points, m
  std::vector<int> vertices;                  // the part's control points, rising …
  std::vector<double> distances;              // … and how high each is above the plane, m
  std::vector<int> at_fault;                  // those further than the tolerance
  // Control points around the part that bend its rim, further than the tolerance: a face is flat
  // only if those around it are, unless creases part them.
  std::vector<int> neighbours_at_fault;
};

struct FlatPart {
  std::vector<int> faces;     // of the control mesh
  std::vector<int> vertices;  // those of the faces, or more
};
// REQUIRES of neither: the faces with all their control points, …
FlatPart flat_part_of_faces(const surface::LimitSurface& surface, std::vector<int> faces);
// … the control points, with the faces all of whose corners are among them. Both throw
// std::invalid_argument for indices that the mesh has not, and for none at all.
FlatPart flat_part_of_vertices(const surface::LimitSurface& surface, std::vector<int> vertices);

// Distances from the plane; without one from that which most of the part's control points lie in:
// the least sum of distances, so that a few points at fault do not tilt it, and then the least
// squares of those within the tolerance. The surface's distance is the largest to 1e-9 of the
// mesh's size. Throws std::invalid_argument for a tolerance that is not above zero, and, without a
// plane, for fewer than three control points or such in a line.
Flatness flatness(const surface::LimitSurface& surface, const FlatPart& part,
                  const std::optional<Plane>& plane, double tolerance);

}  // namespace hull::analysis
