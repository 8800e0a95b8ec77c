// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <iostream>

#include "network/splines/network_patches.h"
#include "network_curves.h"
#include "patch_measures.h"

namespace hull::network {
namespace {

using conversion::BSplinePatch;
using hull::testing::ellipsoid;
using hull::testing::furthest_off;
using hull::testing::line_between;
using hull::testing::net_on;
using hull::testing::network_of;
using hull::testing::patches_of;
using hull::testing::seam_angles;
using hull::testing::told;
using hull::testing::torus;

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

TEST(ReferenceCurves, AWigleyQuarterWithReferencesIsExact) {
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
TEST(ReferenceCurves, ReferencesAreMetAlongTheirLength) {
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

TEST(ReferenceCurves, ThePapersWayWithoutTwistErrs) {
  std::cout << "zero twist, m = 6: " << 100.0 * paper_error(0.0) << " % of B\n";
  EXPECT_NEAR(paper_error(0.0), 0.0064, 0.0001);
  EXPECT_LT(paper_error(1.0), 1e-14);
}

// Three that meet within, and two end to end, in curves of their own or at a knuckle of one.
TEST(ReferenceCurves, ThatEndWithinHaveTheirPlacesThere) {
  const auto surface = [](double u, double v) { return torus(0.5 * u, 0.5 * v); };
  const auto on = [&](const Vector2d& from, const Vector2d& to) {
    NetworkCurve curve = hull::testing::curve_along("R", [&](double t) {
      const Vector2d at = (1.0 - t) * from + t * to;
      return surface(at.x(), at.y());
    });
    curve.role = NetworkCurve::Role::kReference;
    return curve;
  };
  NetworkCurve bent = on({0.5, 0.0}, {0.5, 1.0});
  bent.definition.knuckles = {4};
  const std::vector<std::vector<NetworkCurve>> inner{
      {on({0.5, 0.0}, {0.5, 0.5}), on({0.5, 0.5}, {0.5, 1.0})},
      {bent},
      {on({0.5, 0.0}, {0.5, 0.5}), on({0.5, 0.5}, {0.0, 0.5}), on({0.5, 0.5}, {1.0, 1.0})}};
  for (const auto& references : inner) {
    auto curves = net_on(surface, 1, 1, 7);
    curves.insert(curves.end(), references.begin(), references.end());
    const CurveNetwork network = network_of(curves);
    // To the network's tolerance, else it is told.
    const NetworkPatches made = patches_of(network, 4, 1e-3);
    EXPECT_EQ(made.set.patches.size(), 1u);
    std::cout << "off by " << made.largest_curve_error() << " m\n";
  }
}

// A sheer that is the border aft, and forward goes on as a knuckle below a bulwark, or the other
// way round: the same side of one region.
TEST(ReferenceCurves, AreFreeAlongTheBordersPartOfASideAlone) {
  const auto surface = [](double u, double v) { return torus(0.5 * u, 0.5 * v); };
  for (bool is_forward : {false, true}) {
    auto curves = net_on(surface, 1, 1, 7);
    NetworkCurve middle =
        hull::testing::curve_along("M", [&](double t) { return surface(0.5, t); });
    middle.role = NetworkCurve::Role::kReference;
    curves.push_back(middle);
    // V1 is the side; what goes on beyond half of it.
    const double low = is_forward ? 0.5 : 0.0;
    const auto beyond = [&](double u, double v) { return surface(low + 0.5 * u, 1.0 + 0.4 * v); };
    for (double u : {0.0, 1.0}) {
      curves.push_back(hull::testing::curve_along("B" + std::to_string(u),
                                                  [&](double t) { return beyond(u, t); }));
    }
    curves.push_back(hull::testing::curve_along("T", [&](double t) { return beyond(t, 1.0); }));
    const CurveNetwork network = network_of(curves);
    EXPECT_EQ(network.regions().size(), 3u) << told(network);
    const NetworkPatches made = patches_of(network, 4, 1e-6);
    EXPECT_EQ(made.set.patches.size(), 2u);
    const auto angles = seam_angles(network, made, 4);
    std::cout << "seam " << angles.anywhere << " deg\n";
    EXPECT_LT(angles.anywhere, 0.05);
  }
}

// What a spline along it would be off is no matter: the patch is plane, as the curve is.
TEST(ReferenceCurves, AreNotToldOfForTheirOwnSplines) {
  auto curves = hull::testing::square();
  NetworkCurve sharp;
  sharp.definition.name = "R";
  sharp.definition.kind = CurveDefinition::Kind::kConic;
  sharp.definition.points = {{0, 4, 0}, {10, 4, 0}};
  sharp.definition.start = {EndCondition::Kind::kTangent, {1, 0.5, 0}, -1};
  sharp.definition.end = {EndCondition::Kind::kTangent, {1, -0.5, 0}, -1};
  sharp.definition.fullness = 1000.0;
  curves.push_back(sharp);
  const auto problems = [&] { return network_patches(network_of(curves), {4, 1e-9}).problems; };
  ASSERT_EQ(problems().size(), 1u);
  EXPECT_EQ(problems().front().kind, NetworkProblem::Kind::kMissedCurve);
  curves.back().role = NetworkCurve::Role::kReference;
  EXPECT_TRUE(problems().empty());
}

}  // namespace
}  // namespace hull::network
