// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_criteria.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/arithmetic/degree.h"
#include "barges.h"

namespace hull::analysis {
namespace {

// A box barge of the given depth, its centre of gravity at the height z.
struct Case {
  testing::Polygon section;
  double z;
  surface::LimitSurface surface;
  HullBody body;

  Case(double depth, double height)
      : section(testing::box_section(testing::kBargeBeam, depth)),
        z(height),
        surface(mesh::ControlMesh(testing::barge(section, testing::kBargeLength))),
        body(surface, false) {}
  Case(const Case&) = delete;  // the body refers to the surface

  StabilityReport report(const StabilityEdges& edges = {}) const {
    const LoadCase load{testing::kBargeLength * testing::kBargeBeam * testing::kBargeDraft,
                        {0.5 * testing::kBargeLength, 0.0, z},
                        1.0};
    return stability_criteria(body, load, {TrimMode::kFree, 0.0, edges});
  }
  // Potential energy over weight, by the clipped section: its rise is the area under GZ.
  double height(double heel) const {
    const Eigen::Vector2d up(std::sin(heel), std::cos(heel));
    const auto wet =
        testing::section_afloat(section, up, testing::kBargeBeam * testing::kBargeDraft);
    return up.dot(Eigen::Vector2d(0.0, z) - wet.centroid);
  }
  double lever(double heel) const {
    return testing::section_lever(section, testing::kBargeBeam * testing::kBargeDraft, {0.0, z},
                                  heel);
  }
  // The greatest lever from one heel to another, to the square of the step.
  double greatest(double from, double to) const {
    double best = -1e9;
    for (int i = 0; i <= 2000; ++i) best = std::max(best, lever(from + (to - from) * i / 2000.0));
    return best;
  }
};

void expect_values(const StabilityReport& report, const std::vector<double>& values,
                   double tolerance) {
  ASSERT_EQ(report.criteria.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Criterion& c = report.criteria[i];
    ASSERT_TRUE(c.value) << c.name;
    EXPECT_NEAR(*c.value, values[i], tolerance) << c.name;
    EXPECT_EQ(c.outcome, values[i] >= c.limit ? CriterionOutcome::kPass : CriterionOutcome::kFail)
        << c.name;
  }
}

TEST(StabilityCriteria, ValuesOfABarge) {
  const Case high(5.0, 2.8);
  const StabilityReport report = high.report();
  const double from_0 = high.height(0.0), at_30 = high.height(30.0 * kDegree);
  const double at_40 = high.height(40.0 * kDegree);
  const Criterion& heel = report.criteria.at(4);
  ASSERT_TRUE(heel.value);
  EXPECT_NEAR(high.lever(*heel.value), high.greatest(0.0, 90.0 * kDegree), 1e-6);
  constexpr double kGM = 0.5 * testing::kBargeDraft +
                         testing::kBargeBeam * testing::kBargeBeam / 12.0 / testing::kBargeDraft -
                         2.8;
  expect_values(report,
                {at_30 - from_0, at_40 - from_0, at_40 - at_30,
                 high.greatest(30.0 * kDegree, 90.0 * kDegree), *heel.value, kGM},
                1e-6);
  EXPECT_TRUE(report.passes);
  EXPECT_FALSE(report.downflooding_heel);
  EXPECT_EQ(report.criteria[0].paragraph, "2.2.1");
  EXPECT_EQ(report.criteria[5].paragraph, "2.2.4");
  EXPECT_NE(report.criteria[0].note.find("No downflooding point"), std::string::npos);
}

// A shallow barge has its greatest lever early: one criterion fails, and with it the ship.
TEST(StabilityCriteria, EarlyGreatestLeverFails) {
  const Case shallow(2.6, 1.5);
  const StabilityReport report = shallow.report();
  const Criterion& heel = report.criteria.at(4);
  ASSERT_TRUE(heel.value);
  EXPECT_LT(*heel.value, 25.0 * kDegree);
  EXPECT_EQ(heel.outcome, CriterionOutcome::kFail);
  EXPECT_NE(heel.note.find("not practicable"), std::string::npos);
  EXPECT_FALSE(report.passes);
}

TEST(StabilityCriteria, SmallMetacentricHeightFails) {
  const Case tender(
      5.0, 0.5 * testing::kBargeDraft +
               testing::kBargeBeam * testing::kBargeBeam / 12.0 / testing::kBargeDraft - 0.1);
  const Criterion gm = tender.report().criteria.at(5);
  EXPECT_NEAR(gm.value.value(), 0.1, 1e-10);
  EXPECT_EQ(gm.outcome, CriterionOutcome::kFail);
}

// Between 30° and 40° flooding ends the areas; before 30° it fails them.
TEST(StabilityCriteria, FloodingEndsTheCurve) {
  const Case barge(5.0, 2.8);
  const auto point_at = [&](double heel) {
    // A point 3 m to starboard that comes under water at this heel.
    double low = 0.0, high = 10.0;
    const Eigen::Vector2d up(std::sin(heel), std::cos(heel));
    for (int i = 0; i < 100; ++i) {
      const double z = 0.5 * (low + high);
      const double area =
          testing::wet_section(barge.section, up, up.dot(Eigen::Vector2d(-3.0, z))).area;
      (area < testing::kBargeBeam * testing::kBargeDraft ? low : high) = z;
    }
    return StabilityEdges{{{10.0, -3.0, low}}, {}};
  };
  const double at_35 = 70.0 * kDegree / 2.0;
  const StabilityReport late = barge.report(point_at(at_35));
  ASSERT_TRUE(late.downflooding_heel);
  EXPECT_NEAR(*late.downflooding_heel, at_35, 1e-9);
  EXPECT_NEAR(late.criteria[1].value.value(), barge.height(at_35) - barge.height(0.0), 1e-7);
  EXPECT_NEAR(late.criteria[2].value.value(), barge.height(at_35) - barge.height(30.0 * kDegree),
              1e-7);
  EXPECT_NE(late.criteria[1].name.find("35.0°"), std::string::npos);

  const StabilityReport early = barge.report(point_at(20.0 * kDegree));
  ASSERT_TRUE(early.downflooding_heel);
  EXPECT_FALSE(early.passes);
  for (int i : {0, 2, 3, 4}) {
    EXPECT_EQ(early.criteria[i].outcome, CriterionOutcome::kFail) << early.criteria[i].name;
  }
  EXPECT_FALSE(early.criteria[2].value || early.criteria[3].value);
  EXPECT_NE(early.criteria[3].note.find("floods at 20.0°"), std::string::npos);
  EXPECT_EQ(early.criteria[5].outcome, CriterionOutcome::kPass);
}

}  // namespace
}  // namespace hull::analysis
