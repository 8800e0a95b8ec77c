// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/line_rule.h"

namespace hull::analysis {

const GaussRule& gauss(SpanRule rule) {
  static const PerRule<GaussRule> rules(
      [](SpanRule which) { return gauss_rule(static_cast<int>(which)); });
  return rules[rule];
}

LineRule::LineRule(const GaussRule& rule, double begin, double size)
    : count(static_cast<int>(rule.nodes.size())) {
  for (int i = 0; i < count; ++i) {
    value[i] = surface::cubic_basis(begin + size * rule.nodes[i]);
    slope[i] = surface::cubic_basis_d1(begin + size * rule.nodes[i]);
    weights[i] = rule.weights[i] * size;
    for (int a = 0; a < 4; ++a) {
      values[a][i] = value[i][a];
      slopes[a][i] = slope[i][a];
    }
  }
}

const LineRule& LineRule::whole(SpanRule rule) {
  static const PerRule<LineRule> lines(
      [](SpanRule which) { return LineRule(gauss(which), 0.0, 1.0); });
  return lines[rule];
}

}  // namespace hull::analysis
