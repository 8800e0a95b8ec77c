// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/pull/pull_spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "modelling/pull/pull.h"
#include "random_values.h"
#include "surface/curvature.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr unsigned kPullSpreadSeed = 22112026;

std::vector<Vector3d> moves_of(const surface::LimitSurface& surface, const Pull& pulled) {
  std::vector<Vector3d> moves(surface.mesh().points().size(), Vector3d::Zero());
  for (std::size_t i = 0; i < pulled.points.size(); ++i) moves[pulled.points[i]] = pulled.moves[i];
  return moves;
}

surface::LimitSurface pulled_surface(surface::LimitSurface surface, const Pull& pulled) {
  std::vector<Vector3d> points = surface.mesh().points();
  const std::vector<Vector3d> moves = moves_of(surface, pulled);
  for (std::size_t p = 0; p < points.size(); ++p) points[p] += moves[p];
  surface.set_points(points);
  return surface;
}

// A flat net of 41 x 41 points, 1 m apart, and the place in the middle of it.
struct Net {
  surface::LimitSurface surface{mesh::ControlMesh(testing::grid(40, 40))};
  int cell = 4 * (40 * 20 + 20);
  Vector3d place = surface.position(cell, 0.0, 0.0);
  PullTarget up{cell, 0.0, 0.0, place + Vector3d::UnitZ()};

  int nearest(const Vector3d& at) const {
    const auto& points = surface.mesh().points();
    return static_cast<int>(std::min_element(points.begin(), points.end(),
                                             [&](const Vector3d& a, const Vector3d& b) {
                                               return (a - at).squaredNorm() <
                                                      (b - at).squaredNorm();
                                             }) -
                            points.begin());
  }
};

double steepest_edge(const surface::LimitSurface& surface, const std::vector<Vector3d>& moves) {
  const mesh::Topology& topology = surface.mesh().topology();
  double most = 0.0;
  for (int h = 0; h < topology.half_edge_count(); ++h) {
    const int from = topology.origin(h), to = topology.origin(topology.next(h));
    most = std::max(most, (moves[from] - moves[to]).norm());
  }
  return most;
}

double most_bent(const surface::LimitSurface& surface) {
  double most = 0.0;
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for (double u : {0.25, 0.75}) {
      for (double v : {0.25, 0.75}) {
        const surface::SurfaceJet jet = surface.evaluate(cell, u, v, 2);
        const double du = jet.du.squaredNorm(), dv = jet.dv.squaredNorm();
        most = std::max({most, std::abs(jet.duu.z()) / du, std::abs(jet.dvv.z()) / dv});
      }
    }
  }
  return most;
}

// On random meshes of every kind, with limits and several places: targets are met, and what is
// locked or held stays.
TEST(PullSpread, MeetsTargetsWithinLimitsWhateverTheRadius) {
  SCOPED_TRACE(::testing::Message() << "seed " << kPullSpreadSeed);
  std::mt19937 random(kPullSpreadSeed);
  int done = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const surface::LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 9)));
    const double size = surface.mesh().size();
    const int count = surface.mesh().topology().vertex_count();
    const auto point = [&] { return static_cast<int>(random() % count); };
    MoveLimits limits;
    limits.locked = {point()};
    limits.held = {{point(), testing::random_vector(random)},
                   {point(), testing::random_vector(random)}};
    std::vector<PullTarget> targets;
    for (int i = 0; i < 1 + trial % 2; ++i) {
      PullTarget t{static_cast<int>(random() % surface.cell_count()),
                   testing::uniform(random, 0.0, 1.0), testing::uniform(random, 0.0, 1.0),
                   Vector3d::Zero()};
      t.point = surface.position(t.cell, t.u, t.v) + 0.1 * size * testing::random_vector(random);
      targets.push_back(t);
    }
    const PullSpread spread{size * std::pow(10.0, testing::uniform(random, -3.0, 1.0)),
                            trial % 3 == 0};
    Pull pulled;
    try {
      pulled = pull(surface, targets, {limits}, spread);
    } catch (const std::invalid_argument&) {
      continue;  // two places of one small mesh may be out of reach of one another
    }
    ++done;
    const surface::LimitSurface after = pulled_surface(surface, pulled);
    for (const PullTarget& t : targets) {
      ASSERT_LT((after.position(t.cell, t.u, t.v) - t.point).norm(),
                1e-11 * size * std::max(1.0, pulled.reach))
          << "trial " << trial;
    }
    const std::vector<Vector3d> moves = moves_of(surface, pulled);
    for (int p : limits.locked) ASSERT_EQ(moves[p], Vector3d(Vector3d::Zero()));
    for (const HeldDirection& h : limits.held) {
      ASSERT_NEAR(moves[h.point].dot(h.normal), 0.0, 1e-12 * size * std::max(1.0, pulled.reach));
    }
  }
  EXPECT_GT(done, 250);
}

TEST(PullSpread, FallsOffByTheDistance) {
  const Net net;
  const double radius = 10.0;
  const Pull pulled = pull(net.surface, {net.up}, {}, {radius, false});
  const std::vector<Vector3d> moves = moves_of(net.surface, pulled);
  const double top = moves[net.nearest(net.place)].z();
  EXPECT_NEAR(top, 1.0, 0.05);
  for (std::size_t p = 0; p < moves.size(); ++p) {
    const double q = (net.surface.mesh().points()[p] - net.place).norm() / radius;
    EXPECT_NEAR(moves[p].z(), q < 1.0 ? top * std::pow(1.0 - q * q, 3) : 0.0, 1e-13);
  }
}

// What a dense net is pulled to by its sixteen points is a pimple.
TEST(PullSpread, MakesNoPimple) {
  const Net net;
  const double pimple = most_bent(pulled_surface(net.surface, pull(net.surface, {net.up})));
  const Pull wide = pull(net.surface, {net.up}, {}, {10.0, false});
  EXPECT_GT(pimple, 1.0);
  // Of (1 - d²/R²)³ the second derivative at the top is 6 / R².
  EXPECT_LT(most_bent(pulled_surface(net.surface, wide)), 1.1 * 6.0 / 100.0);
}

// A radius smaller than the net's distances changes nothing of importance: the same points move.
TEST(PullSpread, GoesOverIntoTheLeastMoves) {
  const Net net;
  const PullTarget target{net.cell, 0.4, 0.7,
                          net.surface.position(net.cell, 0.4, 0.7) + Vector3d(0.1, 0.2, 1.0)};
  const std::vector<Vector3d> least = moves_of(net.surface, pull(net.surface, {target}));
  const std::vector<Vector3d> small =
      moves_of(net.surface, pull(net.surface, {target}, {}, {0.1, false}));
  for (std::size_t p = 0; p < least.size(); ++p) EXPECT_LT((least[p] - small[p]).norm(), 1e-13);
}

// Beside a row of points that is held the moves rise from zero, not by a step.
TEST(PullSpread, FadesOutTowardsWhatIsHeld) {
  const Net net;
  const auto& points = net.surface.mesh().points();
  MoveLimits locked, held;
  for (int p = 0; p < static_cast<int>(points.size()); ++p) {
    if (std::abs(points[p].x() - net.place.x() - 5.0) > 0.25) continue;
    locked.locked.push_back(p);
    held.held.push_back({p, Vector3d::UnitZ()});
  }
  ASSERT_EQ(locked.locked.size(), 41u);
  const double free = steepest_edge(
      net.surface, moves_of(net.surface, pull(net.surface, {net.up}, {}, {12.0, false})));
  for (const MoveLimits& limits : {locked, held}) {
    const std::vector<Vector3d> moves =
        moves_of(net.surface, pull(net.surface, {net.up}, {limits}, {12.0, false}));
    // A step would be (1 - 16/144)³ = 0.7 m beside the row; falling by 1 m over 5 m takes 0.3 m.
    EXPECT_LT(steepest_edge(net.surface, moves), 0.35);
    EXPECT_GT(steepest_edge(net.surface, moves), free);
    for (int p : locked.locked) EXPECT_NEAR(moves[p].z(), 0.0, 1e-12);
  }
  // What is behind a row of locked points stays; in a flat's plane points move as ever.
  const std::vector<Vector3d> behind =
      moves_of(net.surface, pull(net.surface, {net.up}, {locked}, {12.0, false}));
  for (std::size_t p = 0; p < points.size(); ++p) {
    const bool is_behind = points[p].x() > net.place.x() + 5.0;
    EXPECT_TRUE(!is_behind || behind[p].isZero(0.0));
  }
  PullTarget along = net.up;
  along.point = net.place + Vector3d::UnitY();
  const auto free_moves = moves_of(net.surface, pull(net.surface, {along}, {}, {12.0, false}));
  const auto held_moves = moves_of(net.surface, pull(net.surface, {along}, {held}, {12.0, false}));
  for (std::size_t p = 0; p < points.size(); ++p) {
    EXPECT_LT((free_moves[p] - held_moves[p]).norm(), 1e-13);
  }
}

// Half of a hull whose border is the centre plane: heights are even functions of y there.
TEST(PullSpread, StaysSmoothAcrossTheCentrePlane) {
  mesh::MeshArrays arrays = testing::grid(40, 40);
  double least = arrays.points[0].y();
  for (const Vector3d& p : arrays.points) least = std::min(least, p.y());
  MoveLimits centre;
  for (std::size_t p = 0; p < arrays.points.size(); ++p) {
    arrays.points[p].y() -= least;
    if (arrays.points[p].y() == 0.0) {
      centre.held.push_back({static_cast<int>(p), Vector3d::UnitY()});
    }
  }
  const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  PullTarget target{-1, 0.0, 0.0, {}};
  for (int cell = 0; cell < surface.cell_count() && target.cell < 0; ++cell) {
    const Vector3d at = surface.position(cell, 0.0, 0.0);
    if (std::abs(at.y() - 3.0) < 0.1 && std::abs(at.x() - arrays.points[820].x()) < 0.1) {
      target = {cell, 0.0, 0.0, at + Vector3d(0.0, 0.0, 1.0)};
    }
  }
  ASSERT_GE(target.cell, 0);
  const auto slope_on_border = [&](bool mirrored) {
    const std::vector<Vector3d> moves =
        moves_of(surface, pull(surface, {target}, {centre}, {8.0, mirrored}));
    double most = 0.0;
    for (std::size_t p = 0; p < moves.size(); ++p) {
      if (arrays.points[p].y() != 0.0) continue;
      for (std::size_t q = 0; q < moves.size(); ++q) {
        if (arrays.points[q].x() == arrays.points[p].x() && arrays.points[q].y() == 1.0) {
          most = std::max(most, std::abs(moves[q].z() - moves[p].z()));
        }
      }
    }
    return most;
  };
  EXPECT_GT(slope_on_border(false), 0.1);
  EXPECT_LT(slope_on_border(true), 0.05);  // a parabola rises by its half curvature over 1 m
}

TEST(PullSpread, SaysWhatIsNoRadius) {
  const Net net;
  for (double radius : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(pull(net.surface, {net.up}, {}, {radius, false}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace hull::modelling
