// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/offsets/offset_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "barges.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

// A barge of 20 m with a sharp chine at (3, 1) and its deck's edge at (3.5, 4); all faces plane.
surface::LimitSurface chine_barge() {
  const testing::Polygon section = {{0.0, 0.0}, {3.0, 1.0}, {3.5, 4.0}, {-3.5, 4.0}, {-3.0, 1.0}};
  return surface::LimitSurface{mesh::ControlMesh(testing::barge(section, 20.0))};
}

constexpr double kTolerance = 2e-6;  // 1e-7 of the size

TEST(OffsetTable, OfABargeWithAChine) {
  const OffsetTable table =
      offset_table(chine_barge(), {5.0, 10.0}, {-1.0, 0.5, 1.0, 2.5}, {0.0, 1.5, 3.0, 3.25, 5.0});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(std::isnan(table.half_breadth(i, 0).value));
    EXPECT_NEAR(table.half_breadth(i, 1).value, 1.5, kTolerance);
    EXPECT_NEAR(table.half_breadth(i, 2).value, 3.0, 10.0 * kTolerance);
    EXPECT_NEAR(table.half_breadth(i, 3).value, 3.25, kTolerance);
    EXPECT_FALSE(table.half_breadth(i, 1).on_knuckle);
    EXPECT_TRUE(table.half_breadth(i, 2).on_knuckle);
    EXPECT_NEAR(table.height(i, 0).value, 0.0, 10.0 * kTolerance);
    EXPECT_NEAR(table.height(i, 1).value, 0.5, kTolerance);
    EXPECT_TRUE(table.height(i, 2).on_knuckle);
    EXPECT_NEAR(table.height(i, 3).value, 2.5, 10.0 * kTolerance);
    EXPECT_TRUE(std::isnan(table.height(i, 4).value));
  }
  // Not the keel, which is in the centre plane, nor the starboard side's.
  ASSERT_EQ(table.features.size(), 2u);
  const FeatureOffsets &chine = table.features[0], &deck = table.features[1];
  EXPECT_EQ(chine.name, "Knuckle 1");
  EXPECT_EQ(deck.name, "Knuckle 2");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(chine.half_breadths[i], 3.0, 1e-12);
    EXPECT_NEAR(chine.heights[i], 1.0, 1e-12);
    EXPECT_NEAR(deck.half_breadths[i], 3.5, 1e-12);
    EXPECT_NEAR(deck.heights[i], 4.0, 1e-12);
  }
}

TEST(OffsetTable, FlatEndsBottomsAndSidesGiveTheirEdges) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(40.0, 8.0, 5.0))};
  const OffsetTable table = offset_table(box, {0.0, 20.0, 40.0}, {0.0, 2.0, 5.0}, {0.0, 4.0});
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(table.half_breadth(i, j).value, 4.0, 4e-5) << i << ' ' << j;
    }
    for (std::size_t j = 0; j < 2; ++j) EXPECT_NEAR(table.height(i, j).value, 0.0, 4e-5);
  }
  EXPECT_TRUE(table.half_breadth(1, 0).on_knuckle);
  EXPECT_FALSE(table.half_breadth(1, 1).on_knuckle);
}

TEST(OffsetTable, IsEmptyBeyondTheHull) {
  const OffsetTable table = offset_table(chine_barge(), {-3.0, 25.0}, {1.0}, {1.0});
  EXPECT_TRUE(std::isnan(table.half_breadth(0, 0).value));
  EXPECT_TRUE(std::isnan(table.height(1, 0).value));
  EXPECT_TRUE(table.features.empty());
}

TEST(OffsetTable, RefusesBadPositions) {
  const surface::LimitSurface surface = chine_barge();
  EXPECT_THROW(offset_table(surface, {NAN}, {1.0}, {}), std::invalid_argument);
  EXPECT_THROW(offset_table(surface, {1.0}, {}, {-1.0}), std::invalid_argument);
  EXPECT_THROW(offset_table(surface, std::vector<double>(1001, 1.0), {}, {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace hull::analysis
