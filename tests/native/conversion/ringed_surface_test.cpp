// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/blocks/ringed_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "test_meshes.h"

namespace hull::conversion {
namespace {

// A pyramid without a base: one point with `valence` faces, tilted so that no corner is alike.
mesh::ControlMesh pyramid(int valence) {
  mesh::MeshArrays mesh;
  mesh.points.emplace_back(0.1, 0.2, 1.0);
  for (int i = 0; i < valence; ++i) {
    const double a = 2.0 * M_PI * i / valence;
    mesh.points.emplace_back(std::cos(a), std::sin(a), 0.1 * std::cos(3.0 * a));
  }
  for (int i = 0; i < valence; ++i) {
    testing::add_face(mesh, {0, 1 + i, 1 + (i + 1) % valence});
  }
  return mesh::ControlMesh(mesh);
}

TEST(RingedSurface, IsTheSurface) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int valence : {3, 5, 7, 16, 64}) {
    const surface::LimitSurface surface(pyramid(valence));
    const RingedSurface ringed(surface);
    for (int i = 0; i < 2000; ++i) {
      const int cell = static_cast<int>(share(random) * surface.cell_count());
      // Towards any of the four corners, crowding there.
      const double scale = std::exp2(-40.0 * share(random));
      double u = scale * share(random), v = scale * share(random);
      if (share(random) < 0.1) u = 0.0;
      if (share(random) < 0.5) u = 1.0 - u;
      if (share(random) < 0.5) v = 1.0 - v;
      const surface::SurfaceJet one = surface.evaluate(cell, u, v, 1);
      const surface::SurfaceJet two = ringed.evaluate(cell, u, v, 1);
      ASSERT_LE((one.point - two.point).norm(), 1e-14)
          << valence << ": " << cell << " " << u << " " << v;
      // Differences of points close together: rounding of the points over the size of the ring.
      const double ring = std::max(std::min(u, 1.0 - u), std::min(v, 1.0 - v));
      const double rounding = 1e-13 * (1.0 + 1.0 / std::max(ring, 1e-14));
      ASSERT_LE((one.du - two.du).norm(), rounding) << valence << ": " << u << " " << v;
      ASSERT_LE((one.dv - two.dv).norm(), rounding) << valence << ": " << u << " " << v;
    }
  }
}

}  // namespace
}  // namespace hull::conversion
