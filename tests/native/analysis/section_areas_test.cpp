// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/section_areas.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <stdexcept>

#include "analysis/arithmetic/gauss.h"
#include "analysis/stations/bonjean.h"
#include "natural_hull.h"

namespace hull::analysis {
namespace {

constexpr double kWaterline = 4.1;  // between knots

SectionArea at(const HullBody& body, double x, const FloatingPosition& position) {
  return section_areas(body, {x}, position).front();
}

// ∫ A dx between knots, by a rule far finer than what is asked of it.
double integral_of_areas(const HullBody& body, double length, int spans,
                         const FloatingPosition& position) {
  const GaussRule rule = gauss_rule(16);
  double volume = 0.0;
  for (int k = 0; k < spans; ++k) {
    for (int i = 0; i < 16; ++i) {
      const double x = length * (k + rule.nodes[i]) / spans;
      volume += length / spans * rule.weights[i] * at(body, x, position).area;
    }
  }
  return volume;
}

TEST(SectionAreas, OfABox) {
  constexpr double kL = 40.0, kB = 8.0, kD = 5.0, kT = 2.7;
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(kL, kB, kD))};
  const HullBody body(box, false);
  // The ends are flats in the plane of the station: the larger area counts.
  for (double x : {0.0, 13.0, 20.0, kL}) {
    const SectionArea s = at(body, x, {kT});
    EXPECT_NEAR(s.area, kB * kT, 1e-12) << x;
    EXPECT_LT((s.centroid - Vector3d(x, 0.0, 0.5 * kT)).norm(), 1e-13) << x;
    EXPECT_NEAR(s.girth, kB + 2.0 * kT, 1e-12) << x;
    EXPECT_NEAR(s.breadth, kB, 1e-12) << x;
  }
  EXPECT_EQ(at(body, -1.0, {kT}).area, 0.0);
  EXPECT_EQ(at(body, 41.0, {kT}).area, 0.0);
  EXPECT_EQ(at(body, 20.0, {-0.1}).area, 0.0);
  EXPECT_NEAR(at(body, 20.0, {7.0}).area, kB * kD, 1e-12);
  EXPECT_EQ(at(body, 20.0, {7.0}).breadth, 0.0);
}

// A heeled box: a trapezium below a line through (0, T) that rises by tan(heel) to starboard …
TEST(SectionAreas, OfAHeeledAndTrimmedBox) {
  constexpr double kL = 40.0, kB = 8.0, kT = 2.7, kHeel = 0.2, kTrim = 0.03, kX = 30.0;
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(kL, kB, 5.0))};
  const HullBody body(box, false);
  const SectionArea s = at(body, kX, {kT, kTrim, kHeel, 20.0});
  const Plane water = water_plane({kT, kTrim, kHeel, 20.0});
  const auto height = [&](double y) {
    return (water.offset - water.normal.x() * kX - water.normal.y() * y) / water.normal.z();
  };
  const double port = height(0.5 * kB), starboard = height(-0.5 * kB);
  EXPECT_GT(starboard, port);
  const double area = 0.5 * kB * (port + starboard);
  EXPECT_NEAR(s.area, area, 1e-12);
  EXPECT_NEAR(s.centroid.y(), (port - starboard) * kB * kB / 12.0 / area, 1e-12);
  EXPECT_NEAR(s.centroid.z(),
              kB * (port * port + port * starboard + starboard * starboard) / 6.0 / area, 1e-12);
  EXPECT_NEAR(s.girth, kB + port + starboard, 1e-12);
  EXPECT_NEAR(s.breadth, std::hypot(kB, port - starboard), 1e-12);
}

// A half box open at the deck, heeled until the deck is under water: closed across by the level of
// its edge it is the whole box.
TEST(SectionAreas, CloseTheDeckAthwartships) {
  mesh::MeshArrays half = testing::creased_box(20.0, 3.0, 4.0);
  for (auto& p : half.points) p.y() += 1.5;
  const auto drop_face = [&](int face) {
    half.face_sizes.erase(half.face_sizes.begin() + face);
    half.face_vertices.erase(half.face_vertices.begin() + 4 * face,
                             half.face_vertices.begin() + 4 * face + 4);
  };
  drop_face(2);  // y = 0
  drop_face(1);  // z = 4
  const surface::LimitSurface surface{mesh::ControlMesh(half)};
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(20.0, 6.0, 4.0))};
  const HullBody open(surface, true), closed(box, false);
  for (double heel : {0.0, 0.5, 1.2, -0.9, 2.0, 3.0}) {
    const FloatingPosition position{3.5, 0.02, heel, 10.0};
    const SectionArea a = at(open, 7.0, position), b = at(closed, 7.0, position);
    EXPECT_NEAR(a.area, b.area, 1e-12) << heel;
    EXPECT_LT((a.centroid - b.centroid).norm(), 1e-12) << heel;
    EXPECT_NEAR(a.breadth, b.breadth, 1e-12) << heel;
  }
}

TEST(SectionAreas, OfANaturalHullUpright) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  const HullBody body(surface, true);
  const double fullness = ship.upwards.integral(ship.upwards, kWaterline);
  const double moment =
      ship.upwards.integral([&](double z) { return z * ship.upwards(z); }, kWaterline);
  for (double x : {0.4, 3.0, 10.0, 20.0, 31.7, 59.0}) {
    const SectionArea s = at(body, x, {kWaterline});
    EXPECT_NEAR(s.area, 2.0 * ship.along(x) * fullness, 1e-12 * 50.0) << x;
    EXPECT_NEAR(s.centroid.z(), moment / fullness, 1e-12 * 6.0) << x;
    EXPECT_NEAR(s.centroid.y(), 0.0, 1e-15) << x;
    EXPECT_NEAR(s.breadth, 2.0 * ship.along(x) * ship.upwards(kWaterline), 1e-12 * 12.0) << x;
  }
}

// In waters that the deck edge does not touch, nor an end.
TEST(SectionAreas, IntegrateToTheVolume) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  const HullBody body(surface, true);
  for (const FloatingPosition& position :
       {FloatingPosition{kWaterline}, FloatingPosition{3.0, 0.02, 0.0, 30.0},
        FloatingPosition{3.0, 0.02, 0.1, 30.0}, FloatingPosition{2.5, -0.03, -0.2, 30.0}}) {
    const double volume = body.immersion(water_plane(position)).volume;
    // Where the water leaves the keel's or the knots' lines the curve has kinks between the rule's.
    EXPECT_NEAR(integral_of_areas(body, 60.0, 54, position), volume, 2e-7 * volume);
  }
}

TEST(SectionAreas, OfTheSmoothCubeIntegrateToItsVolume) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const HullBody body(surface, false);
  // The areas begin and end like a paraboloid's: smooth within eight spans, in x from -r to r.
  const GaussRule rule = gauss_rule(20);
  double volume = 0.0;
  const double r = surface.position(0, 1.0, 1.0).cwiseAbs().maxCoeff();
  for (int k = 0; k < 16; ++k) {
    for (int i = 0; i < 20; ++i) {
      const double x = r * (-1.0 + (k + rule.nodes[i]) / 8.0);
      volume += r / 8.0 * rule.weights[i] * at(body, x, {2.0}).area;
    }
  }
  EXPECT_NEAR(volume, 2.62041903269898, 1e-7);
}

TEST(SectionAreas, DoNotDependOnTheHalfThatWasModelled) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface half{mesh::ControlMesh(ship.mesh)},
      whole{mesh::ControlMesh(ship.whole())};
  const HullBody a(half, true), b(whole, false);
  // The deck edge is immersed in the last.
  for (double heel : {0.0, 0.15, -0.4, 0.9}) {
    for (double x : {2.0, 15.5, 30.0, 50.0}) {
      const FloatingPosition position{3.5, 0.01, heel, 30.0};
      const SectionArea p = at(a, x, position), q = at(b, x, position);
      EXPECT_NEAR(p.area, q.area, 1e-11) << heel << " " << x;
      EXPECT_LT((p.centroid - q.centroid).norm(), 1e-11) << heel << " " << x;
      EXPECT_NEAR(p.girth, q.girth, 1e-9) << heel << " " << x;
      EXPECT_NEAR(p.breadth, q.breadth, 1e-10) << heel << " " << x;
    }
  }
}

// The area's derivative with draft is the breadth.
TEST(SectionAreas, GrowByTheirBreadth) {
  constexpr unsigned kSeed = 41;
  std::mt19937 random(kSeed);
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  for (int trial = 0; trial < 20; ++trial) {
    mesh::MeshArrays arrays = testing::prism(3 + trial % 6);
    testing::randomise(arrays, random, 0.2, 0.0, 0.2);
    const surface::LimitSurface surface{mesh::ControlMesh(arrays)};
    const HullBody body(surface, false);
    constexpr double kStep = 1e-4;
    const double x = -0.5 + 0.05 * trial, draft = -0.3 + 0.03 * trial;
    const double above = at(body, x, {draft + kStep}).area;
    const double below = at(body, x, {draft - kStep}).area;
    EXPECT_NEAR((above - below) / (2.0 * kStep), at(body, x, {draft}).breadth, 1e-6) << trial;
  }
}

TEST(Bonjean, EqualsTheSectionsOfEachDraft) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  const HullBody body(surface, true);
  const BonjeanCurves curves = bonjean(body, {0.0, 11.0, 30.0}, {-1.0, 0.0, 0.5, 3.0, 4.5, 6.0});
  for (std::size_t i = 0; i < curves.stations.size(); ++i) {
    for (std::size_t j = 0; j < curves.drafts.size(); ++j) {
      const SectionArea one = at(body, curves.stations[i], {curves.drafts[j]});
      EXPECT_NEAR(curves.at(i, j).area, one.area, 1e-12) << i << " " << j;
      EXPECT_NEAR(curves.at(i, j).girth, one.girth, 1e-9) << i << " " << j;
      EXPECT_NEAR(curves.at(i, j).breadth, one.breadth, 1e-12) << i << " " << j;
      EXPECT_LT((curves.at(i, j).centroid - one.centroid).norm(), 1e-11) << i << " " << j;
    }
  }
  EXPECT_EQ(curves.at(1, 0).area, 0.0);
  EXPECT_EQ(curves.at(1, 1).area, 0.0);
}

// A transom with the noise of single precision is one all the same.
TEST(SectionAreas, AtANoisyTransom) {
  std::mt19937 random(511);
  std::uniform_real_distribution<double> noise(-2e-6, 2e-6);
  for (int trial = 0; trial < 20; ++trial) {
    mesh::MeshArrays box = testing::creased_box(40.0, 8.0, 5.0);
    for (auto& p : box.points) p.x() += noise(random);
    const surface::LimitSurface surface{mesh::ControlMesh(box)};
    const HullBody body(surface, false);
    for (double x : {0.0, 40.0}) {
      const SectionArea found = at(body, x, {3.0});
      EXPECT_NEAR(found.area, 24.0, 1e-12);
      EXPECT_NEAR(found.breadth, 8.0, 1e-12);
      EXPECT_NEAR(found.girth, 14.0, 1e-5);
    }
  }
}

TEST(SectionAreas, RefuseToFlood) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  const HullBody open(surface, true, Openings::kOpen);
  const double edge = open.lowest_opening(Vector3d::UnitZ());
  EXPECT_GT(at(open, 11.0, {edge - 0.1}).area, 0.0);
  EXPECT_THROW(at(open, 11.0, {edge + 0.1}), std::invalid_argument);
  EXPECT_THROW(bonjean(open, {11.0}, {1.0, edge + 0.1}), std::invalid_argument);
}

TEST(SectionAreas, RefuseWhatIsNotANumber) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const HullBody body(surface, false);
  EXPECT_THROW(at(body, NAN, {0.0}), std::invalid_argument);
  EXPECT_THROW(bonjean(body, {0.0}, {NAN}), std::invalid_argument);
  EXPECT_TRUE(bonjean(body, {0.0}, {}).sections.empty());
}

}  // namespace
}  // namespace hull::analysis
