// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "analysis/immersion/span_rule.h"
#include "surface/pieces/bicubic.h"

namespace hull::analysis {

// Cubic basis functions at the nodes of a Gauss rule on an interval, node by node, and for each
// function; beyond the last node they are zero, and so are weights.
struct LineRule {
  static constexpr int kMostNodes = 8;

  LineRule(const GaussRule& rule, double begin, double size);
  // On all of a span's side.
  static const LineRule& whole(SpanRule rule);

  int count = 0;
  alignas(32) std::array<surface::Basis, kMostNodes> value{}, slope{};
  alignas(32) std::array<std::array<double, kMostNodes>, 4> values{}, slopes{};
  alignas(32) std::array<double, kMostNodes> weights{};
};

}  // namespace hull::analysis
