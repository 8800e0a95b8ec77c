// SPDX-License-Identifier: GPL-3.0-or-later
// Hydrostatics of bodies that have closed forms, and their identities.
#include "analysis/hydrostatics/hydrostatics.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

#include "natural_hull.h"

namespace hull::analysis {
namespace {

constexpr double kDraft = 4.1;  // between knots

TEST(Hydrostatics, OfABox) {
  constexpr double kL = 40.0, kB = 8.0, kT = 2.7, kDensity = 1.0;
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(kL, kB, 5.0))};
  const HullBody body(box, false);
  const Hydrostatics p = hydrostatics(body, {kT}, {50.0, 10.0, 3.0}, kDensity);
  EXPECT_NEAR(p.displacement_t, kL * kB * kT, 1e-12 * kL * kB * kT);
  EXPECT_NEAR(p.lcb_percent, 100.0 * (20.0 / 50.0 - 0.5), 1e-12);
  EXPECT_NEAR(p.lcf_percent, p.lcb_percent, 1e-12);
  EXPECT_NEAR(p.tpc, kL * kB / 100.0, 1e-12);
  EXPECT_NEAR(p.mtc, kB * kL * kL * kL / 12.0 / (100.0 * 50.0), 1e-9);
  EXPECT_NEAR(p.waterline_length, kL, 1e-12);
  EXPECT_NEAR(p.waterline_beam, kB, 1e-12);
  EXPECT_NEAR(p.waterline_aft, 0.0, 1e-12);
  EXPECT_NEAR(p.waterline_forward, kL, 1e-12);
  EXPECT_NEAR(p.immersed_length, kL, 1e-12);
  EXPECT_NEAR(p.immersed_beam, kB, 1e-12);
  EXPECT_NEAR(p.immersed_draft, kT, 1e-12);
  EXPECT_NEAR(p.midship_section.area, kB * kT, 1e-12);
  EXPECT_NEAR(p.midship_section.position, 25.0, 0.0);
  EXPECT_NEAR(p.largest_section.area, kB * kT, 1e-12);
  EXPECT_NEAR(p.project.block, kL * kB * kT / (50.0 * 10.0 * 3.0), 1e-12);
  EXPECT_NEAR(p.project.midship, kB * kT / 30.0, 1e-12);
  EXPECT_NEAR(p.project.prismatic, kL / 50.0, 1e-12);
  EXPECT_NEAR(p.project.waterplane, kL * kB / 500.0, 1e-12);
  EXPECT_NEAR(p.project.vertical_prismatic, kT / 3.0, 1e-12);
  for (double c : {p.immersed.block, p.immersed.midship, p.immersed.prismatic,
                   p.immersed.waterplane, p.immersed.vertical_prismatic}) {
    EXPECT_NEAR(c, 1.0, 1e-12);
  }
  EXPECT_NEAR(p.half_angle_of_entrance, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(p.entrance_chord_angle, std::atan2(0.5 * kB, 2.0), 1e-9);
  EXPECT_NEAR(p.lateral_area, kL * kT, 1e-10);
  EXPECT_NEAR(p.lateral_x, 0.5 * kL, 1e-11);
  EXPECT_NEAR(p.lateral_z, 0.5 * kT, 1e-11);
}

// Without length_pp there is no midship; without a design draft, coefficients use the draft.
TEST(Hydrostatics, LeaveOutWhatIsNotGiven) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(40.0, 8.0, 5.0))};
  const HullBody body(box, false);
  const Hydrostatics p = hydrostatics(body, {2.0}, {});
  EXPECT_EQ(p.midship_section.area, 0.0);
  EXPECT_EQ(p.project.block, 0.0);
  EXPECT_EQ(p.lcb_percent, 0.0);
  EXPECT_EQ(p.mtc, 0.0);
  EXPECT_NEAR(p.immersed.block, 1.0, 1e-12);
  EXPECT_NEAR(hydrostatics(body, {2.0}, {40.0, 8.0, 0.0}).project.block, 1.0, 1e-12);
}

TEST(Hydrostatics, AreZeroInTheAir) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(40.0, 8.0, 5.0))};
  const Hydrostatics p = hydrostatics(HullBody(box, false), {-1.0}, {40.0, 8.0, 2.0});
  for (double value : {p.displaced_volume, p.kb, p.waterplane_area, p.km_transverse,
                       p.waterline_length, p.immersed_length, p.immersed_draft, p.lcb_percent,
                       p.project.block, p.lateral_area, p.half_angle_of_entrance}) {
    EXPECT_EQ(value, 0.0);
  }
  // Drowned there is a volume, but no waterplane.
  const Hydrostatics drowned = hydrostatics(HullBody(box, false), {6.0}, {40.0, 8.0, 2.0});
  EXPECT_NEAR(drowned.displaced_volume, 1600.0, 1e-9);
  EXPECT_EQ(drowned.waterline_length, 0.0);
  EXPECT_NEAR(drowned.lateral_area, 200.0, 1e-10);
  EXPECT_EQ(drowned.half_angle_of_entrance, 0.0);
}

// The demi-hulls of a catamaran, one modelled or both, and a rudder amidships.
TEST(Hydrostatics, LateralAreaOfACatamaran) {
  constexpr double kL = 40.0;
  mesh::MeshArrays demi = testing::creased_box(kL, 2.0, 5.0);
  for (auto& p : demi.points) p.y() += 4.0;
  const surface::LimitSurface one{mesh::ControlMesh(demi)};
  const Hydrostatics half = hydrostatics(HullBody(one, true), {3.0}, {kL, 10.0, 3.0});
  EXPECT_NEAR(half.lateral_area, kL * 3.0, 1e-10);
  EXPECT_NEAR(half.lateral_x, 0.5 * kL, 1e-10);
  EXPECT_NEAR(half.lateral_z, 1.5, 1e-10);
  EXPECT_NEAR(half.displaced_volume, 2.0 * kL * 2.0 * 3.0, 1e-9);

  mesh::MeshArrays with_rudder = demi;
  mesh::MeshArrays rudder = testing::creased_box(2.0, 0.4, 2.0);
  const int first = static_cast<int>(demi.points.size());
  for (auto p : rudder.points) with_rudder.points.push_back(p + Eigen::Vector3d(-4.0, 0.0, 0.0));
  for (int v : rudder.face_vertices) with_rudder.face_vertices.push_back(first + v);
  for (int n : rudder.face_sizes) with_rudder.face_sizes.push_back(n);
  for (auto e : rudder.creases) with_rudder.creases.push_back({first + e[0], first + e[1]});
  const surface::LimitSurface three{mesh::ControlMesh(with_rudder)};
  const Hydrostatics p = hydrostatics(HullBody(three, false), {3.0}, {kL, 10.0, 3.0});
  EXPECT_NEAR(p.lateral_area, kL * 3.0 + 4.0, 1e-10);
}

TEST(Hydrostatics, OfANaturalHull) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  const HullBody body(surface, true);
  constexpr double kL = 60.0;
  const Hydrostatics p = hydrostatics(body, {kDraft}, {kL, 12.0, kDraft});
  const auto &Y = ship.along, &Z = ship.upwards;
  const double along = Y.integral(Y, kL), upwards = Z.integral(Z, kDraft);
  const double volume = 2.0 * along * upwards, z = Z(kDraft);
  EXPECT_NEAR(p.displaced_volume, volume, 1e-12 * volume);
  const double lcb = Y.integral([&](double x) { return x * Y(x); }, kL) / along;
  EXPECT_NEAR(p.lcb, lcb, 1e-11);
  EXPECT_NEAR(p.kb, Z.integral([&](double s) { return s * Z(s); }, kDraft) / upwards, 1e-11);
  EXPECT_NEAR(p.waterplane_area, 2.0 * along * z, 1e-10);
  EXPECT_NEAR(p.lcf, lcb, 1e-11);
  const double transverse =
      2.0 / 3.0 * z * z * z * Y.integral([&](double x) { return std::pow(Y(x), 3); }, kL);
  EXPECT_NEAR(p.waterplane_inertia_transverse, transverse, 1e-11 * transverse);
  const double longitudinal =
      2.0 * z * Y.integral([&](double x) { return (x - lcb) * (x - lcb) * Y(x); }, kL);
  EXPECT_NEAR(p.waterplane_inertia_longitudinal, longitudinal, 1e-11 * longitudinal);
  EXPECT_NEAR(p.waterplane_inertia_product, 0.0, 1e-9);
  EXPECT_NEAR(p.bm_transverse, transverse / volume, 1e-11);
  EXPECT_NEAR(p.km_longitudinal, p.kb + longitudinal / volume, 1e-9);
  EXPECT_NEAR(p.midship_section.area, 2.0 * Y(0.5 * kL) * upwards, 1e-11);

  EXPECT_NEAR(p.waterline_length, kL, 1e-9 * kL);
  EXPECT_NEAR(p.half_angle_of_entrance, std::atan(-Y.slope(kL) * z), 1e-10);
  EXPECT_NEAR(p.entrance_chord_angle, std::atan(Y(0.95 * kL) * z / (0.05 * kL)), 1e-9);
  EXPECT_NEAR(p.lateral_area, kL * kDraft, 1e-10);
  EXPECT_NEAR(p.lateral_x, 0.5 * kL, 1e-10);
  EXPECT_NEAR(p.lateral_z, 0.5 * kDraft, 1e-11);

  // The largest breadth along: where the slope passes zero.
  double low = 20.0, high = 35.0;
  while (high - low > 1e-13 * kL) {
    const double middle = 0.5 * (low + high);
    (Y.slope(middle) > 0.0 ? low : high) = middle;
  }
  EXPECT_NEAR(p.waterline_beam, 2.0 * Y(low) * z, 1e-9 * kL);
  EXPECT_NEAR(p.immersed_beam, p.waterline_beam, 1e-9 * kL);
  EXPECT_NEAR(p.largest_section.area, 2.0 * Y(low) * upwards, 1e-8 * 50.0);
  EXPECT_NEAR(p.largest_section.position, low, 1e-2 * kL);
  EXPECT_NEAR(p.immersed.prismatic, volume / (2.0 * Y(low) * upwards * kL), 1e-8);
}

// A body whose waterline is round at its ends, and which is widest below the water.
TEST(Hydrostatics, OfTheSmoothCube) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const HullBody body(surface, false);
  const double r = surface.position(0, 1.0, 1.0).cwiseAbs().maxCoeff();
  const Hydrostatics p = hydrostatics(body, {0.2}, {});
  EXPECT_NEAR(p.immersed_length, 2.0 * r, 1e-9);
  EXPECT_NEAR(p.immersed_beam, 2.0 * r, 1e-9);
  EXPECT_NEAR(p.immersed_draft, r + 0.2, 1e-9);
  EXPECT_LT(p.waterline_length, 2.0 * r - 1e-3);
  EXPECT_NEAR(p.waterline_length, p.waterline_beam, 1e-9);
  EXPECT_NEAR(p.half_angle_of_entrance, 0.5 * std::numbers::pi, 1e-3);
  EXPECT_NEAR(p.largest_section.position, 0.0, 1e-3);
  EXPECT_NEAR(p.lateral_area, p.largest_section.area, 1e-8);
}

// dV/dT = Awp, d(V KB)/dT = T Awp: central differences, error of the step squared.
TEST(Hydrostatics, GrowByTheWaterplane) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  const HullBody body(surface, true);
  constexpr double kStep = 1e-3;
  for (double draft : {0.7, 2.2, 3.9, 5.2}) {
    const Hydrostatics at = hydrostatics(body, {draft}, {});
    const Hydrostatics a = hydrostatics(body, {draft - kStep}, {});
    const Hydrostatics b = hydrostatics(body, {draft + kStep}, {});
    const double area = at.waterplane_area;
    EXPECT_NEAR((b.displaced_volume - a.displaced_volume) / (2.0 * kStep), area, 1e-5 * area);
    EXPECT_NEAR((b.displaced_volume * b.kb - a.displaced_volume * a.kb) / (2.0 * kStep),
                draft * area, 1e-5 * draft * area);
    EXPECT_NEAR((b.lateral_area - a.lateral_area) / (2.0 * kStep), at.waterline_length, 1e-6 * 60);
  }
}

void expect_same(const Hydrostatics& a, const Hydrostatics& b, double relative) {
  const auto near = [&](double x, double y, const char* name) {
    EXPECT_NEAR(x, y, relative * std::max(1.0, std::abs(x))) << name;
  };
  near(a.displaced_volume, b.displaced_volume, "volume");
  near(a.lcb, b.lcb, "lcb");
  near(a.tcb, b.tcb, "tcb");
  near(a.kb, b.kb, "kb");
  near(a.waterplane_area, b.waterplane_area, "waterplane");
  near(a.waterplane_inertia_transverse, b.waterplane_inertia_transverse, "It");
  near(a.waterplane_inertia_longitudinal, b.waterplane_inertia_longitudinal, "Il");
  near(a.waterplane_inertia_product, b.waterplane_inertia_product, "Ilt");
  near(a.waterline_length, b.waterline_length, "Lwl");
  near(a.waterline_beam, b.waterline_beam, "Bwl");
  near(a.immersed_length, b.immersed_length, "Los");
  near(a.immersed_beam, b.immersed_beam, "immersed beam");
  near(a.immersed_draft, b.immersed_draft, "draft");
  near(a.midship_section.area, b.midship_section.area, "midship");
  near(a.largest_section.area, b.largest_section.area, "largest");
  near(a.half_angle_of_entrance, b.half_angle_of_entrance, "entrance");
  near(a.lateral_area, b.lateral_area, "lateral area");
  near(a.lateral_x, b.lateral_x, "lateral x");
  near(a.lateral_z, b.lateral_z, "lateral z");
}

TEST(Hydrostatics, DoNotDependOnTheHalfThatWasModelled) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface half{mesh::ControlMesh(ship.mesh)},
      whole{mesh::ControlMesh(ship.whole())};
  const HullBody a(half, true), b(whole, false);
  for (const FloatingPosition& position :
       {FloatingPosition{3.3}, FloatingPosition{3.3, 0.01, 0.0, 30.0},
        FloatingPosition{3.0, 0.01, 0.12, 30.0}, FloatingPosition{3.0, 0.01, -0.12, 30.0}}) {
    SCOPED_TRACE(::testing::Message() << "trim " << position.trim << " heel " << position.heel);
    const ProjectDimensions project{60.0, 12.0, 4.0};
    expect_same(hydrostatics(a, position, project), hydrostatics(b, position, project), 2e-8);
  }
}

TEST(Hydrostatics, DoNotDependOnNumbering) {
  constexpr unsigned kSeed = 5;
  std::mt19937 random(kSeed);
  const testing::NaturalHull ship = testing::natural_ship();
  mesh::MeshArrays mesh = ship.mesh;
  std::vector<int> order(mesh.points.size()), faces(mesh.face_sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::iota(faces.begin(), faces.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  std::shuffle(faces.begin(), faces.end(), random);
  mesh::MeshArrays shuffled;
  shuffled.points.resize(mesh.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) shuffled.points[order[i]] = mesh.points[i];
  for (int f : faces) {
    std::vector<int> corners;
    const int turn = static_cast<int>(random() % 4);
    for (int k = 0; k < 4; ++k) {
      corners.push_back(order[mesh.face_vertices[4 * f + (k + turn) % 4]]);
    }
    testing::add_face(shuffled, corners);
  }
  const surface::LimitSurface a{mesh::ControlMesh(mesh)}, b{mesh::ControlMesh(shuffled)};
  for (double heel : {0.0, 0.1}) {
    const FloatingPosition position{3.3, 0.005, heel, 30.0};
    const ProjectDimensions project{60.0, 12.0, 4.0};
    expect_same(hydrostatics(HullBody(a, true), position, project),
                hydrostatics(HullBody(b, true), position, project), 1e-9);
  }
}

TEST(Hydrostatics, Table) {
  const testing::NaturalHull ship = testing::natural_ship();
  const surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  const HullBody body(surface, true);
  const ProjectDimensions project{60.0, 12.0, 4.0};
  const std::vector<Hydrostatics> rows =
      hydrostatic_table(body, {1.0, 2.0, 3.0}, {0.0, 0.02}, project, 1.0);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[4].draft, 2.0);
  EXPECT_EQ(rows[4].position.trim, 0.02);
  const Hydrostatics one = hydrostatics(body, {2.0, 0.02, 0.0, 30.0}, project, 1.0);
  EXPECT_EQ(rows[4].displaced_volume, one.displaced_volume);
  EXPECT_EQ(rows[4].immersed.block, one.immersed.block);
}

TEST(Hydrostatics, RefuseWhatMakesNoSense) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const HullBody body(surface, false);
  EXPECT_THROW(hydrostatics(body, {NAN}, {}), std::invalid_argument);
  EXPECT_THROW(hydrostatics(body, {0.0, 1.6}, {}), std::invalid_argument);
  EXPECT_THROW(hydrostatics(body, {0.0}, {-1.0, 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(hydrostatics(body, {0.0}, {}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace hull::analysis
