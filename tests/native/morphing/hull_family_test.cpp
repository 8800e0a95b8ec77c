// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/families/hull_family.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "morphing/half_hulls.h"
#include "surface/refined_mesh.h"

namespace hull::morphing {
namespace {

std::vector<surface::LimitSurface> three_parents() {
  return {half_hull(bulb_profile(3.0)), half_hull(bulb_profile(5.0)), half_hull(bulb_profile(8.0))};
}

surface::LimitSurface member_of(const HullFamily& family, const std::vector<double>& weights) {
  surface::LimitSurface surface = family.parents()[0];
  surface.set_points(family.points(weights));
  return surface;
}

TEST(HullFamily, HasItsParentsBitByBit) {
  const HullFamily family(three_parents());
  for (int k = 0; k < 3; ++k) {
    std::vector<double> weights(3, 0.0);
    weights[k] = 1.0;
    EXPECT_EQ(family.points(weights), family.parents()[k].mesh().points());
  }
}

TEST(HullFamily, SurfacesAreTheSumsOfTheParents) {
  const HullFamily family(three_parents());
  const std::vector<double> weights{0.7, -0.5, 0.8};
  const surface::LimitSurface member = member_of(family, weights);
  for (int cell = 0; cell < member.cell_count(); ++cell) {
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      sum += weights[k] * family.parents()[k].position(cell, 0.3, 0.8);
    }
    EXPECT_LT((member.position(cell, 0.3, 0.8) - sum).norm(), 1e-12);
  }
}

TEST(HullFamily, KeepsWhatParentsHaveAlike) {
  const HullFamily family(three_parents());
  const std::vector<Vector3d> points = family.points(std::vector<double>{0.1, 0.2, 0.7});
  for (int i = 0; i < family.point_count(); ++i) {
    EXPECT_EQ(points[i].y(), family.parents()[0].mesh().points()[i].y());
  }
}

TEST(HullFamily, WeightsOfEachPoint) {
  const HullFamily family(three_parents());
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(family.point_count(), 3);
  for (int i = 0; i < family.point_count(); ++i) weights(i, i % 3) = 1.0;
  const std::vector<Vector3d> points = family.points(weights);
  for (int i = 0; i < family.point_count(); ++i) {
    EXPECT_EQ(points[i], family.parents()[i % 3].mesh().points()[i]);
  }
  weights(4, 0) += 0.5;
  EXPECT_THROW(family.points(weights), std::invalid_argument);
}

TEST(HullFamily, FindsFoldsFarOutside) {
  const HullFamily family({half_hull(bulb_profile(3.0)), half_hull(bulb_profile(8.0))});
  EXPECT_FALSE(family.first_fold(family.points(std::vector<double>{0.5, 0.5})));
  EXPECT_TRUE(family.first_fold(family.points(std::vector<double>{11.0, -10.0})));
}

TEST(HullFamily, RefusesWhatIsNone) {
  EXPECT_THROW(HullFamily({half_hull(plain_profile())}), std::invalid_argument);
  EXPECT_THROW(HullFamily({half_hull(plain_profile()), half_hull(bulb_profile(3.0))}),
               std::invalid_argument);
  const HullFamily family(three_parents());
  EXPECT_THROW(family.points(std::vector<double>{0.5, 0.4, 0.0}), std::invalid_argument);
  EXPECT_THROW(family.points(std::vector<double>{1.0}), std::invalid_argument);
}

TEST(HullFamily, SubdividesWithItsParents) {
  const HullFamily family(three_parents());
  std::vector<surface::LimitSurface> finer;
  for (const surface::LimitSurface& parent : family.parents()) {
    finer.emplace_back(surface::refined_mesh(parent));
  }
  const std::vector<double> weights{0.2, 0.3, 0.5};
  const std::vector<Vector3d> points = HullFamily(finer).points(weights);
  const mesh::ControlMesh expected = surface::refined_mesh(member_of(family, weights));
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((points[i] - expected.points()[i]).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace hull::morphing
