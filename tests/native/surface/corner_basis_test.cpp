// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/eigenbasis/corner_basis.h"

#include <gtest/gtest.h>

#include <random>

#include "surface/eigenbasis/basis_cache.h"
#include "surface/eigenbasis/local_matrix.h"
#include "trials.h"

namespace hull::surface {
namespace {

std::vector<CornerKey> keys(int max_faces) {
  std::vector<CornerKey> result;
  for (Scheme scheme : {Scheme::kBiermann, Scheme::kCatmullClark}) {
    for (int n = 1; n <= max_faces; n += n < 9 ? 1 : 7) {
      for (int cell = 0; cell < n; cell += n < 9 ? 1 : 5) {
        result.push_back({scheme, mesh::VertexKind::kCrease, false, n, cell});
        result.push_back({scheme, mesh::VertexKind::kCorner, false, n, cell});
        if (n < 3) continue;
        result.push_back({scheme, mesh::VertexKind::kDart, false, n, cell});
        result.push_back({scheme, mesh::VertexKind::kCone, false, n, cell});
        if (cell > 0) continue;
        result.push_back({scheme, mesh::VertexKind::kSmooth, true, n, 0});
        result.push_back({scheme, mesh::VertexKind::kCone, true, n, 0});
      }
    }
  }
  return result;
}

std::string name(const CornerKey& key) {
  return "scheme " + std::to_string(static_cast<int>(key.scheme)) + " kind " +
         std::to_string(static_cast<int>(key.kind)) + " faces " + std::to_string(key.faces) +
         " cell " + std::to_string(key.cell);
}

// The eigenbasis with its blocks against plain powers of the local matrix, which for such matrices
// (rows of non-negative weights that sum to one) lose no accuracy.
TEST(CornerBasis, AgreesWithPowersOfTheLocalMatrix) {
  constexpr unsigned kSeed = 51;
  SCOPED_TRACE(::testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double size = 2.0 * std::sqrt(3.0);  // of the box the points are drawn from
  BasisCache cache;
  for (const CornerKey& key : keys(testing::trials(64))) {
    SCOPED_TRACE(name(key));
    const auto shared = cache.get(key);
    const CornerBasis& basis = *shared;
    const int n = basis.point_count();
    std::vector<Vector3d> points(n);
    Eigen::Matrix<double, Eigen::Dynamic, 3> plain(n, 3);
    for (int i = 0; i < n; ++i) {
      points[i] = {unit(random), unit(random), unit(random)};
      plain.row(i) = points[i].transpose();
    }
    CornerPoints prepared;
    prepared.outer = points;
    basis.prepare(prepared);
    // From the square the eigenbasis takes over in, so that it is this that is compared.
    for (int i = 0; i < n; ++i) plain.row(i) = prepared.inner[i].transpose();
    CornerRing ring(basis, prepared);
    for (int level = 0; level < kPlainRings; ++level) ring.advance();
    for (int level = kPlainRings; level < 24; ++level) {
      const std::vector<Vector3d> square = ring.points();
      for (int i = 0; i < n; ++i) {
        ASSERT_LT((square[i] - plain.row(i).transpose()).norm(), 1e-13 * size) << "level " << level;
      }
      plain = (basis.matrix() * plain).eval();
      ring.advance();
    }
  }
}

// Rows sum to one, and a matrix of weights maps affinely: a constant neighbourhood stays so.
TEST(CornerBasis, LocalMatricesAreAffine) {
  for (const CornerKey& key : keys(9)) {
    SCOPED_TRACE(name(key));
    const LocalMatrices local = local_matrices(key);
    const Eigen::Index n = local.A.rows();
    EXPECT_LT((local.A.rowwise().sum() - Eigen::VectorXd::Ones(n)).cwiseAbs().maxCoeff(), 1e-15);
    for (const RingSegment& segment : local.segments) {
      EXPECT_LT((segment.rows.rowwise().sum() - Eigen::VectorXd::Ones(16)).cwiseAbs().maxCoeff(),
                2e-15);
    }
  }
}

// Trap 1 of docs/surface.md: under Biermann's rules the crease sectors of odd valence are defective
// at 1/4.
TEST(CornerBasis, FindsTheDefectiveSectors) {
  for (int n = 1; n <= 9; ++n) {
    const auto shared =
        BasisCache().get({Scheme::kBiermann, mesh::VertexKind::kCrease, false, n, 0});
    const CornerBasis& basis = *shared;
    bool defective = false;
    for (const DominantBlock& block : basis.spectrum().blocks) {
      if (!block.coupled) continue;
      defective = true;
      EXPECT_NEAR(block.eigenvalue, 0.25, 1e-12);
    }
    // Where 1/4 is left to the rest, the block is not looked for.
    if (basis.spectrum().rest < 0.2499) {
      EXPECT_EQ(defective, n % 2 == 1) << "sector of " << n;
    }
  }
}

TEST(CornerBasis, SubdominantEigenvalueOfInteriorVertices) {
  for (int n : {3, 5, 6, 12, 50}) {
    const auto shared =
        BasisCache().get({Scheme::kBiermann, mesh::VertexKind::kSmooth, true, n, 0});
    const CornerBasis& basis = *shared;
    // Stam 1998: of the eigenvalues of the interior matrix for frequency 1.
    const double c = std::cos(2.0 * M_PI / n);
    const double expected = (c + 5.0 + std::sqrt((c + 9.0) * (c + 1.0))) / 16.0;
    EXPECT_EQ(basis.spectrum().blocks[1].size, 2);
    EXPECT_NEAR(basis.spectrum().blocks[1].eigenvalue, expected, 1e-13);
  }
}

}  // namespace
}  // namespace hull::surface
