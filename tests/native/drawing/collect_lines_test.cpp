// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/lines_plan/collect_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "test_meshes.h"

namespace hull::drawing {
namespace {

// The port half of a box [0, 40] x [-4, 4] x [0, 5], open at the deck and the centre plane.
surface::LimitSurface half_box() {
  mesh::MeshArrays box = testing::creased_box(40.0, 4.0, 5.0);
  for (auto& p : box.points) p.y() += 2.0;
  mesh::MeshArrays half = box;
  half.face_sizes.clear();
  half.face_vertices.clear();
  for (int face : {0, 3, 4, 5}) {  // bottom, side, ends; see testing::cube
    const auto begin = box.face_vertices.begin() + 4 * face;
    testing::add_face(half, std::vector<int>(begin, begin + 4));
  }
  return surface::LimitSurface{mesh::ControlMesh(half)};
}

LinesOptions options() {
  LinesOptions chosen;
  chosen.stations = {30.0, 10.0, 20.0, 10.0};
  chosen.waterlines = {1.0, 2.0};
  chosen.buttocks = {1.5};
  chosen.draft = 3.0;
  return chosen;
}

TEST(CollectLines, CutsEveryPositionOnceInOrder) {
  const LinesDrawing drawing = collect_lines(half_box(), options());
  ASSERT_EQ(drawing.stations.size(), 3u);
  EXPECT_EQ(drawing.stations[0].position, 10.0);
  EXPECT_EQ(drawing.stations[0].label, "1");
  EXPECT_EQ(drawing.stations[2].label, "3");
  ASSERT_EQ(drawing.waterlines.size(), 3u);  // the draft is added
  ASSERT_EQ(drawing.buttocks.size(), 1u);
  for (const NamedCurves& station : drawing.stations) {
    ASSERT_EQ(station.curves.size(), 1u);
    for (const auto& p : station.curves[0].points) EXPECT_NEAR(p.x(), station.position, 1e-12);
  }
}

// Turned so that rounding puts the centre plane's points on either side of y = 0, the outline along
// it, keel and ends, is still there.
TEST(CollectLines, KeepsTheCentrePlaneOutline) {
  const LinesOptions chosen = options();
  const surface::LimitSurface surface = half_box();
  for (double noise : {0.0, 1e-15, -1e-15}) {
    std::vector<Vector3d> points = surface.mesh().points();
    for (auto& p : points) p.y() += noise;
    surface::LimitSurface moved = surface;
    moved.set_points(points);
    double on_centre_plane = 0.0;
    for (const ShipCurve& curve : collect_lines(moved, chosen).outlines) {
      const auto& p = curve.points;
      for (std::size_t i = 1; i < p.size(); ++i) {
        if (std::abs(p[i].y()) + std::abs(p[i - 1].y()) < 1e-9) {
          on_centre_plane += (p[i] - p[i - 1]).norm();
        }
      }
    }
    EXPECT_NEAR(on_centre_plane, 40.0 + 2.0 * 5.0, 1e-9) << noise;
  }
}

// Planes that hold an end, the bottom or the side show its edge, whichever way rounding has moved
// them.
TEST(CollectLines, ShowsTheEdgesOfFlatParts) {
  LinesOptions chosen = options();
  chosen.stations = {0.0, 40.0};
  chosen.waterlines = {0.0};
  chosen.buttocks = {4.0};
  chosen.draft.reset();
  const surface::LimitSurface surface = half_box();
  for (double noise : {0.0, 1e-9, -1e-9}) {
    std::vector<Vector3d> points = surface.mesh().points();
    for (auto& p : points) p += noise * Vector3d(1.0, 1.0, 1.0);
    surface::LimitSurface moved = surface;
    moved.set_points(points);
    const LinesDrawing drawing = collect_lines(moved, chosen);
    ASSERT_EQ(drawing.stations.size(), 2u);
    for (const NamedCurves& station : drawing.stations) {
      EXPECT_FALSE(station.curves.empty()) << station.position << " moved by " << noise;
      for (const ShipCurve& curve : station.curves) {
        for (const auto& p : curve.points) EXPECT_EQ(p.x(), station.position);
      }
    }
    EXPECT_FALSE(drawing.waterlines.front().curves.empty()) << noise;
    EXPECT_FALSE(drawing.buttocks.front().curves.empty()) << noise;
  }
}

TEST(CollectLines, NumbersStationsFromTheAfterPerpendicular) {
  LinesOptions chosen = options();
  const surface::LimitSurface surface = half_box();
  const auto labels = [&] {
    std::vector<std::string> all;
    for (const auto& station : collect_lines(surface, chosen).stations) {
      all.push_back(station.label);
    }
    return all;
  };
  using Labels = std::vector<std::string>;
  chosen.stations = {5.0, 15.0, 20.0};
  EXPECT_EQ(labels(), (Labels{"1", "3", "4"}));
  chosen.station_spacing = 10.0;
  EXPECT_EQ(labels(), (Labels{"0.5", "1.5", "2"}));
  chosen.station_spacing.reset();
  chosen.stations = {1.0, 3.3, 10.0};  // not evenly spaced: counted
  EXPECT_EQ(labels(), (Labels{"0", "1", "2"}));
}

TEST(CollectLines, LabelsHeightsAsExactlyAsNeeded) {
  LinesOptions chosen = options();
  chosen.waterlines = {1.0, 2.0};
  chosen.draft = 1.25;
  const LinesDrawing drawing = collect_lines(half_box(), chosen);
  EXPECT_EQ(drawing.waterlines[0].label, "1.0 m");
  EXPECT_EQ(drawing.waterlines[1].label, "DWL 1.25 m");
}

TEST(CollectLines, LeavesTheCentrePlaneToTheOutline) {
  LinesOptions chosen = options();
  chosen.buttocks = {0.0, 1.5};
  const LinesDrawing drawing = collect_lines(half_box(), chosen);
  ASSERT_EQ(drawing.buttocks.size(), 1u);
  EXPECT_EQ(drawing.buttocks[0].position, 1.5);
}

TEST(CollectLines, RefusesBadPositions) {
  const surface::LimitSurface surface = half_box();
  LinesOptions bad = options();
  bad.buttocks = {-1.0};
  EXPECT_THROW(collect_lines(surface, bad), std::invalid_argument);
  bad = options();
  bad.stations = {NAN};
  EXPECT_THROW(collect_lines(surface, bad), std::invalid_argument);
  bad = options();
  bad.station_spacing = 0.0;
  EXPECT_THROW(collect_lines(surface, bad), std::invalid_argument);
  // Marks of so many frames would fill the memory.
  for (const double spacing : {1e-9, 1e-300}) {
    bad = options();
    bad.frame_spacing = spacing;
    EXPECT_THROW(collect_lines(surface, bad), std::invalid_argument);
  }
}

// In the box's bilge corner a diagonal at 45 degrees from z = 4 reaches the side at z = 0.
TEST(CollectLines, DiagonalsFallFromTheCentrePlane) {
  LinesOptions chosen = options();
  const double quarter = 0.25 * std::numbers::pi;
  chosen.diagonals = {{4.5, quarter}, {3.0, 0.5 * quarter}, {60.0, quarter}};
  const LinesDrawing drawing = collect_lines(half_box(), chosen);
  ASSERT_EQ(drawing.diagonals.size(), 2u);  // the third passes above the hull
  EXPECT_EQ(drawing.diagonals[1].label, "D2");
  for (const NamedDiagonal& member : drawing.diagonals) {
    double reach = 0.0;
    for (const ShipCurve& curve : member.curves) {
      for (const auto& p : curve.points) {
        const double height = member.diagonal.height - p.y() * std::tan(member.diagonal.angle);
        EXPECT_NEAR(p.z(), height, 1e-9);
        reach = std::max(reach, p.y());
      }
    }
    EXPECT_NEAR(reach, 4.0, 1e-9);
  }
  chosen.diagonals = {{3.0, 2.0 * quarter}};
  EXPECT_THROW(collect_lines(half_box(), chosen), std::invalid_argument);
}

TEST(CollectLines, KnucklesAndBordersAreSplinesThroughTheirPoints) {
  const LinesDrawing drawing = collect_lines(half_box(), options());
  for (const auto* family : {&drawing.outlines, &drawing.knuckles}) {
    ASSERT_FALSE(family->empty());
    for (const ShipCurve& curve : *family) {
      ASSERT_TRUE(curve.spline);
      const surface::CubicSpline& spline = *curve.spline;
      EXPECT_LT((spline.points().front() - curve.points.front()).norm(), 1e-12);
      EXPECT_LT((spline.points().back() - curve.points.back()).norm(), 1e-12);
    }
  }
}

TEST(CollectLines, OffsetsAreThoseOfTheLines) {
  const LinesDrawing drawing = collect_lines(half_box(), options());
  ASSERT_TRUE(drawing.offsets);
  const analysis::OffsetTable& table = *drawing.offsets;
  EXPECT_EQ(table.stations, (std::vector<double>{10.0, 20.0, 30.0}));
  EXPECT_EQ(table.waterlines, (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(table.buttocks, (std::vector<double>{0.0, 1.5}));
  LinesOptions without = options();
  without.offsets = false;
  EXPECT_FALSE(collect_lines(half_box(), without).offsets);
}

TEST(CollectLines, LeavesOutWhatIsBeyondTheHull) {
  LinesOptions chosen = options();
  chosen.stations = {-30.0, 10.0, 70.0};
  chosen.waterlines = {1.0, 9.0};
  chosen.buttocks = {1.0, 5.0};
  const LinesDrawing drawing = collect_lines(half_box(), chosen);
  ASSERT_EQ(drawing.stations.size(), 1u);
  EXPECT_EQ(drawing.stations[0].position, 10.0);
  EXPECT_EQ(drawing.waterlines.size(), 2u);  // with the draft
  EXPECT_EQ(drawing.buttocks.size(), 1u);
}

}  // namespace
}  // namespace hull::drawing
