// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/creases/crease_curves.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "test_meshes.h"

namespace hull::surface {
namespace {

constexpr unsigned kCreaseCurvesSeed = 881;

Vector3d at_place(const LimitSurface& surface, const CellPlace& place) {
  return surface.position(place.cell, place.u, place.v);
}

// The curve against the surface from both sides, at t and near both ends.
void expect_on_surface(const LimitSurface& surface, const CreaseCurve& curve) {
  const double size = surface.mesh().size(), length = curve.edge_count();
  std::vector<double> ts;
  for (int i = 0; i < curve.edge_count(); ++i) {
    for (double s : {0.0, 1e-3, 0.11, 0.25, 0.3, 0.5, 0.73, 0.9999}) ts.push_back(i + s);
  }
  for (double near : {1e-4, 1e-7, 1e-10, 1e-13, 1e-20, 0.0}) {
    ts.push_back(near);
    ts.push_back(length - near);
  }
  for (double t : ts) {
    const Vector3d point = curve.evaluate(t, 0).point;
    const CellPlace left = curve.left(t), right = curve.right(t);
    ASSERT_TRUE(left.cell >= 0 || right.cell >= 0);
    ASSERT_EQ(curve.kind() == CreaseKind::kBorder, left.cell < 0 || right.cell < 0);
    for (const CellPlace& place : {left, right}) {
      if (place.cell < 0) continue;
      const double error = (at_place(surface, place) - point).norm();
      const bool last_numbers = t < 1e-12 || t > length - 1e-12;
      ASSERT_LE(error, 1e-14 * size + (last_numbers ? curve.dart_error() : 0.0))
          << "t " << t << " of " << length;
    }
  }
}

TEST(CreaseCurves, AreTheSurfaceAlongCreases) {
  SCOPED_TRACE(::testing::Message() << "seed " << kCreaseCurvesSeed);
  std::mt19937 random(kCreaseCurvesSeed);
  const auto cache = std::make_shared<BasisCache>();
  int darts = 0, closed = 0, borders = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const mesh::ControlMesh mesh(testing::random_mesh(random, 24));
    const mesh::Topology& t = mesh.topology();
    const LimitSurface surface(mesh, trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    std::set<int> edges;
    int edge_count = 0;
    for (const CreaseCurve& curve : crease_curves(surface)) {
      expect_on_surface(surface, curve);
      if (HasFatalFailure()) FAIL() << "trial " << trial;
      edge_count += curve.edge_count();
      closed += curve.closed();
      borders += curve.kind() == CreaseKind::kBorder;
      const bool dart = t.kind(curve.vertices().front()) == mesh::VertexKind::kDart;
      darts += dart;
      EXPECT_TRUE(dart || t.kind(curve.vertices().back()) != mesh::VertexKind::kDart);
      EXPECT_EQ(dart, curve.dart_error() > 0.0);
      for (double s = 0.5; s < curve.edge_count(); ++s) {
        const CellPlace left = curve.left(s), right = curve.right(s);
        edges.insert(t.edge(left.cell >= 0 ? left.cell : right.cell));
      }
      if (t.kind(curve.vertices().back()) != mesh::VertexKind::kDart) {
        EXPECT_LE(curve.dart_error(), 1e-14 * mesh.size());
      }
    }
    int creases = 0;
    for (int h = 0; h < t.half_edge_count(); ++h) creases += t.is_crease(h) && t.is_edge_front(h);
    EXPECT_EQ(edge_count, creases);
    EXPECT_EQ(edges.size(), static_cast<std::size_t>(creases));
  }
  EXPECT_GT(darts, 100);
  EXPECT_GT(closed, 5);
  EXPECT_GT(borders, 100);
}

// Of a uniform B-spline the control points are the chain's, with one more beyond each corner.
TEST(CreaseCurves, OfABorderHaveItsControlPoints) {
  mesh::MeshArrays arrays = testing::grid(4, 3);
  std::mt19937 random(kCreaseCurvesSeed + 1);
  testing::randomise(arrays, random, 0.0, 0.0, 0.3);
  const LimitSurface surface{mesh::ControlMesh(arrays)};
  const std::vector<CreaseCurve> curves = crease_curves(surface);
  ASSERT_EQ(curves.size(), 4u);
  for (const CreaseCurve& curve : curves) {
    const std::vector<Vector3d>& points = curve.spline().points();
    const std::vector<double>& knots = curve.spline().knots();
    ASSERT_EQ(points.size(), curve.vertices().size() + 2);
    ASSERT_EQ(knots.size(), points.size() + 4);
    for (std::size_t i = 0; i < knots.size(); ++i) {
      EXPECT_EQ(knots[i], static_cast<double>(i) - 3.0);
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      EXPECT_EQ(points[i], arrays.points[curve.vertices()[i - 1]]);
    }
    EXPECT_EQ(points.front(), 2.0 * points[1] - points[2]);
    EXPECT_EQ(curve.spline().begin(), 0.0);
    EXPECT_EQ(curve.spline().end(), curve.edge_count());
    EXPECT_LT((curve.evaluate(0.0, 0).point - points[1]).norm(), 1e-15);
  }
}

TEST(CreaseCurves, CloseSmoothly) {
  mesh::MeshArrays arrays = testing::prism(6);
  for (int k = 0; k < 6; ++k) arrays.creases.push_back({k, (k + 1) % 6});
  const std::vector<CreaseCurve> curves = crease_curves(LimitSurface{mesh::ControlMesh(arrays)});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].closed());
  EXPECT_EQ(curves[0].vertices().size(), 6u);
  EXPECT_EQ(curves[0].spline().points().size(), 9u);
  const CurveJet begin = curves[0].evaluate(0.0, 2), end = curves[0].evaluate(6.0, 2);
  EXPECT_LT((begin.point - end.point).norm(), 1e-14);
  EXPECT_LT((begin.d1 - end.d1).norm(), 1e-14);
  EXPECT_LT((begin.d2 - end.d2).norm(), 1e-14);
}

TEST(CreaseCurves, HaveTheDerivativesOfDifferences) {
  std::mt19937 random(kCreaseCurvesSeed + 2);
  constexpr double kStep = 1e-5;
  for (int trial = 0; trial < 60; ++trial) {
    const LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 9))};
    for (const CreaseCurve& curve : crease_curves(surface)) {
      // Away from knots, where third derivatives jump.
      for (double t = 0.3; t < curve.edge_count(); ++t) {
        const CurveJet at = curve.evaluate(t, 2);
        const CurveJet after = curve.evaluate(t + kStep, 1), before = curve.evaluate(t - kStep, 1);
        ASSERT_LT(((after.point - before.point) / (2.0 * kStep) - at.d1).norm(), 1e-8);
        ASSERT_LT(((after.d1 - before.d1) / (2.0 * kStep) - at.d2).norm(), 1e-8);
      }
    }
  }
}

// Darts at both ends: of one edge, and of several.
TEST(CreaseCurves, RunBetweenTwoDarts) {
  for (int edges : {1, 2, 3, 6}) {
    for (Scheme scheme : {Scheme::kBiermann, Scheme::kCatmullClark}) {
      mesh::MeshArrays arrays = testing::grid(10, 4);
      std::mt19937 random(kCreaseCurvesSeed + 3);
      testing::randomise(arrays, random, 0.0, 0.0, 0.3);
      const int first = 2 * 11 + 2;
      for (int i = 0; i < edges; ++i) arrays.creases.push_back({first + i, first + i + 1});
      const LimitSurface surface(mesh::ControlMesh(arrays), scheme);
      for (const CreaseCurve& curve : crease_curves(surface)) {
        if (curve.kind() == CreaseKind::kBorder) continue;
        EXPECT_EQ(curve.edge_count(), edges);
        EXPECT_LT(curve.dart_error(), 1e-12);
        expect_on_surface(surface, curve);
        // The knots are simple between the ends, and their distances from the ends are halved.
        const std::vector<double>& knots = curve.spline().knots();
        EXPECT_EQ(curve.spline().points().size() + 4, knots.size());
        for (std::size_t i = 3; i + 4 < knots.size(); ++i) EXPECT_LT(knots[i], knots[i + 1]);
        EXPECT_EQ(knots[5], 2.0 * knots[4]);
      }
    }
  }
}

}  // namespace
}  // namespace hull::surface
