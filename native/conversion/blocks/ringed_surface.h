// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "surface/eigenbasis/corner_basis.h"
#include "surface/limit_surface.h"

namespace hull::conversion {

// A surface that is asked for many points close to its irregular ones. There LimitSurface computes
// each from the eigenbasis, which takes the longer the more faces meet; this keeps the bicubic
// spans of the rings around them, once computed. Values differ by rounding of the mesh's size.
//
// Not for several threads at once. REQUIRES: the surface outlives this, and its points stay.
class RingedSurface {
 public:
  explicit RingedSurface(const surface::LimitSurface& surface) : surface_(surface) {}

  const mesh::Topology& cells() const { return surface_.cells(); }
  // As those of LimitSurface.
  Vector3d position(int cell, double u, double v) const;
  surface::SurfaceJet evaluate(int cell, double u, double v, int order) const;

 private:
  // Around one corner, from the largest inwards.
  struct Rings {
    surface::CornerRing walk;
    std::vector<surface::BicubicPoints> spans;
  };
  const surface::BicubicPoints& span(int corner, int ring, int segment) const;

  const surface::LimitSurface& surface_;
  mutable std::map<int, Rings> rings_;  // by corner of the layout
};

}  // namespace hull::conversion
