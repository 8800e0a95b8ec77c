// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

#include "analysis/immersion/hull_body.h"

namespace hull::bindings {

// "closed" or "open"; std::invalid_argument for what is neither.
inline analysis::Openings openings_from(const std::string& name) {
  if (name == "closed") return analysis::Openings::kClosed;
  if (name == "open") return analysis::Openings::kOpen;
  throw std::invalid_argument("openings is \"closed\" or \"open\", not \"" + name + "\".");
}

}  // namespace hull::bindings
