// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_turns.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_meshes.h"

namespace hull::morphing {
namespace {

using modelling::SurfacePlaces;

constexpr int kSide = 8;

surface::LimitSurface plate(const mesh::MeshArrays& mesh) {
  return surface::LimitSurface(mesh::ControlMesh(mesh));
}

// Two rows of a plane grid slid through one another: it lies on the plane, over and over.
mesh::MeshArrays slid_through() {
  mesh::MeshArrays mesh = testing::grid(kSide, kSide);
  for (Vector3d& p : mesh.points) {
    if (p.y() < 2.0 || p.y() > 6.0) continue;
    if (p.x() == 3.0)
      p.x() = 5.0;
    else if (p.x() == 5.0)
      p.x() = 3.0;
  }
  return mesh;
}

TEST(LayoutTurns, FindsRowsThatHaveSlidThroughOneAnother) {
  const surface::LimitSurface hull = plate(testing::grid(kSide, kSide));
  const SurfacePlaces slid(plate(slid_through()));
  const std::vector<int> turned = LayoutTurns(hull).turned(slid);
  ASSERT_FALSE(turned.empty());
  for (int place : turned) {
    EXPECT_LT(slid.normal(place).z(), 0.0);
    EXPECT_NEAR(slid.position(place).x(), 4.0, 1.5);
    EXPECT_NEAR(slid.position(place).y(), 4.0, 3.0);
  }
  EXPECT_TRUE(LayoutTurns(hull).turned(SurfacePlaces(hull)).empty());
}

// A box whose top rim has an acute angle, as flare gives it to a deck edge; the layout's sides end
// a little below it or above it, so that their feet are on the deck.
TEST(LayoutTurns, AsksBothFacesBesideAnAcuteKnuckle) {
  mesh::MeshArrays box = testing::creased_box(10.0, 4.0, 4.0);
  for (Vector3d& p : box.points) {
    if (p.z() > 2.0) p.y() *= 3.0;
  }
  const surface::LimitSurface hull = plate(box);
  for (double shift : {-0.02, 0.02}) {
    mesh::MeshArrays moved = box;
    for (Vector3d& p : moved.points) {
      if (p.z() > 2.0) p += Vector3d(0.0, p.y() > 0.0 ? shift : -shift, -shift);
    }
    EXPECT_TRUE(LayoutTurns(hull).turned(SurfacePlaces(plate(moved))).empty()) << shift;
  }
}

TEST(LayoutTurns, AskNothingOfWhatIsFarFromTheHull) {
  const surface::LimitSurface hull = plate(testing::grid(kSide, kSide));
  mesh::MeshArrays far = slid_through();
  for (Vector3d& p : far.points) p.z() += 2.0 * LayoutTurns::kNearHull * hull.mesh().size();
  EXPECT_TRUE(LayoutTurns(hull).turned(SurfacePlaces(plate(far))).empty());
}

}  // namespace
}  // namespace hull::morphing
