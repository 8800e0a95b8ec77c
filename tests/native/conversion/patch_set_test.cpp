// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/patch_set.h"

#include <gtest/gtest.h>

#include <string>

#include "sheets.h"

namespace hull::conversion {
namespace {

std::string message(const PatchSet& set) {
  try {
    set.check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

::testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "\"" << part << "\" is not in \"" << text << "\"";
}

TEST(PatchSet, OfASheetIsConsistent) {
  const PatchSet set = testing::rectangle(6.0, 4.0, 3, 2);
  EXPECT_EQ(message(set), "");
  EXPECT_EQ(set.vertex_count, 12);
  EXPECT_EQ(set.edge_count, 17);
}

TEST(PatchSet, CheckNamesWhatDoesNotFit) {
  const PatchSet good = testing::rectangle(6.0, 4.0, 3, 2);
  PatchSet bad = good;
  bad.sides.pop_back();
  EXPECT_TRUE(contains(message(bad), "6 patches, but corners of 6 and sides of 5"));
  bad = good;
  bad.sides[4][2][0].edge = 17;
  EXPECT_TRUE(contains(message(bad), "cell 4: there is no edge 17"));
  bad = good;
  bad.corners[2][0] = -1;
  EXPECT_TRUE(contains(message(bad), "cell 2: there is no vertex -1"));
  bad = good;
  bad.patches[5].knots_u.clear();
  EXPECT_TRUE(contains(message(bad), "cell 5"));
}

TEST(PatchSet, SharedCurvesMustAgreeToRounding) {
  PatchSet bad = testing::rectangle(6.0, 4.0, 2, 1);
  double& z = bad.patches[1].control_points[bad.patches[1].side_index(3, 2)].z();
  z = 1e-15;
  EXPECT_EQ(message(bad), "");
  EXPECT_LT(bad.largest_gap(), 1e-15);
  z = 1e-11;
  EXPECT_GT(bad.largest_gap(), 1e-12);
  EXPECT_TRUE(contains(message(bad), "cell 1"));
  EXPECT_TRUE(contains(message(bad), "has not the same curve as the patch of cell 0"));
}

TEST(PatchSet, SharedKnotsMustAgree) {
  PatchSet bad = testing::rectangle(6.0, 4.0, 2, 1);
  bad.patches[1].knots_v[4] = 0.4;
  EXPECT_TRUE(contains(message(bad), "has not the same curve"));
}

TEST(PatchSet, VerticesMustAgree) {
  PatchSet bad = testing::rectangle(6.0, 4.0, 2, 1);
  bad.corners[1][1] = bad.sides[1][0][0].to = bad.sides[1][1][0].from = bad.corners[0][0];
  EXPECT_TRUE(contains(message(bad), "is not where cell 0 has it"));
}

TEST(PatchSet, EdgesHaveTwoPatchesThatRunOppositeWays) {
  PatchSet bad = testing::rectangle(6.0, 4.0, 2, 1);
  PatchSet third = bad;
  third.patches.push_back(bad.patches[0]);
  third.corners.push_back(bad.corners[0]);
  third.sides.push_back(bad.sides[0]);
  EXPECT_NE(message(third), "");
  PatchSet twice = testing::rectangle(6.0, 4.0);
  twice.patches.push_back(twice.patches[0]);
  twice.corners.push_back(twice.corners[0]);
  twice.sides.push_back(twice.sides[0]);
  EXPECT_TRUE(contains(message(twice), "does not run between the same vertices, the other way"));
}

// One patch whose side u = 1 has two neighbours of half its width.
PatchSet tee() {
  std::vector<BSplinePatch> patches = testing::rectangle(2.0, 2.0).patches;
  for (int j = 0; j < 2; ++j) {
    patches.push_back(testing::rectangle(1.0, 1.0).patches[0]);
    for (Vector3d& point : patches.back().control_points) point += Vector3d(2.0, j, 0.0);
    patches.back().cell = 1 + j;
  }
  PatchSet set = testing::joined(std::move(patches));
  const SideEdge lower = set.sides[1][3][0], upper = set.sides[2][3][0];
  set.sides[0][1] = {{lower.edge, lower.to, lower.from, 0.0, 0.5},
                     {upper.edge, upper.to, upper.from, 0.5, 1.0}};
  return set;
}

TEST(PatchSet, SidesMayHaveSeveralEdges) {
  const PatchSet good = tee();
  EXPECT_EQ(message(good), "");
  EXPECT_LT(good.largest_gap(), 1e-15);
  PatchSet bad = good;
  bad.sides[0][1][0].end = 0.4;
  EXPECT_TRUE(contains(message(bad), "does not begin where side 1 has come to"));
  bad = good;
  bad.sides[0][1].pop_back();
  EXPECT_TRUE(contains(message(bad), "the edges of side 1 do not reach its end"));
  bad = good;
  bad.sides[0][1][0].end = bad.sides[0][1][1].begin = 0.4;
  EXPECT_TRUE(contains(message(bad), "is not on the side where cell 1 has it"));
}

}  // namespace
}  // namespace hull::conversion
