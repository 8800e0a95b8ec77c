// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// A body with all its openings closed: itself, or if it has open ones a twin without. How a ship
// heels and rests is computed of this, and then where she floods.
class Weathertight {
 public:
  // `body` must outlive this.
  explicit Weathertight(const HullBody& body) : body_(&body) {
    if (body.openings() == Openings::kClosed) return;
    twin_.emplace(body.closed());
    body_ = &*twin_;
  }
  Weathertight(const Weathertight&) = delete;
  Weathertight& operator=(const Weathertight&) = delete;

  const HullBody& body() const { return *body_; }

 private:
  std::optional<HullBody> twin_;
  const HullBody* body_;
};

}  // namespace hull::analysis
