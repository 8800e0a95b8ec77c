// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/immersion/hull_body.h"

namespace hull::bindings {

// "closed" or "open"; std::invalid_argument for what is neither.
analysis::Openings openings_from(const std::string& name);

}  // namespace hull::bindings
