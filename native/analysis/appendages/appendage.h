// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "analysis/appendages/closed_shell.h"
#include "analysis/appendages/section_form.h"

namespace hull::analysis {

// A circular cylinder, or a cone with its tip cut off, between two points: a bow thruster's tunnel,
// a stern tube, a shaft, a trunk. 64 cubics make a circle to 2e-11 of its radius.
struct CylinderShape {
  Vector3d start, end;
  double start_radius, end_radius;  // m
};

// A body of straight lines between two sections, root and tip: a keel, rudder, skeg, bracket. Both
// lie in planes of the chord's and the thickness' directions. The outline of a section is a cubic
// spline in √x, within 1e-6 of the chord of the form.
struct FoilShape {
  std::string section;
  Vector3d root, tip;            // leading edges
  Vector3d chord_direction;      // from the leading to the trailing edge
  Vector3d thickness_direction;  // to the upper side
  double root_chord, tip_chord;  // m
  // Of the chord; 0: that of the section.
  double root_thickness = 0.0, tip_thickness = 0.0;
};

// A body of revolution with a section's thickness: a bulb of a keel, a pod.
struct BulbShape {
  std::string section;
  Vector3d nose, tail;
  double diameter;  // m, the largest
};

using AppendageShape = std::variant<CylinderShape, FoilShape, BulbShape>;

// A body that is joined to a hull, or cut out of it.
struct Appendage {
  std::string name;
  AppendageShape shape;
  bool is_cut = false;
  // On port too, or on starboard, as its mirror image.
  bool mirrored = false;
};

// The spline of an outline, C¹: segment i by its Bézier points, from the trailing edge along the
// upper side to the leading edge, and back along the lower one. Chord 1, or half the outline of a
// body of revolution by `upper_only`.
std::vector<std::array<Eigen::Vector2d, 4>> outline_of(const SectionForm& form, double thickness,
                                                       bool upper_only);

// The surface of a shape. Throws std::invalid_argument for lengths that are not positive, negative
// thicknesses, numbers that are not finite, and directions along one another.
ClosedShell shell_of(const AppendageShape& shape);
ClosedShell mirror_image(const ClosedShell& shell);

}  // namespace hull::analysis
