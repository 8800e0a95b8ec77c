// SPDX-License-Identifier: GPL-3.0-or-later
// First and second derivatives: against the tensor-product formula where the mesh is regular, and
// against differences close to irregular knots of every kind.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "surface/limit_surface.h"
#include "surface/sampling/grid_samples.h"
#include "test_meshes.h"

namespace hull::surface {
namespace {

// Cox–de Boor on the knots …, -1, 0, 1, …; the derivative is the difference of two functions of one
// degree less (de Boor 1978, X).
double b_spline(int i, int degree, int derivative, double t) {
  if (derivative > 0) {
    return b_spline(i, degree - 1, derivative - 1, t) -
           b_spline(i + 1, degree - 1, derivative - 1, t);
  }
  if (degree == 0) return t >= i && t < i + 1 ? 1.0 : 0.0;
  return (t - i) / degree * b_spline(i, degree - 1, 0, t) +
         (i + degree + 1 - t) / degree * b_spline(i + 1, degree - 1, 0, t);
}

constexpr int kM = 6, kN = 5;

// Control point (i, j) of a grid(kM, kN), reflected beyond the borders.
Vector3d grid_point(const mesh::MeshArrays& mesh, int i, int j) {
  if (i < 0) return 2.0 * grid_point(mesh, 0, j) - grid_point(mesh, -i, j);
  if (i > kM) return 2.0 * grid_point(mesh, kM, j) - grid_point(mesh, 2 * kM - i, j);
  if (j < 0) return 2.0 * grid_point(mesh, i, 0) - grid_point(mesh, i, -j);
  if (j > kN) return 2.0 * grid_point(mesh, i, kN) - grid_point(mesh, i, 2 * kN - j);
  return mesh.points[j * (kM + 1) + i];
}

Vector3d tensor_product(const mesh::MeshArrays& mesh, double x, double y, int dx, int dy) {
  Vector3d sum = Vector3d::Zero();
  for (int j = -1; j <= kN + 1; ++j) {
    for (int i = -1; i <= kM + 1; ++i) {
      sum += grid_point(mesh, i, j) * b_spline(i - 2, 3, dx, x) * b_spline(j - 2, 3, dy, y);
    }
  }
  return sum;
}

void expect_tensor_product(const mesh::MeshArrays& mesh, int face, double u, double v,
                           const SurfaceJet& jet) {
  // Corner 0 of a face is its lower left one; a cell is half as long as its face.
  const double x = face % kM + 0.5 * u, y = face / kM + 0.5 * v;
  const double tolerance = 1e-12;  // the mesh's size is about 8
  const auto off = [&](const Vector3d& value, int dx, int dy) {
    return (value - std::pow(0.5, dx + dy) * tensor_product(mesh, x, y, dx, dy)).norm();
  };
  ASSERT_LT(off(jet.point, 0, 0), 1e-14);
  ASSERT_LT(off(jet.du, 1, 0), tolerance);
  ASSERT_LT(off(jet.dv, 0, 1), tolerance);
  ASSERT_LT(off(jet.duu, 2, 0), tolerance);
  ASSERT_LT(off(jet.duv, 1, 1), tolerance);
  ASSERT_LT(off(jet.dvv, 0, 2), tolerance);
}

TEST(Derivatives, OfRegularMeshesAreThoseOfATensorProduct) {
  constexpr unsigned kSeed = 90;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (Scheme scheme : {Scheme::kBiermann, Scheme::kCatmullClark}) {
    mesh::MeshArrays mesh = testing::grid(kM, kN);
    testing::randomise(mesh, random, 0.0, 0.0, 0.4);
    const LimitSurface surface(mesh::ControlMesh(mesh), scheme);
    for (int trial = 0; trial < 300; ++trial) {
      const int face = static_cast<int>(unit(random) * kM * kN);
      const double u = unit(random), v = unit(random);
      expect_tensor_product(mesh, face, u, v, surface.evaluate(4 * face, u, v, 2));
    }
    constexpr int kGrid = 5;
    const GridSamples samples = evaluate_grid(surface, kGrid, 2);
    for (int face = 0; face < kM * kN; ++face) {
      for (int i = 0; i <= kGrid; ++i) {
        for (int j = 0; j <= kGrid; ++j) {
          const std::size_t k = samples.index(4 * face, i, j);
          expect_tensor_product(mesh, face, i / (1.0 * kGrid), j / (1.0 * kGrid),
                                {samples.points[k], samples.du[k], samples.dv[k], samples.duu[k],
                                 samples.duv[k], samples.dvv[k]});
        }
      }
    }
  }
}

// Central differences at a place `away` from a corner of the cell, with steps in proportion.
void expect_differences(const LimitSurface& surface, int cell, int corner, double away) {
  const double cu = corner == 1 || corner == 2, cv = corner >= 2;
  const auto inwards = [](double from, double by) { return from > 0.5 ? 1.0 - by : by; };
  // Within a piece: these lie between the knot lines at 1/4, 1/2 and 3/4 of `away`.
  const double u = inwards(cu, 0.64 * away), v = inwards(cv, 0.37 * away), h = 1e-4 * away;
  const SurfaceJet at = surface.evaluate(cell, u, v, 2);
  const SurfaceJet right = surface.evaluate(cell, u + h, v, 1);
  const SurfaceJet left = surface.evaluate(cell, u - h, v, 1);
  const SurfaceJet above = surface.evaluate(cell, u, v + h, 1);
  const SurfaceJet below = surface.evaluate(cell, u, v - h, 1);
  // What first derivatives are like here. Truncation is (h / away)² of the third ones, which are
  // like this by away²; rounding 1e-16 of the size, and of first derivatives, by h.
  const double first = (at.point - surface.position(cell, cu, cv)).norm() / away + at.du.norm() +
                       at.dv.norm() + away * (at.duu.norm() + at.duv.norm() + at.dvv.norm());
  const double size = surface.mesh().size();
  const double allowed_first = 1e-6 * first + 1e-15 * size / h,
               allowed_second = 1e-6 * first / away;
  const auto off = [h](const Vector3d& high, const Vector3d& low, const Vector3d& value) {
    return ((high - low) / (2.0 * h) - value).norm();
  };
  ASSERT_LT(off(right.point, left.point, at.du), allowed_first);
  ASSERT_LT(off(above.point, below.point, at.dv), allowed_first);
  ASSERT_LT(off(right.du, left.du, at.duu), allowed_second);
  ASSERT_LT(off(above.du, below.du, at.duv), allowed_second);
  ASSERT_LT(off(right.dv, left.dv, at.duv), allowed_second);
  ASSERT_LT(off(above.dv, below.dv, at.dvv), allowed_second);
}

TEST(Derivatives, NearIrregularKnotsAgreeWithDifferences) {
  constexpr unsigned kSeed = 91;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  const auto cache = std::make_shared<BasisCache>();
  std::map<std::pair<Scheme, mesh::VertexKind>, int> seen;
  for (int trial = 0; trial < 120; ++trial) {
    const Scheme scheme = trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark;
    const LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 20)), scheme, cache);
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      constexpr double kCorners[4][2] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
      for (int corner = 0; corner < 4; ++corner) {
        if (!surface.is_irregular_knot(cell, kCorners[corner][0], kCorners[corner][1])) continue;
        ++seen[{scheme, surface.cells().kind_at(4 * cell + corner)}];
        for (int level : {1, 3, 6, 9, 14}) {
          SCOPED_TRACE(::testing::Message() << "trial " << trial << " cell " << cell << " corner "
                                            << corner << " level " << level);
          expect_differences(surface, cell, corner, std::ldexp(1.0, -level));
          if (::testing::Test::HasFatalFailure()) return;
        }
      }
    }
  }
  for (Scheme scheme : {Scheme::kBiermann, Scheme::kCatmullClark}) {
    for (mesh::VertexKind kind :
         {mesh::VertexKind::kSmooth, mesh::VertexKind::kDart, mesh::VertexKind::kCrease,
          mesh::VertexKind::kCorner, mesh::VertexKind::kCone}) {
      EXPECT_GE((seen[{scheme, kind}]), 20) << static_cast<int>(kind);
    }
  }
}

}  // namespace
}  // namespace hull::surface
