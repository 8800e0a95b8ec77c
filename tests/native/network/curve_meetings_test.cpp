// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/crossings/curve_meetings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "network/crossings/near_zones.h"
#include "network/curves/conics.h"
#include "random_values.h"
#include "trials.h"

namespace hull::network {
namespace {

using hull::testing::random_vector;
using hull::testing::uniform;

constexpr double kReach = 1e-3;

CurveMeetings met(const NurbsCurve& a, const NurbsCurve& b, double reach = kReach) {
  CurveTree first(a, 0.05 * reach), second(b, 0.05 * reach);
  return curve_meetings(first, second, reach);
}

NurbsCurve any_curve(std::mt19937& random, bool is_flat) {
  const int degree = 1 + static_cast<int>(random() % 4);
  const int count = degree + 2 + static_cast<int>(random() % 5);
  Points3 points(count, 3);
  Eigen::VectorXd weights(count);
  for (int i = 0; i < count; ++i) {
    points.row(i) = random_vector(random);
    if (is_flat) points(i, 2) = 0.0;
    weights[i] = uniform(random, 0.5, 2.0);
  }
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  for (int i = degree + 1; i < count; ++i)
    knots.push_back(knots.back() + uniform(random, 0.3, 1.0));
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, knots.back() + 0.5);
  return {degree, knots, points, weights};
}

double at_share(const NurbsCurve& curve, double share) {
  return curve.begin() + share * (curve.end() - curve.begin());
}

Points3 sampled(const NurbsCurve& curve, int count) {
  Points3 points(count + 1, 3);
  for (int i = 0; i <= count; ++i)
    points.row(i) = curve.point(at_share(curve, i / double(count))).transpose();
  return points;
}

// By segments of the sampled curves, in the plane.
int crossing_count(const Points3& a, const Points3& b) {
  const auto side = [](const auto& p, const auto& q, const auto& r) {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0.0;
  };
  int count = 0;
  for (int i = 0; i + 1 < a.rows(); ++i) {
    for (int k = 0; k + 1 < b.rows(); ++k) {
      const Eigen::RowVector3d p = a.row(i), q = a.row(i + 1), r = b.row(k), s = b.row(k + 1);
      count += side(p, q, r) != side(p, q, s) && side(r, s, p) != side(r, s, q) ? 1 : 0;
    }
  }
  return count;
}

TEST(CurveMeetings, InThePlaneAreAllCrossingsToRounding) {
  std::mt19937 random(21);
  int total = 0;
  for (int trial = 0; trial < hull::testing::trials(100); ++trial) {
    const NurbsCurve a = any_curve(random, true), b = any_curve(random, true);
    const CurveMeetings meetings = met(a, b, 1e-7);
    EXPECT_TRUE(meetings.overlaps.empty());
    int crossings = 0;
    for (const CurveMeeting& meeting : meetings.points) {
      if (meeting.distance() > 1e-14) continue;
      ++crossings;
      EXPECT_EQ((a.point(meeting.first) - meeting.first_place).norm(), 0.0);
      EXPECT_EQ((b.point(meeting.second) - meeting.second_place).norm(), 0.0);
    }
    EXPECT_EQ(static_cast<std::size_t>(crossings), meetings.points.size()) << trial;
    EXPECT_EQ(crossings, crossing_count(sampled(a, 700), sampled(b, 700))) << trial;
    total += crossings;
  }
  EXPECT_GT(total, hull::testing::trials(100));
}

TEST(CurveMeetings, InSpaceTheNearestIsThatOfASearch) {
  std::mt19937 random(22);
  int near = 0;
  for (int trial = 0; trial < hull::testing::trials(60); ++trial) {
    const NurbsCurve a = any_curve(random, false), b = any_curve(random, false);
    const double reach = 0.2;
    const CurveMeetings meetings = met(a, b, reach);
    const Points3 on_a = sampled(a, 400), on_b = sampled(b, 400);
    double least = 1e300, step = 0.0;
    for (int i = 0; i <= 400; ++i) {
      least = std::min(least, (on_b.rowwise() - on_a.row(i)).rowwise().norm().minCoeff());
      if (i == 400) break;
      step = std::max(
          {step, (on_a.row(i + 1) - on_a.row(i)).norm(), (on_b.row(i + 1) - on_b.row(i)).norm()});
    }
    double told = 1e300;
    for (const CurveMeeting& meeting : meetings.points) told = std::min(told, meeting.distance());
    if (!meetings.overlaps.empty()) continue;  // long near stretches of short curves
    if (least < reach) {
      ++near;
      EXPECT_LE(told, least + 1e-12) << trial;
      EXPECT_GE(told, least - step) << trial;
    } else if (least > reach + step) {
      EXPECT_TRUE(meetings.points.empty()) << trial;
    }
  }
  EXPECT_GT(near, hull::testing::trials(60) / 6);
}

TEST(CurveMeetings, ACurveThatIsMovedOntoAnotherMeetsItThere) {
  std::mt19937 random(23);
  for (int trial = 0; trial < hull::testing::trials(200); ++trial) {
    const NurbsCurve a = any_curve(random, false), b = any_curve(random, false);
    const double s = at_share(a, uniform(random, 0.0, 1.0));
    const double t = at_share(b, uniform(random, 0.0, 1.0));
    const Vector3d shift = a.point(s) - b.point(t);
    const NurbsCurve moved(b.degree(), b.knots(), b.points().rowwise() + shift.transpose(),
                           b.weights());
    const Vector3d da = a.evaluate(s, 1).row(1), db = b.evaluate(t, 1).row(1);
    const double sine = da.cross(db).norm() / (da.norm() * db.norm());
    bool is_found = false;
    for (const CurveMeeting& meeting : met(a, moved).points) {
      is_found |= (meeting.first_place - a.point(s)).norm() < 1e-14 / std::max(sine, 1e-2) &&
                  meeting.distance() < 2e-15;
    }
    EXPECT_TRUE(is_found) << trial << " at " << sine;
  }
}

NurbsCurve line(const Vector3d& from, const Vector3d& to) {
  Points3 points(2, 3);
  points << from.transpose(), to.transpose();
  return {1, {0, 0, 1, 1}, points};
}

// y = x² over -1 … 1, shifted.
NurbsCurve parabola(double up) {
  Points3 points(3, 3);
  points << -1, 1 + up, 0, 0, -1 + up, 0, 1, 1 + up, 0;
  return {2, {0, 0, 0, 1, 1, 1}, points};
}

TEST(CurveMeetings, ATouchIsOneMeeting) {
  const NurbsCurve axis = line({-2, 0, 0}, {2, 0, 0});
  for (double up : {0.0, 1e-5, -1e-5, 5e-4, -9e-4}) {
    const CurveMeetings meetings = met(axis, parabola(up));
    ASSERT_EQ(meetings.points.size(), 1u) << up;
    EXPECT_TRUE(meetings.overlaps.empty());
    EXPECT_NEAR(meetings.points[0].distance(), std::max(up, 0.0), 1e-14) << up;
    EXPECT_NEAR(std::abs(meetings.points[0].first_place.x()), std::sqrt(std::max(-up, 0.0)), 1e-7);
  }
  EXPECT_EQ(met(axis, parabola(-0.01)).points.size(), 2u);
  EXPECT_TRUE(met(axis, parabola(2e-3)).points.empty());
}

TEST(CurveMeetings, AnEndBesideACurveMeetsIt) {
  const NurbsCurve axis = line({-2, 0, 0}, {2, 0, 0});
  for (double gap : {0.0, 0.5e-3, -0.5e-3}) {
    const CurveMeetings meetings = met(axis, line({0.3, gap, 0}, {0.7, 1.0, 0}));
    ASSERT_EQ(meetings.points.size(), 1u);
    if (gap >= 0.0) {
      EXPECT_EQ(meetings.points[0].second, 0.0);
    }
    EXPECT_NEAR(meetings.points[0].distance(), std::max(gap, 0.0), 1e-15);
  }
  EXPECT_TRUE(met(axis, line({0.3, 2e-3, 0}, {0.7, 1.0, 0.2})).points.empty());
}

TEST(CurveMeetings, TwoEndsMeet) {
  const CurveMeetings meetings = met(line({0, 0, 0}, {1, 0, 0}), line({2, 1, 0}, {1, 4e-4, 0}));
  ASSERT_EQ(meetings.points.size(), 1u);
  EXPECT_EQ(meetings.points[0].first, 1.0);
  EXPECT_EQ(meetings.points[0].second, 1.0);
}

TEST(CurveMeetings, StretchesThatLieOnOneAnotherAreOverlaps) {
  const CurveMeetings lines = met(line({0, 0, 0}, {10, 0, 0}), line({14, 2e-4, 0}, {4, 2e-4, 0}));
  EXPECT_TRUE(lines.points.empty());
  ASSERT_EQ(lines.overlaps.size(), 1u);
  EXPECT_NEAR(lines.overlaps[0].length, 6.0, 2.1e-3);  // and the reach on either side
  EXPECT_NEAR(lines.overlaps[0].start.x(), 4.0, 1.1e-3);
  EXPECT_NEAR(lines.overlaps[0].second_low, 1.0, 1.1e-4);
  EXPECT_NEAR(lines.overlaps[0].second_high, 0.4, 1.1e-4);
  // A curve over other parameters, turned: half of the one, and a part of it.
  std::mt19937 random(24);
  for (int trial = 0; trial < 20; ++trial) {
    const NurbsCurve curve = any_curve(random, false);
    const CurveMeetings whole = met(curve, curve.reversed());
    ASSERT_EQ(whole.overlaps.size(), 1u);
    EXPECT_EQ(whole.overlaps[0].first_low, curve.begin());
    EXPECT_EQ(whole.overlaps[0].first_high, curve.end());
    EXPECT_GT(whole.overlaps[0].second_low, whole.overlaps[0].second_high);
  }
}

TEST(CurveMeetings, OfCirclesAreThoseOfTheFormula) {
  std::mt19937 random(25);
  for (int trial = 0; trial < 50; ++trial) {
    const double apart = uniform(random, 0.3, 1.9);
    const NurbsCurve left = arc_through({0, -1, 0}, {1, 0, 0}, {0, 1, 0});
    const NurbsCurve right = arc_through({apart, 1, 0}, {apart - 1, 0, 0}, {apart, -1, 0});
    const CurveMeetings meetings = met(left, right);
    ASSERT_EQ(meetings.points.size(), 2u);
    const double height = std::sqrt(1.0 - 0.25 * apart * apart);
    for (std::size_t i : {0u, 1u}) {
      const Vector3d expected(0.5 * apart, i == 0 ? -height : height, 0.0);
      EXPECT_LT((meetings.points[i].first_place - expected).norm(), 1e-14 / height);
    }
  }
}

TEST(CoherentZones, AreThoseThatHangTogetherByAnyPair) {
  std::mt19937 random(24);
  const auto interval = [&] {
    const double low = uniform(random, -1.0, 1.0);
    return std::pair(low, low + 0.1 * uniform(random, 0.0, 1.0));
  };
  for (int trial = 0; trial < hull::testing::trials(50); ++trial) {
    std::vector<NearZone> zones;
    for (int i = 0; i < 60; ++i) {
      const auto [a, b] = interval();
      const auto [c, d] = interval();
      zones.push_back({a, b, static_cast<double>(i), c, d, 0.0});
    }
    // By the number of each one's group: spread from neighbour to neighbour until nothing changes.
    std::vector<int> group(zones.size());
    std::iota(group.begin(), group.end(), 0);
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (std::size_t i = 0; i < zones.size(); ++i) {
        for (std::size_t k = 0; k < zones.size(); ++k) {
          const NearZone &a = zones[i], &b = zones[k];
          const bool touch = a.first_low <= b.first_high && b.first_low <= a.first_high &&
                             a.second_low <= b.second_high && b.second_low <= a.second_high;
          if (!touch || group[i] <= group[k]) continue;
          group[i] = group[k];
          is_changed = true;
        }
      }
    }
    std::map<int, std::vector<int>> expected;
    for (std::size_t i = 0; i < zones.size(); ++i) {
      expected[group[i]].push_back(static_cast<int>(i));
    }
    std::vector<std::vector<int>> found, all;
    for (const auto& [first, members] : expected) all.push_back(members);
    for (const auto& zones_of : coherent_zones(zones)) {
      found.emplace_back();
      for (const NearZone& zone : zones_of) {
        found.back().push_back(static_cast<int>(zone.first_nearest));
      }
    }
    std::ranges::sort(found);
    EXPECT_EQ(found, all);
  }
}

}  // namespace
}  // namespace hull::network
