// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/appendages/appendage.h"
#include "exchange/solids/brep_shape.h"
#include "surface/progress.h"

namespace hull::exchange {

// The hull's solid with appendages joined to it and cut out of it, by Open CASCADE's Boolean
// operations. Faces that are parts of the hull's keep its regions; others have the names of the
// appendages. Throws std::invalid_argument where there is no solid, or the result is none that is
// valid.
void join_appendages(BRepShape& hull, std::vector<std::string>& regions,
                     const std::vector<analysis::Appendage>& appendages,
                     const surface::Progress& progress);

}  // namespace hull::exchange
