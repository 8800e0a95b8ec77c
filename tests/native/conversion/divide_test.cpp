// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/divide.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

#include "conversion/blocks/block_places.h"
#include "conversion/exact/exact_conversion.h"
#include "conversion/patches/matched_knots.h"
#include "conversion/quality/measure_quality.h"
#include "test_meshes.h"
#include "trials.h"

namespace hull::conversion {
namespace {

surface::LimitSurface random_surface(int trial, std::mt19937& random) {
  mesh::MeshArrays mesh = trial % 3 == 0   ? testing::double_pyramid(3 + trial % 5)
                          : trial % 3 == 1 ? testing::prism(3 + trial % 5)
                                           : testing::fan(3 + trial % 5);
  testing::randomise(mesh, random, 0.15, 0.2, 0.1);
  return surface::LimitSurface{mesh::ControlMesh(mesh)};
}

std::size_t point_count(const PatchSet& set) {
  std::size_t count = 0;
  for (const BSplinePatch& patch : set.patches) count += patch.control_points.size();
  return count;
}

// Pieces are listed patch by patch, along u and within that along v.
void expect_same_patches(const PatchSet& whole, const PatchSet& set) {
  ASSERT_NO_THROW(set.check());
  ASSERT_EQ(set.blocks.size(), set.patches.size());
  double largest = 0.0;
  std::size_t p = 0;
  for (std::size_t n = 0; n < set.patches.size(); ++n) {
    const Block& part = set.blocks[n];
    if (n > 0 && part.begin_u == 0.0 && part.begin_v == 0.0) ++p;
    ASSERT_LT(p, whole.patches.size());
    for (double a : {0.0, 0.3, 1.0}) {
      for (double b : {0.0, 0.6, 1.0}) {
        const Vector3d point =
            whole.patches[p].position(part.begin_u + a * (part.end_u - part.begin_u),
                                      part.begin_v + b * (part.end_v - part.begin_v));
        largest = std::max(largest, (set.patches[n].position(a, b) - point).norm());
      }
    }
  }
  EXPECT_EQ(p + 1, whole.patches.size());
  EXPECT_LT(largest, 1e-13 * whole.size());
}

// The report finds the pieces on the surface, and their seams.
TEST(Divided, QualityIsThatOfTheWhole) {
  std::mt19937 random(61);
  const surface::LimitSurface surface = random_surface(3, random);
  const QualityReport before = measure_quality(surface, exact_patches(surface));
  constexpr std::array kMost{100, 16};
  for (int k = 0; k < testing::trials(2); ++k) {
    const PatchSet set = exact_patches(surface, {.most_control_points = kMost[k]});
    const QualityReport after = measure_quality(surface, set);
    EXPECT_NEAR(after.area, before.area, 1e-6 * before.area);
    EXPECT_NEAR(after.exact_share, before.exact_share, 1e-3);
    EXPECT_LE(after.distance.value, 1e-6 * after.length);
    EXPECT_LE(after.worst_seams.gap.value, 1e-13 * set.size());
    // More places are sampled where there are more seams and knots.
    EXPECT_LE(after.worst_seams.angle.value, 1.2 * before.worst_seams.angle.value + 1e-9);
  }
}

TEST(Divided, BezierPatchesAreTheSameSurface) {
  constexpr unsigned kSeed = 51;
  std::mt19937 random(kSeed);
  for (int trial = 0; trial < testing::trials(6); ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " trial " << trial);
    const surface::LimitSurface surface = random_surface(trial, random);
    const PatchSet whole = exact_patches(surface);
    const PatchSet set = exact_patches(surface, {.bezier = true});
    for (const BSplinePatch& patch : set.patches) {
      EXPECT_EQ(patch.count_u, 4);
      EXPECT_EQ(patch.count_v, 4);
    }
    std::size_t pieces = 0;
    for (const PatchCuts& cuts : cuts_at_knots(whole)) {
      pieces += (cuts.u.size() + 1) * (cuts.v.size() + 1);
    }
    EXPECT_EQ(set.patches.size(), pieces);
    expect_same_patches(whole, set);
  }
}

TEST(Divided, PiecesAreWhereTheirBlocksSay) {
  std::mt19937 random(53);
  mesh::MeshArrays mesh = testing::grid(4, 3);
  std::normal_distribution<double> noise(0.0, 0.1);
  for (Vector3d& point : mesh.points) point.z() += noise(random);
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const PatchSet set = exact_patches(surface, {.bezier = true});
  EXPECT_GT(set.patches.size(), 11u);
  for (std::size_t p = 0; p < set.patches.size(); ++p) {
    const CellPoint place = place_in_block(set.blocks[p], 0.3, 0.6);
    const Vector3d exact = surface.position(place.cell, place.u, place.v);
    EXPECT_LT((set.patches[p].position(0.3, 0.6) - exact).norm(), 1e-13);
  }
}

TEST(Divided, NoPatchHasMoreControlPointsThanAsked) {
  constexpr unsigned kSeed = 57;
  std::mt19937 random(kSeed);
  for (int trial = 0; trial < testing::trials(6); ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " trial " << trial);
    const surface::LimitSurface surface = random_surface(trial, random);
    const PatchSet whole = exact_patches(surface);
    for (int most : {16, 40, 100, 100000}) {
      const PatchSet set = exact_patches(surface, {.most_control_points = most});
      for (const BSplinePatch& patch : set.patches) {
        EXPECT_LE(static_cast<int>(patch.control_points.size()), most);
      }
      EXPECT_EQ(most == 100000, set.patches.size() == whole.patches.size() && most > 100);
      expect_same_patches(whole, set);
    }
  }
}

// Nearer cuts could not be told from rounding, and pieces would be without edges.
TEST(Divided, RefusesPiecesThatAreTooNarrow) {
  std::mt19937 random(65);
  const PatchSet set = exact_patches(random_surface(0, random));
  std::vector<PatchCuts> cuts(set.patches.size());
  cuts[1].u = {0.5, 0.5 + 1e-11};
  EXPECT_NO_THROW(divided(set, cuts).check());
  for (const double gap : {0.0, 5e-13}) {
    for (const double from : {0.0, 0.3, 1.0 - gap}) {
      cuts[1].u = {};
      cuts[1].v = {from, from + gap};
      if (from == 0.0) cuts[1].v = {gap};
      if (from + gap == 1.0) cuts[1].v = {from};
      EXPECT_THROW(divided(set, cuts), std::invalid_argument) << from << " " << gap;
    }
  }
}

TEST(Divided, RefusesFewerControlPointsThanABezierPatchHas) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::grid(2, 2))};
  EXPECT_THROW(exact_patches(surface, {.most_control_points = 15}), std::invalid_argument);
  EXPECT_THROW(cuts_for_most_points(exact_patches(surface), 3), std::invalid_argument);
}

TEST(MatchKnots, GivesNeighboursTheSameKnots) {
  constexpr unsigned kSeed = 59;
  std::mt19937 random(kSeed);
  bool differed = false;
  for (int trial = 0; trial < 6; ++trial) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " trial " << trial);
    const surface::LimitSurface surface = random_surface(trial, random);
    const PatchSet whole = exact_patches(surface);
    PatchSet set = whole;
    match_knots(set);
    differed |= point_count(set) > point_count(whole);
    expect_same_patches(whole, set);
    std::vector<BSplineCurve> first(set.edge_count);
    for (std::size_t p = 0; p < set.patches.size(); ++p) {
      for (int k = 0; k < 4; ++k) {
        for (const SideEdge& part : set.sides[p][k]) {
          BSplineCurve curve = set.curve(static_cast<int>(p), k, part);
          if (first[part.edge].points.empty()) {
            first[part.edge] = std::move(curve);
            continue;
          }
          const BSplineCurve other = curve.reversed();
          ASSERT_EQ(first[part.edge].knots.size(), other.knots.size());
          for (std::size_t i = 0; i < other.knots.size(); ++i) {
            EXPECT_NEAR(first[part.edge].knots[i], other.knots[i], 1e-10);
            if (i >= other.points.size()) continue;
            EXPECT_LT((first[part.edge].points[i] - other.points[i]).norm(), 1e-9);
          }
        }
      }
    }
  }
  EXPECT_TRUE(differed);
}

}  // namespace
}  // namespace hull::conversion
