// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/hull_body.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "analysis/immersion/floating_position.h"
#include "test_meshes.h"

namespace hull {
namespace {

constexpr double kL = 40.0, kB = 8.0, kD = 5.0;

// ∫ (t - n·p)^power / power! over the box [0, a]³ below n·p = t, for n > 0: the divided differences
// of a truncated power (Schoenberg's formula for the volume of a cube's slice).
double box_moment(const Vector3d& n, const Vector3d& sides, double t, int power) {
  double sum = 0.0, factorial = 1.0;
  for (int k = 2; k <= power + 3; ++k) factorial *= k;
  for (int corner = 0; corner < 8; ++corner) {
    double height = t;
    int sign = 1;
    for (int k = 0; k < 3; ++k) {
      if (!(corner >> k & 1)) continue;
      height -= n[k] * sides[k];
      sign = -sign;
    }
    sum += sign * std::pow(std::max(0.0, height), power + 3);
  }
  return sum / (factorial * n.prod());
}

// The same for the box of creased_box and any plane.
double box_moment(const Plane& water, int power) {
  const Vector3d sides(kL, kB, kD);
  const Vector3d low(0.0, -0.5 * kB, 0.0);
  double t = water.offset - water.normal.dot(low);
  for (int k = 0; k < 3; ++k) t -= std::min(0.0, water.normal[k]) * sides[k];
  return box_moment(water.normal.cwiseAbs(), sides, t, power);
}

Plane random_water(std::mt19937& random, const Vector3d& through, double spread) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(-spread, spread);
  const Vector3d e = Vector3d(normal(random), normal(random), normal(random)).normalized();
  return {e, e.dot(through) + unit(random)};
}

// Half of creased_box: y >= 0, open at the centre plane and, if asked, on deck and at the stern.
MeshArrays half_box(bool open) {
  MeshArrays mesh = testing::creased_box(kL, 0.5 * kB, kD);
  for (auto& p : mesh.points) p.y() += 0.25 * kB;
  MeshArrays result = mesh;
  result.face_sizes.clear();
  result.face_vertices.clear();
  for (int f = 0; f < 6; ++f) {
    std::vector<int> corners(mesh.face_vertices.begin() + 4 * f,
                             mesh.face_vertices.begin() + 4 * f + 4);
    const auto all = [&](auto test) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](int v) { return test(mesh.points[v]); });
    };
    if (all([](const Vector3d& p) { return p.y() < 1e-9; })) continue;
    if (open && all([](const Vector3d& p) { return p.z() > kD - 1e-9; })) continue;
    if (open && all([](const Vector3d& p) { return p.x() < 1e-9; })) continue;
    testing::add_face(result, corners);
  }
  return result;
}

// Volumes, waterplanes and heights of centres of a box in any water.
TEST(HullBody, BoxInAnyWater) {
  const LimitSurface box{ControlMesh(testing::creased_box(kL, kB, kD))};
  const HullBody body(box, false);
  constexpr unsigned kSeed = 411;
  std::mt19937 random(kSeed);
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  for (int trial = 0; trial < 300; ++trial) {
    const Plane water = random_water(random, {0.5 * kL, 0.0, 0.5 * kD}, 4.0);
    if (water.normal.cwiseAbs().minCoeff() < 0.05) continue;  // the formula's divisor
    const Immersion found = body.immersion(water);
    const double volume = box_moment(water, 0), whole = kL * kB * kD;
    EXPECT_NEAR(found.volume, volume, 1e-12 * whole) << trial;
    EXPECT_NEAR(found.waterplane_area, box_moment(water, -1), 1e-12 * kL * kL) << trial;
    if (volume < 1e-3 * whole) continue;
    const double depth = water.offset - water.normal.dot(found.centre_of_buoyancy);
    EXPECT_NEAR(depth * volume, box_moment(water, 1), 1e-12 * whole * kL) << trial;
    EXPECT_LT(found.volume_error, 1e-11 * whole);
  }
}

// The same body whole; as a half; as a half without deck, transom and centre plane.
TEST(HullBody, ClosingsMakeTheWholeBody) {
  const LimitSurface whole{ControlMesh(testing::creased_box(kL, kB, kD))};
  const LimitSurface half{ControlMesh(half_box(false))};
  const LimitSurface open{ControlMesh(half_box(true))};
  const HullBody a(whole, false), b(half, true), c(open, true);
  std::mt19937 random(412);
  for (int trial = 0; trial < 100; ++trial) {
    const Plane water = random_water(random, {0.5 * kL, 0.0, 0.5 * kD}, 3.0);
    const Immersion of_whole = a.immersion(water);
    for (const HullBody* body : {&b, &c}) {
      const Immersion found = body->immersion(water);
      EXPECT_NEAR(found.volume, of_whole.volume, 1e-11);
      EXPECT_NEAR(found.waterplane_area, of_whole.waterplane_area, 1e-11);
      EXPECT_LT((found.centre_of_buoyancy - of_whole.centre_of_buoyancy).norm() * found.volume,
                1e-9);
      EXPECT_LT((found.waterplane_second - of_whole.waterplane_second).norm(), 1e-8);
    }
    EXPECT_LE(c.immersion(water).wetted_surface, of_whole.wetted_surface + 1e-9);
    EXPECT_NEAR(b.immersion(water).wetted_surface, of_whole.wetted_surface, 1e-9);
  }
}

// A closed body's three flux forms, each with the waterplane's share, are its volume; also with
// irregular points of every kind in the water's surface.
TEST(HullBody, FluxFormsAgree) {
  std::mt19937 random(413);
  for (const Scheme scheme : {Scheme::kBiermann, Scheme::kCatmullClark}) {
    for (int trial = 0; trial < 40; ++trial) {
      MeshArrays arrays =
          trial % 2 ? testing::double_pyramid(3 + trial % 14) : testing::prism(3 + trial % 14);
      testing::randomise(arrays, random, 0.25, 0.1, 0.2);
      const LimitSurface surface(ControlMesh(arrays), scheme);
      const HullBody body(surface, false);
      // Through a control point's limit, so that knots are cut too.
      const Vector3d knot = surface.position(trial % surface.cell_count(), 0.0, 0.0);
      const Immersion found = body.immersion(random_water(random, knot, trial % 4 ? 0.3 : 0.0));
      const Vector3d& e = found.water.normal;
      const Vector3d forms =
          found.flux_forms +
          (found.waterplane_area * e.cwiseProduct(found.centre_of_flotation)).eval();
      for (double volume : forms) EXPECT_NEAR(volume, found.volume, 1e-11) << trial;
    }
  }
}

TEST(HullBody, TurnsWithTheWater) {
  std::mt19937 random(414);
  for (int trial = 0; trial < 30; ++trial) {
    MeshArrays arrays = testing::prism(3 + trial % 8);
    testing::randomise(arrays, random, 0.3, 0.1, 0.2);
    const Eigen::AngleAxisd turn(0.3 * trial, Vector3d(1.0, 0.3, 0.2).normalized());
    MeshArrays turned = arrays;
    for (auto& p : turned.points) p = turn * p;
    const Plane water = random_water(random, Vector3d::Zero(), 0.4);
    const LimitSurface surface{ControlMesh(arrays)}, other{ControlMesh(turned)};
    const Immersion a = HullBody(surface, false).immersion(water);
    const Immersion b = HullBody(other, false).immersion({turn * water.normal, water.offset});
    EXPECT_NEAR(a.volume, b.volume, 1e-12);
    EXPECT_NEAR(a.waterplane_area, b.waterplane_area, 2e-12);
    EXPECT_NEAR(a.wetted_surface, b.wetted_surface, 1e-9);
    EXPECT_LT((turn * a.centre_of_buoyancy - b.centre_of_buoyancy).norm(), 1e-11);
    EXPECT_LT((turn * a.centre_of_flotation - b.centre_of_flotation).norm(), 1e-11);
  }
}

TEST(HullBody, FollowsMovedPoints) {
  std::mt19937 random(415);
  MeshArrays arrays = testing::prism(7);
  testing::randomise(arrays, random, 0.2, 0.0, 0.2);
  LimitSurface surface{ControlMesh(arrays)};
  HullBody body(surface, false);
  for (auto& p : arrays.points) p.x() *= 1.5;
  surface.set_points(arrays.points);
  body.update();
  const LimitSurface fresh{ControlMesh(arrays)};
  const Plane water{Vector3d::UnitZ(), 0.1};
  EXPECT_EQ(body.immersion(water).volume, HullBody(fresh, false).immersion(water).volume);
}

std::string words_of(const HullBody& body, const Plane& water) {
  try {
    body.immersion(water);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

// An open half box floods over its deck, not through its transom.
TEST(HullBody, FloodsAtItsLowestOpening) {
  const LimitSurface surface{ControlMesh(half_box(true))};
  const HullBody body(surface, true, Openings::kOpen);
  EXPECT_NEAR(body.immersion({Vector3d::UnitZ(), 2.0}).volume, kL * kB * 2.0, 1e-10);
  EXPECT_NEAR(body.lowest_opening(Vector3d::UnitZ()), kD, 1e-12);
  EXPECT_NE(words_of(body, {Vector3d::UnitZ(), kD + 0.25}).find("0.250 m under water"),
            std::string::npos);
  // Heeled to starboard the edge there goes under first.
  const Plane heeled = water_plane({kD - 0.5, 0.0, 0.2, 0.0});
  const FloodingPoint point = body.flooding_point(heeled.normal);
  EXPECT_NEAR(point.point.y(), -0.5 * kB, 1e-12);
  EXPECT_NE(words_of(body, heeled).find("floods at"), std::string::npos);
  EXPECT_GT(HullBody(surface, true).immersion(heeled).volume, 0.0);
}

TEST(HullBody, BodiesAddUpAndInvertedOnesAreNamed) {
  MeshArrays two = testing::creased_box(kL, kB, kD);
  const MeshArrays other = testing::creased_box(kL, kB, kD);
  for (std::size_t v = 0; v < 8; ++v) {
    two.points.push_back(other.points[v] + Vector3d(0.0, 20.0, 0.0));
  }
  for (int v : other.face_vertices) two.face_vertices.push_back(v + 8);
  two.face_sizes.insert(two.face_sizes.end(), 6, 4);
  for (auto [a, b] : other.creases) two.creases.push_back({a + 8, b + 8});
  const Plane water{Vector3d(0.0, 0.1, 1.0).normalized(), 2.0};
  {
    const LimitSurface surface{ControlMesh(two)};
    const Immersion found = HullBody(surface, false).immersion(water);
    Plane shifted = water;
    shifted.offset -= 20.0 * water.normal.y();
    EXPECT_NEAR(found.volume,
                box_moment({water.normal + Vector3d(1e-9, 0.0, 0.0), water.offset}, 0) +
                    box_moment({water.normal + Vector3d(1e-9, 0.0, 0.0), shifted.offset}, 0),
                1.0);
  }
  for (int f = 6; f < 12; ++f) {
    std::reverse(two.face_vertices.begin() + 4 * f, two.face_vertices.begin() + 4 * f + 4);
  }
  const LimitSurface surface{ControlMesh(two)};
  EXPECT_NE(words_of(HullBody(surface, false), water).find("body with face 6"), std::string::npos);
}

}  // namespace
}  // namespace hull
