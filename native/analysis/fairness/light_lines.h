// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "analysis/fairness/level_curves.h"

namespace hull::analysis {

// From where a surface is seen: along parallel rays, or from a point.
struct Eye {
  Vector3d direction = Vector3d::Zero();  // from the hull to the eye, if it is far away
  std::optional<Vector3d> point;          // m
  // Unit vector from a point of the hull to the eye.
  Vector3d from(const Vector3d& p) const;
};

// Parallel straight lines of light, as tubes in a hall, that are seen mirrored in the hull (Klass
// 1980, "Correction of local surface irregularities using reflection lines"). Line k is k spacings
// beside line 0; they are numbered across, along line_direction x light_direction.
struct LightBank {
  Vector3d line_direction = Vector3d::UnitX();   // of the lines
  Vector3d light_direction = Vector3d::UnitZ();  // from the hull to line 0
  // m from the origin to the plane of the lines, which is across light_direction, with line 0 right
  // above the origin; without it they are infinitely far away.
  std::optional<double> distance;
  double spacing = 0.1;  // m; of lines infinitely far away the angle between them, radians
  double phase = 0.0;    // the bank is moved by so many spacings
  Eye eye;
  std::optional<int> lines;  // to each side of line 0; by default those above the horizon, or 20
};

// The number, with fractions, of the line that is seen at a point of the surface: greater on line
// 1's side of line 0. NaN where no light can be seen: for lines at a distance where the ray goes
// away from their plane, for others where it goes along the lines. Lines infinitely far away have
// numbers all around: from -period/2 to period/2.
class LightLines {
 public:
  // Throws std::invalid_argument for directions of no length, lines along light_direction, a
  // spacing or a distance not above zero, and no eye.
  explicit LightLines(const LightBank& bank);

  double operator()(const Vector3d& point, const Vector3d& normal) const;
  double period() const { return period_; }
  // The numbers of all lines.
  std::vector<double> numbers() const;

 private:
  LightBank bank_;
  Vector3d up_, across_;
  double period_;
};

// The curves in which the lines of light are seen; `level` is the number of the line. Back sides
// have theirs, too: what hides them is not looked at.
std::vector<LevelCurve> reflection_lines(const surface::LimitSurface& surface,
                                         const LightBank& bank, const LevelOptions& options);

// Curves along which the normal has an angle (radians, between 0 and π) to a direction, of any
// length but zero: `level` is the angle (Poeschl 1984, "Detecting surface irregularities using
// isophotes").
std::vector<LevelCurve> isophotes(const surface::LimitSurface& surface, const Vector3d& direction,
                                  const std::vector<double>& angles, const LevelOptions& options);

// The outline of the surface as seen: where it is smooth, and turns away from the eye; and parts of
// creases with one side turned to the eye and one away. What lies behind other parts is given, too;
// borders are not.
std::vector<LevelCurve> silhouette(const surface::LimitSurface& surface, const Eye& eye,
                                   const LevelOptions& options);

}  // namespace hull::analysis
