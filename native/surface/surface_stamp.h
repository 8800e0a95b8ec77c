// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "surface/limit_surface.h"

namespace hull::surface {

// Which points of a surface something was computed of: what keeps parts of a surface and asks it
// for others must not do so after set_points() before it was updated or made anew, as old and new
// would mix.
class SurfaceStamp {
 public:
  // `surface` must outlive the stamp.
  explicit SurfaceStamp(const LimitSurface& surface)
      : surface_(&surface), revision_(surface.revision()) {}

  // After everything was computed again.
  void renew() { revision_ = surface_->revision(); }

  const LimitSurface& surface() const { return *surface_; }
  int revision() const { return revision_; }
  bool is_current() const { return revision_ == surface_->revision(); }
  // Throws std::invalid_argument; `what` was computed, as "The body", and `remedy` mends it.
  void require_current(const char* what, const char* remedy = "Call update() first.") const {
    if (is_current()) return;
    throw std::invalid_argument(std::string(what) +
                                " is out of date: the surface's points were set since. " + remedy);
  }

 private:
  const LimitSurface* surface_;
  int revision_;
};

}  // namespace hull::surface
