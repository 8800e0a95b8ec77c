// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/knuckle_setting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "surface/creases/knuckle_angle.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr int kSide = 8;
constexpr double kDegree = 0.017453292519943295;

// A net creased along x = 0, from edge `first` to before `last`, bent there and twisted.
surface::LimitSurface bent_net(int first = 0, int last = kSide) {
  mesh::MeshArrays arrays = testing::grid(kSide, kSide);
  for (Vector3d& p : arrays.points) {
    p -= Vector3d(kSide / 2, kSide / 2, 0.0);
    p.z() = -std::abs(p.x()) * (0.5 + 0.05 * p.y()) + 0.02 * p.y() * p.y() - 0.03 * p.x() * p.x();
  }
  for (int i = first; i < last; ++i) {
    const int from = kSide / 2 + (kSide + 1) * i;
    arrays.creases.push_back({from, from + kSide + 1});
  }
  return surface::LimitSurface(mesh::ControlMesh(arrays));
}

surface::CreaseCurve knuckle_of(const surface::LimitSurface& surface) {
  for (surface::CreaseCurve& curve : surface::crease_curves(surface)) {
    if (curve.kind() == surface::CreaseKind::kCrease) return curve;
  }
  throw std::logic_error("no crease");
}

surface::LimitSurface moved(surface::LimitSurface surface, const KnuckleSetting& setting) {
  std::vector<Vector3d> points = surface.mesh().points();
  for (std::size_t i = 0; i < setting.points.size(); ++i) {
    points[setting.points[i]] += setting.moves[i];
  }
  surface.set_points(points);
  return surface;
}

TEST(KnuckleSetting, GivesTheAngleAllAlong) {
  for (double degrees : {-40.0, 0.0, 15.0, 60.0, 120.0}) {
    const surface::LimitSurface before = bent_net();
    const surface::CreaseCurve knuckle = knuckle_of(before);
    const KnuckleSetting setting = set_knuckle_angle(before, knuckle, degrees * kDegree);
    EXPECT_TRUE(setting.met) << degrees << ": " << setting.deviation / kDegree << "° off after "
                             << setting.steps << " steps";
    EXPECT_LT(setting.steps, 40);
    const surface::LimitSurface after = moved(before, setting);
    const surface::CreaseCurve same = knuckle_of(after);
    for (int i = 0; i <= 97; ++i) {
      const double t = kSide * i / 97.0;
      EXPECT_NEAR(surface::knuckle_angle(after, same, t), degrees * kDegree, 0.1 * kDegree);
      EXPECT_LT((same.evaluate(t, 0).point - knuckle.evaluate(t, 0).point).norm(), 1e-13);
    }
    for (int p : setting.points) EXPECT_EQ(std::abs(before.mesh().points()[p].x()), 1.0);
  }
}

// Other moves that give the same angles are longer: the same from a start that was shaken.
TEST(KnuckleSetting, MovesLeast) {
  const surface::LimitSurface surface = bent_net();
  const surface::CreaseCurve knuckle = knuckle_of(surface);
  const KnuckleSetting setting = set_knuckle_angle(surface, knuckle, 50.0 * kDegree);
  double least = 0.0;
  for (const Vector3d& move : setting.moves) least += move.squaredNorm();
  for (int k = 0; k < 10; ++k) {
    std::vector<Vector3d> points = surface.mesh().points();
    std::vector<Vector3d> moves(points.size(), Vector3d::Zero());
    for (int p : setting.points)
      moves[p] = 0.1 * Vector3d(std::sin(p + k), std::cos(3.0 * p + k), std::sin(5.0 * p - k));
    for (std::size_t p = 0; p < points.size(); ++p) points[p] += moves[p];
    surface::LimitSurface shaken = surface;
    shaken.set_points(points);
    const KnuckleSetting other = set_knuckle_angle(shaken, knuckle, 50.0 * kDegree);
    ASSERT_TRUE(other.met);
    for (std::size_t i = 0; i < other.points.size(); ++i) moves[other.points[i]] += other.moves[i];
    double sum = 0.0;
    for (const Vector3d& move : moves) sum += move.squaredNorm();
    EXPECT_GT(sum, least);
  }
}

TEST(KnuckleSetting, KeepsWhatIsLockedOrHeld) {
  const surface::LimitSurface surface = bent_net();
  MoveLimits limits;
  for (std::size_t p = 0; p < surface.mesh().points().size(); ++p) {
    const double x = surface.mesh().points()[p].x();
    if (x == -1.0) limits.locked.push_back(static_cast<int>(p));
    if (x == 1.0) limits.held.push_back({static_cast<int>(p), Vector3d::UnitZ()});
  }
  const surface::CreaseCurve knuckle = knuckle_of(surface);
  const KnuckleSetting setting = set_knuckle_angle(surface, knuckle, 70.0 * kDegree, {limits});
  EXPECT_TRUE(setting.met);
  for (std::size_t i = 0; i < setting.points.size(); ++i) {
    EXPECT_EQ(surface.mesh().points()[setting.points[i]].x(), 1.0);
    EXPECT_NEAR(setting.moves[i].z(), 0.0, 1e-15);
  }
}

TEST(KnuckleSetting, LeavesOutEdgesThatEndInDarts) {
  const surface::LimitSurface surface = bent_net(0, 5);
  const surface::CreaseCurve knuckle = knuckle_of(surface);
  const KnuckleSetting setting = set_knuckle_angle(surface, knuckle, 60.0 * kDegree);
  EXPECT_EQ(setting.edges.size(), 4u);
  EXPECT_TRUE(setting.met);
}

TEST(KnuckleSetting, SetsTheEdgesThatAreNamed) {
  const surface::LimitSurface surface = bent_net();
  const surface::CreaseCurve knuckle = knuckle_of(surface);
  KnuckleOptions options;
  options.edges = {2, 3};
  const KnuckleSetting setting = set_knuckle_angle(surface, knuckle, 60.0 * kDegree, {}, options);
  EXPECT_TRUE(setting.met);
  const surface::LimitSurface after = moved(surface, setting);
  EXPECT_NEAR(surface::knuckle_angle(after, knuckle, 3.0), 60.0 * kDegree, 0.1 * kDegree);
  EXPECT_NEAR(surface::knuckle_angle(after, knuckle, 7.9),
              surface::knuckle_angle(surface, knuckle, 7.9), 1e-12);
}

TEST(KnuckleSetting, SaysWhatCannotBe) {
  const surface::LimitSurface surface = bent_net();
  const surface::CreaseCurve knuckle = knuckle_of(surface);
  for (double angle : {3.1, -3.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(set_knuckle_angle(surface, knuckle, angle), std::invalid_argument);
  }
  MoveLimits limits;
  for (int p = 0; p < static_cast<int>(surface.mesh().points().size()); ++p) {
    limits.locked.push_back(p);
  }
  EXPECT_THROW(set_knuckle_angle(surface, knuckle, 0.5, {limits}), std::invalid_argument);
  const surface::LimitSurface dart = bent_net(3, 4);
  EXPECT_THROW(set_knuckle_angle(dart, knuckle_of(dart), 0.5), std::invalid_argument);
  for (const surface::CreaseCurve& curve : surface::crease_curves(surface)) {
    if (curve.kind() != surface::CreaseKind::kBorder) continue;
    EXPECT_THROW(set_knuckle_angle(surface, curve, 0.5), std::invalid_argument);
  }
}

}  // namespace
}  // namespace hull::modelling
