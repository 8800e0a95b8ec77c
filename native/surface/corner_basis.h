// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "surface/bicubic.h"
#include "surface/slow_spectrum.h"

namespace hull {

// Topology of a cell's neighbourhood at its irregular corner (0, 0), the other corners regular.
struct CornerKey {
  Scheme scheme;
  VertexKind kind;  // of the corner
  bool closed;      // its fan; a dart's and a one-creased cone's are opened at the crease
  int faces;        // in the fan
  int cell;         // position of the cell in the fan
  auto operator<=>(const CornerKey&) const = default;
};

CornerKey corner_key(Scheme scheme, const CornerFan& fan);

// A regular square of the ring that one subdivision adds around the corner.
struct RingSegment {
  double u, v, size;                               // [u, u + size] x [v, v + size] of the cell
  Eigen::Matrix<double, 16, Eigen::Dynamic> rows;  // its bicubic control points from the cell's
  Eigen::Matrix<double, 16, Eigen::Dynamic> slow;  // rows * right: from the slow coordinates
};

// How the tangent plane at the corner follows from the slow coordinates: it is spanned by
// a^T x and b^T x, whose cross product, times sign, is the outward normal's direction.
struct TangentRule {
  bool defined = false;
  Eigen::VectorXd a, b;  // weights of the slow coordinates (m)
  double sign = 1.0;
};

// Control points of one irregular cell, split by CornerBasis::prepare.
struct CornerPoints {
  Vector3d origin;                                // subtracted from all, for accuracy
  Eigen::Matrix<double, Eigen::Dynamic, 3> slow;  // left^T q: m x 3
  Eigen::Matrix<double, Eigen::Dynamic, 3> rest;  // q - right slow: N x 3
  Vector3d limit;                                 // the surface point at (0, 0)
};

// Evaluation of cells with one irregular corner: Stam's eigenbasis (Stam 1998; Greshake 2021,
// 4.5), with the local subdivision matrix A built by running the rules on a model neighbourhood.
//
// A^(k-1) q is had in two parts. The slowly decaying part of q lies in the eigenspaces of the
// largest eigenvalues, where powers are those of numbers, or of a small Jordan-like block where A
// is defective. The rest, which decays like 1/8^k or little slower, is multiplied by A itself. No
// eigenvector of a small, possibly complex or defective, eigenvalue is ever needed.
//
// Immutable: safe to share between threads and surfaces.
class CornerBasis {
 public:
  explicit CornerBasis(const CornerKey& key);

  // Number N of control points: those of ring_points() followed by outer_points().
  int point_count() const { return static_cast<int>(A_.rows()); }
  const Eigen::MatrixXd& matrix() const { return A_; }
  const SlowSpectrum& spectrum() const { return spectrum_; }
  const std::vector<RingSegment>& segments() const { return segments_; }
  const TangentRule& tangent_rule() const { return tangent_; }

  CornerPoints prepare(const std::vector<Vector3d>& points) const;

  // Position and derivatives at (u, v) in [0, 1]^2. At (0, 0), where derivatives do not exist in
  // this parametrisation, they are zero.
  SurfaceJet evaluate(const CornerPoints& points, double u, double v, int order) const;

  // Direction (not of unit length) of the normal at (0, 0); zero where there is no tangent plane.
  Vector3d corner_normal(const CornerPoints& points) const;

 private:
  friend class CornerRing;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  void find_tangent_rule();
  Rows slow_at_level(const CornerPoints& points, int level) const;
  Rows rest_at_level(const CornerPoints& points, int level) const;

  Eigen::MatrixXd A_;
  Eigen::MatrixXd right_;  // slow eigenvectors of A: those of the ring, extended to outer points
  SlowSpectrum spectrum_;  // of the ring's own matrix
  std::vector<RingSegment> segments_;
  std::array<std::array<int, 4>, 4>
      segment_at_;   // by quarter of v, of u; -1 in the corner's square
  int rest_levels_;  // beyond these the rest is below rounding
  TangentRule tangent_;
};

// Walks through the rings of pieces around an irregular corner, from the largest inwards.
class CornerRing {
 public:
  // `basis` and `points` must outlive the walk.
  CornerRing(const CornerBasis& basis, const CornerPoints& points);

  // The N control points of the square [0, 2^-k]^2 after k steps.
  Eigen::Matrix<double, Eigen::Dynamic, 3> points() const;
  // Control points of segment `segment` (an index of CornerBasis::segments()) of the ring, which
  // covers the segment's square divided by 2^k.
  BicubicPoints segment_points(int segment) const;
  void advance();

 private:
  const CornerBasis& basis_;
  const CornerPoints& origin_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> slow_, rest_;  // slow_ without the constant part
};

}  // namespace hull
