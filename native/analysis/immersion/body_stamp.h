// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// What surface::SurfaceStamp is of a surface, of a body: what keeps some of its numbers and asks it
// for others must not do so once it was updated, or something else was joined to it.
class BodyStamp {
 public:
  // `body` must outlive the stamp. Throws std::invalid_argument if it is out of date.
  explicit BodyStamp(const HullBody& body) : body_(&body), version_(body.version()) {
    body.boxes();  // refuses
  }

  const HullBody& body() const { return *body_; }
  bool is_current() const { return version_ == body_->version() && body_->is_current(); }
  // Throws std::invalid_argument; `what` was computed, as "The heeling path".
  void require_current(const char* what) const {
    if (is_current()) return;
    throw std::invalid_argument(
        std::string(what) + " is out of date: " +
        (body_->is_current() ? "the body was updated, or joined to others, since. Make it anew."
                             : "the surface's points were set since. Call the body's update() and "
                               "make it anew."));
  }

 private:
  const HullBody* body_;
  int version_;
};

}  // namespace hull::analysis
