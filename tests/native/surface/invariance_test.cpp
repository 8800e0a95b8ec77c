// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change the surface: numbers of points and faces, where a face begins, the side it
// is seen from, the unit of length, the number of threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "surface/parallel_for.h"
#include "surface/sampling/grid_samples.h"
#include "test_meshes.h"

namespace hull::surface {
namespace {

constexpr unsigned kInvarianceSeed = 4711;

std::vector<int> shuffled(int count, std::mt19937& random) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  return order;
}

// A mesh whose cell c is cell cell_of[c] of another.
struct Renumbered {
  mesh::MeshArrays mesh;
  std::vector<int> cell_of;
};

Renumbered renumbered(const mesh::MeshArrays& from, std::mt19937& random) {
  Renumbered result;
  const int vertices = static_cast<int>(from.points.size());
  const int faces = static_cast<int>(from.face_sizes.size());
  const std::vector<int> vertex = shuffled(vertices, random);  // old to new
  result.mesh.points.resize(vertices);
  for (int v = 0; v < vertices; ++v) result.mesh.points[vertex[v]] = from.points[v];
  std::vector<int> begin{0};
  for (int size : from.face_sizes) begin.push_back(begin.back() + size);
  for (int f : shuffled(faces, random)) {
    const int size = from.face_sizes[f];
    const int first = std::uniform_int_distribution<int>(0, size - 1)(random);
    result.mesh.face_sizes.push_back(size);
    for (int j = 0; j < size; ++j) {
      const int old = begin[f] + (j + first) % size;
      result.mesh.face_vertices.push_back(vertex[from.face_vertices[old]]);
      result.cell_of.push_back(old);
    }
  }
  for (const auto& [a, b] : from.creases) result.mesh.creases.push_back({vertex[b], vertex[a]});
  std::shuffle(result.mesh.creases.begin(), result.mesh.creases.end(), random);
  for (int v : from.corners) result.mesh.corners.push_back(vertex[v]);
  return result;
}

TEST(Invariance, Renumbering) {
  SCOPED_TRACE(::testing::Message() << "seed " << kInvarianceSeed);
  std::mt19937 random(kInvarianceSeed);
  const auto cache = std::make_shared<BasisCache>();
  constexpr double kPlaces[][2] = {{0.0, 0.0}, {1e-9, 3e-10}, {0.01, 0.2}, {0.7, 0.4}, {1.0, 0.9}};
  for (int trial = 0; trial < 400; ++trial) {
    const mesh::MeshArrays arrays = testing::random_mesh(random, 64);
    const Renumbered other = renumbered(arrays, random);
    const Scheme scheme = trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark;
    const LimitSurface a(mesh::ControlMesh(arrays), scheme, cache);
    const LimitSurface b(mesh::ControlMesh(other.mesh), scheme, cache);
    const double size = a.mesh().size();
    for (int cell = 0; cell < b.cell_count(); ++cell) {
      for (const auto& [u, v] : kPlaces) {
        const int same = other.cell_of[cell];
        ASSERT_LT((a.position(same, u, v) - b.position(cell, u, v)).norm(), 1e-14 * size)
            << "trial " << trial << " cell " << cell << " at " << u << ", " << v;
      }
      const SurfaceJet p = a.evaluate(other.cell_of[cell], 0.3, 0.2, 2);
      const SurfaceJet q = b.evaluate(cell, 0.3, 0.2, 2);
      ASSERT_LT((p.du - q.du).norm(), 1e-13 * size);
      ASSERT_LT((p.dvv - q.dvv).norm(), 1e-12 * size);
    }
  }
}

// Seen in a mirror and turned round, so that faces run counter-clockwise again: u and v change
// places, the normal's side does not.
TEST(Invariance, Mirror) {
  std::mt19937 random(kInvarianceSeed + 1);
  const auto cache = std::make_shared<BasisCache>();
  const Vector3d flip(1.0, -1.0, 1.0);
  for (int trial = 0; trial < 100; ++trial) {
    const mesh::MeshArrays arrays = testing::random_mesh(random, 16);
    mesh::MeshArrays mirrored = arrays;
    for (auto& p : mirrored.points) p = p.cwiseProduct(flip);
    auto begin = mirrored.face_vertices.begin();
    for (int size : arrays.face_sizes) {
      std::reverse(begin + 1, begin + size);  // the first corner stays
      begin += size;
    }
    const Scheme scheme = trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark;
    const LimitSurface a(mesh::ControlMesh(arrays), scheme, cache);
    const LimitSurface b(mesh::ControlMesh(mirrored), scheme, cache);
    int first = 0;
    for (int size : arrays.face_sizes) {
      for (int j = 0; j < size; ++j) {
        const int cell = first + j, image = first + (size - j) % size;
        const Vector3d p = a.position(cell, 0.13, 0.4).cwiseProduct(flip);
        ASSERT_LT((p - b.position(image, 0.4, 0.13)).norm(), 1e-14 * a.mesh().size());
        const Vector3d normal = a.normal(cell, 0.13, 0.4).cwiseProduct(flip);
        ASSERT_LT((normal - b.normal(image, 0.4, 0.13)).norm(), 1e-9);
      }
      first += size;
    }
  }
}

TEST(Invariance, Scale) {
  std::mt19937 random(kInvarianceSeed + 2);
  for (double factor : {0x1p-30, 0x1p20, 3.7e-4}) {
    const mesh::MeshArrays arrays = testing::random_mesh(random, 12);
    mesh::MeshArrays scaled = arrays;
    for (auto& p : scaled.points) p *= factor;
    const LimitSurface a{mesh::ControlMesh(arrays)}, b{mesh::ControlMesh(scaled)};
    for (int cell = 0; cell < a.cell_count(); ++cell) {
      const Vector3d expected = a.position(cell, 0.01, 0.3) * factor;
      ASSERT_LT((b.position(cell, 0.01, 0.3) - expected).norm(), 1e-14 * b.mesh().size());
    }
  }
}

TEST(Invariance, NumberOfThreads) {
  std::mt19937 random(kInvarianceSeed + 3);
  mesh::MeshArrays arrays = testing::fan(7);
  testing::randomise(arrays, random, 0.2, 0.1, 0.1);
  const LimitSurface surface{mesh::ControlMesh(arrays)};
  constexpr int kN = 24;
  const GridSamples one = evaluate_grid(surface, kN, 2);
  for (int threads : {2, 5}) {
    GridSamples many;
    evaluate_grid(surface, kN, 2, many, threads);
    EXPECT_EQ(one.points, many.points);
    EXPECT_EQ(one.dv, many.dv);
    EXPECT_EQ(one.duv, many.duv);
  }
}

// Surfaces built at the same time with the same bases are those built one after the other.
TEST(Invariance, ThreadsSharingBases) {
  std::mt19937 random(kInvarianceSeed + 5);
  std::vector<mesh::ControlMesh> meshes;
  for (int i = 0; i < 24; ++i) meshes.emplace_back(testing::random_mesh(random, 12));
  const auto build = [&meshes](int threads) {
    const auto cache = std::make_shared<BasisCache>();
    std::vector<Vector3d> points(meshes.size());
    parallel_for(
        meshes.size(), threads,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            const LimitSurface surface(meshes[i], Scheme::kBiermann, cache);
            points[i] = surface.position(surface.cell_count() - 1, 0.01, 0.02);
          }
        },
        /*grain=*/1);
    return points;
  };
  const std::vector<Vector3d> one_after_the_other = build(1);
  for (int trial = 0; trial < 5; ++trial) EXPECT_EQ(build(4), one_after_the_other);
}

// Shared sides at the greatest valence that meshes may have.
TEST(Invariance, GreatestValence) {
  std::mt19937 random(kInvarianceSeed + 4);
  const auto cache = std::make_shared<BasisCache>();
  for (mesh::MeshArrays arrays :
       {testing::double_pyramid(mesh::kMaxValence), testing::prism(mesh::kMaxValence)}) {
    testing::randomise(arrays, random, 0.0, 0.0, 0.2);
    const LimitSurface surface(mesh::ControlMesh(arrays), Scheme::kBiermann, cache);
    const mesh::Topology& cells = surface.cells();
    for (int h = 0; h < cells.half_edge_count(); ++h) {
      if ((h & 3) != 0) continue;  // side v = 0, which is side u = 0 of the neighbour's cell
      const int g = cells.twin(h);
      for (double t : {0.0, 1e-12, 0.1, 0.6}) {
        const Vector3d p = surface.position(h / 4, t, 0.0);
        const Vector3d q = (g & 3) == 3 ? surface.position(g / 4, 0.0, t) : p;
        ASSERT_LT((p - q).norm(), 1e-13 * surface.mesh().size());
      }
    }
  }
}

}  // namespace
}  // namespace hull::surface
