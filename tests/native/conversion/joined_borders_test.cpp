// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/joined_borders.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "conversion/exact/exact_conversion.h"
#include "conversion/patches/edge_uses.h"
#include "test_meshes.h"

namespace hull::conversion {
namespace {

// The largest move of a control point, m.
double largest_move(const PatchSet& one, const PatchSet& two) {
  double largest = 0.0;
  for (std::size_t p = 0; p < one.patches.size(); ++p) {
    for (std::size_t i = 0; i < one.patches[p].control_points.size(); ++i) {
      largest = std::max(
          largest, (one.patches[p].control_points[i] - two.patches[p].control_points[i]).norm());
    }
  }
  return largest;
}

TEST(JoinedBorders, AreEqualBitForBitAndMovedByRounding) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::sheet_of_triangles(6))};
  const PatchSet before = exact_patches(surface, {.grading = 3});
  ASSERT_GT(before.largest_gap(), 0.0);
  PatchSet set = before;
  join_borders(set);
  ASSERT_NO_THROW(set.check());
  EXPECT_LE(largest_move(before, set), 1e-13 * set.size());
  const EdgeUses uses(set);
  int compared = 0;
  for (int edge = 0; edge < set.edge_count; ++edge) {
    const auto& [one, two] = uses.of(edge);
    if (two.patch < 0) continue;
    const BSplineCurve a = uses.curve(one), b = uses.curve(two).reversed();
    if (a.points.size() != b.points.size()) continue;
    EXPECT_EQ(a.points, b.points);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

// What differs in knots stays.
TEST(JoinedBorders, NeedTheSameKnots) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::sheet_of_triangles(6))};
  PatchSet set = exact_patches(surface);
  const double gap = set.largest_gap();
  join_borders(set);
  ASSERT_NO_THROW(set.check());
  EXPECT_LE(set.largest_gap(), gap);
}

}  // namespace
}  // namespace hull::conversion
