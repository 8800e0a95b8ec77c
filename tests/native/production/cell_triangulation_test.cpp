// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/cell_triangulation.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace hull::production {
namespace {

using Grid = CellTriangulation::Grid;

// Twice the area of a triangle, exactly.
std::int64_t twice_area(const Grid& a, const Grid& b, const Grid& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

TEST(CellTriangulation, CoversTheSquareWithItsEdges) {
  std::mt19937 random(23);
  for (int trial = 0; trial < 40; ++trial) {
    SCOPED_TRACE("seed 23, trial " + std::to_string(trial));
    CellTriangulation net({1.0, trial % 2 ? 8.0 : 1.0});
    // Coarse coordinates, so that points fall on sides and edges, and on one another.
    std::uniform_int_distribution<std::int64_t> coarse(0, trial < 20 ? 8 : 1000);
    const std::int64_t step = CellTriangulation::kParts / (trial < 20 ? 8 : 1000);
    std::vector<Grid> points{{0, 0},
                             {CellTriangulation::kParts, 0},
                             {CellTriangulation::kParts, CellTriangulation::kParts},
                             {0, CellTriangulation::kParts}};
    std::vector<int> added;
    for (int i = 0; i < 30; ++i) {
      const Grid at{coarse(random) * step, coarse(random) * step};
      const int number = net.add(at);
      if (number == static_cast<int>(points.size())) points.push_back(at);
      EXPECT_EQ(points[number], at);
      added.push_back(number);
    }
    for (int i = 0; i + 1 < 6; ++i) net.constrain(added[i], added[i + 1], i);

    std::int64_t sum = 0;
    std::map<std::array<int, 2>, int> sides;
    for (const auto& t : net.triangles()) {
      const std::int64_t twice = twice_area(points[t[0]], points[t[1]], points[t[2]]);
      EXPECT_GT(twice, 0);
      sum += twice;
      for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
    }
    EXPECT_EQ(sum, 2 * CellTriangulation::kParts * CellTriangulation::kParts);
    for (const auto& [side, count] : sides) EXPECT_EQ(count, 1);
    for (const auto& edge : net.constraints()) {
      EXPECT_TRUE(sides.contains({edge.a, edge.b}) || sides.contains({edge.b, edge.a}));
    }
  }
}

TEST(CellTriangulation, EdgesConnectTheirEnds) {
  CellTriangulation net({1.0, 1.0});
  constexpr std::int64_t kHalf = CellTriangulation::kParts / 2;
  const int middle = net.add({kHalf, kHalf});
  const int low = net.add({kHalf, 0}), high = net.add({kHalf, CellTriangulation::kParts});
  net.constrain(low, high, 7);
  std::set<std::set<int>> found;
  for (const auto& edge : net.constraints()) {
    EXPECT_EQ(edge.tag, 7);
    found.insert({edge.a, edge.b});
  }
  // Through the point on the way.
  EXPECT_EQ(found, (std::set<std::set<int>>{{low, middle}, {middle, high}}));
}

}  // namespace
}  // namespace hull::production
