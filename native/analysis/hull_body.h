// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "analysis/corner_moments.h"
#include "analysis/cut_moments.h"
#include "analysis/immersion.h"
#include "surface/limit_surface.h"

namespace hull {

// A limit surface as the shell of a floating body, for many waters: what does not depend on the
// water is computed once.
//
// Polynomial integrands (volume, its moments, waterplane) are integrated exactly where the water
// does not cut, and to about 1e-13 of the whole where it does; the wetted surface to about 1e-9.
// Estimates come with the results. Queries are thread-safe among themselves.
class HullBody {
 public:
  // `mirrored`: the surface is the port half (y >= 0) and counts twice. `surface` must outlive the
  // body.
  HullBody(const LimitSurface& surface, bool mirrored);

  // To be called after surface.set_points().
  void update();

  const LimitSurface& surface() const { return *surface_; }
  bool mirrored() const { return mirrored_; }

  // Of both sides. Throws std::invalid_argument if the plane is not finite.
  Immersion immersion(const Plane& water) const;

 private:
  // A box around control points, positions counted from centre_.
  struct Box {
    Vector3d middle = Vector3d::Zero(), half = Vector3d::Zero();
  };
  static Box box_of(const Vector3d* points, std::size_t count, const Vector3d& centre);

  ShellMoments wet_part(const Plane& water) const;
  ShellMoments wet_corner(int corner, const Plane& water) const;
  const CornerSeries& series(int corner) const;

  const LimitSurface* surface_;
  bool mirrored_;
  Vector3d centre_;
  CornerTolerance corner_tolerance_;
  CutTolerance cut_tolerance_;
  std::map<const CornerBasis*, CornerSeries> series_;
  std::vector<Box> leaf_boxes_, corner_boxes_;
  std::vector<ShellMoments> leaf_moments_, corner_moments_;
};

}  // namespace hull
