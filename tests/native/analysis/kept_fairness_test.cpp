// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/kept_fairness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test_meshes.h"

namespace hull::analysis {
namespace {

constexpr unsigned kKeptFairnessSeed = 2911;

void expect_equal(const std::vector<CurveFairness>& a, const std::vector<CurveFairness>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].closed, b[i].closed);
    EXPECT_EQ(a[i].length, b[i].length);
    EXPECT_EQ(a[i].arc_lengths, b[i].arc_lengths);
    EXPECT_EQ(a[i].starts, b[i].starts);
    ASSERT_EQ(a[i].samples.size(), b[i].samples.size());
    for (std::size_t k = 0; k < a[i].samples.size(); ++k) {
      EXPECT_EQ(a[i].samples[k].point, b[i].samples[k].point);
      EXPECT_EQ(a[i].samples[k].tangent, b[i].samples[k].tangent);
      EXPECT_EQ(a[i].samples[k].curvature, b[i].samples[k].curvature);
    }
    ASSERT_EQ(a[i].marks.size(), b[i].marks.size());
    for (std::size_t k = 0; k < a[i].marks.size(); ++k) {
      EXPECT_EQ(a[i].marks[k].kind, b[i].marks[k].kind);
      EXPECT_EQ(a[i].marks[k].arc_length, b[i].marks[k].arc_length);
      EXPECT_EQ(a[i].marks[k].point, b[i].marks[k].point);
      EXPECT_EQ(a[i].marks[k].curvature, b[i].marks[k].curvature);
      EXPECT_EQ(a[i].marks[k].peak, b[i].marks[k].peak);
    }
  }
}

// With a crease across it, and irregular points.
mesh::MeshArrays bumps() {
  mesh::MeshArrays arrays = testing::grid(16, 12);
  for (auto& p : arrays.points) p.z() = 2.0 * std::sin(0.3 * p.x()) * std::cos(0.4 * p.y());
  for (int i = 4; i < 12; ++i) arrays.creases.push_back({13 * i + 6, 13 * (i + 1) + 6});
  return arrays;
}

std::vector<std::vector<const SectionCurve*>> pointers_to(
    const std::vector<std::vector<SectionCurve>>& sections) {
  std::vector<std::vector<const SectionCurve*>> pointers(sections.size());
  for (std::size_t i = 0; i < sections.size(); ++i) {
    for (const SectionCurve& curve : sections[i]) pointers[i].push_back(&curve);
  }
  return pointers;
}

std::vector<Plane> some_planes(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  // Along lines between patches, beside them, level and aslant.
  std::vector<Plane> planes;
  for (int i = 1; i < 12; ++i) planes.push_back(plane_across(static_cast<Axis>(i % 2), 1.0 * i));
  for (int i = 1; i < 12; ++i) planes.push_back(plane_across(static_cast<Axis>(i % 2), 0.93 * i));
  for (int i = 0; i < 4; ++i) planes.push_back(plane_across(Axis::kZ, 0.4 * i - 0.7));
  for (int i = 0; i < 6; ++i) {
    const Vector3d normal = Vector3d(unit(random), unit(random), 1.0).normalized();
    planes.push_back({normal, 6.0 * unit(random)});
  }
  return planes;
}

// Whatever was asked for before, and whatever has moved: one plane twice in a call, others in each
// call, other rules, sections cut to other tolerances, another size of the mesh.
TEST(KeptFairness, IsThatOfNewSections) {
  SCOPED_TRACE(::testing::Message() << "seed " << kKeptFairnessSeed);
  std::mt19937 random(kKeptFairnessSeed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  mesh::MeshArrays arrays = bumps();
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  KeptFairness kept(surface);
  const std::vector<Plane> planes = some_planes(random);
  FairnessOptions options;
  double chord = 2e-5;
  int recalled = 0;
  for (int step = 0; step < 60; ++step) {
    std::vector<Plane> asked;
    for (const Plane& plane : planes) {
      if (unit(random) < 0.7) asked.push_back(plane);
    }
    if (!asked.empty() && step % 3 == 0) asked.push_back(asked.front());
    const auto cut = sections(surface, asked, {chord, 1e-9});
    const auto curves = pointers_to(cut);
    const auto found = kept.section_fairness(asked, curves, options);
    recalled += kept.recalled_count();
    const auto wanted = section_fairness(surface, asked, curves, options);
    for (std::size_t i = 0; i < found.size(); ++i) {
      SCOPED_TRACE(::testing::Message() << "step " << step << ", plane " << i);
      expect_equal(found[i], wanted[i]);
    }
    if (step % 7 == 5) continue;  // nothing has moved
    // Every ninth time a corner, so that the size is another one.
    const auto point = step % 9 == 8
                           ? std::size_t{0}
                           : static_cast<std::size_t>(unit(random) * arrays.points.size());
    arrays.points[point] += 0.3 * Vector3d(unit(random) - 0.5, unit(random) - 0.5, unit(random));
    surface.set_points(arrays.points);
    if (step % 11 == 10) options.step = 0.01 * (1.0 + step);
    if (step % 13 == 12) chord = chord == 2e-5 ? 1e-4 : 2e-5;
  }
  EXPECT_GT(recalled, 10000);
}

// Where a point moves, what is elsewhere is kept; where none has moved, all is.
TEST(KeptFairness, KeepsWhatHasNotMoved) {
  mesh::MeshArrays arrays = bumps();
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  KeptFairness kept(surface);
  const std::vector<Plane> planes{plane_across(Axis::kX, 7.3)};
  const auto judge = [&] {
    const auto cut = sections(surface, planes, {1e-4, {}});
    kept.section_fairness(planes, pointers_to(cut), {});
    return static_cast<int>(cut[0].at(0).points.size()) - 1;
  };
  judge();
  EXPECT_EQ(kept.recalled_count(), 0);
  const int once_more = judge();
  EXPECT_EQ(kept.recalled_count(), once_more);
  arrays.points[13 * 7 + 1].z() += 0.1;  // near one end of the section
  surface.set_points(arrays.points);
  const int all = judge();
  EXPECT_GT(kept.recalled_count(), all / 2);
  EXPECT_LT(kept.recalled_count(), all);
}

TEST(KeptFairness, ForgetsPlanesOfBefore) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::grid(2, 2))};
  KeptFairness kept(surface);
  for (int i = 0; i < 40; ++i) {
    std::vector<Plane> planes;
    for (int k = 0; k < 50; ++k) planes.push_back(plane_across(Axis::kX, 1e-3 * (50 * i + k)));
    const auto cut = sections(surface, planes, {1e-5, {}});
    kept.section_fairness(planes, pointers_to(cut), {});
    EXPECT_LE(kept.plane_count(), 1050u);
  }
}

TEST(KeptFairness, RefusesSectionsOfBefore) {
  mesh::MeshArrays arrays = bumps();
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  KeptFairness kept(surface);
  const std::vector<Plane> planes{plane_across(Axis::kX, 7.3)};
  const auto cut = sections(surface, planes, {1e-4, {}});
  for (auto& p : arrays.points) p.z() += 0.1 * p.x();
  surface.set_points(arrays.points);
  EXPECT_THROW(kept.section_fairness(planes, pointers_to(cut), {}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::analysis
