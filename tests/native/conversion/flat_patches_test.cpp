// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/flat_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sheets.h"

namespace hull::conversion {
namespace {

// A wavy sheet of `columns` x 3 patches whose columns from `first` to `last` have no width; each
// column's patches keep their own edges.
PatchSet sheet_with_fold(int columns, int first, int last) {
  const double begin = static_cast<double>(first) / columns;
  const double end = static_cast<double>(last) / columns;
  PatchSet set = testing::sheet(columns, 3, [](double s, double t) { return Vector3d(s, t, 0); });
  // Joined before it is folded, so that coinciding edges keep numbers of their own.
  for (BSplinePatch& patch : set.patches) {
    for (Vector3d& p : patch.control_points) {
      const double x = p.x() <= begin ? p.x() : std::max(begin, p.x() - (end - begin));
      p = Vector3d(x, p.y(), 0.1 * std::sin(5 * p.y()) + x * x);
    }
  }
  return set;
}

TEST(WithoutFlatPatches, KeepsWhatHasAnArea) {
  const PatchSet set = testing::rectangle(6.0, 4.0, 3, 2);
  const WithoutFlatPatches result = without_flat_patches(set);
  EXPECT_TRUE(result.left_out.empty());
  EXPECT_EQ(result.patches.patches.size(), 6u);
  EXPECT_EQ(result.patches.sides, set.sides);
}

TEST(WithoutFlatPatches, ClosesAFoldOfOneColumn) {
  const PatchSet set = sheet_with_fold(4, 1, 2);
  ASSERT_NO_THROW(set.check());
  const WithoutFlatPatches result = without_flat_patches(set);
  EXPECT_EQ(result.left_out, (std::vector<int>{1, 5, 9}));
  EXPECT_NO_THROW(result.patches.check());
  EXPECT_EQ(testing::free_edges(result.patches), 2 * (3 + 3));
}

TEST(WithoutFlatPatches, ClosesAFoldOfTwoColumns) {
  const PatchSet set = sheet_with_fold(5, 2, 4);
  const WithoutFlatPatches result = without_flat_patches(set);
  EXPECT_EQ(result.left_out.size(), 6u);
  EXPECT_NO_THROW(result.patches.check());
  EXPECT_EQ(testing::free_edges(result.patches), 2 * (3 + 3));
}

TEST(WithoutFlatPatches, OpensWhereSidesDoNotLieTogether) {
  // The last column is folded onto its border line, but slides along it.
  PatchSet set = testing::sheet(3, 2, [](double s, double t) {
    return s <= 2.0 / 3 ? Vector3d(s, t, 0) : Vector3d(2.0 / 3, t + (s - 2.0 / 3), 0);
  });
  ASSERT_NO_THROW(set.check());
  const WithoutFlatPatches result = without_flat_patches(set);
  EXPECT_EQ(result.left_out, (std::vector<int>{2, 5}));
  EXPECT_NO_THROW(result.patches.check());
  EXPECT_EQ(testing::free_edges(result.patches), 2 * (2 + 2));
}

TEST(WithoutFlatPatches, KeepsThinPatchesThatHaveAnArea) {
  const PatchSet set =
      testing::sheet(2, 2, [](double s, double t) { return Vector3d(s, 1e-7 * t, 0); });
  EXPECT_TRUE(without_flat_patches(set).left_out.empty());
}

TEST(WithoutFlatPatches, LeavesOutAPoint) {
  const PatchSet set = testing::sheet(1, 1, [](double, double) { return Vector3d(1, 2, 3); });
  const WithoutFlatPatches result = without_flat_patches(set);
  EXPECT_EQ(result.left_out, std::vector<int>{0});
  EXPECT_TRUE(result.patches.patches.empty());
}

}  // namespace
}  // namespace hull::conversion
