// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "surface/eigenbasis/corner_key.h"
#include "surface/eigenbasis/dominant_spectrum.h"
#include "surface/eigenbasis/sparse_rows.h"
#include "surface/eigenbasis/tangent_rule.h"
#include "surface/pieces/bicubic.h"

namespace hull::surface {

struct LocalMatrices;

// A regular square of the ring that one subdivision adds around the corner.
struct RingSegment {
  double u, v, size;                               // [u, u + size] x [v, v + size] of the cell
  Eigen::Matrix<double, 16, Eigen::Dynamic> rows;  // its bicubic control points from the cell's
  Eigen::Matrix<double, 16, Eigen::Dynamic>
      dominant;  // rows * right: from the dominant coordinates
};

// The outermost rings are subdivided, not evaluated in the eigenbasis: it costs less, and no more
// than 1 in 4^kPlainRings of a cell's points lies within.
inline constexpr int kPlainRings = 4;

// Parameters both below this are the corner itself: the square of the ring's scale, and powers of
// the eigenvalues, leave the range of numbers further in, where no point differs from the limit.
inline constexpr double kAtCorner = 0x1p-500;

// What a surface keeps of one irregular cell.
struct CornerPoints {
  std::vector<Vector3d> outer;                                // N control points of [0, 1]² …
  std::array<std::vector<Vector3d>, kPlainRings - 1> middle;  // … of [0, 1/2]² and so on …
  std::vector<Vector3d> inner;                                // … and of [0, 2^-kPlainRings]²
  std::vector<BicubicPoints> segments;  // of ring 1, of ring 2, … of ring kPlainRings
  Vector3d limit;                       // the surface point at (0, 0)

  // Control points of [0, 2^-k]², k <= kPlainRings.
  const std::vector<Vector3d>& square(int k) const {
    return k == 0 ? outer : k == kPlainRings ? inner : middle[k - 1];
  }
};

// Coordinates of the innermost plain square in the eigenbasis.
struct EigenCoordinates {
  Eigen::Matrix<double, Eigen::Dynamic, 3> dominant;  // left^T (q - q_0): m x 3
  Eigen::Matrix<double, Eigen::Dynamic, 3> rest;      // q - q_0 - right dominant: N x 3
};

// Evaluation of cells with one irregular corner: Stam's eigenbasis (Stam 1998; Greshake 2021,
// 4.5), with the local subdivision matrix A built by running the rules on a model neighbourhood.
//
// A^(k-1) q is had in two parts. The slowly decaying part of q lies in the eigenspaces of the
// largest eigenvalues, where powers are those of numbers, or of a small block where A is defective
// or has complex eigenvalues. The rest, which decays like 1/8^k or little slower, is multiplied by
// A itself. No eigenvector of a small, possibly defective, eigenvalue is ever needed.
//
// Immutable: safe to share between threads and surfaces.
class CornerBasis {
 public:
  // `spectrum`: that of the ring's matrix, ring_spectrum(); it does not depend on key.cell.
  CornerBasis(const CornerKey& key, const LocalMatrices& local,
              std::shared_ptr<const DominantSpectrum> spectrum);

  // Number N of control points: those of ring_points() followed by outer_points().
  int point_count() const { return static_cast<int>(A_.rows()); }
  const Eigen::MatrixXd& matrix() const { return A_; }
  const DominantSpectrum& spectrum() const { return *spectrum_; }
  const std::vector<RingSegment>& segments() const { return segments_; }
  int segment_count() const { return static_cast<int>(segments_.size()); }
  const TangentRule& tangent_rule() const { return tangent_; }
  // One subdivision as a sparse matrix: rows for the points of the next square, next_square(), and
  // of the ring's segments; equal points share one.
  const SparseRows& refinement() const { return refine_; }
  const std::vector<int>& next_square() const { return next_square_; }
  const std::array<int, 16>& segment_rows(int segment) const { return segment_rows_[segment]; }

  // Computes the rest of `points` from its outer square.
  void prepare(CornerPoints& points) const;

  // Position and derivatives up to `order` at (u, v) in [0, 1]^2; higher ones are left as they are
  // in `jet`. At (0, 0), where derivatives do not exist in this parametrisation, they are zero, and
  // so they are within kAtCorner of it.
  void evaluate(const CornerPoints& points, double u, double v, int order, SurfaceJet& jet) const;

  // Direction (not of unit length) of the normal at (0, 0); zero where there is no tangent plane.
  // It costs two sums over the control points.
  Vector3d corner_normal(const CornerPoints& points) const;

  EigenCoordinates eigen_coordinates(const CornerPoints& points) const;

 private:
  friend class CornerRing;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  void extend_eigenvectors();
  void find_rest_powers();
  void place_segments();
  void evaluate_deep(const CornerPoints& points, int level, double u, double v, int order,
                     SurfaceJet& jet) const;
  void advance(EigenCoordinates& coordinates, int steps) const;

  Eigen::MatrixXd A_;
  Eigen::MatrixXd
      right_;  // dominant eigenvectors of A: those of the ring, extended to outer points
  std::shared_ptr<const DominantSpectrum> spectrum_;
  std::vector<RingSegment> segments_;
  SparseRows refine_;                              // A's rows, then all others that segments need
  std::vector<int> next_square_;                   // rows of refine_: the child's N points …
  std::vector<std::array<int, 16>> segment_rows_;  // … and the segments' points
  std::array<std::array<int, 4>, 4> segment_at_;   // by quarter of v, of u; -1 at the corner
  int rest_levels_;                                // beyond these the rest is below rounding
  std::vector<Eigen::MatrixXd> rest_powers_;       // advance the rest by 1, 2, 4, ... levels
  TangentRule tangent_;
  Eigen::Matrix<double, 2, Eigen::Dynamic> tangent_rows_;  // its two vectors from ring points
};

// The dominant spectrum of the ring's own part of a local matrix.
DominantSpectrum ring_spectrum(const CornerKey& key, const LocalMatrices& local);

// Walks through the rings of pieces around an irregular corner, from the largest inwards.
class CornerRing {
 public:
  // `basis` and `points` must outlive the walk.
  CornerRing(const CornerBasis& basis, const CornerPoints& points);

  // The N control points of the square [0, 2^-k]^2 after k steps; valid until the next one.
  const std::vector<Vector3d>& points() const;
  // The surface point at the corner.
  const Vector3d& limit() const { return points_.limit; }
  // Control points of segment `segment` (an index of CornerBasis::segments()) of the ring, which
  // covers the segment's square divided by 2^k.
  BicubicPoints segment_points(int segment) const;
  void advance();

 private:
  const CornerBasis& basis_;
  const CornerPoints& points_;
  int step_ = 0;
  EigenCoordinates deep_;  // from step kPlainRings on; dominant without its constant part
  mutable std::vector<Vector3d> deep_square_;  // points() there, once asked for
};

}  // namespace hull::surface
