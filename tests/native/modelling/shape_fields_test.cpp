// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/shape_fields.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include "modelling/fields/falloff.h"

namespace hull::modelling {
namespace {

using Points = std::vector<Vector3d>;

// Equation 3 as it is printed.
double printed(double delta, double kappa) {
  if (delta >= 1.0) return 0.0;
  if (delta < kappa) {
    return (kappa * kappa + kappa * delta * delta * (delta - 3.0) + delta * delta * delta) /
           (kappa * kappa);
  }
  return std::pow(delta - 1.0, 3) / (kappa - 1.0);
}

ShapeField field_at(const Vector3d& point, double extent, const Vector3d& shift,
                    double kappa = 0.5) {
  ShapeField field;
  field.base = point_base(point);
  field.extent = AlongBase<double>(extent);
  field.kappa = AlongBase<double>(kappa);
  field.shift = AlongBase<Vector3d>(shift);
  return field;
}

ShapeField field_along(const Points& points, double extent, const Vector3d& shift) {
  ShapeField field = field_at(points[0], extent, shift);
  field.base = curve_base(FieldCurve::through(points));
  return field;
}

const Points kBent{{0, 1, 0}, {2, 2, 0.5}, {4, 2.5, 0}, {6, 2, 1}};
const Points kCrossing{{3, 1, -2}, {3.4, 1.6, 0}, {3.1, 2.2, 2}};

TEST(Falloff, HasThePublishedValuesHalfway) {
  const std::array<std::array<double, 2>, 5> published{
      {{1.0, 0.5}, {0.75, 7.0 / 18.0}, {0.5, 0.25}, {0.25, 1.0 / 6.0}, {0.0, 0.125}}};
  for (const auto& [kappa, value] : published) {
    EXPECT_NEAR(selection_intensity(0.5, kappa).value, value, 1e-15);
  }
}

TEST(Falloff, IsEquation3) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 10000; ++k) {
    const double kappa = part(random), delta = 1.1 * part(random);
    const Intensity found = selection_intensity(delta, kappa);
    // The printed form divides by kappa² and 1 - kappa.
    const double rounding = 1e-15 / std::min(kappa * kappa, 1.0 - kappa);
    EXPECT_NEAR(found.value, printed(delta, kappa), rounding);
    EXPECT_NEAR(found.value + found.rest, 1.0, 2e-16);
  }
}

TEST(Falloff, HasTwoContinuousDerivatives) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> part(0.02, 0.98);
  for (int k = 0; k < 100; ++k) {
    const double kappa = part(random), h = 1e-6;
    for (double joint : {kappa, 1.0}) {
      const auto slope = [&](double delta) { return selection_intensity(delta, kappa).slope; };
      const double before = (slope(joint - h) - slope(joint - 2 * h)) / h,
                   after = (slope(joint + 2 * h) - slope(joint + h)) / h;
      EXPECT_NEAR(slope(joint - 1e-12), slope(joint + 1e-12), 1e-9);
      // The third derivative is 6 (1 + kappa) / kappa² at most, or 6 / (1 - kappa).
      EXPECT_NEAR(before, after, 4 * h * (12 / (kappa * kappa) + 6 / (1 - kappa)) + 1e-8);
    }
  }
}

TEST(Falloff, SlopesAreThoseOfDifferences) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> part(0.05, 0.95);
  for (int k = 0; k < 1000; ++k) {
    const double kappa = part(random), delta = part(random), h = 1e-6;
    if (std::abs(kappa - delta) < 1e-3) continue;
    const auto f = [](double d, double s) { return selection_intensity(d, s).value; };
    const Intensity found = selection_intensity(delta, kappa);
    const double rounding = 1e-9 / (kappa * kappa);
    EXPECT_NEAR(found.slope, (f(delta + h, kappa) - f(delta - h, kappa)) / (2 * h), rounding);
    EXPECT_NEAR(found.kappa_slope, (f(delta, kappa + h) - f(delta, kappa - h)) / (2 * h), rounding);
  }
}

TEST(Falloff, IsANumberAtItsLimits) {
  for (double kappa : {0.0, 5e-324, 1e-300, 1e-17, 0.5, 1.0 - 1e-16, 1.0}) {
    for (double delta : {0.0, 5e-324, 1e-300, 1e-17, 0.5, 1.0 - 1e-16, 1.0, 2.0}) {
      const Intensity found = selection_intensity(delta, kappa);
      EXPECT_TRUE(found.value >= 0.0 && found.value <= 1.0) << delta << " " << kappa;
      EXPECT_TRUE(found.rest >= 0.0 && found.rest <= 1.0) << delta << " " << kappa;
      EXPECT_TRUE(std::isfinite(found.slope) && std::isfinite(found.kappa_slope));
    }
  }
}

TEST(Falloff, AttainsItsSteepestSlope) {
  for (double kappa : {0.1, 0.5, 0.9, 1.0}) {
    const double bound = -3.0 / (1.0 + kappa);
    EXPECT_NEAR(selection_intensity(kappa / (1.0 + kappa), kappa).slope, bound, 1e-14);
    for (int i = 0; i <= 1000; ++i) {
      EXPECT_GE(selection_intensity(i / 1000.0, kappa).slope, bound - 1e-14);
    }
  }
}

TEST(ShapeFields, AreEquation2WhereTheyAddUp) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> place(-4.0, 4.0);
  ShapeField kept = field_at({1, 0, 0}, 2.0, Vector3d::Zero(), 0.3);
  kept.base = plane_base({1, 0, 0}, {0, 0, 2});
  kept.protects = true;
  kept.axes = {false, true, true};
  const ShapeFields fields({field_at({0, 1, 0}, 3.0, {1, 2, 3}, 0.8),
                            field_at({2, -1, 1}, 2.5, {-1, 0.5, 0}, 0.2), kept},
                           false, FieldBlend::kSum);
  for (int k = 0; k < 10000; ++k) {
    const Vector3d p(place(random), place(random), place(random));
    const double f1 = printed((p - Vector3d(0, 1, 0)).norm() / 3.0, 0.8),
                 f2 = printed((p - Vector3d(2, -1, 1)).norm() / 2.5, 0.2),
                 g = 1.0 - printed(std::abs(p.z()) / 2.0, 0.3);
    const Vector3d all = f1 * Vector3d(1, 2, 3) + f2 * Vector3d(-1, 0.5, 0);
    const Vector3d wanted(all.x(), g * all.y(), g * all.z());
    EXPECT_LT((fields.at(p).shift - wanted).norm(), 1e-12);
  }
}

// Three overlapping fields with all that varies along a base, and one that protects.
std::vector<ShapeField> varied_fields() {
  ShapeField along = field_along(kBent, 2.0, {0, 0.4, 0.1});
  along.extent = AlongBase<double>({0.0, 2.0, 6.0}, {1.5, 2.2, 1.8});
  along.kappa = AlongBase<double>({0.0, 3.0, 6.0}, {0.3, 0.7, 0.5});
  along.shift = AlongBase<Vector3d>({0.0, 3.0, 6.0},
                                    {Vector3d(0, 0.2, 0), Vector3d(0.1, 0.5, 0.2), {0, 0.1, 0}});
  ShapeField across = field_along(kCrossing, 1.7, {0.3, 0.1, 0});
  ShapeField kept = field_at({4.5, 2, 0}, 1.2, Vector3d::Zero(), 0.6);
  kept.protects = true;
  kept.axes = {true, true, false};
  return {along, across, field_at({1, 0.6, 0.4}, 2.0, {0, -0.3, 0.2}), kept};
}

class Blends : public ::testing::TestWithParam<FieldBlend> {};
INSTANTIATE_TEST_SUITE_P(Both, Blends, ::testing::Values(FieldBlend::kSum, FieldBlend::kExact));

TEST_P(Blends, GradientsAreThoseOfDifferences) {
  const ShapeFields fields(varied_fields(), true, GetParam());
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const double h = 1e-6;
  int compared = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vector3d p(6 * part(random), 3 * part(random), -1 + 3 * part(random));
    const Eigen::Matrix3d found = fields.at(p).gradient;
    Eigen::Matrix3d wanted, wider;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d step = h * Vector3d::Unit(axis);
      wanted.col(axis) = (fields.at(p + step).shift - fields.at(p - step).shift) / (2 * h);
      wider.col(axis) = (fields.at(p + 2 * step).shift - fields.at(p - 2 * step).shift) / (4 * h);
    }
    // Where closest points jump there is no gradient.
    if ((wanted - wider).norm() > 1e-7) continue;
    EXPECT_LT((found - wanted).norm(), 1e-6) << p.transpose();
    compared += found.norm() > 0.0;
  }
  EXPECT_GT(compared, 1000);
}

TEST_P(Blends, AreSymmetricAboutTheCentrePlane) {
  const ShapeFields fields(varied_fields(), true, GetParam());
  std::mt19937 random(12);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const Vector3d p(6 * part(random), part(random), -1 + 3 * part(random)),
        image(p.x(), -p.y(), p.z()), on_plane(p.x(), 0.0, p.z());
    const Vector3d shift = fields.at(p).shift, other = fields.at(image).shift;
    // Fields and images are summed up in another order.
    EXPECT_LT((shift - Vector3d(other.x(), -other.y(), other.z())).norm(), 1e-15);
    const FieldShift at_plane = fields.at(on_plane);
    EXPECT_EQ(at_plane.shift.y(), 0.0);
    // What keeps a smooth keel smooth.
    EXPECT_LT(std::abs(at_plane.gradient(0, 1)) + std::abs(at_plane.gradient(2, 1)), 1e-14);
  }
}

// Bases that are meant to be in the plane, and off it by what single precision leaves: no two of
// them, which would shift up to twice as far.
TEST_P(Blends, BasesBesideTheCentrePlaneByRoundingAreInIt) {
  const auto fields_off = [&](double off) {
    std::vector<ShapeField> fields{
        field_at({1, off, 0}, 1.5, {0.1, 0, 0.3}),
        field_along({{2, off, 1}, {3, -off, 2}, {5, off, 2}}, 2.0, {0, 0, -0.2})};
    fields.push_back(field_at({0, 0, 0}, 1.0, {0.2, 0, 0}));
    fields.back().base = plane_base({2, -off, 0}, {off, 1, -off});
    return ShapeFields(fields, true, GetParam());
  };
  const ShapeFields exact = fields_off(0.0), noisy = fields_off(5e-7);
  std::mt19937 random(13);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 500; ++k) {
    const Vector3d p(6 * part(random), part(random), -1 + 3 * part(random)),
        image(p.x(), -p.y(), p.z());
    const Vector3d shift = noisy.at(p).shift, other = noisy.at(image).shift;
    EXPECT_LT((shift - exact.at(p).shift).norm(), 1e-5);
    EXPECT_EQ(shift, Vector3d(other.x(), -other.y(), other.z()));
    EXPECT_EQ(noisy.at({p.x(), 0, p.z()}).shift.y(), 0.0);
  }
}

TEST_P(Blends, NothingBeyondTheExtents) {
  const ShapeFields fields(varied_fields(), true, GetParam());
  for (const Vector3d& p : Points{{-3, 1, 0}, {9, 2, 0}, {3, 6, 0}, {2, 1, 7}}) {
    EXPECT_EQ(fields.at(p).shift, Vector3d::Zero());
    EXPECT_EQ(fields.at(p).gradient, Eigen::Matrix3d::Zero());
  }
}

TEST_P(Blends, OneFieldAloneIsEquation2) {
  const ShapeFields fields({field_along(kBent, 2.0, {0, 0.4, 0.1})}, false, GetParam());
  const FieldCurve curve = FieldCurve::through(kBent);
  for (const Vector3d& p : Points{{1, 1, 1}, {3, 3, 0}, {5, 1.7, 1}}) {
    const double f = printed(curve.foot(p).distance / 2.0, 0.5);
    EXPECT_LT((fields.at(p).shift - f * Vector3d(0, 0.4, 0.1)).norm(), 1e-14);
  }
}

TEST(ShapeFields, OverlappingBasesGetTheirOwnShifts) {
  const std::vector<ShapeField> all = varied_fields();
  const std::vector<ShapeField> two{all[0], all[2]};
  const ShapeFields exact(two, true, FieldBlend::kExact), sum(two, true, FieldBlend::kSum);
  const FieldCurve curve = FieldCurve::through(kBent);
  double missed = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double length = curve.length() * i / 100;
    const Vector3d p = curve.point_at(length), wanted = two[0].shift.at(length).value;
    EXPECT_LT((exact.at(p).shift - wanted).norm(), 1e-12);
    missed = std::max(missed, (sum.at(p).shift - wanted).norm());
  }
  EXPECT_LT((exact.at({1, 0.6, 0.4}).shift - Vector3d(0, -0.3, 0.2)).norm(), 1e-15);
  EXPECT_GT(missed, 0.1);  // the fields do overlap
}

TEST(ShapeFields, ProtectedBasesStay) {
  std::vector<ShapeField> fields = varied_fields();
  fields[3].base = curve_base(FieldCurve::through(kCrossing));
  fields[3].axes = {true, true, true};
  const ShapeFields all(fields, true, FieldBlend::kExact);
  const FieldCurve curve = FieldCurve::through(kCrossing);
  for (int i = 0; i <= 50; ++i) {
    // To the squared rounding of the distance.
    EXPECT_LT(all.at(curve.point_at(curve.length() * i / 50)).shift.norm(), 1e-25);
  }
}

TEST(ShapeFields, BasesThatMeetShareTheirShift) {
  const ShapeFields fields(
      {field_at({1, 1, 1}, 2.0, {1, 0, 0}), field_at({1, 1, 1}, 1.0, {0, 2, 0})}, false,
      FieldBlend::kExact);
  EXPECT_EQ(fields.at({1, 1, 1}).shift, Vector3d(0.5, 1, 0));
}

TEST(ShapeFields, ABaseInTheCentrePlaneIsItsOwnImage) {
  const ShapeFields fields({field_at({1, 0, 1}, 2.0, {1, 5, 0.5})}, true, FieldBlend::kSum);
  EXPECT_EQ(fields.at({1, 0, 1}).shift, Vector3d(1, 0, 0.5));
}

// Whatever is changed between two calls: falloffs, a shift, a base, one that varies along its base.
TEST(ShapeFields, RememberedPlacesGetTheSameShifts) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  Points points;
  for (int k = 0; k < 2000; ++k) {
    points.emplace_back(3.0 + 4.0 * part(random), 3.0 * part(random), 2.0 * part(random));
  }
  FieldPlaces places(points);
  std::vector<ShapeField> fields{field_along(kBent, 2.0, {0.0, 0.2, 0.1}),
                                 field_along(kCrossing, 1.5, {0.1, 0.0, 0.0}),
                                 field_at({1, 1, 0}, 1.0, {0.0, 0.1, 0.0})};
  const auto check = [&] {
    for (bool mirrored : {false, true}) {
      const ShapeFields all(fields, mirrored, FieldBlend::kExact);
      const std::vector<FieldShift> wanted = all.at(points), found = all.at(places);
      bool moves = false;
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(found[i].shift, wanted[i].shift);
        EXPECT_EQ(found[i].gradient, wanted[i].gradient);
        moves = moves || !wanted[i].shift.isZero(0.0);
      }
      EXPECT_TRUE(moves);
    }
  };
  check();
  for (ShapeField& field : fields) field.kappa = AlongBase<double>(0.8);
  fields[0].shift = AlongBase<Vector3d>({0.3, 0.0, 0.0});
  check();
  fields[1].extent = AlongBase<double>({0.0, 2.0}, {1.0, 2.0});
  check();
  fields[0].base = curve_base(FieldCurve::through({{0, 1, 0}, {2, 2, 0.5}, {4, 2.4, 0}}));
  fields[2].base = point_base({1, 1.5, 0});
  check();
  fields.erase(fields.begin());
  check();
}

TEST(ShapeFields, RefuseWhatIsNone) {
  const auto made = [](const std::function<void(ShapeField&)>& spoil) {
    ShapeField field = field_at({0, 0, 0}, 1.0, {0, 0, 1});
    spoil(field);
    return ShapeFields({field}, false, FieldBlend::kExact);
  };
  EXPECT_THROW(made([](ShapeField& f) { f.base = nullptr; }), std::invalid_argument);
  EXPECT_THROW(made([](ShapeField& f) { f.extent = AlongBase<double>(0.0); }),
               std::invalid_argument);
  EXPECT_THROW(made([](ShapeField& f) { f.kappa = AlongBase<double>(1.5); }),
               std::invalid_argument);
  EXPECT_THROW(
      made([](ShapeField& f) { f.shift = AlongBase<Vector3d>(Vector3d(0, std::nan(""), 0)); }),
      std::invalid_argument);
  // A spline through positive extents that is not positive between them.
  EXPECT_THROW(made([](ShapeField& f) {
                 f.extent = AlongBase<double>({0, 1, 2, 3}, {5, 0.1, 0.1, 5});
               }),
               std::invalid_argument);
  EXPECT_THROW(AlongBase<double>({0, 0}, {1, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::modelling
