// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/hull_curves.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "test_meshes.h"

namespace hull::production {
namespace {

// Rays would meet the pieces as they were, and curves be followed over the surface as it is.
TEST(HullCurves, RefuseOnceTheirSurfaceHasMoved) {
  surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const HullCurves curves(surface, 1e-3);
  const std::vector<Vector3d> line{{-0.1, -0.1, 3.0}, {0.1, 0.1, 3.0}};
  const Vector3d down = -Vector3d::UnitZ(), across = Vector3d::UnitX();
  const auto base = curves.in_plane({Vector3d::UnitZ(), 0.1}, "base");
  ASSERT_EQ(base.size(), 1u);
  ASSERT_FALSE(curves.projected(line, down, "line").empty());

  std::vector<Vector3d> points = surface.mesh().points();
  for (Vector3d& p : points) p.z() *= 1.2;
  surface.set_points(points);
  const auto refuses = [](const auto& query) {
    try {
      query();
      ADD_FAILURE() << "an answer of old and new parts";
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(),
                   "The HullCurves object is out of date: the surface's points were set since. "
                   "Make it anew.");
    }
  };
  refuses([&] { curves.surface(); });
  refuses([&] { curves.in_plane({Vector3d::UnitX(), 0.1}, "frame"); });
  refuses([&] { curves.on_cylinder({Vector3d::Zero(), Vector3d::UnitZ(), 0.1}, "tunnel"); });
  refuses([&] { curves.at_girth(base[0], 0.1, down, across, "seam"); });
  refuses([&] { curves.projected(line, down, "line"); });
  refuses([&] { curves.projected_from(line, {0.0, 0.0, 5.0}, "line"); });
  refuses([&] { curves.borders(); });
  refuses([&] { curves.knuckles(0.1); });
  EXPECT_FALSE(HullCurves(surface, 1e-3).projected(line, down, "line").empty());
}

}  // namespace
}  // namespace hull::production
