// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/derivatives/span_derivatives.h"

namespace hull::analysis {

// add_immersion_derivatives() of a span that is wholly below the water, which most are. REQUIRES: a
// rule of at most 8 nodes.
void add_whole_span(const surface::BicubicPoints& points, const ImmersionFrame& frame,
                    SpanRule rule, PointColumns& sum);

}  // namespace hull::analysis
