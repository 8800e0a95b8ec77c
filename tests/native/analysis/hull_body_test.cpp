// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/hull_body.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "analysis/appendages/appendage.h"
#include "analysis/immersion/floating_position.h"
#include "natural_hull.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

constexpr double kL = 40.0, kB = 8.0, kD = 5.0;

// ∫ (t - n·p)^power / power! over the box [0, a]³ below n·p = t, for n > 0: the divided differences
// of a truncated power, as for the volume of a cube's slice. They cancel where n is almost
// square to an axis, hence the longer numbers.
double box_moment(const Vector3d& n, const Vector3d& sides, long double t, int power) {
  long double sum = 0.0, factorial = 1.0, product = 1.0;
  for (int k = 2; k <= power + 3; ++k) factorial *= k;
  for (double component : n) product *= component;
  for (int corner = 0; corner < 8; ++corner) {
    long double height = t;
    int sign = 1;
    for (int k = 0; k < 3; ++k) {
      if (!(corner >> k & 1)) continue;
      height -= static_cast<long double>(n[k]) * sides[k];
      sign = -sign;
    }
    sum += sign * std::pow(std::max(0.0L, height), power + 3);
  }
  return static_cast<double>(sum / (factorial * product));
}

// The same for the box of creased_box and any plane.
double box_moment(const Plane& water, int power) {
  const Vector3d sides(kL, kB, kD);
  const Vector3d low(0.0, -0.5 * kB, 0.0);
  long double t = water.offset;
  for (int k = 0; k < 3; ++k) {
    t -= static_cast<long double>(water.normal[k]) * low[k];
    t -= static_cast<long double>(std::min(0.0, water.normal[k])) * sides[k];
  }
  return box_moment(water.normal.cwiseAbs(), sides, t, power);
}

Plane random_water(std::mt19937& random, const Vector3d& through, double spread) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(-spread, spread);
  const Vector3d e = Vector3d(normal(random), normal(random), normal(random)).normalized();
  return {e, e.dot(through) + unit(random)};
}

// Half of creased_box: y >= 0, open at the centre plane and, if asked, on deck and at the stern.
mesh::MeshArrays half_box(bool open) {
  mesh::MeshArrays mesh = testing::creased_box(kL, 0.5 * kB, kD);
  for (auto& p : mesh.points) p.y() += 0.25 * kB;
  mesh::MeshArrays result = mesh;
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
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(kL, kB, kD))};
  const HullBody body(box, false);
  constexpr unsigned kSeed = 411;
  std::mt19937 random(kSeed);
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  for (int trial = 0; trial < 300; ++trial) {
    const Plane water = random_water(random, {0.5 * kL, 0.0, 0.5 * kD}, 4.0);
    if (water.normal.cwiseAbs().minCoeff() < 0.05) continue;  // the formula's divisor
    const Immersion found = body.immersion(water);
    const double volume = box_moment(water, 0), whole = kL * kB * kD;
    EXPECT_NEAR(found.volume, volume, 1e-13 * whole) << trial;
    EXPECT_NEAR(found.waterplane_area, box_moment(water, -1), 1e-13 * kL * kL) << trial;
    if (volume < 1e-3 * whole) continue;
    const double depth = water.offset - water.normal.dot(found.centre_of_buoyancy);
    EXPECT_NEAR(depth * volume, box_moment(water, 1), 1e-13 * whole * kL) << trial;
    EXPECT_LT(found.volume_error, 1e-11 * whole);
  }
}

// The regular prism of n sides along x, all edges creased: a polyhedron.
mesh::MeshArrays creased_prism(int n) {
  mesh::MeshArrays mesh = testing::prism(n);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) mesh.corners.push_back(static_cast<int>(v));
  int first = 0;
  for (int size : mesh.face_sizes) {
    for (int k = 0; k < size; ++k) {
      const int a = mesh.face_vertices[first + k], b = mesh.face_vertices[first + (k + 1) % size];
      if (a < b) mesh.creases.push_back({a, b});
    }
    first += size;
  }
  return mesh;
}

// Volume and oriented waterplane of what is left of a polyhedron below the water: of its faces,
// clipped by the plane and seen from a point in it, where the waterplane adds nothing.
struct Clipped {
  double volume = 0.0;
  Vector3d waterplane = Vector3d::Zero();
};

Clipped clipped(const mesh::MeshArrays& mesh, const Plane& water) {
  Clipped sum;
  const Vector3d origin = water.offset * water.normal;
  int first = 0;
  for (int size : mesh.face_sizes) {
    std::vector<Vector3d> kept;
    for (int k = 0; k < size; ++k) {
      const Vector3d a = mesh.points[mesh.face_vertices[first + k]] - origin;
      const Vector3d b = mesh.points[mesh.face_vertices[first + (k + 1) % size]] - origin;
      const double ha = water.normal.dot(a), hb = water.normal.dot(b);
      if (ha < 0.0) kept.push_back(a);
      if ((ha < 0.0) != (hb < 0.0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
      const Vector3d area = 0.5 * (kept[k] - kept[0]).cross(kept[k + 1] - kept[0]);
      sum.volume += kept[0].dot(area) / 3.0;
      sum.waterplane -= area;
    }
    first += size;
  }
  return sum;
}

TEST(HullBody, PrismsInAnyWater) {
  constexpr unsigned kSeed = 416;
  std::mt19937 random(kSeed);
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  for (int n : {3, 5, 6, 9}) {
    const mesh::MeshArrays mesh = creased_prism(n);
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const HullBody body(surface, false);
    for (int trial = 0; trial < 50; ++trial) {
      const Plane water = random_water(random, Vector3d::Zero(), 1.0);
      const Immersion found = body.immersion(water);
      const Clipped expected = clipped(mesh, water);
      EXPECT_NEAR(found.volume, expected.volume, 1e-13 * 8.0);
      EXPECT_NEAR(found.waterplane_area, water.normal.dot(expected.waterplane), 1e-13 * 4.0);
    }
  }
}

// What a coarser tolerance allows is kept, and estimated.
TEST(HullBody, KeepsToTheTolerance) {
  std::mt19937 random(417);
  for (int trial = 0; trial < 60; ++trial) {
    mesh::MeshArrays arrays = trial % 3 == 0   ? testing::double_pyramid(3 + trial % 14)
                              : trial % 3 == 1 ? testing::prism(3 + trial % 14)
                                               : testing::creased_box(2.0, 2.0, 2.0);
    testing::randomise(arrays, random, 0.25, 0.1, 0.2);
    const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
    const HullBody finest(surface, false);
    const Plane water = random_water(random, Vector3d::Zero(), 0.4);
    const Immersion a = finest.immersion(water);
    const ShellMoments whole = finest.shell_moments();
    const double volume = std::abs(whole.first.trace()) / 3.0;
    for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      SCOPED_TRACE(::testing::Message() << "trial " << trial << ", tolerance " << tolerance);
      const Immersion b = HullBody(surface, false, Openings::kClosed, tolerance).immersion(water);
      EXPECT_NEAR(b.volume, a.volume, tolerance * volume);
      EXPECT_NEAR(b.wetted_surface, a.wetted_surface, std::max(1e-9, tolerance) * whole.area);
      EXPECT_NEAR(b.waterplane_area, a.waterplane_area, tolerance * whole.area);
      EXPECT_LT((b.centre_of_buoyancy * b.volume - a.centre_of_buoyancy * a.volume).norm(),
                tolerance * volume * surface.mesh().size());
      EXPECT_LT(std::abs(b.volume - a.volume), b.volume_error + a.volume_error + 1e-12);
    }
  }
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  for (double tolerance : {0.0, -1.0, 0.5, std::nan("")}) {
    EXPECT_THROW(HullBody(surface, false, Openings::kClosed, tolerance), std::invalid_argument);
  }
}

// The same body whole; as a half; as a half without deck, transom and centre plane.
TEST(HullBody, ClosingsMakeTheWholeBody) {
  const surface::LimitSurface whole{mesh::ControlMesh(testing::creased_box(kL, kB, kD))};
  const surface::LimitSurface half{mesh::ControlMesh(half_box(false))};
  const surface::LimitSurface open{mesh::ControlMesh(half_box(true))};
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
  for (const surface::Scheme scheme :
       {surface::Scheme::kBiermann, surface::Scheme::kCatmullClark}) {
    for (int trial = 0; trial < 40; ++trial) {
      mesh::MeshArrays arrays =
          trial % 2 ? testing::double_pyramid(3 + trial % 14) : testing::prism(3 + trial % 14);
      testing::randomise(arrays, random, 0.25, 0.1, 0.2);
      const surface::LimitSurface surface(mesh::ControlMesh(arrays), scheme);
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
    mesh::MeshArrays arrays = testing::prism(3 + trial % 8);
    testing::randomise(arrays, random, 0.3, 0.1, 0.2);
    const Eigen::AngleAxisd turn(0.3 * trial, Vector3d(1.0, 0.3, 0.2).normalized());
    mesh::MeshArrays turned = arrays;
    for (auto& p : turned.points) p = turn * p;
    const Plane water = random_water(random, Vector3d::Zero(), 0.4);
    const surface::LimitSurface surface{mesh::ControlMesh(arrays)},
        other{mesh::ControlMesh(turned)};
    const Immersion a = HullBody(surface, false).immersion(water);
    const Immersion b = HullBody(other, false).immersion({turn * water.normal, water.offset});
    EXPECT_NEAR(a.volume, b.volume, 1e-12);
    EXPECT_NEAR(a.waterplane_area, b.waterplane_area, 2e-12);
    EXPECT_NEAR(a.wetted_surface, b.wetted_surface, 1e-9);
    EXPECT_LT((turn * a.centre_of_buoyancy - b.centre_of_buoyancy).norm() * a.volume, 1e-12);
    EXPECT_LT((turn * a.centre_of_flotation - b.centre_of_flotation).norm() * a.waterplane_area,
              2e-12);
  }
}

// Only what has moved is computed again, yet nothing depends on what was there before.
TEST(HullBody, FollowsMovedPoints) {
  std::mt19937 random(415);
  mesh::MeshArrays arrays = testing::prism(7);
  testing::randomise(arrays, random, 0.2, 0.0, 0.2);
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  HullBody body(surface, false);
  const Plane water{Vector3d::UnitZ(), 0.1};
  std::normal_distribution<double> move(0.0, 0.05);
  for (int step = 0; step < 20; ++step) {
    const bool all = step % 5 == 0;
    for (std::size_t i = 0; i < arrays.points.size(); ++i) {
      if (all || static_cast<int>(i) == step % 7) arrays.points[i].x() += move(random);
    }
    surface.set_points(arrays.points);
    body.update();
    const surface::LimitSurface fresh{mesh::ControlMesh(arrays)};
    const Immersion a = body.immersion(water), b = HullBody(fresh, false).immersion(water);
    EXPECT_EQ(a.volume, b.volume);
    EXPECT_EQ(a.wetted_surface, b.wetted_surface);
    EXPECT_EQ(a.centre_of_flotation, b.centre_of_flotation);
  }
}

// Of what is immersed a body for one water tells what the whole one does, though it computes
// nothing of the rest.
TEST(HullBody, ForOneWater) {
  std::mt19937 random(416);
  mesh::MeshArrays arrays = testing::prism(7);
  testing::randomise(arrays, random, 0.2, 0.0, 0.2);
  const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  const HullBody body(surface, false);
  const Plane water{Vector3d::UnitZ(), 0.1};
  surface::LimitSurface copy(surface);
  HullBody alone(body, copy, water);
  EXPECT_THROW(alone.join({}), std::invalid_argument);
  std::normal_distribution<double> move(0.0, 0.05);
  for (int step = 0; step < 20; ++step) {
    for (Vector3d& p : arrays.points) p.x() += move(random);
    copy.set_points(arrays.points);
    alone.update();
    const Immersion found = alone.immersion(water);
    const Immersion whole = HullBody(copy, false).immersion(water);
    ASSERT_GT(whole.volume, 0.1);
    EXPECT_NEAR(found.volume, whole.volume, 1e-13);
    EXPECT_LT((found.centre_of_buoyancy - whole.centre_of_buoyancy).norm(), 1e-12);
    EXPECT_NEAR(found.waterplane_area, whole.waterplane_area, 1e-12);
    EXPECT_TRUE(std::isnan(found.wetted_surface));
  }
}

// Moments of the old points must not meet the new ones that the water cuts.
TEST(HullBody, OutOfDateRefusesToAnswer) {
  mesh::MeshArrays arrays = testing::prism(7);
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  HullBody body(surface, false, Openings::kOpen);
  const Plane water{Vector3d::UnitZ(), 0.1};
  const double before = body.immersion(water).volume;
  const HullBody twin = body.closed();
  EXPECT_EQ(body.revision(), 0);
  for (auto& point : arrays.points) point.x() *= 2.0;
  surface.set_points(arrays.points);
  const auto refuses = [&](const auto& query) {
    try {
      query();
      ADD_FAILURE() << "an answer of old and new parts";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("Call update() first"), std::string::npos);
    }
  };
  for (const HullBody* stale : std::initializer_list<const HullBody*>{&body, &twin}) {
    refuses([&] { stale->immersion(water); });
    refuses([&] { stale->shell_moments(); });
    refuses([&] { stale->downflooding_point(Vector3d::UnitZ()); });
    refuses([&] { stale->refuse_flooding(water); });
    refuses([&] { stale->closed(); });
    refuses([&] { stale->boxes(); });
    refuses([&] { stale->border(); });
    refuses([&] { stale->closings(); });
  }
  body.update();
  EXPECT_EQ(body.revision(), 1);
  EXPECT_NEAR(body.immersion(water).volume, 2.0 * before, 1e-12 * before);
  refuses([&] { twin.immersion(water); });
}

std::string words_of(const HullBody& body, const Plane& water) {
  try {
    body.immersion(water);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

// y = f(x) g(z): what lies abaft x and below z is twice the product of two integrals, whichever
// cell the water and the station meet in.
TEST(HullBody, VolumeAbaftAStation) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface half{mesh::ControlMesh(ship.mesh)};
  const surface::LimitSurface whole{mesh::ControlMesh(ship.whole())};
  const HullBody halves[] = {HullBody(half, true), HullBody(whole, false)};
  const double size = half.mesh().size();
  for (double draft : {0.3, 3.0, 4.1}) {
    const Plane water = water_plane({draft, 0.0, 0.0, 0.0});
    const double below = ship.upwards.integral([&](double z) { return ship.upwards(z); }, draft);
    for (double x : {-1.0, 0.0, 7.0, 20.0, 31.234, 60.0, 70.0}) {
      const double along = ship.along.integral([&](double s) { return ship.along(s); }, x);
      for (const HullBody& body : halves) {
        EXPECT_NEAR(body.volume_abaft(water, x), 2.0 * along * below, 1e-13 * size * size * size)
            << draft << ", " << x;
      }
    }
  }
  const Plane heeled = water_plane({3.0, 0.0, 0.1, 0.0});
  EXPECT_THROW(halves[0].volume_abaft(heeled, 30.0), std::invalid_argument);
  EXPECT_THROW(halves[0].volume_abaft(water_plane({3.0}), std::nan("")), std::invalid_argument);
}

// An open half box floods over its deck, not through its transom.
TEST(HullBody, FloodsAtItsLowestOpening) {
  const surface::LimitSurface surface{mesh::ControlMesh(half_box(true))};
  const HullBody body(surface, true, Openings::kOpen);
  EXPECT_NEAR(body.immersion({Vector3d::UnitZ(), 2.0}).volume, kL * kB * 2.0, 1e-10);
  EXPECT_NEAR(body.lowest_opening(Vector3d::UnitZ()), kD, 1e-12);
  EXPECT_NE(words_of(body, {Vector3d::UnitZ(), kD + 0.25}).find("0.250 m under water"),
            std::string::npos);
  // Heeled to starboard the edge there goes under first.
  const Plane heeled = water_plane({kD - 0.5, 0.0, 0.2, 0.0});
  const DownfloodingPoint point = body.downflooding_point(heeled.normal);
  EXPECT_NEAR(point.point.y(), -0.5 * kB, 1e-12);
  EXPECT_NE(words_of(body, heeled).find("floods at"), std::string::npos);
  EXPECT_GT(HullBody(surface, true).immersion(heeled).volume, 0.0);
}

TEST(HullBody, BodiesAddUpAndInvertedOnesAreNamed) {
  mesh::MeshArrays two = testing::creased_box(kL, kB, kD);
  const mesh::MeshArrays other = testing::creased_box(kL, kB, kD);
  for (std::size_t v = 0; v < 8; ++v) {
    two.points.push_back(other.points[v] + Vector3d(0.0, 20.0, 0.0));
  }
  for (int v : other.face_vertices) two.face_vertices.push_back(v + 8);
  two.face_sizes.insert(two.face_sizes.end(), 6, 4);
  for (auto [a, b] : other.creases) two.creases.push_back({a + 8, b + 8});
  const Plane water{Vector3d(0.0, 0.1, 1.0).normalized(), 2.0};
  {
    const surface::LimitSurface surface{mesh::ControlMesh(two)};
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
  const surface::LimitSurface surface{mesh::ControlMesh(two)};
  EXPECT_NE(words_of(HullBody(surface, false), water).find("body with face 6"), std::string::npos);
}

}  // namespace
}  // namespace hull::analysis
