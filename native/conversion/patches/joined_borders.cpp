// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/joined_borders.h"

#include <cmath>
#include <cstddef>

namespace hull::conversion {
namespace {

struct Side {
  int patch = -1, side = -1;
};

// Whether two sides that run against one another have the same knots. Turned patches have knots 1 -
// t, which is rounded.
bool have_same_knots(const BSplinePatch& one, int side, const BSplinePatch& two, int other) {
  constexpr double kRounding = 1e-15;
  const std::vector<double> a = one.side_knots(side), b = two.side_knots(other);
  if (a.size() != b.size() || one.side_degree(side) != two.side_degree(other)) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(std::abs(a[i] + b[b.size() - 1 - i] - 1.0) <= kRounding)) return false;
  }
  return true;
}

}  // namespace

void join_borders(PatchSet& set) {
  std::vector<Side> first(set.edge_count);
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      // Control points of a side of several edges belong to more than one of them.
      if (set.sides[p][k].size() != 1) continue;
      Side& known = first[set.sides[p][k].front().edge];
      if (known.patch < 0) {
        known = {p, k};
        continue;
      }
      const BSplinePatch& from = set.patches[known.patch];
      BSplinePatch& to = set.patches[p];
      if (!have_same_knots(from, known.side, to, k)) continue;
      // Neighbours run along their edge the other way.
      const int last = to.side_count(k) - 1;
      for (int i = 0; i <= last; ++i) {
        to.control_points[to.side_index(k, i)] =
            from.control_points[from.side_index(known.side, last - i)];
      }
    }
  }
}

}  // namespace hull::conversion
