// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "modelling/transformation/longitudinal_reshape.h"
#include "modelling/transformation/working_hull.h"

namespace hull::modelling {

// Moves the surface along the normals of its sections, by an amount that depends on x: sections
// are inflated, or deflated where it is negative. A circle stays one, but for what the control
// points cannot do. Where the surface runs across the ship, as in a transom, a section has no
// normal to speak of: there the shift fades.
//
// Rigid groups and locked points stay. Immutable.
class NormalReshape {
 public:
  // Throws std::invalid_argument as Reshape does.
  NormalReshape(const surface::LimitSurface& surface, const TransformLimits& limits);

  // `amount`: outwards, of a place at x, m.
  Reshaped solve(const std::function<double(double x)>& amount) const;

  const SurfacePlaces& places() const { return reshape_.places(); }

 private:
  Reshape reshape_;
  std::vector<Vector3d> directions_;  // by place
};

// A section that was brought to an area.
struct Inflated {
  std::vector<Vector3d> moves;  // of all control points, m
  double amount;                // by which it was inflated, m
  double area;                  // m², of the resulting surface's immersed section
  double rms, largest;          // of the wanted shifts less what the surface does, m
  Vector3d largest_place;       // where on the surface as it was
  int iterations;
  bool converged;  // the area is met to 1e-10 of itself
};

// Brings the immersed section at x = place, m, to `area`, m². Sections beside it are inflated with
// it, less and less, up to `extent`, m, on either side; all by the same amount where that is
// infinite. Throws std::invalid_argument for what cannot be reached.
Inflated inflate(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                 double place, double area, double extent, const TransformLimits& limits);

}  // namespace hull::modelling
