// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/pull/pull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "random_values.h"
#include "surface/pieces/point_weights.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr unsigned kPullSeed = 5112026;

std::vector<Vector3d> moved_points(const surface::LimitSurface& surface, const Pull& pulled) {
  std::vector<Vector3d> points = surface.mesh().points();
  for (std::size_t i = 0; i < pulled.points.size(); ++i) {
    points[pulled.points[i]] += pulled.moves[i];
  }
  return points;
}

// On random meshes of every kind: places land on their targets on the surface that the moved
// control points make.
TEST(Pull, TakesPlacesToTheirTargets) {
  SCOPED_TRACE(::testing::Message() << "seed " << kPullSeed);
  std::mt19937 random(kPullSeed);
  const auto cache = std::make_shared<surface::BasisCache>();
  for (int trial = 0; trial < 300; ++trial) {
    surface::LimitSurface surface(
        mesh::ControlMesh(testing::random_mesh(random, 12)),
        trial % 2 ? surface::Scheme::kBiermann : surface::Scheme::kCatmullClark, cache);
    const double size = surface.mesh().size();
    const int cell = static_cast<int>(testing::uniform(random, 0.0, surface.cell_count() - 1e-9));
    const double snap[] = {0.0, 0.5, 1.0};
    const auto parameter = [&] {
      return trial % 3 ? testing::uniform(random, 0.0, 1.0) : snap[random() % 3];
    };
    PullTarget target{cell, parameter(), parameter(), Vector3d::Zero()};
    target.point =
        surface.position(cell, target.u, target.v) + 0.1 * size * testing::random_vector(random);
    const Pull pulled = pull(surface, {target});
    EXPECT_LT(pulled.miss, 1e-13 * size);
    surface.set_points(moved_points(surface, pulled));
    ASSERT_LT((surface.position(cell, target.u, target.v) - target.point).norm(), 1e-13 * size)
        << "trial " << trial;
  }
}

// One place without limits, in closed form: each control point moves by its weight over the sum of
// squared weights times the pull.
TEST(Pull, MovesEachPointByItsWeight) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::grid(5, 5))};
  const PullTarget target{4 * 12, 0.3, 0.8,
                          surface.position(4 * 12, 0.3, 0.8) + Vector3d(0.1, -0.2, 0.7)};
  const Pull pulled = pull(surface, {target});
  const std::vector<surface::PointWeight> weights =
      surface::PointWeights(surface).at(4 * 12, 0.3, 0.8);
  double squares = 0.0;
  for (const surface::PointWeight& w : weights) squares += w.weight * w.weight;
  ASSERT_EQ(pulled.points.size(), weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_EQ(pulled.points[i], weights[i].point);
    EXPECT_LT((pulled.moves[i] - weights[i].weight / squares * Vector3d(0.1, -0.2, 0.7)).norm(),
              1e-14);
  }
}

// Limits are kept, and any other moves that do and take the places to the targets are longer.
TEST(Pull, StaysWithinLimitsAndIsTheLeast) {
  SCOPED_TRACE(::testing::Message() << "seed " << kPullSeed + 1);
  std::mt19937 random(kPullSeed + 1);
  for (int trial = 0; trial < 100; ++trial) {
    mesh::MeshArrays arrays = testing::grid(6, 6);
    for (auto& p : arrays.points) p += 0.2 * testing::random_vector(random);
    surface::LimitSurface surface{mesh::ControlMesh(arrays)};
    MoveLimits limits;
    const std::vector<int> faces{7, 16, 28};
    for (int k = 0; k < 6; ++k) limits.locked.push_back(static_cast<int>(random() % 49));
    for (int k = 0; k < 8; ++k) {
      limits.held.push_back({static_cast<int>(random() % 49), testing::random_vector(random)});
    }
    std::vector<PullTarget> targets;
    for (int face : faces) {
      PullTarget t{
          4 * face + 2, testing::uniform(random, 0.0, 1.0), testing::uniform(random, 0.0, 1.0), {}};
      t.point = surface.position(t.cell, t.u, t.v) + testing::random_vector(random);
      targets.push_back(t);
    }
    const Pull pulled = pull(surface, targets, {limits});
    std::vector<Vector3d> moves(49, Vector3d::Zero());
    for (std::size_t i = 0; i < pulled.points.size(); ++i) {
      moves[pulled.points[i]] = pulled.moves[i];
    }
    for (int point : limits.locked) EXPECT_EQ(moves[point], Vector3d(Vector3d::Zero()));
    for (const HeldDirection& h : limits.held) {
      EXPECT_NEAR(moves[h.point].dot(h.normal), 0.0, 1e-13);
    }
    const auto squares = [](const std::vector<Vector3d>& all) {
      double sum = 0.0;
      for (const Vector3d& m : all) sum += m.squaredNorm();
      return sum;
    };
    const double least = squares(moves);
    for (int other = 0; other < 10; ++other) {
      // Random start, then pulled to the targets: the start counts towards the moves.
      std::vector<Vector3d> start(49, Vector3d::Zero());
      for (int p = 0; p < 49; ++p) {
        const bool is_limited = std::count(limits.locked.begin(), limits.locked.end(), p) > 0 ||
                                std::any_of(limits.held.begin(), limits.held.end(),
                                            [p](const HeldDirection& h) { return h.point == p; });
        if (!is_limited) start[p] = 0.1 * testing::random_vector(random);
      }
      surface::LimitSurface shaken = surface;
      std::vector<Vector3d> points = surface.mesh().points();
      for (int p = 0; p < 49; ++p) points[p] += start[p];
      shaken.set_points(points);
      const Pull second = pull(shaken, targets, {limits});
      for (std::size_t i = 0; i < second.points.size(); ++i) {
        start[second.points[i]] += second.moves[i];
      }
      EXPECT_GT(squares(start), least);
    }
  }
}

TEST(Pull, ReachesAsManyTargetsAsPointsAllow) {
  surface::LimitSurface surface{mesh::ControlMesh(testing::grid(8, 8))};
  std::vector<PullTarget> targets;
  for (int face = 0; face < 64; ++face) {
    const Vector3d at = surface.position(4 * face + 1, 0.4, 0.6);
    targets.push_back({4 * face + 1, 0.4, 0.6, at + Vector3d(0.0, 0.0, std::sin(at.x()))});
  }
  const Pull pulled = pull(surface, targets);
  surface.set_points(moved_points(surface, pulled));
  for (const PullTarget& t : targets) {
    EXPECT_LT((surface.position(t.cell, t.u, t.v) - t.point).norm(), 1e-12);
  }
}

TEST(Pull, SaysWhatCannotBe) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::grid(4, 4))};
  const Vector3d at = surface.position(20, 0.5, 0.5);
  MoveLimits flat;
  for (int p = 0; p < 25; ++p) flat.held.push_back({p, {0.0, 0.0, 2.0}});
  EXPECT_THROW(pull(surface, {{20, 0.5, 0.5, at + Vector3d(0.0, 0.0, 1.0)}}, {flat}),
               std::invalid_argument);
  const Pull within = pull(surface, {{20, 0.5, 0.5, at + Vector3d(0.1, 0.2, 0.0)}}, {flat});
  for (const Vector3d& move : within.moves) EXPECT_EQ(move.z(), 0.0);

  MoveLimits all;
  for (int p = 0; p < 25; ++p) all.locked.push_back(p);
  EXPECT_THROW(pull(surface, {{20, 0.5, 0.5, at + Vector3d(0.1, 0.0, 0.0)}}, {all}),
               std::invalid_argument);
  EXPECT_TRUE(pull(surface, {{20, 0.5, 0.5, at}}, {all}).points.empty());

  const PullTarget here{20, 0.5, 0.5, at}, there{20, 0.5, 0.5, at + Vector3d(0.0, 0.0, 1.0)};
  EXPECT_THROW(pull(surface, {here, there}), std::invalid_argument);
  EXPECT_NO_THROW(pull(surface, {there, there}));

  EXPECT_THROW(pull(surface, {{64, 0.5, 0.5, at}}), std::invalid_argument);
  EXPECT_THROW(pull(surface, {{0, 1.5, 0.5, at}}), std::invalid_argument);
  EXPECT_THROW(pull(surface, {{0, 0.5, 0.5, {NAN, 0.0, 0.0}}}), std::invalid_argument);
  EXPECT_THROW(pull(surface, {here}, {MoveLimits{{25}, {}}}), std::invalid_argument);
  EXPECT_THROW(pull(surface, {here}, {MoveLimits{{}, {{3, Vector3d::Zero()}}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace hull::modelling
