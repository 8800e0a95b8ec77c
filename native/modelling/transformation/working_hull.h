// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "analysis/immersion/floating_position.h"
#include "analysis/immersion/hull_body.h"
#include "analysis/stations/section_areas.h"

namespace hull::modelling {

// A copy of a body in its water whose control points are moved to see what comes of it. Not for
// several threads at a time.
class WorkingHull {
 public:
  // The position must be without heel. Throws std::invalid_argument where it is not, and where
  // nothing of the body is immersed.
  WorkingHull(const analysis::HullBody& body, const analysis::FloatingPosition& position);
  WorkingHull(const WorkingHull&) = delete;
  WorkingHull& operator=(const WorkingHull&) = delete;

  const surface::LimitSurface& surface() const { return surface_; }
  const analysis::Plane& water() const { return water_; }
  // Control points as given.
  const std::vector<Vector3d>& points() const { return points_; }
  // Ends of the immersed shell as given, x, m.
  const std::pair<double, double>& immersed_range() const { return immersed_range_; }
  // What is computed of the immersed body as given.
  double volume() const { return volume_; }

  // Moves of all control points from where they were as given; the same as last time cost nothing.
  void move(const std::vector<Vector3d>& moves);

  // Of the hull as moved last; asked again it costs nothing. The wetted surface is not measured.
  const analysis::Immersion& immersion() const;
  double section_area(double x) const;
  std::vector<analysis::SectionArea> sections(const std::vector<double>& positions) const;

 private:
  surface::LimitSurface surface_;
  analysis::Plane water_;
  analysis::HullBody body_;
  std::vector<Vector3d> points_, moves_;
  mutable std::optional<analysis::Immersion> immersion_;
  std::pair<double, double> immersed_range_;
  double volume_;
};

}  // namespace hull::modelling
