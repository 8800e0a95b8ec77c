// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/derivatives/body_derivatives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>

#include "analysis/derivatives/form_numbers.h"
#include "analysis/stations/section_areas.h"
#include "natural_hull.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

constexpr unsigned kDerivativesSeed = 23112026;

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

std::vector<Vector3d> random_shifts(std::mt19937& random, std::size_t count, double length) {
  std::vector<Vector3d> shifts;
  for (std::size_t i = 0; i < count; ++i) {
    shifts.emplace_back(uniform(random, -length, length), uniform(random, -length, length),
                        uniform(random, -length, length));
  }
  return shifts;
}

double product(const Gradient& gradient, const std::vector<Vector3d>& shifts) {
  double sum = 0.0;
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    sum += gradient.row(static_cast<Eigen::Index>(i)).dot(shifts[i].transpose());
  }
  return sum;
}

// d/dt of what is measured of the surface with its points shifted by t times the shifts, by central
// differences of fourth order. Their own error is that of the sixth differences and of rounding.
double difference(surface::LimitSurface& surface, const std::vector<Vector3d>& shifts, double step,
                  const std::function<double()>& measured) {
  const std::vector<Vector3d> points = surface.mesh().points();
  const auto at = [&](double t) {
    std::vector<Vector3d> moved = points;
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += t * shifts[i];
    surface.set_points(moved);
    return measured();
  };
  const double result =
      (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step);
  surface.set_points(points);
  return result;
}

// Everything that an immersion has, in one row.
Eigen::VectorXd numbers_of(const Immersion& i) {
  Eigen::VectorXd row(15);
  const Eigen::Matrix3d& s = i.waterplane_second;
  row << i.volume, i.centre_of_buoyancy, i.wetted_surface, i.waterplane_area, i.centre_of_flotation,
      s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0);
  return row;
}

Eigen::VectorXd products_of(const ImmersionDerivatives& d, const std::vector<Vector3d>& shifts) {
  Eigen::VectorXd row(15);
  int k = 0;
  row[k++] = product(d.volume, shifts);
  for (const Gradient& g : d.centre_of_buoyancy) row[k++] = product(g, shifts);
  row[k++] = product(d.wetted_surface, shifts);
  row[k++] = product(d.waterplane_area, shifts);
  for (const Gradient& g : d.centre_of_flotation) row[k++] = product(g, shifts);
  for (const Gradient& g : d.waterplane_second) row[k++] = product(g, shifts);
  return row;
}

// Steps are small, so that no edge of a transom or deck dips meanwhile; rounding of the numbers
// over the step is what is left, which the wetted surface has most of.
constexpr double kStep = 1e-5;      // of the size
constexpr double kRounding = 1e-8;  // of powers of the size
constexpr double kOfWetted = 1e-6;

void check_immersion(surface::LimitSurface& surface, bool mirrored, const Plane& water,
                     const std::vector<Vector3d>& shifts) {
  HullBody body(surface, mirrored);
  const double size = surface.mesh().size();
  const Immersion now = body.immersion(water);
  const Eigen::VectorXd got = products_of(BodyDerivatives(body).immersion(now), shifts);
  for (int k = 0; k < got.size(); ++k) {
    // No waterplane but for rounding: no centre of one.
    if (k >= 6 && k < 9 && now.waterplane_area < 1e-9 * size * size) continue;
    const double want = difference(surface, shifts, kStep * size, [&] {
      body.update();
      return numbers_of(body.immersion(water))[k];
    });
    body.update();
    constexpr int kPowers[] = {2, 0, 0, 0, 1, 1, 0, 0, 0, 3, 3, 3, 3, 3, 3};
    const double scale = std::pow(size, kPowers[k]);
    EXPECT_NEAR(got[k], want, (k == 4 ? kOfWetted : kRounding) * scale)
        << "number " << k << ", mirrored " << mirrored;
  }
}

Plane upright(double draft) { return {Vector3d::UnitZ(), draft}; }

TEST(BodyDerivatives, AgreeWithDifferencesOnAShip) {
  std::mt19937 random(kDerivativesSeed);
  RecordProperty("seed", static_cast<int>(kDerivativesSeed));
  const testing::NaturalHull ship = testing::natural_ship();
  for (bool whole : {false, true}) {
    surface::LimitSurface surface{mesh::ControlMesh(whole ? ship.whole() : ship.mesh)};
    const std::vector<Vector3d>& points = surface.mesh().points();
    for (const Plane& water :
         {upright(3.7), water_plane({3.1, 0.02, 0.0, 30.0}), water_plane({3.3, -0.01, 0.3, 30.0}),
          // Above the deck's edge: closings are immersed.
          upright(7.0)}) {
      std::vector<Vector3d> shifts = random_shifts(random, points.size(), 1.0);
      for (std::size_t i = 0; i < points.size() && whole; ++i) {
        // A deck that is not symmetric any longer is closed in another way.
        for (std::size_t j = 0; j <= i; ++j) {
          const Vector3d mirror(1.0, -1.0, 1.0);
          if ((points[i].cwiseProduct(mirror) - points[j]).norm() > 1e-9) continue;
          shifts[i] = shifts[j].cwiseProduct(mirror);
          if (i == j) shifts[i].y() = 0.0;
        }
      }
      check_immersion(surface, !whole, water, shifts);
    }
  }
}

// Rows of control points at even heights have the surface's own rows there: columns of the spans
// below them end exactly on the water.
TEST(BodyDerivatives, AgreeWithDifferencesWhereRowsLieOnTheWater) {
  std::mt19937 random(kDerivativesSeed + 3);
  RecordProperty("seed", static_cast<int>(kDerivativesSeed + 3));
  const testing::NaturalHull ship = testing::natural_ship();
  for (const bool turned : {false, true}) {
    mesh::MeshArrays mesh = ship.mesh;
    // Faces begin with another corner, and so the spans' parameters somewhere else.
    for (std::size_t face = 0; turned && face < mesh.face_sizes.size(); ++face) {
      const auto first = mesh.face_vertices.begin() + static_cast<std::ptrdiff_t>(4 * face);
      std::rotate(first, first + 1 + face % 3, first + 4);
    }
    surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const std::vector<Vector3d>& points = surface.mesh().points();
    for (const double draft : {1.5, 3.0, 4.5}) {
      check_immersion(surface, true, upright(draft), random_shifts(random, points.size(), 1.0));
    }
  }
}

// Corners of three faces, closed bodies and open ones, whose border is closed by a fan from its
// centroid, which moves along.
TEST(BodyDerivatives, AgreeWithDifferencesOnRandomBodies) {
  std::mt19937 random(kDerivativesSeed + 1);
  RecordProperty("seed", static_cast<int>(kDerivativesSeed + 1));
  for (int trial = 0; trial < 8; ++trial) {
    mesh::MeshArrays mesh = testing::cube();
    if (trial % 2) {
      // Without its last face, turned upwards.
      mesh.face_sizes.pop_back();
      mesh.face_vertices.resize(mesh.face_vertices.size() - 4);
      for (auto& p : mesh.points) p = {p.x(), -p.z(), p.y()};
    }
    if (trial % 3 == 0) mesh.creases = {{0, 1}, {1, 3}};
    const auto about = random_shifts(random, mesh.points.size(), 0.25);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) mesh.points[i] += about[i];
    surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const Vector3d up = (Vector3d::UnitZ() + 0.2 * random_shifts(random, 1, 1.0)[0]).normalized();
    const Plane water{up, uniform(random, -0.2, 0.6)};
    check_immersion(surface, false, water, random_shifts(random, mesh.points.size(), 1.0));
  }
}

TEST(BodyDerivatives, OfSectionsAgreeWithDifferences) {
  std::mt19937 random(kDerivativesSeed + 2);
  RecordProperty("seed", static_cast<int>(kDerivativesSeed + 2));
  const testing::NaturalHull ship = testing::natural_ship();
  surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  HullBody body(surface, true);
  const BodyDerivatives derivatives(body);
  for (int trial = 0; trial < 20; ++trial) {
    const Plane water = trial % 2 ? water_plane({3.4, 0.02, trial % 4 == 1 ? 0.2 : 0.0, 30.0})
                                  : upright(trial % 4 ? 6.5 : 3.7);
    const double x = uniform(random, 1.0, 59.0);
    const std::vector<Vector3d> shifts = random_shifts(random, surface.mesh().points().size(), 1.0);
    const double got = product(derivatives.section_area(x, water), shifts);
    const double want = difference(surface, shifts, kStep * surface.mesh().size(), [&] {
      body.update();
      return section_areas(body, {x}, water).front().area;
    });
    body.update();
    EXPECT_NEAR(got, want, 1e-7 * surface.mesh().size()) << "x = " << x;
  }
}

TEST(BodyDerivatives, SectionsWhereAreasJumpAreRefused) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::creased_box(10.0, 4.0, 3.0))};
  const HullBody body(surface, false);
  const BodyDerivatives derivatives(body);
  EXPECT_THROW(derivatives.section_area(0.0, upright(1.0)), std::invalid_argument);
  EXPECT_THROW(derivatives.section_area(std::nan(""), upright(1.0)), std::invalid_argument);
  // The box 10 x 4 x 3: wider by dy at both sides everywhere, the area grows by 2 T dy.
  Gradient gradient = derivatives.section_area(4.0, upright(1.0));
  double wider = 0.0;
  for (Eigen::Index i = 0; i < gradient.rows(); ++i) {
    wider += std::copysign(gradient(i, 1), gradient(i, 1) * surface.mesh().points()[i].y());
  }
  EXPECT_NEAR(wider, 2.0, 1e-12);
}

// Broadest at its open end, or at a flat there: nobody chose that station.
TEST(FormNumbers, SayThatTheLargestSectionIsATransom) {
  mesh::MeshArrays wedge = testing::creased_box(10.0, 4.0, 3.0);
  for (Vector3d& p : wedge.points) p.y() *= 1.0 - 0.05 * p.x();
  mesh::MeshArrays open = wedge;
  // Without the face at x = 0.
  open.face_sizes.erase(open.face_sizes.begin() + 4);
  open.face_vertices.erase(open.face_vertices.begin() + 16, open.face_vertices.begin() + 20);
  for (const mesh::MeshArrays& mesh : {wedge, open}) {
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const HullBody body(surface, false);
    const BodyDerivatives derivatives(body);
    FormNumbers numbers(derivatives, {1.0, 0.0, 0.0, 0.0}, {10.0, 4.0, 1.0});
    EXPECT_NEAR(numbers.value(FormNumber::kLargestSectionArea), 4.0, 1e-9);
    for (const FormNumber number : {FormNumber::kLargestSectionArea, FormNumber::kImmersedPrismatic,
                                    FormNumber::kImmersedMidship}) {
      try {
        numbers.gradient(number);
        ADD_FAILURE() << name_of(number);
      } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()).find("The largest section is a transom"), 0u)
            << error.what();
      }
    }
    EXPECT_NO_THROW(numbers.gradient(FormNumber::kProjectPrismatic));
  }
}

// Nor changed by anything: wholly under water there is no waterplane, and out of it nothing at all.
TEST(FormNumbers, UndefinedNumbersHaveNoDerivatives) {
  using N = FormNumber;
  // By powers of two: what its faces have of a waterplane adds up to nothing, without rounding.
  const surface::LimitSurface surface{mesh::ControlMesh(testing::creased_box(8.0, 4.0, 2.0))};
  const HullBody body(surface, false);
  const BodyDerivatives derivatives(body);
  const auto check = [&](double draft, const std::vector<N>& undefined) {
    FormNumbers numbers(derivatives, {draft, 0.0, 0.0, 4.0}, {8.0, 4.0, 1.0});
    for (const N number : undefined) {
      EXPECT_EQ(numbers.value(number), 0.0) << name_of(number);
      const Gradient gradient = numbers.gradient(number);
      EXPECT_TRUE(gradient.isZero(0.0)) << name_of(number);
      EXPECT_TRUE(numbers.scaling(number, gradient).isZero(0.0)) << name_of(number);
    }
  };
  check(5.0, {N::kLcf, N::kLcfPercent, N::kTcf, N::kBmTransverse, N::kBmLongitudinal,
              N::kKmTransverse, N::kKmLongitudinal, N::kImmersedVerticalPrismatic});
  std::vector<N> all;
  for (int k = 0; k < static_cast<int>(N::kCount); ++k) all.push_back(static_cast<N>(k));
  check(-1.0, all);
}

TEST(FormNumbers, ScalingIsThatOfHullAndWater) {
  const testing::NaturalHull ship = testing::natural_ship();
  surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  const std::vector<Vector3d> points = surface.mesh().points();
  HullBody body(surface, true);
  const BodyDerivatives derivatives(body);
  const auto numbers_at = [&](const Vector3d& scale) {
    std::vector<Vector3d> scaled = points;
    for (Vector3d& p : scaled) p = p.cwiseProduct(scale);
    surface.set_points(scaled);
    body.update();
    return FormNumbers(derivatives, {3.7 * scale.z(), 0.0, 0.0, 30.0 * scale.x()},
                       {60.0 * scale.x(), 12.0 * scale.y(), 3.7 * scale.z()});
  };
  constexpr double kBy = 1e-4;
  for (int k = 0; k < static_cast<int>(FormNumber::kCount); ++k) {
    const auto number = static_cast<FormNumber>(k);
    Eigen::Vector3d want;
    double now = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      Vector3d up = Vector3d::Ones(), down = up;
      up[axis] = std::exp(kBy);
      down[axis] = std::exp(-kBy);
      want[axis] = (numbers_at(up).value(number) - numbers_at(down).value(number)) / (2.0 * kBy);
    }
    FormNumbers numbers = numbers_at(Vector3d::Ones());
    now = numbers.value(number);
    const Vector3d got = numbers.scaling(number, numbers.gradient(number));
    // Second differences leave some 1e-8; the largest section and farthest points are found to
    // less.
    EXPECT_LT((got - want).norm(), 2e-6 * std::max(1.0, std::abs(now))) << name_of(number);
  }
}

}  // namespace
}  // namespace hull::analysis
