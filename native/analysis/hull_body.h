// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion.h"
#include "surface/limit_surface.h"

namespace hull {

// A limit surface as the shell of a floating body, for many waters: what does not depend on the
// water is computed once.
class HullBody {
 public:
  // `mirrored`: the surface is the port half (y >= 0) and counts twice. `surface` must outlive the
  // body. Throws std::invalid_argument if faces are turned inwards.
  HullBody(const LimitSurface& surface, bool mirrored);

  // To be called after surface.set_points().
  void update();

  const LimitSurface& surface() const { return *surface_; }
  bool mirrored() const { return mirrored_; }

  // Both sides. Throws std::invalid_argument if the plane is not finite.
  Immersion immersion(const Plane& water) const;

 private:
  const LimitSurface* surface_;
  bool mirrored_;
};

}  // namespace hull
