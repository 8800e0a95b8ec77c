// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/square_fan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "conversion/blocks/block_layout.h"
#include "conversion/blocks/block_places.h"
#include "conversion/exact/exact_patches.h"
#include "conversion/exact/seam_fit.h"
#include "test_meshes.h"

namespace hull::conversion {
namespace {

surface::LimitSurface random_fan(int trial, std::mt19937& random) {
  const int n = 3 + trial % 7;
  mesh::MeshArrays mesh = trial % 2 ? testing::double_pyramid(n) : testing::fan(n);
  testing::randomise(mesh, random, 0.1, trial % 4 == 3 ? 0.2 : 0.0, 0.0);
  return surface::LimitSurface{mesh::ControlMesh(mesh), trial % 3 ? surface::Scheme::kBiermann
                                                                  : surface::Scheme::kCatmullClark};
}

// The first vertex with an irregular knot, -1: there is none.
int irregular_vertex(const surface::LimitSurface& surface) {
  for (int h = 0; h < surface.cells().half_edge_count(); ++h) {
    if (begins_at_irregular_knot(surface, h)) return surface.cells().origin(h);
  }
  return -1;
}

TEST(CornerFunctions, AddUpToOneAndReproduceTheParameter) {
  for (int inner = 1; inner <= kMostInner; ++inner) {
    for (double beyond : {1.5, 2.0}) {
      for (double t : {0.0, 0.03, 0.13, 0.3, 0.5, 0.7, 1.0}) {
        const CornerFunctions f = corner_functions(inner, beyond, t);
        double sum = 0.0, slope = 0.0;
        for (int k = 0; k < inner + 4; ++k) {
          sum += f.value[k];
          slope += f.slope[k];
        }
        EXPECT_NEAR(sum, 1.0, 1e-15);
        EXPECT_NEAR(slope, 0.0, 1e-12);
      }
    }
  }
}

// On the outer sides of the square it is what whole patches are.
TEST(CornerNet, IsTheCornerOfThePatch) {
  constexpr unsigned kSeed = 31;
  std::mt19937 random(kSeed);
  int compared = 0;
  for (int trial = 0; trial < 30; ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " trial " << trial);
    const surface::LimitSurface surface = random_fan(trial, random);
    const Grading grading{3 + trial % 5, 1 + trial % kMostInner};
    const Gradings gradings(surface.cells().vertex_count(), grading);
    for (const Block& block : BlockLayout(surface).blocks) {
      const BSplinePatch patch = exact_patch(surface, block, gradings);
      for (int k = 0; k < 4; ++k) {
        const int h = block.half_edges(surface.cells(), k).front();
        if (!begins_at_irregular_knot(surface, h)) continue;
        const CornerNet net = corner_net(surface, h, grading);
        const double size = std::exp2(-grading.halvings);
        const double along = size / (k % 2 ? block.count_v : block.count_u);
        const double across = size / (k % 2 ? block.count_u : block.count_v);
        for (double a : {0.0, 0.1, 0.2, 0.4, 0.6, 1.0}) {
          for (double b : {0.0, 0.1, 0.2, 0.4, 0.6, 1.0}) {
            const auto [u, v] = place_on_side(k, a * along);
            const auto [du, dv] = place_on_side((k + 1) % 4, b * across);
            const double x = k % 2 ? du : u, y = k % 2 ? v : dv;
            if (a < 1.0 && b < 1.0) continue;  // points that may be chosen reach there
            EXPECT_LT((net.evaluate(a, b).point - patch.position(x, y)).norm(), 1e-14);
            ++compared;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(SquareFan, FitMakesAnglesSmallerAndMovesOnlyWhatMayBeMoved) {
  constexpr unsigned kSeed = 37;
  std::mt19937 random(kSeed);
  int gained = 0;
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " trial " << trial);
    const surface::LimitSurface surface = random_fan(trial, random);
    const int vertex = irregular_vertex(surface);
    if (vertex < 0) continue;
    const SquareFan before = square_fan(surface, vertex, {4, 1 + trial % 2});
    SquareFan after = before;
    const double angle = fit_seams(after, 1e-6, 0.03);
    EXPECT_EQ(angle, seam_angle(after));
    EXPECT_LE(angle, seam_angle(before));
    gained += angle < 0.2 * seam_angle(before);
    for (int i = 0; i < before.count(); ++i) {
      if (!before.graded[i]) continue;
      const CornerNet &one = before.nets[i], &two = after.nets[i];
      for (int a = 0; a < one.count(); ++a) {
        for (int b = 0; b < one.count(); ++b) {
          const bool stays = a > one.inner || b > one.inner || a + b == 0 ||
                             (a == 0 && !before.seam_smooth[i]) ||
                             (b == 0 && !before.seam_smooth[before.before(i)]);
          EXPECT_TRUE(!stays || one.at(a, b) == two.at(a, b));
        }
      }
      if (!before.seam_smooth[i]) continue;
      const CornerNet& next = after.nets[after.after(i)];
      for (int b = 0; b <= two.inner; ++b) EXPECT_LT((two.at(0, b) - next.at(b, 0)).norm(), 1e-15);
    }
  }
  EXPECT_GT(gained, 30);
}

}  // namespace
}  // namespace hull::conversion
