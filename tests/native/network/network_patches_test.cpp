// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/network_patches.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iostream>
#include <numbers>

#include "network/splines/border_plate.h"
#include "network_curves.h"

namespace hull::network {
namespace {

using conversion::BSplinePatch;
using hull::testing::chine;
using hull::testing::curve_along;
using hull::testing::kTol;
using hull::testing::line_between;
using hull::testing::net_on;
using hull::testing::network_of;
using hull::testing::told;
using hull::testing::torus;

constexpr double kDegree = std::numbers::pi / 180.0;

Vector3d ellipsoid(double u, double v) {
  const double a = 1.3 * u + 0.1, b = 1.2 * v - 0.6;
  return {9.0 * std::cos(b) * std::sin(a), 4.0 * std::cos(b) * std::cos(a), 2.5 * std::sin(b)};
}

NetworkPatches patches_of(const CurveNetwork& network, int spans = 4, double tolerance = 1e-7) {
  NetworkPatches made = network_patches(network, {spans, tolerance});
  for (const NetworkProblem& problem : made.problems) ADD_FAILURE() << problem.what;
  made.set.check();
  EXPECT_LE(made.set.largest_gap(), conversion::kLargestGap * made.set.size());
  return made;
}

Eigen::Vector2d on_side(int side, double t) {
  const Eigen::Vector2d places[] = {{t, 0.0}, {1.0, t}, {1.0 - t, 1.0}, {0.0, 1.0 - t}};
  return places[side];
}

Vector3d normal_of(const BSplinePatch& patch, const Eigen::Vector2d& at) {
  const auto jet = patch.evaluate(at.x(), at.y());
  return jet.du.cross(jet.dv).normalized();
}

struct SeamAngles {
  double at_knots = 0.0, anywhere = 0.0;  // degrees, of smooth seams
  double of_creases = 0.0;                // degrees, the furthest from an angle
};

// Of edges, at shares of 1 / 64, of which, of whole sides, those of 1 / spans are the inner knots.
SeamAngles seam_angles(const CurveNetwork& network, const NetworkPatches& made, int spans,
                       double crease_degrees = 0.0) {
  struct User {
    std::size_t patch;
    int side;
    double begin, end;
  };
  std::vector<std::vector<User>> users(made.edges.size());
  for (std::size_t p = 0; p < made.set.patches.size(); ++p) {
    for (int k = 0; k < 4; ++k) {
      for (const auto& part : made.set.sides[p][static_cast<std::size_t>(k)]) {
        users[static_cast<std::size_t>(part.edge)].push_back({p, k, part.begin, part.end});
      }
    }
  }
  SeamAngles found;
  for (std::size_t e = 0; e < users.size(); ++e) {
    if (users[e].size() != 2) continue;
    const int edge = made.edges[e];
    const auto is_whole = [](const User& user) { return user.begin == 0.0 && user.end == 1.0; };
    const bool has_knots = is_whole(users[e][0]) && is_whole(users[e][1]);
    const bool is_crease =
        edge >= 0 && network.frame().normals.is_crease[static_cast<std::size_t>(edge)];
    for (int i = 1; i < 64; ++i) {
      std::array<Vector3d, 2> normals;
      for (std::size_t s = 0; s < 2; ++s) {
        const User& user = users[e][s];
        const double share = s == 0 ? i / 64.0 : 1.0 - i / 64.0;
        normals[s] = normal_of(made.set.patches[user.patch],
                               on_side(user.side, user.begin + share * (user.end - user.begin)));
      }
      const double angle =
          std::atan2(normals[0].cross(normals[1]).norm(), normals[0].dot(normals[1])) / kDegree;
      if (is_crease) {
        found.of_creases = std::max(found.of_creases, std::abs(angle - crease_degrees));
        continue;
      }
      found.anywhere = std::max(found.anywhere, angle);
      if (has_knots && i % (64 / spans) == 0) found.at_knots = std::max(found.at_knots, angle);
    }
  }
  return found;
}

double furthest_off(const NetworkPatches& made, const std::function<double(const Vector3d&)>& off) {
  double worst = 0.0;
  for (const BSplinePatch& patch : made.set.patches) {
    for (int i = 0; i <= 12; ++i) {
      for (int k = 0; k <= 12; ++k) {
        worst = std::max(worst, std::abs(off(patch.position(i / 12.0, k / 12.0))));
      }
    }
  }
  return worst;
}

TEST(NetworkPatches, OfATorusAndAnEllipsoidAreSmooth) {
  // Tolerances of curves such that spans decide.
  const std::pair<Vector3d (*)(double, double), int> surfaces[] = {{torus, 4}, {ellipsoid, 8}};
  for (const auto& [surface, least] : surfaces) {
    const CurveNetwork network = network_of(net_on(surface, 5, 4, 3));
    double before = 0.0;
    for (int spans : {least, 2 * least, 4 * least}) {
      const NetworkPatches made = patches_of(network, spans, surface == torus ? 1e-7 : 1e-5);
      const SeamAngles angles = seam_angles(network, made, spans);
      std::cout << spans << " spans: " << angles.at_knots << " deg at constraints, "
                << angles.anywhere << " deg anywhere\n";
      EXPECT_LT(angles.at_knots, 1e-6);
      EXPECT_LT(angles.anywhere, 0.05);
      if (before > 0.0) {
        EXPECT_LT(angles.anywhere, 0.5 * before);
      }
      before = angles.anywhere;
    }
  }
}

TEST(NetworkPatches, ComeNearerToASurfaceWithMoreCurves) {
  const auto off = [](const Vector3d& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 10.0, p.z()) - 3.0;
  };
  double before = 0.0;
  for (int count : {2, 4, 8}) {
    const double worst = furthest_off(patches_of(network_of(net_on(torus, count, count, 3))), off);
    std::cout << count << " curves each way: torus " << worst << " m of 3\n";
    if (before > 0.0) {
      EXPECT_LT(worst, before / 8.0);
    }
    before = worst;
  }
}

TEST(NetworkPatches, PlanesAtAnAngleKeepIt) {
  const double angle = 30.0 * kDegree;
  const CurveNetwork network = network_of(chine(angle));
  const NetworkPatches made = patches_of(network);
  const SeamAngles angles = seam_angles(network, made, 4, 30.0);
  EXPECT_LT(angles.of_creases, 1e-6);
  EXPECT_LT(angles.anywhere, 1e-6);
  EXPECT_LT(furthest_off(made,
                         [&](const Vector3d& p) {
                           const double over = std::max(0.0, p.y() - 5.0);
                           return p.z() + over * std::tan(angle);
                         }),
            1e-12);
}

// Breadth 10, draft 6.25 m: the port quarter, over x / 50 and z / -6.25 below the water.
constexpr double kBreadth = 10.0;
Vector3d wigley_form(double x, double z) {
  return {50.0 * x, 0.5 * kBreadth * (1.0 - x * x) * (1.0 - z * z), -6.25 * z};
}

// A parabola of the surface as the conic that it is.
NetworkCurve parabola(const std::string& name, const std::function<Vector3d(double)>& way) {
  NetworkCurve curve;
  curve.definition.name = name;
  curve.definition.kind = CurveDefinition::Kind::kConic;
  curve.definition.points = {way(0.0), way(1.0)};
  curve.definition.fullness = 1.0;
  const double step = 1e-3;
  // Exact for parabolas.
  const auto slope = [&](double t) {
    return Vector3d((way(t + step) - way(t - step)) / (2.0 * step));
  };
  curve.definition.start = {EndCondition::Kind::kTangent, slope(0.0), -1};
  curve.definition.end = {EndCondition::Kind::kTangent, slope(1.0), -1};
  return curve;
}

std::vector<NetworkCurve> wigley_quarter(const std::vector<double>& inner) {
  std::vector<NetworkCurve> curves{
      line_between("stem", wigley_form(1, 0), wigley_form(1, 1)),
      line_between("keel", wigley_form(0, 1), wigley_form(1, 1)),
      parabola("midship", [](double t) { return wigley_form(0.0, t); }),
      parabola("water", [](double t) { return wigley_form(t, 0.0); })};
  for (double at : inner) {
    const std::string number = std::to_string(at);
    curves.push_back(parabola("station " + number, [at](double t) { return wigley_form(at, t); }));
    curves.push_back(
        parabola("waterline " + number, [at](double t) { return wigley_form(t, at); }));
  }
  for (std::size_t i = 4; i < curves.size(); ++i) {
    curves[i].role = NetworkCurve::Role::kReference;
  }
  return curves;
}

double off_wigley(const Vector3d& p) {
  return p.y() - 0.5 * kBreadth * (1.0 - p.x() * p.x() / 2500.0) * (1.0 - p.z() * p.z() / 39.0625);
}

TEST(NetworkPatches, AWigleyQuarterWithReferencesIsExact) {
  for (const std::vector<double>& inner :
       {std::vector{0.5}, std::vector{0.3, 0.7}, std::vector{0.2, 0.45, 0.8}}) {
    const CurveNetwork network = network_of(wigley_quarter(inner));
    ASSERT_EQ(told(network), "");
    const NetworkPatches made = patches_of(network);
    ASSERT_EQ(made.set.patches.size(), 1u);
    const double worst = furthest_off(made, off_wigley);
    std::cout << inner.size() << " curves each way inside: " << worst / kBreadth << " B\n";
    EXPECT_LT(worst, 1e-9 * kBreadth);
  }
}

// All curves inside but one of each family are references: the patches pass through all of them
// along their length, also where no point of the fit is.
TEST(NetworkPatches, ReferencesAreMetAlongTheirLength) {
  for (const auto& surface : {torus, ellipsoid}) {
    std::vector<NetworkCurve> curves = net_on(surface, 4, 4, 5);
    for (std::size_t i : {1u, 3u, 6u, 8u}) curves[i].role = NetworkCurve::Role::kReference;
    const CurveNetwork network = network_of(curves);
    ASSERT_EQ(told(network), "");
    const NetworkPatches made = patches_of(network, 4, 1e-4);
    EXPECT_EQ(made.set.patches.size(), 4u);
    double worst = 0.0;
    for (std::size_t c : {1u, 3u, 6u, 8u}) worst = std::max(worst, made.curve_errors[c]);
    const auto off = [surface = surface](const Vector3d& p) {
      if (surface == torus) return std::hypot(std::hypot(p.x(), p.y()) - 10.0, p.z()) - 3.0;
      const Vector3d unit(p.x() / 9.0, p.y() / 4.0, p.z() / 2.5);
      return (unit.norm() - 1.0) / Vector3d(unit.x() / 9.0, unit.y() / 4.0, unit.z() / 2.5).norm();
    };
    // What references ask for is not square to the seams: these are smooth as the spans get
    // shorter.
    const double seams = seam_angles(network, made, 4).anywhere;
    const double finer = seam_angles(network, patches_of(network, 16, 1e-4), 16).anywhere;
    const double whole = furthest_off(made, off);
    std::cout << "references off by " << worst << " m, all by " << whole << " m, seams " << seams
              << " deg, of 16 spans " << finer << " deg\n";
    EXPECT_LT(worst, 1e-4);
    EXPECT_GT(worst, 0.0);
    // Of the least half-axis, of 3 and 2.5 m.
    EXPECT_LT(whole, 5e-3 * 2.5);
    EXPECT_LT(finer, 0.5);
    EXPECT_LT(finer, 0.5 * seams);
  }
}

// The interpolating cubic over uniform knots with slopes at both ends: the control points of m - 2
// places and two slopes (by the parameter).
std::vector<double> complete_row(const std::vector<double>& places, double start, double end) {
  const int m = static_cast<int>(places.size()) + 2;
  const std::vector<double> knots = uniform_knots(m - 3);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(m, m);
  Eigen::VectorXd right(m);
  for (int i = 0; i < m - 2; ++i) {
    const auto values = conversion::basis_values(knots, 3, i / (m - 3.0));
    rows.row(i).segment(values.first, 4) = values.rows.row(0);
    right[i] = places[static_cast<std::size_t>(i)];
  }
  for (int end_row : {0, 1}) {
    const auto values = conversion::basis_values(knots, 3, end_row);
    rows.row(m - 2 + end_row).segment(values.first, 4) = values.rows.row(1);
  }
  right[m - 2] = start;
  right[m - 1] = end;
  const Eigen::VectorXd points = rows.fullPivLu().solve(right);
  return {points.begin(), points.end()};
}

// Rhim, Cho, Lee & Kim's surface fit (their section 4), of a Wigley quarter's exact points and
// slopes: rows, then columns, whose end slopes go through rows with a slope of `twist` times the
// true twist. y / B over the quarter.
double paper_error(double twist) {
  constexpr int kM = 6, kPoints = kM - 2;
  const auto y = [](double u, double v) { return 0.5 * (1 - u * u) * (1 - v * v); };
  const auto y_u = [](double u, double v) { return -u * (1 - v * v); };
  const auto y_v = [](double u, double v) { return -v * (1 - u * u); };
  const auto y_uv = [twist](double u, double v) { return twist * 2.0 * u * v; };
  const auto at = [](int i) { return i / (kM - 3.0); };
  // Rows along u of points at each v, and of slopes across at both ends.
  std::vector<std::vector<double>> rows, slopes;
  for (int k = 0; k < kPoints; ++k) {
    std::vector<double> places;
    for (int i = 0; i < kPoints; ++i) places.push_back(y(at(i), at(k)));
    rows.push_back(complete_row(places, y_u(0, at(k)), y_u(1, at(k))));
  }
  for (double v : {0.0, 1.0}) {
    std::vector<double> places;
    for (int i = 0; i < kPoints; ++i) places.push_back(y_v(at(i), v));
    slopes.push_back(complete_row(places, y_uv(0, v), y_uv(1, v)));
  }
  BSplinePatch patch;
  patch.knots_u = patch.knots_v = uniform_knots(kM - 3);
  patch.count_u = patch.count_v = kM;
  for (std::size_t i = 0; i < kM; ++i) {
    std::vector<double> places;
    for (const auto& row : rows) places.push_back(row[i]);
    for (double point : complete_row(places, slopes[0][i], slopes[1][i])) {
      patch.control_points.emplace_back(0.0, point, 0.0);
    }
  }
  double worst = 0.0;
  for (int i = 0; i <= 60; ++i) {
    for (int k = 0; k <= 60; ++k) {
      const double u = i / 60.0, v = k / 60.0;
      worst = std::max(worst, std::abs(patch.position(u, v).y() - y(u, v)));
    }
  }
  return worst;
}

TEST(NetworkPatches, ThePapersWayWithoutTwistErrs) {
  std::cout << "zero twist, m = 6: " << 100.0 * paper_error(0.0) << " % of B\n";
  EXPECT_NEAR(paper_error(0.0), 0.0064, 0.0001);
  EXPECT_LT(paper_error(1.0), 1e-14);
}

std::vector<NetworkCurve> octant() {
  std::vector<NetworkCurve> curves;
  for (int i = 0; i < 3; ++i) {
    NetworkCurve arc;
    arc.definition.name = "A" + std::to_string(i);
    arc.definition.kind = CurveDefinition::Kind::kArc;
    const Vector3d from = Vector3d::Unit(i), to = Vector3d::Unit((i + 1) % 3);
    arc.definition.points = {from, std::sqrt(0.5) * (from + to), to};
    curves.push_back(arc);
  }
  return curves;
}

TEST(NetworkPatches, OfASpheresOctantAreThreeAroundItsMiddle) {
  const CurveNetwork network = network_of(octant());
  for (int spans : {4, 8}) {
    const NetworkPatches made = patches_of(network, spans);
    EXPECT_EQ(made.set.patches.size(), 3u);
    const double off = furthest_off(made, [](const Vector3d& p) { return p.norm() - 1.0; });
    const SeamAngles angles = seam_angles(network, made, spans);
    std::cout << spans << " spans: octant off by " << off << " of its radius, seams "
              << angles.at_knots << ", " << angles.anywhere << " deg\n";
    EXPECT_LT(off, 5e-3);
    EXPECT_LT(angles.at_knots, 1e-6);
    EXPECT_LT(angles.anywhere, 0.5);
  }
}

TEST(NetworkPatches, RegionsOfManySidesAreFound) {
  const auto height = [](double x, double y) { return 0.3 * x * x - 0.2 * x * y + 0.1 * y * y; };
  for (int count : {3, 5, 6, 8, 10}) {
    std::vector<NetworkCurve> curves;
    for (int i = 0; i < count; ++i) {
      const auto corner = [count](int k) {
        const double a = 2.0 * std::numbers::pi * k / count;
        return Vector3d(std::cos(a), std::sin(a), 0.0);
      };
      curves.push_back(curve_along(
          "C" + std::to_string(i),
          [&](double t) {
            Vector3d p = (1.0 - t) * corner(i) + t * corner(i + 1);
            p.z() = height(p.x(), p.y());
            return p;
          },
          17));
    }
    const CurveNetwork network = network_of(curves);
    const NetworkPatches made = patches_of(network);
    EXPECT_EQ(std::ssize(made.set.patches), count);
    const double off =
        furthest_off(made, [&](const Vector3d& p) { return p.z() - height(p.x(), p.y()); });
    const SeamAngles angles = seam_angles(network, made, 4);
    std::cout << count << " sides: off by " << off << ", seams " << angles.at_knots << ", "
              << angles.anywhere << " deg\n";
    EXPECT_LT(off, 8e-3);
    EXPECT_LT(angles.at_knots, 1e-6);
    EXPECT_LT(angles.anywhere, 0.5);
  }
}

// With exact normals along its border a plate is the quadratic surface, whatever the border.
TEST(BorderPlate, ReproducesQuadraticHeights) {
  const auto height = [](double x, double y) { return 1 + x - y + 0.3 * x * x - 0.2 * x * y; };
  std::vector<PlateSample> border;
  for (int i = 0; i < 20; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 20, r = 1.0 + 0.2 * std::cos(3.0 * a);
    const double x = r * std::cos(a), y = r * std::sin(a);
    const double by_x = 1 + 0.6 * x - 0.2 * y, by_y = -1 - 0.2 * x;
    const double along_x = -std::sin(a), along_y = std::cos(a);
    border.push_back({{x, y, height(x, y)},
                      {along_x, along_y, by_x * along_x + by_y * along_y},
                      Vector3d(-by_x, -by_y, 1.0).normalized(),
                      true});
  }
  const auto plate = BorderPlate::within(border, true);
  ASSERT_TRUE(plate);
  for (const Vector2d& at : {Vector2d(0, 0), Vector2d(0.3, 0.1), Vector2d(-0.2, 0.4)}) {
    // Quadratic over one plane is not over another one: told where the mean plane is the same.
    const PatchPoint point = plate->at(at);
    EXPECT_NEAR(point.point.z(), height(point.point.x(), point.point.y()), 2e-2);
  }
  std::vector<PlateSample> upright = border;
  upright[3].normal = Vector3d(1, 0, 0);
  EXPECT_FALSE(BorderPlate::within(upright, true));
}

TEST(NetworkPatches, TeesAndDanglingEndsAreNoObstacle) {
  auto curves = net_on(torus, 2, 2, 3);
  curves.push_back(curve_along("T", [](double t) { return torus(0.75, 0.5 * t); }));
  curves.push_back(curve_along("D", [](double t) { return torus(0.3 * t, 0.25); }));
  const CurveNetwork network = network_of(curves);
  std::vector<NetworkProblem::Kind> kinds = hull::testing::kinds_of(network);
  EXPECT_EQ(std::ranges::count(kinds, NetworkProblem::Kind::kTee), 1);
  EXPECT_EQ(std::ranges::count(kinds, NetworkProblem::Kind::kDanglingEnd), 1);
  const NetworkPatches made = patches_of(network);
  EXPECT_EQ(made.set.patches.size(), 5u);
  // The sides with the tee in them, and where the dangling curve began, are two edges.
  int divided = 0;
  for (const auto& sides : made.set.sides) {
    for (const auto& side : sides) divided += side.size() > 1 ? 1 : 0;
  }
  EXPECT_EQ(divided, 2);
}

TEST(NetworkPatches, WithACurveMovedAreThoseMadeAnew) {
  auto curves = net_on(torus, 5, 4, 1);
  CurveNetwork network = network_of(curves);
  NetworkPatches made = network_patches(network, {});
  for (std::size_t i = 1; i < curves[2].definition.points.size(); i += 2) {
    curves[2].definition.points[i] *= 1.002;
  }
  network = network.with_curve(2, curves[2]);
  const NetworkPatches changed = network_patches(network, {}, &made);
  const NetworkPatches anew = network_patches(network_of(curves), {});
  ASSERT_EQ(changed.set.patches.size(), anew.set.patches.size());
  int same = 0;
  for (std::size_t p = 0; p < anew.set.patches.size(); ++p) {
    EXPECT_EQ(changed.set.patches[p].control_points, anew.set.patches[p].control_points);
    same += anew.set.patches[p].control_points == made.set.patches[p].control_points ? 1 : 0;
  }
  EXPECT_GE(same, 2);
}

TEST(NetworkPatches, RefuseWhatIsNoOption) {
  const CurveNetwork network = network_of(hull::testing::square());
  EXPECT_THROW(network_patches(network, {0, 0.0}), std::invalid_argument);
  EXPECT_THROW(network_patches(network, {65, 0.0}), std::invalid_argument);
  EXPECT_THROW(network_patches(network, {4, -1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::network
