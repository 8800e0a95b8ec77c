// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/caps/caps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

#include "conversion/patches/edge_uses.h"
#include "conversion/patches/mirror.h"
#include "conversion/sheets.h"

namespace hull::conversion {
namespace {

using Kind = Cap::Kind;

// Half a boat of 20 x 3 x 2 m: side t = 0 is its keel, t = 1 the deck's edge with the sheer given;
// s = 0 the transom's edge, s = 1 the stem, both sides of no or some breadth.
PatchSet half_boat(const std::function<double(double)>& sheer, int nu = 4) {
  return testing::sheet(nu, 3, [&](double s, double t) {
    const double y = 3.0 * t * (1.0 - s * s);
    const double z = t * t * sheer(s);
    return Vector3d(s == 1.0 ? 20.0 : 20.0 * s, s == 1.0 ? 0.0 : -y, z);
  });
}

std::map<Kind, int> kinds(const Closing& closing) {
  std::map<Kind, int> count;
  for (const Cap& cap : closing.caps) ++count[cap.kind];
  return count;
}

// How often edges are used by patches and caps together, those of no length aside: all twice, once
// each way, where the shell is closed.
void expect_closed(const PatchSet& set, const Closing& closing) {
  const EdgeUses uses(set);
  std::map<int, int> balance, count;
  for (int e = 0; e < set.edge_count; ++e) {
    if (uses.is_border(e) && !uses.is_collapsed(e)) {
      ++count[e];
      ++balance[e];
    }
  }
  for (const Cap& cap : closing.caps) {
    for (const EdgePath& loop : cap.loops) {
      for (const DirectedEdge& edge : loop) {
        ++count[edge.edge];
        balance[edge.edge] += edge.reversed ? -1 : 1;
      }
    }
  }
  for (const auto& [edge, times] : count) {
    EXPECT_EQ(times, 2) << edge;
    EXPECT_EQ(balance[edge], 0) << edge;
  }
}

std::string refusal(PatchSet set) {
  try {
    closing_of(set);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Caps, OfALevelDeckArePlane) {
  PatchSet half = half_boat([](double) { return 2.0; });
  const Closing closing = closing_of(half);
  EXPECT_EQ(kinds(closing),
            (std::map<Kind, int>{{Kind::kDeck, 1}, {Kind::kTransom, 1}, {Kind::kCentrePlane, 1}}));
  for (const Cap& cap : closing.caps) EXPECT_FALSE(cap.patch.has_value());
  expect_closed(half, closing);
  // They look out of the hull, which is on the side y < 0.
  std::map<Kind, Vector3d> normals;
  for (const Cap& cap : closing.caps) normals[cap.kind] = cap.normal;
  EXPECT_LT((normals[Kind::kDeck] - Vector3d::UnitZ()).norm(), 1e-9);
  EXPECT_LT((normals[Kind::kTransom] + Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_LT((normals[Kind::kCentrePlane] - Vector3d::UnitY()).norm(), 1e-9);
}

TEST(Caps, OfADeckWithSheerAreRuledOneForEachEdge) {
  PatchSet half = half_boat([](double s) { return 2.0 + s * s; });
  const Closing closing = closing_of(half);
  EXPECT_EQ(kinds(closing),
            (std::map<Kind, int>{{Kind::kDeck, 4}, {Kind::kTransom, 1}, {Kind::kCentrePlane, 1}}));
  expect_closed(half, closing);
  const EdgeUses uses(half);
  for (const Cap& cap : closing.caps) {
    if (!cap.patch) continue;
    ASSERT_NO_THROW(cap.patch->check());
    // Side 1 is the hull's border, exactly; side 3 its projection.
    const DirectedEdge border = cap.loops[1][0];
    ASSERT_TRUE(border.reversed);
    const BSplineCurve hull = uses.curve(uses.of(border.edge)[0]);
    EXPECT_LT(gap_between(cap.patch->side_curve(1).reversed(), hull), 1e-14);
    for (double t : {0.0, 0.3, 1.0}) {
      Vector3d foot = hull.position(t);
      foot.y() = 0.0;
      EXPECT_LT((cap.patch->side_curve(3).position(t) - foot).norm(), 1e-14);
    }
  }
}

TEST(Caps, OfAMirroredHullReachAcross) {
  for (double sheer : {0.0, 1.0}) {
    PatchSet whole = with_mirror_image(half_boat([&](double s) { return 2.0 + sheer * s * s; }));
    const Closing closing = closing_of(whole);
    const int decks = sheer > 0.0 ? 4 : 1;
    EXPECT_EQ(kinds(closing), (std::map<Kind, int>{{Kind::kDeck, decks}, {Kind::kTransom, 1}}));
    EXPECT_TRUE(closing.vertices.empty());
    expect_closed(whole, closing);
  }
}

TEST(Caps, OfAClosedSurfaceAreNone) {
  std::vector<BSplinePatch> tube = testing::sheet(4, 1, [](double s, double t) {
                                     const double a = 2.0 * M_PI * (s == 1.0 ? 0.0 : s);
                                     return Vector3d(std::cos(a), std::sin(a), t);
                                   }).patches;
  PatchSet open = testing::joined(tube);
  const Closing closing = closing_of(open);
  // A tube has two plane ends.
  ASSERT_EQ(closing.caps.size(), 2u);
  expect_closed(open, closing);
  PatchSet none;
  EXPECT_TRUE(closing_of(none).caps.empty());
}

// One patch from the transom around the bow to the transom.
TEST(Caps, ReachAcrossFromAnEdgeAroundTheBow) {
  PatchSet whole = testing::sheet(1, 1, [](double s, double t) {
    const double side = 2.0 * s - 1.0;
    return Vector3d(10.0 * (1.0 - side * side), 2.0 * side, t * (1.0 + 0.1 * side * side));
  });
  std::vector<BSplinePatch> patches = whole.patches;
  // A flat bottom as well, so that the deck and the transom stay open.
  const BSplineCurve around = patches[0].side_curve(0);
  BSplinePatch bottom{around.degree,
                      1,
                      around.knots,
                      {0, 0, 1, 1},
                      static_cast<int>(around.points.size()),
                      2,
                      {},
                      1};
  for (const Vector3d& point : around.points) {
    bottom.control_points.emplace_back(0.0, point.y(), point.z());
    bottom.control_points.push_back(point);
  }
  patches.push_back(bottom);
  PatchSet set = testing::joined(patches);
  const int edges = set.edge_count;
  const Closing closing = closing_of(set);
  EXPECT_EQ(set.edge_count, edges + 1);
  ASSERT_NO_THROW(set.check());
  expect_closed(set, closing);
  EXPECT_EQ(kinds(closing), (std::map<Kind, int>{{Kind::kDeck, 1}, {Kind::kTransom, 1}}));
}

TEST(Caps, RefuseABorderThatIsNeitherFlatNorSymmetric) {
  const PatchSet bent = testing::sheet(
      2, 2, [](double s, double t) { return Vector3d(s, 1 + t, s * t + s * s * t); });
  EXPECT_NE(refusal(bent).find("neither flat nor symmetric"), std::string::npos) << refusal(bent);
  EXPECT_NE(refusal(bent).find("(0.5, 1.5, 1) m"), std::string::npos) << refusal(bent);
}

// A deck's edge that steps inwards at midship: the edge athwart is part of the plane face, and of a
// sheered deck it is where the caps' ends are.
TEST(Caps, GoAlongEdgesAthwart) {
  for (double sheer : {0.0, 0.1}) {
    PatchSet half = testing::sheet(3, 1, [&](double s, double t) {
      // The middle third runs straight athwart.
      const double x = s <= 1.0 / 3 ? 3 * s : s >= 2.0 / 3 ? 3 * s - 1 : 1.0;
      const double y = s <= 1.0 / 3 ? 2.0 : s >= 2.0 / 3 ? 1.0 : 2.0 - 3 * (s - 1.0 / 3);
      return Vector3d(x, -t * y, t + sheer * x * x);
    });
    const Closing closing = closing_of(half);
    expect_closed(half, closing);
    EXPECT_EQ(kinds(closing)[Kind::kDeck], sheer > 0.0 ? 2 : 1);
    PatchSet whole = with_mirror_image(half);
    expect_closed(whole, closing_of(whole));
  }
}

TEST(Caps, OfTheCentrePlaneHaveHoles) {
  // A ring around the axis y, cut at y = 0: a half torus of two borders there.
  std::vector<BSplinePatch> patches =
      testing::sheet(8, 2, [](double s, double t) {
        const double a = 2.0 * M_PI * (s == 1.0 ? 0.0 : s), b = M_PI * t;
        const double r = 3.0 + std::cos(b);
        return Vector3d(r * std::cos(a), t == 0.0 || t == 1.0 ? 0.0 : std::sin(b), r * std::sin(a));
      }).patches;
  for (BSplinePatch& patch : patches) patch = patch.transposed();
  PatchSet half = testing::joined(patches);
  const Closing closing = closing_of(half);
  ASSERT_EQ(closing.caps.size(), 1u);
  EXPECT_EQ(closing.caps[0].loops.size(), 2u);
  expect_closed(half, closing);
}

}  // namespace
}  // namespace hull::conversion
