// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/overlay/merged_discs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "morphing/plane_grid.h"

namespace hull::morphing {
namespace {

DiscMap map_of_grid(int n, double waves) {
  const TriangleDisc flat = plane_grid(n);
  std::vector<Vector3d> points = flat.points();
  for (Vector3d& p : points) {
    p = Vector3d(p.x() / n, p.y() / n, 0.0);
    p.z() = 0.2 * std::sin(waves * p.x()) * std::cos(waves * p.y());
  }
  const int last = (n + 1) * (n + 1) - 1;
  return {TriangleDisc(points, flat.triangles()),
          {0, n, last, last - n},
          ConvexPolygon({{0.0, 0.1}, {1.0, 0.0}, {1.2, 0.9}, {-0.1, 1.1}})};
}

int edge_count(const std::vector<Triangle>& triangles) {
  std::set<std::pair<int, int>> edges;
  for (const Triangle& corners : triangles) {
    for (int i = 0; i < 3; ++i) edges.insert(std::minmax(corners[i], corners[(i + 1) % 3]));
  }
  return static_cast<int>(edges.size());
}

TEST(MergedDiscs, CountsAgree) {
  for (int n : {1, 2, 5, 12}) {
    for (int m : {1, 3, 8}) {
      const DiscMap first = map_of_grid(n, 3.0), second = map_of_grid(m, 5.0);
      const MergedDiscs merged(first, second);
      const int points = static_cast<int>(merged.places().size());
      EXPECT_EQ(points, static_cast<int>(first.places().size() + second.places().size()) -
                            merged.shared_count() + merged.crossing_count());
      EXPECT_EQ(
          points - edge_count(merged.triangles()) + static_cast<int>(merged.triangles().size()), 1);
    }
  }
}

// The merged mesh is a disc by the same checks as any, and can be mapped and merged itself: so
// families of more than two parents are made.
TEST(MergedDiscs, AreDiscs) {
  const DiscMap first = map_of_grid(6, 3.0), second = map_of_grid(5, 5.0);
  const MergedDiscs merged(first, second);
  const TriangleDisc disc(merged.points(0.4), merged.triangles());
  std::vector<int> corners;
  for (int corner : first.corners()) {
    for (std::size_t i = 0; i < merged.origins().size(); ++i) {
      if (merged.origins()[i][0] == corner) corners.push_back(static_cast<int>(i));
    }
  }
  const DiscMap again(disc, corners, first.polygon());
  const MergedDiscs three(again, map_of_grid(4, 2.0));
  EXPECT_EQ(static_cast<int>(three.places().size()) - edge_count(three.triangles()) +
                static_cast<int>(three.triangles().size()),
            1);
}

TEST(MergedDiscs, EndsAreTheParentsToTheBit) {
  const DiscMap first = map_of_grid(6, 3.0), second = map_of_grid(5, 5.0);
  const MergedDiscs merged(first, second);
  EXPECT_EQ(merged.points(0.0), merged.points_on(0));
  EXPECT_EQ(merged.points(1.0), merged.points_on(1));
  for (std::size_t i = 0; i < merged.origins().size(); ++i) {
    const auto& [of_first, of_second] = merged.origins()[i];
    if (of_first >= 0) {
      EXPECT_EQ(merged.points_on(0)[i], first.disc().points()[of_first]);
    }
    if (of_second >= 0) {
      EXPECT_EQ(merged.points_on(1)[i], second.disc().points()[of_second]);
    }
  }
}

}  // namespace
}  // namespace hull::morphing
