// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/patches/transfinite_patch.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "network/patches/patch_grid.h"
#include "random_sides.h"

namespace hull::network {
namespace {

using hull::testing::CubicWay;
using hull::testing::random_sides;
using hull::testing::random_vector;
using hull::testing::side_of;
using hull::testing::uniform;

Vector2d on_side(const TransfinitePatch& patch, std::size_t side, double u) {
  const auto& corners = patch.domain();
  return (1.0 - u) * corners[side] + u * corners[(side + 1) % corners.size()];
}

Vector2d inside(const TransfinitePatch& patch, std::mt19937& random) {
  Vector2d sum = Vector2d::Zero();
  double all = 0.0;
  for (const Vector2d& corner : patch.domain()) {
    const double share = uniform(random, 0.05, 1.0);
    sum += share * corner;
    all += share;
  }
  return sum / all;
}

double angle_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(TransfinitePatch, PassesThroughItsSidesInTheirTangentPlanes) {
  std::mt19937 random(31);
  for (int trial = 0; trial < 90; ++trial) {
    const int count = 3 + trial % 8;
    const auto sides = random_sides(random, count);
    const TransfinitePatch patch(sides);
    ASSERT_EQ(patch.side_count(), count);
    for (std::size_t side = 0; side < sides.size(); ++side) {
      for (int i = 0; i <= 40; ++i) {
        const double u = i / 40.0;
        const SideJet jet = sides[side](u);
        const PatchPoint point = patch.at(on_side(patch, side, u));
        ASSERT_LT((point.point - jet.point).norm(), 1e-12) << count << " sides at " << u;
        const Vector3d normal = jet.slope.cross(jet.ribbon);
        // Not at corners, where two ribbons are what is asked for, nor where there is no plane.
        if (i == 0 || i == 40 || normal.norm() < 0.05) continue;
        ASSERT_LT(angle_between(point.normal(), normal), 1e-9) << count << " sides at " << u;
      }
    }
  }
}

TEST(TransfinitePatch, OfTwoSidesHasAHalvedOne) {
  std::mt19937 random(32);
  for (int trial = 0; trial < 20; ++trial) {
    const auto sides = random_sides(random, 2);
    const TransfinitePatch patch(sides);
    ASSERT_EQ(patch.side_count(), 3);
    // The side that is whole, and the halves of the other: each point of both sides is met.
    const bool is_second = (patch.at(on_side(patch, 0, 0.3)).point - sides[1](0.3).point).norm() <
                           (patch.at(on_side(patch, 0, 0.3)).point - sides[0](0.3).point).norm();
    const RibbonedSide &whole = sides[is_second ? 1 : 0], &halved = sides[is_second ? 0 : 1];
    for (int i = 0; i <= 20; ++i) {
      const double u = i / 20.0;
      EXPECT_LT((patch.at(on_side(patch, 0, u)).point - whole(u).point).norm(), 1e-12);
      const PatchPoint first = patch.at(on_side(patch, 1, u));
      const PatchPoint second = patch.at(on_side(patch, 2, u));
      EXPECT_LT((first.point - halved(0.5 * u).point).norm(), 1e-12);
      EXPECT_LT((second.point - halved(0.5 + 0.5 * u).point).norm(), 1e-12);
      if (i == 0 || i == 20) continue;
      for (const auto& [told, jet] :
           {std::pair(patch.at(on_side(patch, 0, u)), whole(u)), std::pair(first, halved(0.5 * u)),
            std::pair(second, halved(0.5 + 0.5 * u))}) {
        const Vector3d normal = jet.slope.cross(jet.ribbon);
        if (normal.norm() < 0.05) continue;
        EXPECT_LT(angle_between(told.normal(), normal), 1e-9) << trial << " at " << u;
      }
    }
  }
}

// By powers of both coordinates.
struct Bicubic {
  Eigen::Matrix<Vector3d, 4, 4> by;

  Vector3d at(double u, double v, int du, int dv) const {
    const auto power = [](double t, int n, int order) {
      double value = 1.0;
      for (int i = 0; i < order; ++i) value *= n - i;
      return n < order ? 0.0 : value * std::pow(t, n - order);
    };
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) sum += power(u, i, du) * power(v, k, dv) * by(i, k);
    }
    return sum;
  }
};

std::vector<RibbonedSide> sides_of(const Bicubic& s) {
  const auto along_first = [s](double v, double sense) {
    return [s, v, sense](double t) {
      const double u = sense > 0.0 ? t : 1.0 - t;
      return SideJet{s.at(u, v, 0, 0), sense * s.at(u, v, 1, 0), sense * s.at(u, v, 0, 1),
                     s.at(u, v, 1, 1), s.at(u, v, 2, 0)};
    };
  };
  const auto along_second = [s](double u, double sense) {
    return [s, u, sense](double t) {
      const double v = sense > 0.0 ? t : 1.0 - t;
      return SideJet{s.at(u, v, 0, 0), sense * s.at(u, v, 0, 1), -sense * s.at(u, v, 1, 0),
                     -s.at(u, v, 1, 1), s.at(u, v, 0, 2)};
    };
  };
  return {along_first(0.0, 1.0), along_second(1.0, 1.0), along_first(1.0, -1.0),
          along_second(0.0, -1.0)};
}

TEST(TransfinitePatch, OfFourSidesReproducesBicubics) {
  std::mt19937 random(33);
  for (int trial = 0; trial < 20; ++trial) {
    Bicubic surface;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) surface.by(i, k) = random_vector(random);
    }
    const TransfinitePatch patch(sides_of(surface));
    for (int i = 0; i <= 10; ++i) {
      for (int k = 0; k <= 10; ++k) {
        const PatchPoint point = patch.at({i / 10.0, k / 10.0});
        EXPECT_LT((point.point - surface.at(i / 10.0, k / 10.0, 0, 0)).norm(), 1e-13);
        EXPECT_LT((point.by_first - surface.at(i / 10.0, k / 10.0, 1, 0)).norm(), 1e-12);
        EXPECT_LT((point.by_second - surface.at(i / 10.0, k / 10.0, 0, 1)).norm(), 1e-12);
      }
    }
  }
}

TEST(TransfinitePatch, DerivativesAgreeWithDifferences) {
  std::mt19937 random(34);
  const double h = 1e-6;
  for (int trial = 0; trial < 90; ++trial) {
    const TransfinitePatch patch(random_sides(random, 2 + trial % 9));
    const Vector2d at = inside(patch, random);
    const PatchPoint point = patch.at(at);
    for (int i = 0; i < 2; ++i) {
      const Vector2d step = h * Vector2d::Unit(i);
      const Vector3d slope = (patch.at(at + step).point - patch.at(at - step).point) / (2.0 * h);
      EXPECT_LT((slope - (i == 0 ? point.by_first : point.by_second)).norm(), 1e-8);
    }
  }
}

TEST(TransfinitePatch, OfSidesInAPlaneStaysThere) {
  std::mt19937 random(35);
  for (int count = 2; count <= 10; ++count) {
    const TransfinitePatch patch(random_sides(random, count, 0.0));
    for (int i = 0; i < 50; ++i) {
      EXPECT_LT(std::abs(patch.at(inside(patch, random)).point.z()), 1e-15);
    }
  }
}

TEST(TransfinitePatch, GoesWithAffineMapsOfItsSides) {
  std::mt19937 random(36);
  for (int count = 3; count <= 10; ++count) {
    const auto sides = random_sides(random, count);
    Eigen::Matrix3d map;
    for (int i = 0; i < 3; ++i) map.col(i) = random_vector(random);
    const Vector3d shift = 5.0 * random_vector(random);
    std::vector<RibbonedSide> moved;
    for (const RibbonedSide& side : sides) {
      moved.emplace_back([side, map, shift](double u) {
        const SideJet jet = side(u);
        return SideJet{map * jet.point + shift, map * jet.slope, map * jet.ribbon,
                       map * jet.ribbon_slope, map * jet.bend};
      });
    }
    const TransfinitePatch patch(sides), other(moved);
    for (int i = 0; i < 20; ++i) {
      const Vector2d at = inside(patch, random);
      EXPECT_LT((map * patch.at(at).point + shift - other.at(at).point).norm(), 1e-13);
    }
  }
}

TEST(TransfinitePatch, GoesWithTheNumberingOfItsSides) {
  std::mt19937 random(37);
  for (int count : {3, 4, 5, 6, 9}) {
    auto sides = random_sides(random, count);
    const TransfinitePatch patch(sides);
    std::rotate(sides.begin(), sides.begin() + 1, sides.end());
    const TransfinitePatch turned(sides);
    for (int i = 0; i < 20; ++i) {
      // The same place by its corners' numbers: turned by one side.
      const Vector2d at = inside(patch, random);
      const double angle = 2.0 * std::numbers::pi / count;
      const Vector2d there =
          count == 4 ? Vector2d(at[1], 1.0 - at[0]) : Vector2d(Eigen::Rotation2Dd(-angle) * at);
      EXPECT_LT((patch.at(at).point - turned.at(there).point).norm(), 1e-13) << count;
    }
  }
}

TEST(TransfinitePatch, SidesThatDoNotMeetAreRefused) {
  std::mt19937 random(38);
  EXPECT_THROW(TransfinitePatch(random_sides(random, 11)), std::invalid_argument);
  EXPECT_THROW(TransfinitePatch({random_sides(random, 3)[0]}), std::invalid_argument);
  auto sides = random_sides(random, 5);
  std::swap(sides[0], sides[1]);
  EXPECT_THROW(TransfinitePatch{sides}, std::invalid_argument);
  sides = random_sides(random, 4);
  sides[2] = [side = sides[2]](double u) {
    SideJet jet = side(u);
    jet.ribbon *= 1.01;
    return jet;
  };
  EXPECT_THROW(TransfinitePatch{sides}, std::invalid_argument);
}

TEST(PatchGrid, CoversTheDomainOnce) {
  for (int sides = 3; sides <= 10; ++sides) {
    std::mt19937 random(39);
    const auto domain = TransfinitePatch(random_sides(random, sides)).domain();
    double whole = 0.0;
    for (std::size_t i = 0; i < domain.size(); ++i) {
      const Vector2d &a = domain[i], &b = domain[(i + 1) % domain.size()];
      whole += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    for (int count : {1, 2, 7}) {
      const PatchGrid grid = patch_grid(domain, count);
      double area = 0.0;
      for (const auto& [a, b, c] : grid.triangles) {
        const auto at = [&](int i) { return grid.places[static_cast<std::size_t>(i)]; };
        const Vector2d first = at(b) - at(a), second = at(c) - at(a);
        const double part = 0.5 * (first[0] * second[1] - first[1] * second[0]);
        EXPECT_GT(part, 0.0);
        area += part;
      }
      EXPECT_NEAR(area, whole, 1e-12);  // the rounding of up to 490 terms
    }
    EXPECT_THROW(patch_grid(domain, 0), std::invalid_argument);
  }
}

}  // namespace
}  // namespace hull::network
