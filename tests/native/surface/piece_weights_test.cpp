// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/piece_weights.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "test_meshes.h"

namespace hull::surface {
namespace {

constexpr unsigned kPieceWeightsSeed = 22112026;

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Vector3d sum(const Eigen::VectorXd& weights, const std::vector<int>& points,
             const LimitSurface& surface) {
  Vector3d total = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    total += weights[static_cast<Eigen::Index>(i)] * surface.mesh().points()[points[i]];
  }
  return total;
}

// On random meshes of every kind, places on creases, borders and between rings among them: the
// weights give the surface's own position wherever a piece is found, and that is everywhere but
// near irregular knots.
TEST(PieceWeights, GiveTheSurface) {
  SCOPED_TRACE(::testing::Message() << "seed " << kPieceWeightsSeed);
  std::mt19937 random(kPieceWeightsSeed);
  const auto cache = std::make_shared<BasisCache>();
  int found = 0, asked = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 12)),
                               trial % 2 ? Scheme::kBiermann : Scheme::kCatmullClark, cache);
    const PieceWeights pieces(surface);
    const double snap[] = {0.0, 0.25, 0.5, 1.0};
    for (int query = 0; query < 40; ++query, ++asked) {
      const int cell = static_cast<int>(uniform(random, 0.0, surface.cell_count() - 1e-9));
      const auto parameter = [&] {
        return query % 3 ? uniform(random, 0.0, 1.0) : snap[random() % 4];
      };
      const double u = parameter(), v = parameter();
      const auto place = pieces.find(cell, u, v);
      if (!place) continue;
      ++found;
      const PieceWeights::Piece& piece = pieces.piece(place->piece);
      ASSERT_EQ(piece.cell, cell);
      const Vector3d at = sum(pieces.weights(*place), piece.points, surface);
      ASSERT_LT((at - surface.position(cell, u, v)).norm(), 1e-13 * surface.mesh().size())
          << "trial " << trial << ", cell " << cell << ", " << u << ", " << v;
    }
  }
  EXPECT_GT(found, 0.9 * asked);
}

// The derivatives are to the piece's own sides, which may be turned: what is the same for both is
// compared, the lengths and area of the first, and those of the second of a piece not turned.
TEST(PieceWeights, GiveTheDerivatives) {
  SCOPED_TRACE(::testing::Message() << "seed " << kPieceWeightsSeed);
  std::mt19937 random(kPieceWeightsSeed);
  for (int trial = 0; trial < 30; ++trial) {
    const LimitSurface surface(mesh::ControlMesh(testing::random_mesh(random, 12)));
    const PieceWeights pieces(surface);
    const double size = surface.mesh().size();
    for (int query = 0; query < 40; ++query) {
      const int cell = static_cast<int>(uniform(random, 0.0, surface.cell_count() - 1e-9));
      const double u = uniform(random, 0.0, 1.0), v = uniform(random, 0.0, 1.0);
      const auto place = pieces.find(cell, u, v);
      if (!place) continue;
      const PieceWeights::Piece& piece = pieces.piece(place->piece);
      const PieceWeights::Jet jet = pieces.jet(*place);
      SurfaceJet wanted = surface.evaluate(cell, u, v, 2);
      scale_derivatives(wanted, piece.size, 2);
      const auto in_mesh = [&](const Eigen::VectorXd& weights) {
        return sum(weights, piece.points, surface);
      };
      const Vector3d ds = in_mesh(jet.ds), dt = in_mesh(jet.dt);
      EXPECT_LT((ds.cross(dt) - wanted.du.cross(wanted.dv)).norm(), 1e-11 * size * size);
      // The Laplacian is the same from all sides; the sign of the mixed one turns with them.
      EXPECT_LT((in_mesh(jet.dss) + in_mesh(jet.dtt) - wanted.duu - wanted.dvv).norm(),
                1e-11 * size);
      const Vector3d mixed = in_mesh(jet.dst);
      EXPECT_LT(std::min((mixed - wanted.duv).norm(), (mixed + wanted.duv).norm()), 1e-11 * size);
    }
  }
}

}  // namespace
}  // namespace hull::surface
