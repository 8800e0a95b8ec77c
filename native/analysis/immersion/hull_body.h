// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/immersion/bodies.h"
#include "analysis/immersion/closings.h"
#include "analysis/immersion/corner_moments.h"
#include "analysis/immersion/cut_moments.h"
#include "analysis/immersion/immersion.h"
#include "surface/limit_surface.h"

namespace hull {

// How the openings of a shell are taken (closings.h tells which are open at all): they let the
// water in, or are covered, as by a weathertight deck.
enum class Openings { kOpen, kClosed };

// A limit surface as the shell of a floating body, for many waters: what does not depend on the
// water is computed once. Its bodies, if they are several, add up.
//
// Polynomial integrands (volume, its moments, waterplane) are integrated exactly where the water
// does not cut, and to about 1e-13 of the whole where it does; the wetted surface to about 1e-9.
// Estimates come with the results. Queries are thread-safe among themselves.
class HullBody {
 public:
  // `mirrored`: the surface is the port half (y >= 0) and counts twice. `surface` must outlive the
  // body.
  HullBody(const LimitSurface& surface, bool mirrored, Openings openings = Openings::kClosed);

  // To be called after surface.set_points().
  void update();

  const LimitSurface& surface() const { return *surface_; }
  bool mirrored() const { return mirrored_; }
  Openings openings() const { return openings_; }
  // What closes the shell, on the modelled side.
  const std::vector<ClosingSpan>& closings() const { return closings_; }

  // Of the whole shell without closings, both sides, about the origin.
  ShellMoments shell_moments() const;

  // Of both sides; the wetted surface without closings. Throws std::invalid_argument if the plane
  // is not finite, if the water rises above an opening that is not closed ("floods at …"), and if
  // the faces of a body are turned inwards.
  Immersion immersion(const Plane& water) const;

  // Of the openings that are not closed, on both sides.
  FloodingPoint flooding_point(const Vector3d& up) const;
  double lowest_opening(const Vector3d& up) const { return flooding_point(up).height; }

 private:
  // A part of the shell whose moments are known: a bicubic span, or the square at an irregular
  // knot.
  struct Part {
    // A box around its control points, positions counted from centre_.
    Vector3d middle = Vector3d::Zero(), half = Vector3d::Zero();
    ShellMoments moments;
  };
  void place(Part& part, const Vector3d* points, std::size_t count) const;
  std::string inversion() const;
  void refuse_flooding(const Plane& water) const;

  template <class Cut>
  void add_wet(const std::vector<Part>& parts, const Plane& water, const Cut& cut,
               ShellMoments& sum) const;
  struct Wet {
    ShellMoments shell, caps;
  };
  Wet wet_part(const Plane& water) const;
  ShellMoments wet_corner(int corner, const Plane& water) const;
  const CornerSeries& series(int corner) const;

  const LimitSurface* surface_;
  bool mirrored_;
  Openings openings_;
  Vector3d centre_;
  CornerTolerance corner_tolerance_;
  CutTolerance cut_tolerance_;
  std::map<const CornerBasis*, CornerSeries> series_;
  std::vector<ClosingSpan> closings_;
  Bodies bodies_;
  std::vector<Part> leaves_, corners_, caps_;
  std::string inversion_;  // what is wrong with the direction of faces; empty if nothing is
};

}  // namespace hull
