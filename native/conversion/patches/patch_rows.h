// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "conversion/patches/bspline_patch.h"

namespace hull::conversion {

// The patch whose rows along u, taken as curves, are changed; `change` does the same to the knots
// of every row.
BSplinePatch with_rows_along_u(const BSplinePatch& patch,
                               const std::function<BSplineCurve(const BSplineCurve&)>& change);

// The same along v.
BSplinePatch with_rows_along_v(const BSplinePatch& patch,
                               const std::function<BSplineCurve(const BSplineCurve&)>& change);

}  // namespace hull::conversion
