// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/point_weights.h"

#include <gtest/gtest.h>

#include <random>

#include "test_meshes.h"

namespace hull::surface {
namespace {

constexpr unsigned kPointWeightsSeed = 22112026;

// The sum over the control points is the surface's own point, and the weights sum to 1: at knots,
// beside them, on sides, within, for irregular points of any valence, creases, corners and borders.
TEST(PointWeights, GiveThePositionOfEveryPlace) {
  SCOPED_TRACE(::testing::Message() << "seed " << kPointWeightsSeed);
  std::mt19937 random(kPointWeightsSeed);
  const auto cache = std::make_shared<BasisCache>();
  const double places[] = {0.0, 1e-12, 1e-5, 0.03, 0.25, 0.5, 0.74, 1.0};
  std::uniform_int_distribution<int> any(0, 7);
  for (int trial = 0; trial < 300; ++trial) {
    const mesh::ControlMesh mesh(testing::random_mesh(random, 24));
    const LimitSurface surface(mesh, trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    PointWeights weights(surface);
    std::uniform_int_distribution<int> cells(0, surface.cell_count() - 1);
    for (int i = 0; i < 30; ++i) {
      const int cell = cells(random);
      const double u = places[any(random)], v = places[any(random)];
      Vector3d sum = Vector3d::Zero();
      double total = 0.0;
      int last = -1;
      for (const PointWeight& w : weights.at(cell, u, v)) {
        ASSERT_GT(w.point, last);
        last = w.point;
        sum += w.weight * mesh.points()[w.point];
        total += w.weight;
      }
      ASSERT_NEAR(total, 1.0, 1e-13) << "trial " << trial << " cell " << cell;
      ASSERT_LT((sum - surface.position(cell, u, v)).norm(), 1e-13 * mesh.size())
          << "trial " << trial << " cell " << cell << " at " << u << ", " << v;
    }
  }
}

// Closed form: at a regular knot 16, 4 and 1 of 36; at a border's knot 4 and 1 of 6.
TEST(PointWeights, AreThoseOfBicubicSplinesAtKnots) {
  const LimitSurface surface{mesh::ControlMesh(testing::grid(4, 4))};
  PointWeights weights(surface);
  const auto at_corner_of_face = [&](int face) { return weights.at(4 * face, 0.0, 0.0); };
  const std::vector<PointWeight> inner = at_corner_of_face(10);  // its first corner is point 12
  ASSERT_EQ(inner.size(), 9u);
  for (const PointWeight& w : inner) {
    const int i = std::abs(w.point % 5 - 2), j = std::abs(w.point / 5 - 2);
    EXPECT_NEAR(w.weight, (i ? 1.0 : 4.0) * (j ? 1.0 : 4.0) / 36.0, 1e-15);
  }
  const std::vector<PointWeight> border = at_corner_of_face(2);  // point 2
  ASSERT_EQ(border.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(border[k].point, 1 + k);
    EXPECT_NEAR(border[k].weight, k == 1 ? 4.0 / 6.0 : 1.0 / 6.0, 1e-15);
  }
  const std::vector<PointWeight> corner = at_corner_of_face(0);
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_EQ(corner[0].point, 0);
  EXPECT_EQ(corner[0].weight, 1.0);
}

}  // namespace
}  // namespace hull::surface
