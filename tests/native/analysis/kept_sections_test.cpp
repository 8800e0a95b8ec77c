// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/kept_sections.h"

#include <gtest/gtest.h>

#include <random>

#include "test_meshes.h"

namespace hull::analysis {
namespace {

constexpr unsigned kKeptSectionsSeed = 1213;

void expect_equal(const std::vector<SectionCurve>& a, const std::vector<SectionCurve>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].points, b[i].points);
    EXPECT_EQ(a[i].cells, b[i].cells);
    EXPECT_EQ(a[i].uv, b[i].uv);
    EXPECT_EQ(a[i].tangents, b[i].tangents);
    EXPECT_EQ(a[i].curvatures, b[i].curvatures);
    EXPECT_EQ(a[i].knuckles, b[i].knuckles);
    EXPECT_EQ(a[i].knuckle_tangents, b[i].knuckle_tangents);
    EXPECT_EQ(a[i].knuckle_curvatures, b[i].knuckle_curvatures);
    EXPECT_EQ(a[i].closed, b[i].closed);
  }
}

mesh::MeshArrays waves() {
  mesh::MeshArrays arrays = testing::grid(16, 12);
  for (auto& p : arrays.points) p.z() = 2.0 * std::sin(0.3 * p.x()) * std::cos(0.4 * p.y());
  // A flat, whose borders are sections.
  for (auto& p : arrays.points) p.z() = p.x() < 6.0 && p.y() < 6.0 ? 0.0 : p.z();
  return arrays;
}

// Whatever was asked for before, and whatever has moved: a plane that the surface lies in, one
// twice in a call, others in each call, other tolerances and another size of the mesh.
TEST(KeptSections, AreThoseOfANewCut) {
  SCOPED_TRACE(::testing::Message() << "seed " << kKeptSectionsSeed);
  std::mt19937 random(kKeptSectionsSeed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  mesh::MeshArrays arrays = waves();
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  KeptSections kept(surface);
  std::vector<Plane> planes{plane_across(Axis::kZ, 0.0)};
  for (int i = 0; i < 12; ++i) planes.push_back(plane_across(static_cast<Axis>(i % 2), 0.9 * i));
  for (int i = 0; i < 6; ++i) {
    const Vector3d normal = Vector3d(unit(random), unit(random), 1.0).normalized();
    planes.push_back({normal, 6.0 * unit(random)});
  }
  SectionOptions options{1e-4, 1e-9};
  for (int step = 0; step < 60; ++step) {
    std::vector<Plane> asked;
    for (const Plane& plane : planes) {
      if (unit(random) < 0.7) asked.push_back(plane);
    }
    if (!asked.empty() && step % 3 == 0) asked.push_back(asked.front());
    const auto found = kept.sections(asked, options);
    const auto wanted = sections(surface, asked, options);
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      SCOPED_TRACE(::testing::Message() << "step " << step << ", plane " << i);
      expect_equal(found[i], wanted[i]);
    }
    if (step % 7 == 5) continue;  // nothing has moved
    const auto point = static_cast<std::size_t>(unit(random) * arrays.points.size());
    arrays.points[point] += 0.4 * Vector3d(unit(random) - 0.5, unit(random) - 0.5, unit(random));
    surface.set_points(arrays.points);
    if (step % 11 == 10) options = {options.chord_tolerance == 1e-4 ? 1e-3 : 1e-4, 1e-8};
  }
}

TEST(KeptSections, ForgetPlanesOfBefore) {
  surface::LimitSurface surface{mesh::ControlMesh(testing::grid(2, 2))};
  KeptSections kept(surface);
  for (int i = 0; i < 40; ++i) {
    std::vector<Plane> planes;
    for (int k = 0; k < 50; ++k) planes.push_back(plane_across(Axis::kX, 1e-3 * (50 * i + k)));
    kept.sections(planes, {1e-3, {}});
    EXPECT_LE(kept.plane_count(), 1050u);
  }
}

TEST(KeptSections, RefuseWhatSectionsRefuse) {
  surface::LimitSurface surface{mesh::ControlMesh(testing::grid(2, 2))};
  KeptSections kept(surface);
  EXPECT_THROW(kept.sections({{Vector3d(2.0, 0.0, 0.0), 0.0}}, {1e-3, {}}), std::invalid_argument);
  EXPECT_THROW(kept.sections({plane_across(Axis::kX, 1.0)}, {0.0, {}}), std::invalid_argument);
  EXPECT_EQ(kept.sections({plane_across(Axis::kX, 1.0)}, {1e-3, {}}).front().size(), 1u);
}

}  // namespace
}  // namespace hull::analysis
