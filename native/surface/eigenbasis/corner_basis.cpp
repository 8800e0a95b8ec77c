// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/eigenbasis/corner_basis.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "surface/eigenbasis/local_matrix.h"

namespace hull::surface {
namespace {

using Weights16 = Eigen::Matrix<double, 16, 1>;

// Weights of the 16 control points in a derivative of a bicubic span.
Weights16 tensor_weights(const Basis& u, const Basis& v) {
  Weights16 weights;
  for (int b = 0; b < 4; ++b) {
    for (int a = 0; a < 4; ++a) weights[4 * b + a] = u[a] * v[b];
  }
  return weights;
}

// The eigenvalues of the part of A that belongs to the outer points alone are 1/8, 1/16, 1/32 and
// 1/64 (they subdivide like cubic B-splines); the dominant ones keep clear of them.
constexpr double kDominantFloor = 0.14;

struct RingPlace {
  int level;
  double u, v;   // in the unit square of the level's cell
  double scale;  // d(u, v) of the level per d(u, v) of the cell: 2^(level - 1)
};

RingPlace place_in_ring(double u, double v) {
  // The ring of (u, v), Greshake 4.12 as mended in docs/surface.md: frexp() tells the power of two
  // above max(u, v), and 1 itself is of the first ring.
  int exponent = 0;
  std::frexp(std::max(u, v), &exponent);
  const int level = std::max(1, 1 - exponent);
  const double scale = std::ldexp(1.0, level - 1);
  return {level, u * scale, v * scale, scale};
}

}  // namespace

DominantSpectrum ring_spectrum(const CornerKey& key, const LocalMatrices& local) {
  const int ring = local.ring_size;
  DominantSpectrum spectrum = dominant_spectrum(local.A.topLeftCorner(ring, ring), kDominantFloor);
  if (key.kind == mesh::VertexKind::kCorner || key.kind == mesh::VertexKind::kCone) {
    // The limit of an interpolated point is the point itself, without a rounding error.
    spectrum.left.col(0) = Eigen::VectorXd::Unit(ring, 0);
  }
  return spectrum;
}

CornerBasis::CornerBasis(const CornerKey& key, const LocalMatrices& local,
                         std::shared_ptr<const DominantSpectrum> spectrum)
    : A_(local.A), spectrum_(std::move(spectrum)), segments_(local.segments) {
  extend_eigenvectors();
  place_segments();
  // In second derivatives the rest grows by 4 a level, the leading terms by at least 4 · 1/4.
  // Outer points fall by 1/8 a level, however fast the ring's own rest does.
  const double decay = std::max(spectrum_->rest, 0.126);
  rest_levels_ = static_cast<int>(std::ceil(std::log(1e-18) / std::log(decay))) + 40;
  find_rest_powers();
  if (key.kind != mesh::VertexKind::kCone) tangent_ = surface::tangent_rule(*spectrum_);
  if (tangent_.defined) {
    tangent_rows_.resize(2, spectrum_->left.rows());
    tangent_rows_.row(0) = tangent_.a.transpose() * spectrum_->left.transpose();
    tangent_rows_.row(1) = tangent_.b.transpose() * spectrum_->left.transpose();
  }
}

// A = [S 0; C D]. The eigenspaces of S extend to A by D X - X L = -C R, block by block.
void CornerBasis::extend_eigenvectors() {
  const Eigen::MatrixXd& ring_right = spectrum_->right;
  const Eigen::Index ring = ring_right.rows(), outer = A_.rows() - ring;
  right_.resize(A_.rows(), ring_right.cols());
  right_.topRows(ring) = ring_right;
  const Eigen::MatrixXd C = A_.bottomLeftCorner(outer, ring);
  const Eigen::MatrixXd D = A_.bottomRightCorner(outer, outer);
  for (const DominantBlock& block : spectrum_->blocks) {
    const int size = block.size;
    // (I ⊗ D - L^T ⊗ I) vec X = -vec C R, a small dense system.
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(outer * size, outer * size);
    Eigen::VectorXd wanted(outer * size);
    for (int j = 0; j < size; ++j) {
      system.block(outer * j, outer * j, outer, outer) += D;
      for (int i = 0; i < size; ++i) {
        const double l = block.coupled ? block.action(i, j) : (i == j ? block.eigenvalue : 0.0);
        system.block(outer * j, outer * i, outer, outer).diagonal().array() -= l;
      }
      wanted.segment(outer * j, outer) = -C * ring_right.col(block.begin + j);
    }
    // Regular, as D's eigenvalues are 1/8 at most, and L's above kDominantFloor.
    const Eigen::VectorXd solution = system.partialPivLu().solve(wanted);
    for (int j = 0; j < size; ++j) {
      right_.block(ring, block.begin + j, outer, 1) = solution.segment(outer * j, outer);
    }
  }
  // Affine invariance gives the first eigenvector exactly; the solve only nearly.
  right_.col(0).setOnes();
}

// What A does to the rest only: its powers shrink as the rest does and so keep the last digits of
// derivatives, which powers of A would drown.
void CornerBasis::find_rest_powers() {
  Eigen::MatrixXd power = A_;
  // A (I - right left^T), where left has no part in the outer points.
  power.leftCols(spectrum_->left.rows()) -= A_ * right_ * spectrum_->left.transpose();
  for (int steps = 1; steps <= rest_levels_; steps *= 2) {
    rest_powers_.push_back(power);
    power = power * power;
  }
}

void CornerBasis::place_segments() {
  for (Eigen::Index i = 0; i < A_.rows(); ++i) next_square_.push_back(refine_.add(A_.row(i)));
  for (auto& quarter_row : segment_at_) quarter_row.fill(-1);
  for (int s = 0; s < segment_count(); ++s) {
    RingSegment& segment = segments_[s];
    segment.dominant = segment.rows * right_;
    std::array<int, 16>& rows = segment_rows_.emplace_back();
    for (int i = 0; i < 16; ++i) rows[i] = refine_.add(segment.rows.row(i));
    // In quarters of the cell: segments beside a modified edge are as small.
    const int i0 = static_cast<int>(4 * segment.u), j0 = static_cast<int>(4 * segment.v);
    const int span = static_cast<int>(4 * segment.size);
    for (int j = j0; j < j0 + span; ++j) {
      for (int i = i0; i < i0 + span; ++i) segment_at_[j][i] = s;
    }
  }
}

void CornerBasis::prepare(CornerPoints& points) const {
  assert(static_cast<int>(points.outer.size()) == point_count());
  points.segments.resize(static_cast<std::size_t>(kPlainRings) * segments_.size());
  std::vector<Vector3d> refined(refine_.count());
  for (int level = 0; level < kPlainRings; ++level) {
    // One product gives the next square and the segments of the ring around it.
    refine_.multiply(points.square(level).data(), refined.data());
    std::vector<Vector3d>& next = level + 1 == kPlainRings ? points.inner : points.middle[level];
    next.resize(points.outer.size());
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = refined[next_square_[i]];
    for (int s = 0; s < segment_count(); ++s) {
      BicubicPoints& segment = points.segments[level * segment_count() + s];
      for (int i = 0; i < 16; ++i) segment[i] = refined[segment_rows_[s][i]];
    }
  }
  // The row of limit weights, applied to the smallest square for accuracy.
  const std::vector<Vector3d>& inner = points.inner;
  points.limit = inner.front();
  for (Eigen::Index i = 0; i < spectrum_->left.rows(); ++i) {
    points.limit += spectrum_->left(i, 0) * (inner[i] - inner.front());
  }
}

EigenCoordinates CornerBasis::eigen_coordinates(const CornerPoints& points) const {
  const std::vector<Vector3d>& inner = points.inner;
  EigenCoordinates result;
  result.rest.resize(point_count(), 3);
  for (int i = 0; i < point_count(); ++i) {
    // Seen from its own corner, coordinates are as small as the square, and so is their rounding.
    result.rest.row(i) = (inner[i] - inner.front()).transpose();
  }
  result.dominant =
      spectrum_->left.transpose().lazyProduct(result.rest.topRows(spectrum_->left.rows()));
  result.rest -= right_.lazyProduct(result.dominant);
  return result;
}

void CornerBasis::advance(EigenCoordinates& coordinates, int steps) const {
  for (const DominantBlock& block : spectrum_->blocks) {
    auto rows = coordinates.dominant.middleRows(block.begin, block.size);
    if (block.coupled) {
      // Jordan blocks and rotations have no powers of numbers.
      for (int k = 0; k < steps; ++k) rows = (block.action * rows).eval();
    } else {
      rows *= steps == 1 ? block.eigenvalue : std::pow(block.eigenvalue, steps);
    }
  }
  if (steps > rest_levels_) {
    coordinates.rest.setZero();
  } else {
    for (std::size_t k = 0; k < rest_powers_.size(); ++k) {
      // By the binary digits of the number of steps.
      if ((steps >> k & 1) == 0) continue;
      coordinates.rest = rest_powers_[k].lazyProduct(coordinates.rest).eval();
    }
  }
}

void CornerBasis::evaluate(const CornerPoints& points, double u, double v, int order,
                           SurfaceJet& jet) const {
  if (std::max(u, v) < kAtCorner) {
    // Derivatives in (u, v) do not exist at an irregular point: the parametrisation is singular
    // there.
    jet = {};
    jet.point = points.limit;
    return;
  }
  const RingPlace place = place_in_ring(u, v);
  if (place.level > kPlainRings) {
    return evaluate_deep(points, place.level, place.u, place.v, order, jet);
  }
  // The min is for u or v of 1, which have no quarter of their own.
  const int s = segment_at_[std::min(3, static_cast<int>(4.0 * place.v))]
                           [std::min(3, static_cast<int>(4.0 * place.u))];
  const RingSegment& segment = segments_[s];
  const double scale = 1.0 / segment.size;  // 2 or 4
  evaluate_bicubic(points.segments[(place.level - 1) * segment_count() + s],
                   (place.u - segment.u) * scale, (place.v - segment.v) * scale, order, jet);
  scale_derivatives(jet, place.scale * scale, order);
}

void CornerBasis::evaluate_deep(const CornerPoints& points, int level, double u, double v,
                                int order, SurfaceJet& jet) const {
  // The square that is kept is that after kPlainRings steps; level 1 takes none.
  EigenCoordinates at = eigen_coordinates(points);
  advance(at, level - 1 - kPlainRings);
  const int s =
      segment_at_[std::min(3, static_cast<int>(4.0 * v))][std::min(3, static_cast<int>(4.0 * u))];
  const RingSegment& segment = segments_[s];
  const double x = (u - segment.u) / segment.size, y = (v - segment.v) / segment.size;
  const auto combine = [&](const Basis& bu, const Basis& bv) -> Vector3d {
    const Weights16 weights = tensor_weights(bu, bv);
    // The constant eigenvector is left out: it only moves, and would drown small differences.
    const Eigen::Index m = at.dominant.rows() - 1;
    const Eigen::RowVectorXd on_dominant = weights.transpose() * segment.dominant.rightCols(m);
    const Eigen::RowVectorXd on_rest = weights.transpose() * segment.rows;
    return (on_dominant * at.dominant.bottomRows(m) + on_rest * at.rest).transpose();
  };
  const Basis bu = cubic_basis(x), bv = cubic_basis(y);
  jet.point = points.limit + combine(bu, bv);
  if (order > 0) {
    const Basis du = cubic_basis_d1(x), dv = cubic_basis_d1(y);
    jet.du = combine(du, bv);
    jet.dv = combine(bu, dv);
    if (order > 1) {
      jet.duu = combine(cubic_basis_d2(x), bv);
      jet.duv = combine(du, dv);
      jet.dvv = combine(bu, cubic_basis_d2(y));
    }
  }
  // By the ring's scale and by the segment's own.
  scale_derivatives(jet, std::ldexp(1.0, level - 1) / segment.size, order);
}

Vector3d CornerBasis::corner_normal(const CornerPoints& points) const {
  if (!tangent_.defined) return Vector3d::Zero();
  Vector3d a = Vector3d::Zero(), b = Vector3d::Zero();
  // Rows of tangents sum to zero, so the first point is taken off before they are applied: what
  // remains is as small as the square, and so is its rounding.
  for (Eigen::Index i = 1; i < tangent_rows_.cols(); ++i) {
    const Vector3d q = points.inner[i] - points.inner.front();
    a += tangent_rows_(0, i) * q;
    b += tangent_rows_(1, i) * q;
  }
  return tangent_.sign * a.cross(b);
}

CornerRing::CornerRing(const CornerBasis& basis, const CornerPoints& points)
    : basis_(basis), points_(points) {}

const std::vector<Vector3d>& CornerRing::points() const {
  if (step_ <= kPlainRings) return points_.square(step_);
  if (!deep_square_.empty()) return deep_square_;
  const CornerBasis::Rows values = basis_.right_.lazyProduct(deep_.dominant) + deep_.rest;
  deep_square_.reserve(values.rows());
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    deep_square_.push_back(points_.limit + values.row(i).transpose());
  }
  return deep_square_;
}

BicubicPoints CornerRing::segment_points(int segment) const {
  if (step_ < kPlainRings) return points_.segments[step_ * basis_.segment_count() + segment];
  const RingSegment& s = basis_.segments_[segment];
  const Eigen::Matrix<double, 16, 3> values =
      s.dominant.lazyProduct(deep_.dominant) + s.rows.lazyProduct(deep_.rest);
  BicubicPoints result;
  for (int i = 0; i < 16; ++i) result[i] = points_.limit + values.row(i).transpose();
  return result;
}

void CornerRing::advance() {
  ++step_;
  deep_square_.clear();
  if (step_ == kPlainRings) {
    deep_ = basis_.eigen_coordinates(points_);
    // The constant part is the limit point, which is added at the end.
    deep_.dominant.row(0).setZero();
  } else if (step_ > kPlainRings) {
    basis_.advance(deep_, 1);
  }
}

}  // namespace hull::surface
