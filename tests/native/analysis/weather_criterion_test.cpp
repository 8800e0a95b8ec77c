// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/weather_criterion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "analysis/arithmetic/degree.h"
#include "analysis/hydrostatics/hydrostatics.h"
#include "analysis/stations/lateral_profile.h"
#include "barges.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

// The tables as printed, at their entries, between them and beyond.
TEST(AngleOfRoll, TablesAreThoseOfTheCode) {
  const auto expect = [](double (*table)(double), std::vector<std::pair<double, double>> entries) {
    for (const auto& [at, value] : entries) EXPECT_NEAR(table(at), value, 1e-15) << at;
  };
  expect(&roll_factor_x1, {{1.0, 1.0},
                           {2.4, 1.0},
                           {2.5, 0.98},
                           {2.6, 0.96},
                           {2.7, 0.95},
                           {2.8, 0.93},
                           {2.9, 0.91},
                           {3.0, 0.90},
                           {3.1, 0.88},
                           {3.2, 0.86},
                           {3.3, 0.84},
                           {3.4, 0.82},
                           {3.5, 0.80},
                           {9.0, 0.80},
                           {2.75, 0.94}});
  expect(&roll_factor_x2, {{0.3, 0.75},
                           {0.45, 0.75},
                           {0.5, 0.82},
                           {0.55, 0.89},
                           {0.6, 0.95},
                           {0.65, 0.97},
                           {0.7, 1.0},
                           {0.9, 1.0},
                           {0.525, 0.855}});
  expect(&roll_factor_k, {{0.0, 1.0},
                          {1.0, 0.98},
                          {1.5, 0.95},
                          {2.0, 0.88},
                          {2.5, 0.79},
                          {3.0, 0.74},
                          {3.5, 0.72},
                          {4.0, 0.70},
                          {7.0, 0.70},
                          {0.5, 0.99}});
  expect(&wave_steepness, {{3.0, 0.1},
                           {6.0, 0.1},
                           {7.0, 0.098},
                           {8.0, 0.093},
                           {12.0, 0.065},
                           {14.0, 0.053},
                           {16.0, 0.044},
                           {18.0, 0.038},
                           {20.0, 0.035},
                           {30.0, 0.035},
                           {10.0, 0.079}});
}

// By hand: B/d = 2.5, X1 = 0.98; CB = 0.575, X2 = 0.92; 100 Ak / (L B) = 2, k = 0.88; OG/d = 0.1,
// r = 0.79; C = 0.373 + 0.0575 - 0.043 = 0.3875, T = 0.775 · 20 / √1 = 15.5 s, s = 0.04625.
TEST(AngleOfRoll, OfAShipByHand) {
  RollingShip ship{100.0, 20.0, 8.0, 0.575, 8.8, 1.0, 40.0, false, {}};
  const AngleOfRoll roll = angle_of_roll(ship);
  EXPECT_NEAR(roll.period, 15.5, 1e-12);
  EXPECT_NEAR(roll.s, 0.04625, 1e-15);
  EXPECT_NEAR(roll.r, 0.79, 1e-15);
  EXPECT_NEAR(roll.angle / kDegree, 109.0 * 0.88 * 0.98 * 0.92 * std::sqrt(0.79 * 0.04625), 1e-12);
  EXPECT_NEAR(roll.angle / kDegree, 16.531, 5e-4);
  EXPECT_EQ(roll.out_of_range, "");
  ship.sharp_bilges = true;
  EXPECT_NEAR(angle_of_roll(ship).angle, roll.angle * 0.7 / 0.88, 1e-14);
  ship.period = 10.0;
  EXPECT_EQ(angle_of_roll(ship).s, wave_steepness(10.0));
}

TEST(AngleOfRoll, SaysWhereItIsNotMeantFor) {
  const RollingShip within{100.0, 20.0, 8.0, 0.6, 8.8, 1.0, 0.0, false, {}};
  const auto words = [&](auto change) {
    RollingShip ship = within;
    change(ship);
    return angle_of_roll(ship).out_of_range;
  };
  EXPECT_EQ(words([](RollingShip&) {}), "");
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(words([](RollingShip& s) { s.beam = 28.0; }), "B/d is 3.5"));
  EXPECT_TRUE(has(words([](RollingShip& s) { s.kg = 12.0; }), "KG/d - 1 is 0.5"));
  EXPECT_TRUE(has(words([](RollingShip& s) { s.kg = 5.0; }), "KG/d - 1 is -0.375"));
  EXPECT_TRUE(has(words([](RollingShip& s) { s.period = 20.0; }), "T is 20"));
  EXPECT_THROW(words([](RollingShip& s) { s.gm = -0.1; }), std::invalid_argument);
  EXPECT_THROW(words([](RollingShip& s) { s.kg = -2.0; }), std::invalid_argument);
  EXPECT_THROW(words([](RollingShip& s) { s.draft = 0.0; }), std::invalid_argument);
  EXPECT_THROW(words([](RollingShip& s) { s.keel_area = NAN; }), std::invalid_argument);
  EXPECT_THROW(words([](RollingShip& s) { s.waterline_length = 1500.0; }), std::invalid_argument);
}

// What is above the water is what is below it of the body turned upside down.
TEST(LateralProfile, OfABodyUpsideDown) {
  std::mt19937 random(23);
  mesh::MeshArrays mesh = testing::cube();
  testing::randomise(mesh, random, 0.0, 0.0, 0.1);
  for (auto& p : mesh.points) p.x() *= 4.0;
  mesh::MeshArrays turned = mesh;
  for (auto& p : turned.points) p = {p.x(), -p.y(), -p.z()};
  const surface::LimitSurface surface{mesh::ControlMesh(mesh)}, other{mesh::ControlMesh(turned)};
  const HullBody body(surface, false), upside_down(other, false);
  const Vector3d up = up_direction(0.05, 0.0);
  const LateralProfile profile = lateral_profile(body, {up, 0.1});
  const LateralProfile image = lateral_profile(upside_down, {Vector3d(-up.x(), 0.0, up.z()), -0.1});
  EXPECT_GT(profile.above.area, 0.5);
  EXPECT_NEAR(profile.above.area, image.below.area, 1e-10);
  EXPECT_NEAR(profile.above.centre.x(), image.below.centre.x(), 1e-10);
  EXPECT_NEAR(profile.above.centre.z(), -image.below.centre.z(), 1e-10);
}

// A box barge, whose righting levers and areas follow from its section alone.
struct Barge {
  static constexpr double kLength = 60.0, kBeam = 12.0, kDraft = 4.5;
  double kg, depth;
  testing::Polygon section = testing::box_section(kBeam, depth);
  surface::LimitSurface surface{mesh::ControlMesh(testing::barge(section, kLength))};
  HullBody body{surface, false};

  explicit Barge(double height, double to_deck = 8.0) : kg(height), depth(to_deck) {}
  Barge(const Barge&) = delete;  // the body refers to the surface

  WeatherOptions options() const {
    WeatherOptions given;
    given.midship = 0.5 * kLength;
    given.wind_areas = {{150.0, 10.0}};
    for (int v = 0; v < static_cast<int>(surface.mesh().points().size()); ++v) {
      if (surface.mesh().points()[v].z() > 0.5 * depth) {
        given.stability.edges.deck_edge_vertices.push_back(v);
      }
    }
    return given;
  }
  LoadCase load() const { return {kLength * kBeam * kDraft, {0.5 * kLength, 0.0, kg}, 1.0}; }
  WeatherCriterion result(const WeatherOptions& given) const {
    return weather_criterion(body, load(), given);
  }
  double lever(double heel) const {
    return testing::section_lever(section, kBeam * kDraft, {0.0, kg}, heel);
  }
  // Potential energy over weight: its rise is the area under GZ.
  double height(double heel) const {
    const Eigen::Vector2d up(std::sin(heel), std::cos(heel));
    const auto wet = testing::section_afloat(section, up, kBeam * kDraft);
    return up.dot(Eigen::Vector2d(0.0, kg) - wet.centroid);
  }
  // Where GZ is as great as a heeling lever, between two heels.
  double heel_at(double wanted, double below, double above) const {
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (below + above);
      (lever(middle) < wanted ? below : above) = middle;
    }
    return below;
  }
};

// The same ship by hand and by the closed forms of a box. A: 60 m · 3.5 m of side at 6.25 m, 150 m²
// of house at 10 m; B/d = 2.667, X1 = 0.9533; CB = 1; OG = -0.1 m.
TEST(WeatherCriterion, OfABargeByHand) {
  const Barge barge(4.4);
  const WeatherCriterion found = barge.result(barge.options());
  EXPECT_NEAR(found.wind_area, 360.0, 1e-9);
  EXPECT_NEAR(found.wind_lever, 2812.5 / 360.0 - 2.25, 1e-11);
  const double lw1 = 504.0 * 360.0 * 5.5625 / (1000.0 * 9.81 * 3240.0);
  EXPECT_NEAR(found.steady_lever, lw1, 1e-13);
  EXPECT_NEAR(found.gust_lever, 1.5 * lw1, 1e-13);
  EXPECT_NEAR(found.draft, 4.5, 1e-10);
  EXPECT_NEAR(found.block_coefficient, 1.0, 1e-9);

  ASSERT_TRUE(found.roll);
  const double gm = 2.25 + 144.0 / 12.0 / 4.5 - 4.4;
  const double period = 2.0 * (0.373 + 0.023 * 12.0 / 4.5 - 0.043 * 0.6) * 12.0 / std::sqrt(gm);
  const double s = 0.065 - 0.006 * (period - 12.0), r = 0.73 - 0.06 / 4.5;
  const double x1 = 0.95 + 0.1 * (2.7 - 12.0 / 4.5);
  EXPECT_NEAR(found.roll->period, period, 1e-8);
  EXPECT_NEAR(found.roll->angle / kDegree, 109.0 * x1 * std::sqrt(r * s), 1e-8);
  EXPECT_NEAR(found.roll->angle / kDegree, 20.660, 1e-3);

  const double steady = barge.heel_at(lw1, 0.0, 0.3), gust = barge.heel_at(1.5 * lw1, 0.0, 0.3);
  const double windward = steady - found.roll->angle, last = 50.0 * kDegree;
  EXPECT_NEAR(found.steady_heel.value(), steady, 1e-10);
  EXPECT_NEAR(found.gust_heel.value(), gust, 1e-10);
  EXPECT_NEAR(found.windward_heel.value(), windward, 1e-10);
  EXPECT_NEAR(found.last_heel.value(), last, 1e-12);
  EXPECT_NEAR(found.deck_edge_heel.value(), std::atan(3.5 / 6.0), 1e-10);
  const double rise_a = barge.height(gust) - barge.height(windward);
  const double rise_b = barge.height(last) - barge.height(gust);
  EXPECT_NEAR(found.area_a.value(), 1.5 * lw1 * (gust - windward) - rise_a, 3e-8);
  EXPECT_NEAR(found.area_b.value(), rise_b - 1.5 * lw1 * (last - gust), 3e-8);
  EXPECT_GT(*found.area_a, 0.01);

  ASSERT_EQ(found.criteria.size(), 2u);
  EXPECT_EQ(found.criteria[0].paragraph, "2.3.1.2");
  EXPECT_EQ(found.criteria[0].limit, 16.0 * kDegree);
  EXPECT_EQ(found.criteria[1].value, found.area_b);
  EXPECT_EQ(found.criteria[1].limit, *found.area_a);
  EXPECT_TRUE(found.passes);
  EXPECT_NE(found.criteria[1].note.find("No downflooding point"), std::string::npos);
}

// The area a is what the gust's work leaves to be taken by b: more wind fails first by the areas.
TEST(WeatherCriterion, FailsWhereTheWindIsTooStrong) {
  const Barge barge(4.4);
  double before = 0.0;
  bool has_failed = false;
  for (double area : {0.0, 400.0, 800.0, 1600.0, 3200.0, 6400.0}) {
    WeatherOptions given = barge.options();
    given.wind_areas = {{area, 12.0}};
    const WeatherCriterion found = barge.result(given);
    EXPECT_GT(found.steady_lever, before);
    before = found.steady_lever;
    EXPECT_FALSE(has_failed && found.passes) << area;
    has_failed = !found.passes;
  }
  EXPECT_TRUE(has_failed);
  WeatherOptions storm = barge.options();
  storm.wind_areas = {{1e5, 12.0}};
  const WeatherCriterion blown_over = barge.result(storm);
  EXPECT_FALSE(blown_over.steady_heel || blown_over.area_b);
  for (const Criterion& c : blown_over.criteria) EXPECT_EQ(c.outcome, CriterionOutcome::kFail);
}

// Area b ends where GZ falls below the gust's lever, or where she floods, if that is before 50°.
TEST(WeatherCriterion, EndsWhereTheCurveDoes) {
  const Barge shallow(3.5, 5.5);
  WeatherOptions given = shallow.options();
  const WeatherCriterion early = shallow.result(given);
  ASSERT_TRUE(early.second_intercept);
  const double intercept = shallow.heel_at(early.gust_lever, 60.0 * kDegree, 25.0 * kDegree);
  EXPECT_NEAR(*early.second_intercept, intercept, 1e-9);
  EXPECT_EQ(early.last_heel, early.second_intercept);
  EXPECT_NE(early.criteria[1].note.find("falls below"), std::string::npos);

  const Barge barge(4.4);
  given = barge.options();
  // At the deck's edge amidships: it floods where that dips.
  given.stability.edges.downflooding_points = {{30.0, -6.0, 8.0}};
  const WeatherCriterion wet = barge.result(given);
  const double flooding = std::atan(3.5 / 6.0);
  EXPECT_NEAR(wet.last_heel.value(), flooding, 1e-10);
  const double lw2 = wet.gust_lever, gust = *wet.gust_heel;
  EXPECT_NEAR(*wet.area_b, barge.height(flooding) - barge.height(gust) - lw2 * (flooding - gust),
              3e-8);
  EXPECT_NE(wet.criteria[1].note.find("floods"), std::string::npos);
  // Flooding before the gust's heel leaves no area b.
  given.stability.edges.downflooding_points = {{30.0, -6.0, 4.6}};
  const WeatherCriterion swamped = barge.result(given);
  EXPECT_EQ(swamped.area_b.value(), 0.0);
  EXPECT_EQ(swamped.criteria[1].outcome, CriterionOutcome::kFail);
}

TEST(WeatherCriterion, TakesWindAreasAsGiven) {
  const Barge barge(4.4);
  WeatherOptions given = barge.options();
  given.hull_profile = false;
  given.wind_areas = {{300.0, 7.0}, {100.0, 11.0}};
  const WeatherCriterion found = barge.result(given);
  EXPECT_NEAR(found.wind_area, 400.0, 1e-12);
  EXPECT_NEAR(found.wind_lever, 8.0 - 2.25, 1e-11);
  given.wind_lever = 6.5;
  EXPECT_EQ(barge.result(given).wind_lever, 6.5);
  given.wind_pressure = 252.0;
  EXPECT_NEAR(barge.result(given).steady_lever, 0.5 * found.steady_lever * 6.5 / 5.75, 1e-12);
}

TEST(WeatherCriterion, DeckEdgeUnderWaterUprightIsSaid) {
  const Barge barge(4.4);
  WeatherOptions given = barge.options();
  given.stability.edges.deck_edge_vertices.clear();
  // The bottom of a side as the deck edge.
  for (int v = 0; v < static_cast<int>(barge.surface.mesh().points().size()); ++v) {
    if (barge.surface.mesh().points()[v].z() < 1.0) {
      given.stability.edges.deck_edge_vertices.push_back(v);
    }
  }
  const Criterion heel = barge.result(given).criteria.at(0);
  EXPECT_EQ(heel.limit, 0.0);
  EXPECT_EQ(heel.outcome, CriterionOutcome::kFail);
  EXPECT_NE(heel.note.find("under water upright"), std::string::npos);
  given.stability.edges.deck_edge_vertices.clear();
  EXPECT_NE(barge.result(given).criteria.at(0).note.find("No deck edge"), std::string::npos);
}

// So far to port that she heels more to windward than is looked.
TEST(WeatherCriterion, TooLargeAListToWindwardIsSaid) {
  const Barge barge(4.4);
  LoadCase load = barge.load();
  load.centre_of_gravity.y() = 5.0;
  const WeatherCriterion found = weather_criterion(barge.body, load, barge.options());
  EXPECT_FALSE(found.steady_heel);
  EXPECT_FALSE(found.passes);
  EXPECT_NE(found.criteria[0].note.find("list to windward"), std::string::npos);
}

TEST(WeatherCriterion, AShipThatDoesNotStandUprightFails) {
  const Barge crank(4.97);
  const WeatherCriterion found = crank.result(crank.options());
  EXPECT_FALSE(found.roll);
  EXPECT_FALSE(found.passes);
  EXPECT_NE(found.criteria[1].note.find("GM is not positive"), std::string::npos);
}

TEST(WeatherCriterion, RefusesWhatMakesNoSense) {
  const Barge barge(4.4);
  const auto refuses = [&](auto change) {
    WeatherOptions given = barge.options();
    change(given);
    EXPECT_THROW(barge.result(given), std::invalid_argument);
  };
  refuses([](WeatherOptions& o) { o.wind_areas = {{-1.0, 3.0}}; });
  refuses([](WeatherOptions& o) { o.wind_areas = {{1.0, NAN}}; });
  refuses([](WeatherOptions& o) { o.hull_profile = false, o.wind_areas = {}; });
  refuses([](WeatherOptions& o) { o.hull_profile = false, o.wind_areas = {{9.0, 1.0}}; });
  refuses([](WeatherOptions& o) { o.wind_lever = 0.0; });
  refuses([](WeatherOptions& o) { o.wind_pressure = 0.0; });
  refuses([](WeatherOptions& o) { o.beam = -1.0; });
  refuses([](WeatherOptions& o) { o.roll_period = -1.0; });
}

}  // namespace
}  // namespace hull::analysis
