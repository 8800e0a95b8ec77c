// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/move_watch.h"

#include <gtest/gtest.h>

#include <random>

#include "analysis/sections/sections.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

constexpr unsigned kMoveWatchSeed = 1212;

bool equal(const std::vector<SectionCurve>& a, const std::vector<SectionCurve>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].points != b[i].points || a[i].curvatures != b[i].curvatures) return false;
  }
  return true;
}

// A section by a plane that the watch says nothing came near is the same before and after, to the
// last bit, and few planes are said to be near that are not.
TEST(MoveWatch, SectionsThatNothingCameNearStay) {
  SCOPED_TRACE(::testing::Message() << "seed " << kMoveWatchSeed);
  std::mt19937 random(kMoveWatchSeed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  mesh::MeshArrays arrays = testing::grid(16, 12);
  for (auto& p : arrays.points) p.z() = 2.0 * std::sin(0.3 * p.x()) * std::cos(0.4 * p.y());
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  MoveWatch watch(surface);
  EXPECT_FALSE(watch.comes_near(plane_across(Axis::kX, 3.0), 1.0)) << "nothing has moved yet";
  int stayed = 0, near = 0, near_but_same = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Plane plane =
        plane_across(static_cast<Axis>(trial % 3), (trial % 3 < 2 ? 12.0 : 1.0) * unit(random));
    if (trial % 4 == 0) {
      plane.normal = Vector3d(unit(random), unit(random), 0.1).normalized();
      plane.offset = 8.0 * unit(random);
    }
    const SectionOptions options{1e-4, 1e-9};
    const auto before = section(surface, plane, options);
    // Not a point of the border's corners: the size, and with it what is rounding, stays.
    const int point =
        17 * static_cast<int>(1 + 10 * unit(random)) + 1 + static_cast<int>(14 * unit(random));
    arrays.points[point].z() += unit(random) - 0.5;
    arrays.points[point].x() += 0.3 * (unit(random) - 0.5);
    surface.set_points(arrays.points);
    watch.update();
    EXPECT_FALSE(watch.cells().empty());
    const bool same = equal(before, section(surface, plane, options));
    if (watch.comes_near(plane, 1e-8)) {
      ++near;
      near_but_same += same;
    } else {
      ++stayed;
      EXPECT_TRUE(same) << "trial " << trial;
    }
  }
  EXPECT_GT(stayed, 15);
  EXPECT_GT(near, 10);
  EXPECT_LT(near_but_same, near / 2);
  watch.update();
  EXPECT_TRUE(watch.cells().empty());
}

// What of a section is rounding goes by the size: none is that of a new cut for certain.
TEST(MoveWatch, ASizeThatChangesIsNearEverywhere) {
  mesh::MeshArrays arrays = testing::grid(12, 4);
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  MoveWatch watch(surface);
  const Plane far = plane_across(Axis::kX, 11.0);
  arrays.points[0].z() = -1.0;
  surface.set_points(arrays.points);
  watch.update();
  EXPECT_TRUE(watch.comes_near(far, 0.0));
  arrays.points[0].z() = -0.5;
  arrays.points[1].z() = -1.0;  // as far as the other was
  surface.set_points(arrays.points);
  watch.update();
  EXPECT_FALSE(watch.comes_near(far, 0.0));
}

TEST(MoveWatch, OutOfDateRefusesToAnswer) {
  mesh::MeshArrays arrays = testing::grid(4, 4);
  surface::LimitSurface surface{mesh::ControlMesh(arrays)};
  MoveWatch watch(surface);
  arrays.points[12].z() += 1.0;
  surface.set_points(arrays.points);
  EXPECT_THROW(watch.comes_near(plane_across(Axis::kX, 2.0), 0.0), std::invalid_argument);
  EXPECT_THROW(watch.cells(), std::invalid_argument);
  watch.update();
  EXPECT_TRUE(watch.comes_near(plane_across(Axis::kX, 2.0), 0.0));
}

}  // namespace
}  // namespace hull::analysis
