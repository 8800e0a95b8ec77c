// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/grid_samples.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "test_meshes.h"

namespace hull::surface {
namespace {

// A grid is evaluated piece by piece, single points through the tree of squares.
TEST(GridSamples, AgreeWithSinglePoints) {
  constexpr unsigned kSeed = 33;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const auto cache = std::make_shared<BasisCache>();
  for (int trial = 0; trial < 60; ++trial) {
    const LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 10)),
                               trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    const int n = 1 + trial % 19;
    const GridSamples samples = evaluate_grid(surface, n, 2);
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
          const SurfaceJet jet = surface.evaluate(cell, u, v, 2);
          const std::size_t k = samples.index(cell, i, j);
          ASSERT_LT((samples.points[k] - jet.point).norm(), 1e-13);
          // Second derivatives jump at knot lines, where either side may be taken.
          if (i == 0 || j == 0 || i == n || j == n) continue;
          ASSERT_LT((samples.du[k] - jet.du).norm(), 1e-11);
          ASSERT_LT((samples.dv[k] - jet.dv).norm(), 1e-11);
          ASSERT_LT((samples.duu[k] - jet.duu).norm(), 1e-9);
          ASSERT_LT((samples.duv[k] - jet.duv).norm(), 1e-9);
          ASSERT_LT((samples.dvv[k] - jet.dvv).norm(), 1e-9);
        }
      }
    }
  }
}

TEST(GridSamples, RefuseBadArguments) {
  const LimitSurface surface{mesh::ControlMesh(testing::cube())};
  EXPECT_THROW(evaluate_grid(surface, 0, 0), std::invalid_argument);
  EXPECT_THROW(evaluate_grid(surface, 257, 0), std::invalid_argument);
  EXPECT_THROW(evaluate_grid(surface, 4, 3), std::invalid_argument);
}

TEST(SetPoints, EqualsANewSurface) {
  std::mt19937 random(34);
  for (int trial = 0; trial < 20; ++trial) {
    const mesh::MeshArrays first = testing::random_mesh(random, 10);
    mesh::MeshArrays second = first;
    for (auto& p : second.points) p = Vector3d(p.y() + 1.0, 2.0 * p.x(), p.z() - p.x());
    LimitSurface moved{mesh::ControlMesh(first)};
    moved.set_points(second.points);
    const LimitSurface anew{mesh::ControlMesh(second)};
    for (int cell = 0; cell < anew.cell_count(); ++cell) {
      for (double t : {0.0, 1e-5, 0.4, 0.9}) {
        ASSERT_EQ(moved.position(cell, t, 0.3 * t), anew.position(cell, t, 0.3 * t));
      }
    }
    EXPECT_THROW(moved.set_points({}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace hull::surface
