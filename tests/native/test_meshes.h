// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/control_mesh.h"

// Small meshes, each made for one feature.
namespace hull::testing {

inline void add_face(mesh::MeshArrays& mesh, const std::vector<int>& corners) {
  mesh.face_sizes.push_back(static_cast<int>(corners.size()));
  mesh.face_vertices.insert(mesh.face_vertices.end(), corners.begin(), corners.end());
}

// The cube [-1, 1]^3, faces turned outwards.
inline mesh::MeshArrays cube() {
  mesh::MeshArrays mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.emplace_back(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
  }
  for (const auto& face : std::initializer_list<std::vector<int>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    add_face(mesh, face);
  }
  return mesh;
}

// The box [0, length] x [-beam/2, beam/2] x [0, depth], all edges creases.
inline mesh::MeshArrays creased_box(double length, double beam, double depth) {
  mesh::MeshArrays mesh = cube();
  for (auto& p : mesh.points) {
    p = {0.5 * (p.x() + 1.0) * length, 0.5 * p.y() * beam, 0.5 * (p.z() + 1.0) * depth};
  }
  for (int a = 0; a < 8; ++a) {
    for (int bit : {1, 2, 4}) {
      if (!(a & bit)) mesh.creases.push_back({a, a | bit});
    }
  }
  return mesh;
}

// m x n quadrilaterals over [0, m] x [0, n] in the plane z = 0, normals up.
inline mesh::MeshArrays grid(int m, int n) {
  mesh::MeshArrays mesh;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= m; ++i) mesh.points.emplace_back(i, j, 0.0);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < m; ++i) {
      const int a = j * (m + 1) + i;
      add_face(mesh, {a, a + 1, a + m + 2, a + m + 1});
    }
  }
  return mesh;
}

// n quadrilaterals around point 0, then two more rings: an inner vertex of valence n.
inline mesh::MeshArrays fan(int n) {
  mesh::MeshArrays mesh;
  mesh.points.emplace_back(0.0, 0.0, 0.3);
  constexpr int kRings = 3;
  // Ring r holds 2 n points.
  for (int r = 1; r <= kRings; ++r) {
    for (int k = 0; k < 2 * n; ++k) {
      const double angle = std::numbers::pi * k / n;
      mesh.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.1 * r * (k % 3));
    }
  }
  const auto at = [n](int r, int k) { return 1 + (r - 1) * 2 * n + (k + 2 * n) % (2 * n); };
  for (int k = 0; k < n; ++k) add_face(mesh, {0, at(1, 2 * k), at(1, 2 * k + 1), at(1, 2 * k + 2)});
  for (int r = 1; r < kRings; ++r) {
    for (int k = 0; k < 2 * n; ++k) {
      add_face(mesh, {at(r, k), at(r + 1, k), at(r + 1, k + 1), at(r, k + 1)});
    }
  }
  return mesh;
}

// A prism with two n-gons, closed; or a double pyramid of 2 n triangles.
inline mesh::MeshArrays prism(int n) {
  mesh::MeshArrays mesh;
  for (int z : {-1, 1}) {
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / n;
      mesh.points.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), z);
    }
  }
  std::vector<int> bottom, top;
  for (int k = 0; k < n; ++k) {
    add_face(mesh, {k, (k + 1) % n, n + (k + 1) % n, n + k});
    bottom.push_back(n - 1 - k);
    top.push_back(n + k);
  }
  add_face(mesh, bottom);
  add_face(mesh, top);
  return mesh;
}

inline mesh::MeshArrays double_pyramid(int n) {
  mesh::MeshArrays mesh;
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / n;
    mesh.points.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
  }
  mesh.points.emplace_back(0.0, 0.0, -1.0);
  mesh.points.emplace_back(0.0, 0.0, 1.0);
  for (int k = 0; k < n; ++k) {
    add_face(mesh, {k, (k + 1) % n, n + 1});
    add_face(mesh, {(k + 1) % n, k, n});
  }
  return mesh;
}

// A bulging sheet of 2 n² triangles: six meet at every inner point.
inline mesh::MeshArrays sheet_of_triangles(int n) {
  mesh::MeshArrays mesh;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double x = 10.0 * i / n, y = 10.0 * j / n;
      mesh.points.emplace_back(x, y,
                               0.05 * x * x + 0.03 * x * y - 0.08 * y * y + std::sin(0.4 * x));
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      add_face(mesh, {a, b, b + 1});
      add_face(mesh, {a, b + 1, a + 1});
    }
  }
  return mesh;
}

// Draws tags: each edge a crease with probability `crease`, each point a corner with `corner`;
// moves every coordinate by up to `move`.
inline void randomise(mesh::MeshArrays& mesh, std::mt19937& random, double crease, double corner,
                      double move) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::size_t begin = 0;
  for (int size : mesh.face_sizes) {
    for (int i = 0; i < size; ++i) {
      const int a = mesh.face_vertices[begin + i], b = mesh.face_vertices[begin + (i + 1) % size];
      if (a < b && unit(random) < crease) mesh.creases.push_back({a, b});
    }
    begin += size;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (unit(random) < corner) mesh.corners.push_back(static_cast<int>(v));
  }
  for (auto& p : mesh.points) {
    for (double& x : p) x += move * (2.0 * unit(random) - 1.0);
  }
}

// A mesh of random kind, size, valence up to `max_valence`, tags and positions.
inline mesh::MeshArrays random_mesh(std::mt19937& random, int max_valence) {
  const auto draw = [&random](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const int kind = draw(0, 4);
  // High valences are costly: draw them seldom.
  const int n = draw(0, 9) == 0 ? draw(3, max_valence) : draw(3, std::min(8, max_valence));
  mesh::MeshArrays mesh = kind == 0   ? cube()
                          : kind == 1 ? grid(draw(1, 4), draw(1, 4))
                          : kind == 2 ? fan(n)
                          : kind == 3 ? prism(n)
                                      : double_pyramid(n);
  constexpr double kCreases[] = {0.0, 0.1, 0.3, 0.7};
  constexpr double kCorners[] = {0.0, 0.0, 0.1};
  randomise(mesh, random, kCreases[draw(0, 3)], kCorners[draw(0, 2)], 0.2);
  return mesh;
}

}  // namespace hull::testing
