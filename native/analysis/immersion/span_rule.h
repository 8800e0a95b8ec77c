// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "analysis/arithmetic/gauss.h"

namespace hull::analysis {

// Number of Gauss nodes in each direction. The highest polynomial integrand, a second moment, has
// degree 3 + 3 + 5 = 11 in u and in v: six nodes are exact. Five are exact for volumes (degree 8).
// Fewer serve for small pieces, and where 1e-9 of a span's share will do.
enum class SpanRule { kExact = 6, kVolume = 5, kSmall = 4, kSmallest = 3 };
const GaussRule& gauss(SpanRule rule);

// One value for each rule.
template <class Value>
class PerRule {
 public:
  template <class Make>
  explicit PerRule(const Make& make)
      : values_{make(SpanRule::kSmallest), make(SpanRule::kSmall), make(SpanRule::kVolume),
                make(SpanRule::kExact)} {}
  const Value& operator[](SpanRule rule) const {
    return values_[static_cast<int>(rule) - static_cast<int>(SpanRule::kSmallest)];
  }

 private:
  std::array<Value, 4> values_;
};

}  // namespace hull::analysis
