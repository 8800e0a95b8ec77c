// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "analysis/derivatives/surface_adjoint.h"
#include "analysis/immersion/closings.h"
#include "analysis/immersion/piece_moments.h"

namespace hull::analysis {

// Adds what closings have in the derivatives of `numbers` numbers to the sum. They move with the
// border that they close: athwartships ones with its x and z (along y they slide within
// themselves), fans with the border and with its centroid. `by_points(points, columns)` adds the
// derivatives by the 16 points of a closing's span. `border` and its `closings` are those of a
// body, one for each edge.
using SpanDerivatives = std::function<void(const surface::BicubicPoints&, PointColumns&)>;
void add_closing_derivatives(const std::vector<BorderEdge>& border,
                             const std::vector<ClosingPatch>& closings, int numbers,
                             const SpanDerivatives& by_points, SurfaceAdjoint::Sum& sum);

}  // namespace hull::analysis
