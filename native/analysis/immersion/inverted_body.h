// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "analysis/immersion/bodies.h"

namespace hull::analysis {

// What is said of a body whose volume is negative. Mostly its faces are turned inwards; where its
// border lies along that of another body, it may be a sheet torn off that instead, whose volume is
// that of its own closing: turning it would not help, joining it to the other does.
std::string inverted_body_text(const surface::LimitSurface& surface, const Bodies& bodies,
                               int body);

}  // namespace hull::analysis
