// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/geodesic_net.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "modelling/fields/shape_fields.h"
#include "random_values.h"
#include "test_meshes.h"
#include "trials.h"

namespace hull::modelling {
namespace {

constexpr unsigned kNetSeed = 24112026;

Vector3d somewhere_on(const surface::LimitSurface& surface, std::mt19937& random) {
  const int cell = static_cast<int>(testing::uniform(random, 0.0, surface.cell_count() - 1e-9));
  return surface.position(cell, testing::uniform(random, 0.0, 1.0),
                          testing::uniform(random, 0.0, 1.0));
}

// On random meshes of every kind: no way is shorter than the straight line, but for the last steps
// of the net, and the base is met.
TEST(GeodesicNet, NoWayIsShorterThanTheStraightLine) {
  SCOPED_TRACE(::testing::Message() << "seed " << kNetSeed);
  std::mt19937 random(kNetSeed);
  for (int trial = 0; trial < testing::trials(40); ++trial) {
    const surface::LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 8)));
    const auto net = std::make_shared<const GeodesicNet>(surface, trial % 2 == 1);
    const Vector3d place = somewhere_on(surface, random);
    const auto base = along_surface(point_base(place), net);
    EXPECT_NEAR(base->foot(place, false).distance, 0.0, 1e-12 * surface.mesh().size());
    for (int k = 0; k < 50; ++k) {
      const Vector3d p = somewhere_on(surface, random);
      const BaseFoot foot = base->foot(p, false);
      EXPECT_GE(foot.distance, (p - place).norm() * (1.0 - 1e-12));
      EXPECT_TRUE(foot.distance_slope.allFinite());
    }
  }
}

TEST(GeodesicNet, RefusesABaseThatIsNotOnTheSurface) {
  std::mt19937 random(kNetSeed);
  const surface::LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 8)));
  const auto net = std::make_shared<const GeodesicNet>(surface, false);
  const Vector3d far = Vector3d::Constant(100.0 * surface.mesh().size());
  EXPECT_THROW(along_surface(point_base(far), net), std::invalid_argument);
}

// On random meshes of every kind: the intensity is 1 all over the region, and none beyond its
// extent.
TEST(RegionBase, IsMetAllOver) {
  SCOPED_TRACE(::testing::Message() << "seed " << kNetSeed);
  std::mt19937 random(kNetSeed);
  for (int trial = 0; trial < testing::trials(100); ++trial) {
    const surface::LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 8)));
    const int cell = static_cast<int>(testing::uniform(random, 0.0, surface.cell_count() - 1e-9));
    ShapeField field;
    field.base = region_base(surface, {cell});
    field.extent = AlongBase<double>(0.2 * surface.mesh().size());
    const Vector3d shift(0.1, -0.2, 0.3);
    field.shift = AlongBase<Vector3d>(shift);
    const ShapeFields fields({field}, false, FieldBlend::kExact);
    for (int k = 0; k < 20; ++k) {
      const Vector3d own = surface.position(cell, testing::uniform(random, 0.0, 1.0),
                                            testing::uniform(random, 0.0, 1.0));
      const FieldShift at = fields.at(own);
      EXPECT_EQ(at.shift, shift);
      EXPECT_TRUE(at.gradient.isZero(0.0));
      const Vector3d p = somewhere_on(surface, random);
      EXPECT_TRUE(fields.at(p).gradient.allFinite());
      if (fields.delta(0, p) >= 1.0) {
        EXPECT_TRUE(fields.at(p).shift.isZero(0.0));
      }
    }
  }
}

}  // namespace
}  // namespace hull::modelling
