// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "conversion/blocks/near_point.h"

namespace hull::conversion {

// The largest of some values and where it was met.
struct Worst {
  double value = 0.0;
  // m, on the patch, or midway between two; NaN where nothing was measured.
  Vector3d point = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  CellPoint place;  // of the surface; cell -1 where nothing was measured

  bool is_measured() const { return place.cell >= 0 || point.allFinite(); }
  void take(double other, const Vector3d& at, const CellPoint& where) {
    if (is_measured() && !(other > value)) return;
    *this = {other, at, where};
  }
  void take(const Worst& other) {
    if (other.is_measured()) take(other.value, other.point, other.place);
  }
};

struct PatchQuality {
  int cells = 0;              // 0: it stands for none, and has no distance
  Worst distance;             // m; `place` is that of the point found on the surface
  double rms_distance = 0.0;  // m, over its area
  double area = 0.0;          // m2
  double exact_area = 0.0;    // m2, of the intervals without a distance above kExactDistance
  int knot_count = 0;         // distinct, in u and v together
  int control_point_count = 0;
};

// What two patches share.
struct SeamQuality {
  int edge = -1;
  std::array<int, 2> patches{-1, -1};
  // Whether the exact surface has a tangent plane all along it: no crease, and no edge of a patch
  // that stands for no cells. Elsewhere only gaps are measured.
  bool is_smooth = false;
  Worst gap;  // m, from points of one curve to the other
  // rad, between the normals of the patches; farther than QualityReport::normal_reach from
  // irregular points, and nearer.
  Worst angle, angle_at_points;
  // 1/m, of the normal curvature in the direction across the seam; the same two.
  Worst curvature_jump, curvature_jump_at_points;

  // Takes over every value that is larger there.
  void take_values(const SeamQuality& other);
};

// How far patches are from the surface that they stand for, as measured by measure_quality().
struct QualityReport {
  // Of the length: where no more is measured, patches count as exact.
  static constexpr double kExactDistance = 1e-12;

  double length = 0.0;        // m, the largest extent of the control mesh
  double normal_reach = 0.0;  // m, around irregular points

  Worst distance;             // m, from points of patches to near points of the surface
  double rms_distance = 0.0;  // m, over the area
  double area = 0.0;          // m2, of the patches that stand for cells
  double exact_share = 0.0;   // of that area
  // The worst of all seams, each of its values with its own place.
  SeamQuality worst_seams;

  int theoretical_patch_count = 0;  // the least that creases and irregular points allow, as counted
  int knot_count = 0;               // distinct, of all patches
  int control_point_count = 0;
  std::vector<PatchQuality> patches;
  std::vector<SeamQuality> seams;

  double distance_per_length() const { return length > 0.0 ? distance.value / length : 0.0; }

  // A table for people: millimetres, degrees, places in metres.
  std::string text() const;
  // All of it as a JSON object; units are in the names, what was not measured is null.
  std::string json() const;
};

}  // namespace hull::conversion
