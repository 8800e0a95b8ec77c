// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/righting_levers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <numbers>
#include <random>
#include <stdexcept>
#include <type_traits>

#include "analysis/arithmetic/degree.h"
#include "analysis/arithmetic/gauss.h"
#include "analysis/immersion/floating_position.h"
#include "analysis/stability/cross_curves.h"
#include "barges.h"

namespace hull::analysis {
namespace {

using testing::Polygon;

std::vector<double> heels_to(double last_deg, double step_deg) {
  std::vector<double> heels;
  for (int i = 0; i * step_deg <= last_deg + 1e-9; ++i) heels.push_back(i * step_deg * kDegree);
  return heels;
}

// A barge of a section, 20 m long, of the draft that a wet area means.
struct Afloat {
  Polygon section;
  double wet_area;
  surface::LimitSurface surface;
  HullBody body;
  static constexpr double kLength = 20.0;

  Afloat(Polygon polygon, double area)
      : section(std::move(polygon)),
        wet_area(area),
        surface(mesh::ControlMesh(testing::barge(section, kLength))),
        body(surface, false) {}
  Afloat(const Afloat&) = delete;  // the body refers to the surface

  LoadCase load(double y, double z, double x = 0.5 * kLength) const {
    return {wet_area * kLength * 1.025, {x, y, z}, 1.025};
  }
};

Afloat box() {
  return {testing::box_section(testing::kBargeBeam, testing::kBargeDepth),
          testing::kBargeBeam * testing::kBargeDraft};
}

// GZ = sin φ (GM + BM tan² φ / 2) as long as the sides cut the water (wall-sided formula).
TEST(RightingLevers, OfAWallSidedBarge) {
  const Afloat barge = box();
  constexpr double kG = 2.5;
  constexpr double kBM = testing::kBargeBeam * testing::kBargeBeam / 12.0 / testing::kBargeDraft;
  constexpr double kGM = 0.5 * testing::kBargeDraft + kBM - kG;
  const RightingLevers levers =
      righting_levers(barge.body, barge.load(0.0, kG), heels_to(25.0, 5.0));
  EXPECT_NEAR(levers.gm, kGM, 1e-11);
  for (const HeeledState& s : levers.states) {
    const double t = std::tan(s.heel);
    EXPECT_NEAR(s.righting_lever, std::sin(s.heel) * (kGM + 0.5 * kBM * t * t), 1e-11);
    EXPECT_NEAR(s.trim, 0.0, 1e-11);
  }
}

// Every section, all the way round, symmetric or not, G off the middle; the lever's slope against
// finite differences of the independent lever.
TEST(RightingLevers, OfPrismsAllTheWayRound) {
  const Polygon lopsided{{-3.0, 0.3}, {1.0, 0.0}, {4.0, 1.5}, {3.5, 4.0}, {-1.0, 5.0}, {-4.0, 3.0}};
  for (const Afloat& barge :
       {box(), Afloat(testing::round_section(12, 3.0, 3.0, 3.0), 11.0), Afloat(lopsided, 13.0)}) {
    const LoadCase load = barge.load(0.15, 2.2);
    const Eigen::Vector2d gravity = load.centre_of_gravity.tail<2>();
    const RightingLevers levers = righting_levers(barge.body, load, heels_to(180.0, 10.0));
    for (const HeeledState& s : levers.states) {
      const auto lever = [&](double heel) {
        return testing::section_lever(barge.section, barge.wet_area, gravity, heel);
      };
      EXPECT_NEAR(s.righting_lever, lever(s.heel), 1e-10) << "heel " << s.heel / kDegree;
      constexpr double kStep = 1e-5;
      const double slope = (lever(s.heel + kStep) - lever(s.heel - kStep)) / (2.0 * kStep);
      EXPECT_NEAR(s.slope, slope, 1e-4) << "heel " << s.heel / kDegree;
    }
  }
}

TEST(RightingLevers, TurnRoundWithTheSide) {
  const Afloat barge(testing::round_section(10, 4.0, 3.0, 3.0, std::numbers::pi / 10.0), 12.0);
  HeelingPath starboard = heeling_path(barge.body, barge.load(0.2, 2.8, 9.5), TrimMode::kFree, 0.0);
  HeelingPath port = heeling_path(barge.body, barge.load(-0.2, 2.8, 9.5), TrimMode::kFree, 0.0);
  for (double heel : heels_to(170.0, 17.0)) {
    const HeeledState &a = starboard.at(heel), &b = port.at(-heel);
    EXPECT_NEAR(a.righting_lever, -b.righting_lever, 1e-10);
    EXPECT_NEAR(a.trim, b.trim, 1e-11);
    EXPECT_NEAR(a.slope, b.slope, 1e-8);
    EXPECT_NEAR(a.immersion.volume, barge.load(0, 0).displaced_volume(), 1e-8);
  }
}

// A body that looks the same after every quarter turn about x, G on that axis: no lever at whole
// multiples of 45°, where it is symmetric, and the same levers a quarter turn on.
TEST(RightingLevers, OfABodyOfFourfoldSymmetry) {
  mesh::MeshArrays mesh = testing::cube();
  for (auto& p : mesh.points) p.x() *= 6.0;
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const HullBody body(surface, false);
  const LoadCase load{2.7, Vector3d::Zero(), 1.0};
  HeelingPath path = heeling_path(body, load, TrimMode::kFree, 0.0);
  for (int k = 0; k <= 8; ++k)
    EXPECT_NEAR(path.at(k * std::numbers::pi / 4.0).righting_lever, 0.0, 1e-10);
  const double quarter = path.at(0.2 + std::numbers::pi / 2.0).righting_lever;
  EXPECT_NEAR(path.at(0.2).righting_lever, quarter, 1e-10);
  EXPECT_GT(std::abs(quarter), 1e-5);
}

// What is known of other heels was of the body as it was.
TEST(RightingLevers, PathsRefuseOnceTheirBodyWasUpdated) {
  surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  HullBody body(surface, false);
  HeelingPath path = heeling_path(body, {0.4, Vector3d::Zero(), 1.0}, TrimMode::kFree, 0.0);
  path.at(0.1);
  surface.set_points(surface.mesh().points());
  for (double heel : {0.1, 0.2}) EXPECT_THROW(path.at(heel), std::invalid_argument);
  body.update();
  for (double heel : {0.1, 0.2}) EXPECT_THROW(path.at(heel), std::invalid_argument);
}

// ∇ ∫ GZ cos θ dφ is the rise of the energy ∇ (G - B)·up, at any trim.
TEST(RightingLevers, WorkIsTheEnergysRise) {
  std::mt19937 random(17);
  mesh::MeshArrays mesh = testing::cube();
  testing::randomise(mesh, random, 0.0, 0.0, 0.15);
  for (auto& p : mesh.points) p.x() *= 5.0;
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const HullBody body(surface, false);
  const LoadCase load{4.0, {0.4, 0.02, -0.1}, 1.0};
  for (TrimMode mode : {TrimMode::kFree, TrimMode::kFixed}) {
    HeelingPath path = heeling_path(body, load, mode, mode == TrimMode::kFixed ? 0.05 : 0.0);
    const auto height = [&](double heel) {
      const HeeledState& s = path.at(heel);
      return s.immersion.water.normal.dot(load.centre_of_gravity - s.immersion.centre_of_buoyancy);
    };
    const GaussRule rule = gauss_rule(8);
    constexpr int kParts = 8;
    const double step = 1.6 / kParts;
    double work = 0.0;
    for (int part = 0; part < kParts; ++part) {
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const HeeledState& s = path.at((part + rule.nodes[i]) * step);
        work += rule.weights[i] * step * s.righting_lever * std::cos(s.trim);
      }
    }
    EXPECT_NEAR(work, height(1.6) - height(0.0), 1e-9);
  }
}

// Areas of a prism, where trim stays zero, are those of the independent lever's energy.
TEST(RightingLevers, AreasToTheirTolerance) {
  const Afloat barge = box();
  const LoadCase load = barge.load(0.0, 2.5);
  const auto height = [&](double heel) {
    const Eigen::Vector2d up(std::sin(heel), std::cos(heel));
    const auto wet = testing::section_afloat(barge.section, up, barge.wet_area);
    return up.dot(Eigen::Vector2d(load.centre_of_gravity.tail<2>()) - wet.centroid);
  };
  RightingLeverOptions options;
  options.area_intervals = {{0.0, 30.0 * kDegree}, {0.0, 70.0 * kDegree}, {0.7, 0.2}};
  const RightingLevers levers = righting_levers(barge.body, load, heels_to(90.0, 10.0), options);
  for (std::size_t i = 0; i < options.area_intervals.size(); ++i) {
    const auto [from, to] = options.area_intervals[i];
    EXPECT_NEAR(levers.areas[i], height(to) - height(from), 2e-9);
  }
}

// sin φ GM is the lever but for terms of the third order.
TEST(RightingLevers, StartAsTheMetacentreSays) {
  const Afloat barge(testing::round_section(8, 4.0, 3.0, 3.0, std::numbers::pi / 8.0), 16.0);
  HeelingPath path = heeling_path(barge.body, barge.load(0.0, 2.5, 9.0), TrimMode::kFree, 0.0);
  const double gm = path.at(0.0).slope;
  const auto departure = [&](double heel) {
    return std::abs(path.at(heel).righting_lever - gm * std::sin(heel));
  };
  EXPECT_GT(path.at(0.0).trim, 0.01);
  for (double heel : {0.08, 0.04}) {
    EXPECT_NEAR(std::log2(departure(heel) / departure(0.5 * heel)), 3.0, 0.05);
  }
}

TEST(RightingLevers, FeaturesAreExact) {
  const Afloat barge = box();
  const LoadCase load = barge.load(0.0, 3.2);
  RightingLeverOptions options;
  options.edges.deck_edge_vertices = {2,
                                      6};  // along the ship, port; one chain from corner to corner
  options.edges.downflooding_points = {{10.0, -2.0, testing::kBargeDepth},
                                       {10.0, 2.0, testing::kBargeDepth}};
  const RightingLevers levers = righting_levers(barge.body, load, heels_to(90.0, 10.0), options);
  const auto lever = [&](double heel) {
    return testing::section_lever(barge.section, barge.wet_area, {0.0, 3.2}, heel);
  };
  ASSERT_TRUE(levers.vanishing_heel && levers.greatest && levers.downflooding_heel);
  EXPECT_NEAR(lever(*levers.vanishing_heel), 0.0, 1e-10);
  EXPECT_GT(lever(*levers.vanishing_heel - 0.01), 0.0);
  EXPECT_FALSE(levers.greatest->at_end);
  const double top = levers.greatest->heel;
  EXPECT_NEAR(lever(top), levers.greatest->lever, 1e-10);
  for (double step : {-1e-3, 1e-3}) EXPECT_LT(lever(top + step), lever(top));
  // The port deck edge goes under only when she heels to port.
  EXPECT_FALSE(levers.deck_edge_heel);
  options.edges.deck_edge_vertices = {2, 6, 3, 7};
  const RightingLevers both = righting_levers(barge.body, load, heels_to(90.0, 10.0), options);
  ASSERT_TRUE(both.deck_edge_heel);
  // In the water through a point that just comes under, the section displaces what it should.
  const auto area_up_to = [&](double y, double heel) {
    const Eigen::Vector2d up(std::sin(heel), std::cos(heel));
    return testing::wet_section(barge.section, up, up.dot(Eigen::Vector2d(y, testing::kBargeDepth)))
        .area;
  };
  EXPECT_NEAR(area_up_to(-0.5 * testing::kBargeBeam, *both.deck_edge_heel), barge.wet_area, 1e-9);
  EXPECT_NEAR(area_up_to(-2.0, *both.downflooding_heel), barge.wet_area, 1e-9);
}

// What a path was asked before does not decide what is found: only the heels given do.
TEST(RightingLevers, FeaturesAreLookedForAmongTheHeelsGiven) {
  static_assert(!std::is_invocable_v<decltype(&HeelingPath::at), const HeelingPath&, double>,
                "to ask is to solve and to keep: not for two threads");
  const Afloat barge = box();
  const LoadCase load = barge.load(0.0, 3.2);
  HeelingPath fresh = heeling_path(barge.body, load, TrimMode::kFree, 0.0);
  HeelingPath asked = heeling_path(barge.body, load, TrimMode::kFree, 0.0);
  for (double heel : heels_to(90.0, 7.0)) asked.at(heel);
  const std::vector<double> ends{0.0, std::numbers::pi}, fine = heels_to(180.0, 5.0);
  // Upright and upside down the lever rises: by these two heels alone no maximum shows.
  ASSERT_GT(fresh.at(0.0).slope, 0.0);
  ASSERT_GT(fresh.at(std::numbers::pi).slope, 0.0);
  EXPECT_TRUE(greatest_lever(fresh, ends).at_end);
  EXPECT_TRUE(greatest_lever(asked, ends).at_end);
  EXPECT_FALSE(greatest_lever(asked, fine).at_end);
  EXPECT_NEAR(greatest_lever(asked, fine).heel, greatest_lever(fresh, fine).heel, 1e-11);
  EXPECT_EQ(heels_between({0.5, 0.1, 0.5, 0.9}, 0.2, 0.8), (std::vector<double>{0.2, 0.5, 0.8}));
}

// Paths are for one thread each; a body is for many.
TEST(RightingLevers, OfOneBodyInTwoThreads) {
  const Afloat barge(testing::round_section(10, 4.0, 3.0, 3.0, std::numbers::pi / 10.0), 12.0);
  const LoadCase load = barge.load(0.2, 2.8, 9.5);
  const auto levers = [&] {
    HeelingPath path = heeling_path(barge.body, load, TrimMode::kFree, 0.0);
    std::vector<double> found;
    for (double heel : heels_to(90.0, 3.0)) found.push_back(path.at(heel).righting_lever);
    return found;
  };
  std::future<std::vector<double>> other = std::async(std::launch::async, levers);
  const std::vector<double> here = levers();
  EXPECT_EQ(here, other.get());
}

// Without a deck: her borders are the deck edge, and where they go under she floods. The levers
// are those of a decked barge.
TEST(RightingLevers, OfAnOpenBargeUntilSheFloods) {
  const Afloat decked = box();
  mesh::MeshArrays mesh = testing::barge(decked.section, Afloat::kLength);
  mesh.face_sizes.erase(mesh.face_sizes.begin() + 2);
  mesh.face_vertices.erase(mesh.face_vertices.begin() + 8, mesh.face_vertices.begin() + 12);
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const HullBody open(surface, false, Openings::kOpen);
  const LoadCase load = decked.load(0.0, 3.2);
  RightingLeverOptions options;
  options.edges.deck_edge_vertices = {3, 7};  // the starboard one
  const std::vector<double> heels = heels_to(90.0, 10.0);
  const RightingLevers with_deck = righting_levers(decked.body, load, heels, options);
  const RightingLevers without = righting_levers(open, load, heels);
  EXPECT_FALSE(with_deck.can_flood || with_deck.downflooding_heel);
  ASSERT_TRUE(without.can_flood && without.downflooding_heel && without.deck_edge_heel);
  EXPECT_NEAR(*without.downflooding_heel, with_deck.deck_edge_heel.value(), 1e-10);
  EXPECT_NEAR(*without.deck_edge_heel, with_deck.deck_edge_heel.value(), 1e-10);
  for (std::size_t i = 0; i < heels.size(); ++i) {
    EXPECT_NEAR(without.states[i].righting_lever, with_deck.states[i].righting_lever, 1e-10);
  }
}

// The count is what makes a curve fast; it does not depend on the machine.
TEST(RightingLevers, TakeFewImmersionsPerHeel) {
  std::mt19937 random(18);
  mesh::MeshArrays mesh = testing::cube();
  testing::randomise(mesh, random, 0.0, 0.0, 0.15);
  for (auto& p : mesh.points) p.x() *= 5.0;
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const HullBody body(surface, false);
  const RightingLevers levers =
      righting_levers(body, {4.0, {0.4, 0.0, -0.1}, 1.0}, heels_to(90.0, 5.0));
  EXPECT_LE(levers.curve_evaluations, 3.5 * 19 + 8);
  int sum = 0;
  for (const HeeledState& s : levers.states) {
    sum += s.evaluations;
    EXPECT_LE(s.evaluations, s.heel > 0.0 ? 5 : 12) << s.heel / kDegree;
  }
  EXPECT_EQ(sum, levers.curve_evaluations);
  EXPECT_GT(std::abs(levers.states.back().trim), 1e-3);
}

// GZ = KN - KG sin φ, with the centre of gravity under which KN was balanced.
TEST(CrossCurves, GiveTheLevers) {
  std::mt19937 random(19);
  mesh::MeshArrays mesh = testing::cube();
  testing::randomise(mesh, random, 0.0, 0.0, 0.1);
  for (auto& p : mesh.points) p.x() *= 5.0;
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
  const HullBody body(surface, false);
  const std::vector<double> heels = heels_to(80.0, 20.0);
  CrossCurveOptions options;
  options.assumed_kg = 0.1;
  for (const CrossCurve& curve : cross_curves(body, {3.0, 6.0}, heels, options)) {
    const LoadCase load{curve.volume, {curve.lcg, 0.0, options.assumed_kg}, 1.0};
    const RightingLevers levers = righting_levers(body, load, heels);
    for (std::size_t i = 0; i < heels.size(); ++i) {
      EXPECT_NEAR(levers.states[i].righting_lever,
                  curve.levers[i] - options.assumed_kg * std::sin(heels[i]), 1e-10);
      EXPECT_NEAR(levers.states[i].trim, curve.trims[i], 1e-9);
    }
    EXPECT_NEAR(curve.trims[0], 0.0, 1e-10);
  }
}

TEST(RightingLevers, RefuseWhatMakesNoSense) {
  const Afloat barge = box();
  const LoadCase load = barge.load(0.0, 2.5);
  EXPECT_THROW(righting_levers(barge.body, load, {}), std::invalid_argument);
  EXPECT_THROW(righting_levers(barge.body, load, {NAN}), std::invalid_argument);
  EXPECT_THROW(righting_levers(barge.body, {1e6, {10, 0, 2}, 1.0}, {0.1}), std::invalid_argument);
  EXPECT_THROW(righting_levers(barge.body, {0.0, {10, 0, 2}, 1.0}, {0.1}), std::invalid_argument);
  RightingLeverOptions options;
  options.edges.deck_edge_vertices = {2};
  EXPECT_THROW(righting_levers(barge.body, load, {0.1}, options), std::invalid_argument);
  options.edges.deck_edge_vertices = {2, 99};
  EXPECT_THROW(righting_levers(barge.body, load, {0.1}, options), std::invalid_argument);
  EXPECT_THROW(cross_curves(barge.body, {0.0}, {0.1}), std::invalid_argument);
  EXPECT_THROW(cross_curves(barge.body, {1e5}, {0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::analysis
