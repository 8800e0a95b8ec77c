// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/exact_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <stdexcept>

#include "conversion/blocks/block_places.h"
#include "test_meshes.h"

namespace hull::conversion {
namespace {

// Every cell lies in one block, and neither creases nor irregular points are inside or, but for its
// corners, on the sides of one.
void expect_rectangles(const surface::LimitSurface& surface, const BlockLayout& layout) {
  const mesh::Topology& cells = surface.cells();
  std::set<int> taken;
  for (const Block& block : layout.blocks) {
    ASSERT_EQ(block.sides.size(), static_cast<std::size_t>(block.count_u * block.count_v));
    for (int i = 0; i < block.count_u; ++i) {
      for (int j = 0; j < block.count_v; ++j) {
        const int side = block.side(i, j);
        EXPECT_TRUE(taken.insert(side / 4).second);
        const bool last_u = i + 1 == block.count_u, last_v = j + 1 == block.count_v;
        if (!last_u) {
          EXPECT_FALSE(cells.is_crease(cells.next(side)));
          EXPECT_EQ(cells.next(cells.twin(cells.next(side))), block.side(i + 1, j));
        }
        if (!last_v) {
          EXPECT_EQ(cells.twin(cells.next(cells.next(side))), block.side(i, j + 1));
        }
        const bool at_u[] = {i == 0, last_u, last_u, i == 0};
        const bool at_v[] = {j == 0, j == 0, last_v, last_v};
        for (int h = side, k = 0; k < 4; h = cells.next(h), ++k) {
          const bool at_corner = at_u[k] && at_v[k];
          EXPECT_TRUE(at_corner || !begins_at_irregular_knot(surface, h));
        }
      }
    }
  }
  EXPECT_EQ(static_cast<int>(taken.size()), surface.cell_count());
}

// Positions and lengths of first and second derivatives, which turn with the cells.
void expect_equal(const surface::LimitSurface& surface, const Block& block,
                  const BSplinePatch& patch, int i, int j, double a, double b) {
  const CellPoint place = place_beside_half_edge(block.side(i, j), a, b);
  const surface::SurfaceJet expected = surface.evaluate(place.cell, place.u, place.v, 2);
  surface::SurfaceJet found = patch.evaluate((i + a) / block.count_u, (j + b) / block.count_v);
  found.du /= block.count_u;
  found.dv /= block.count_v;
  found.duu /= block.count_u * block.count_u;
  found.dvv /= block.count_v * block.count_v;
  const double size = surface.mesh().size();
  EXPECT_LT((found.point - expected.point).norm(), 1e-12 * size);
  const bool turned = block.side(i, j) % 2 == 1;
  const Vector3d &du = turned ? expected.dv : expected.du, &dv = turned ? expected.du : expected.dv;
  EXPECT_NEAR(found.du.norm(), du.norm(), 1e-9 * size);
  EXPECT_NEAR(found.dv.norm(), dv.norm(), 1e-9 * size);
  const Vector3d& duu = turned ? expected.dvv : expected.duu;
  const Vector3d& dvv = turned ? expected.duu : expected.dvv;
  EXPECT_LT((found.duu - duu).norm(), 1e-9 * size);
  EXPECT_LT((found.dvv - dvv).norm(), 1e-9 * size);
}

TEST(ExactPatches, OfRegularMeshesAreOnePatchARectangle) {
  for (const surface::Scheme scheme :
       {surface::Scheme::kBiermann, surface::Scheme::kCatmullClark}) {
    mesh::MeshArrays mesh = testing::grid(5, 4);
    std::mt19937 random(71);
    testing::randomise(mesh, random, 0.0, 0.0, 0.3);
    // A crease right across divides it in two.
    for (int j = 0; j < 4; ++j) mesh.creases.push_back({6 * j + 2, 6 * (j + 1) + 2});
    const surface::LimitSurface surface(mesh::ControlMesh(mesh), scheme);
    const BlockLayout layout(surface);
    ASSERT_EQ(layout.blocks.size(), 2u);
    expect_rectangles(surface, layout);
    int points = 0;
    for (const Block& block : layout.blocks) {
      const BSplinePatch patch = exact_patch(surface, block, 5);
      EXPECT_NO_THROW(patch.check());
      points += static_cast<int>(patch.control_points.size());
      for (int i = 0; i < block.count_u; ++i) {
        for (int j = 0; j < block.count_v; ++j) {
          for (double a : {0.0, 0.3, 0.77}) expect_equal(surface, block, patch, i, j, a, 0.4);
        }
      }
    }
    // Spans are faces, not cells: 2 + 3 by 4 of them.
    EXPECT_EQ(points, (2 + 3) * (4 + 3) + (3 + 3) * (4 + 3));
  }
}

TEST(ExactPatches, EqualTheSurfaceButForVanishingCorners) {
  constexpr unsigned kSeed = 72;
  std::mt19937 random(kSeed);
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 60; ++trial) {
    mesh::MeshArrays mesh = trial % 3 == 0   ? testing::double_pyramid(3 + trial % 11)
                            : trial % 3 == 1 ? testing::prism(3 + trial % 11)
                                             : testing::fan(3 + trial % 6);
    testing::randomise(mesh, random, 0.2, 0.2, 0.1);
    const surface::Scheme scheme =
        trial % 2 ? surface::Scheme::kBiermann : surface::Scheme::kCatmullClark;
    const surface::LimitSurface surface(mesh::ControlMesh(mesh), scheme);
    const BlockLayout layout(surface);
    expect_rectangles(surface, layout);
    const int grading = 2 + trial % 7;
    const double corner = std::exp2(-grading);
    for (const Block& block : layout.blocks) {
      const BSplinePatch patch = exact_patch(surface, block, grading);
      EXPECT_NO_THROW(patch.check());
      for (int k = 0; k < 20; ++k) {
        const int i = static_cast<int>(unit(random) * block.count_u);
        const int j = static_cast<int>(unit(random) * block.count_v);
        // Crowded towards the cells' corners, but not within the squares there.
        const double a = std::pow(unit(random), 3),
                     b = corner + (1.0 - 2.0 * corner) * unit(random);
        SCOPED_TRACE(::testing::Message() << "trial " << trial << " cell " << block.side(i, j) / 4
                                          << " at " << a << ", " << b);
        expect_equal(surface, block, patch, i, j, a, b);
        expect_equal(surface, block, patch, i, j, b, 1.0 - a);
      }
    }
  }
}

TEST(ExactPatches, MeetAtIrregularPoints) {
  std::mt19937 random(73);
  for (int n : {3, 5, 6, 9}) {
    mesh::MeshArrays mesh = testing::double_pyramid(n);
    testing::randomise(mesh, random, 0.2, 0.2, 0.0);
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    for (const Block& block : BlockLayout(surface).blocks) {
      const BSplinePatch patch = exact_patch(surface, block, 4);
      const CellPoint first = place_beside_half_edge(block.side(0, 0), 0.0, 0.0);
      EXPECT_EQ(patch.control_points.front(), surface.position(first.cell, first.u, first.v));
      const CellPoint last =
          place_beside_half_edge(block.side(block.count_u - 1, block.count_v - 1), 1.0, 1.0);
      EXPECT_EQ(patch.control_points.back(), surface.position(last.cell, last.u, last.v));
    }
  }
}

// Corner squares shrink, and with them the distance.
TEST(ExactPatches, ConvergeWithTheGrading) {
  std::mt19937 random(74);
  mesh::MeshArrays mesh = testing::double_pyramid(5);
  testing::randomise(mesh, random, 0.15, 0.1, 0.0);
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  double before = 1.0;
  for (int grading = 2; grading <= 14; grading += 4) {
    double largest = 0.0;
    for (const Block& block : BlockLayout(surface).blocks) {
      const BSplinePatch patch = exact_patch(surface, block, grading);
      for (double a : {0.2, 0.5, 0.8}) {
        for (double b : {0.2, 0.5, 0.8}) {
          const double u = a * std::exp2(-grading), v = b * std::exp2(-grading);
          const CellPoint place = place_beside_half_edge(block.side(0, 0), u, v);
          const Vector3d off = patch.position(u / block.count_u, v / block.count_v) -
                               surface.position(place.cell, place.u, place.v);
          largest = std::max(largest, off.norm());
        }
      }
    }
    EXPECT_LT(largest, 0.3 * before);
    before = largest;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(ExactPatches, OfATorus) {
  mesh::MeshArrays mesh;
  constexpr int kAround = 6, kAcross = 4;
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const double a = 2.0 * M_PI * i / kAround, b = 2.0 * M_PI * j / kAcross;
      const double r = 3.0 + std::cos(b);
      mesh.points.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
    }
  }
  const auto at = [](int i, int j) { return (i % kAround) * kAcross + j % kAcross; };
  for (int i = 0; i < kAround; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      testing::add_face(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const BlockLayout layout(surface);
  expect_rectangles(surface, layout);
  // No block is beside itself.
  EXPECT_EQ(layout.blocks.size(), 4u);
}

TEST(ExactPatches, RefuseBadGradings) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::grid(2, 2))};
  const BlockLayout layout(surface);
  EXPECT_THROW(exact_patch(surface, layout.blocks[0], 1), std::invalid_argument);
  EXPECT_THROW(exact_patch(surface, layout.blocks[0], 31), std::invalid_argument);
}

}  // namespace
}  // namespace hull::conversion
