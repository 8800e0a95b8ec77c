// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/corner_basis.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "surface/local_matrix.h"

namespace hull {
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
// 1/64 (they subdivide like cubic B-splines); slow ones keep clear of them.
constexpr double kSlowFloor = 0.14;

struct RingPlace {
  int level;
  double u, v;   // in the unit square of the level's cell
  double scale;  // d(u, v) of the level per d(u, v) of the cell: 2^(level - 1)
};

RingPlace place_in_ring(double u, double v) {
  int exponent = 0;
  std::frexp(std::max(u, v), &exponent);
  const int level = std::max(1, 1 - exponent);
  const double scale = std::ldexp(1.0, level - 1);
  return {level, u * scale, v * scale, scale};
}

}  // namespace

CornerKey corner_key(Scheme scheme, const CornerFan& fan) {
  return {scheme, fan.kind, fan.closed, fan.faces, fan.cell};
}

CornerBasis::CornerBasis(const CornerKey& key) {
  LocalMatrices local = local_matrices(key);
  A_ = std::move(local.A);
  segments_ = std::move(local.segments);
  const int n = point_count(), ring = local.ring_size, outer = n - ring;
  spectrum_ = slow_spectrum(A_.topLeftCorner(ring, ring), kSlowFloor);

  if (key.kind == VertexKind::kCorner || key.kind == VertexKind::kCone) {
    // The limit of an interpolated point is the point itself, without a rounding error.
    spectrum_.left.col(0) = Eigen::VectorXd::Unit(ring, 0);
  }

  // A = [S 0; C D]. The eigenspaces of S extend to A by D X - X L = -C R, block by block.
  const Eigen::Index m = spectrum_.right.cols();
  right_.resize(n, m);
  right_.topRows(ring) = spectrum_.right;
  const Eigen::MatrixXd C = A_.bottomLeftCorner(outer, ring),
                        D = A_.bottomRightCorner(outer, outer);
  for (const SlowBlock& block : spectrum_.blocks) {
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
      wanted.segment(outer * j, outer) = -C * spectrum_.right.col(block.begin + j);
    }
    const Eigen::VectorXd solution = system.partialPivLu().solve(wanted);
    for (int j = 0; j < size; ++j) {
      right_.block(ring, block.begin + j, outer, 1) = solution.segment(outer * j, outer);
    }
  }
  right_.col(0).setOnes();

  for (auto& quarter_row : segment_at_) quarter_row.fill(-1);
  for (int s = 0; s < static_cast<int>(segments_.size()); ++s) {
    RingSegment& segment = segments_[s];
    segment.slow = segment.rows * right_;
    const int i0 = static_cast<int>(4 * segment.u), j0 = static_cast<int>(4 * segment.v);
    const int span = static_cast<int>(4 * segment.size);
    for (int j = j0; j < j0 + span; ++j) {
      for (int i = i0; i < i0 + span; ++i) segment_at_[j][i] = s;
    }
  }
  // In second derivatives the rest grows by 4 a level, the leading terms by at least 4 · 1/4.
  const double decay = std::max(spectrum_.rest, 0.126);
  rest_levels_ = static_cast<int>(std::ceil(std::log(1e-18) / std::log(decay))) + 40;
  find_tangent_rule();
  tangent_.defined = tangent_.defined && key.kind != VertexKind::kCone;
}

CornerPoints CornerBasis::prepare(const std::vector<Vector3d>& points) const {
  const int n = point_count();
  assert(static_cast<int>(points.size()) == n);
  CornerPoints result;
  result.origin = points.front();
  Rows relative(n, 3);
  for (int i = 0; i < n; ++i) relative.row(i) = (points[i] - result.origin).transpose();
  result.slow.noalias() = spectrum_.left.transpose() * relative.topRows(spectrum_.left.rows());
  result.rest = relative;
  result.rest.noalias() -= right_ * result.slow;
  result.limit = result.origin + result.slow.row(0).transpose();
  return result;
}

CornerBasis::Rows CornerBasis::slow_at_level(const CornerPoints& points, int level) const {
  Rows slow = points.slow;
  if (level == 1) return slow;
  for (const SlowBlock& block : spectrum_.blocks) {
    auto rows = slow.middleRows(block.begin, block.size);
    if (block.coupled) {
      for (int k = 1; k < level; ++k) rows = (block.action * rows).eval();
    } else {
      rows *= std::pow(block.eigenvalue, level - 1);
    }
  }
  return slow;
}

CornerBasis::Rows CornerBasis::rest_at_level(const CornerPoints& points, int level) const {
  if (level > rest_levels_) return Rows::Zero(point_count(), 3);
  Rows rest = points.rest;
  for (int k = 1; k < level; ++k) rest = (A_ * rest).eval();
  return rest;
}

SurfaceJet CornerBasis::evaluate(const CornerPoints& points, double u, double v, int order) const {
  SurfaceJet jet;
  if (u == 0.0 && v == 0.0) {
    jet.point = points.limit;
    return jet;
  }
  const RingPlace place = place_in_ring(u, v);
  const int s = segment_at_[std::min(3, static_cast<int>(4.0 * place.v))]
                           [std::min(3, static_cast<int>(4.0 * place.u))];
  const RingSegment& segment = segments_[s];
  const double x = (place.u - segment.u) / segment.size, y = (place.v - segment.v) / segment.size;
  const Rows slow = slow_at_level(points, place.level);
  const Rows rest = rest_at_level(points, place.level);
  const double scale = place.scale / segment.size;
  const auto combine = [&](const Basis& bu, const Basis& bv) -> Vector3d {
    const Weights16 weights = tensor_weights(bu, bv);
    // The constant eigenvector is left out: it only moves, and would drown small differences.
    const Eigen::Index m = slow.rows() - 1;
    const Eigen::RowVectorXd on_slow = weights.transpose() * segment.slow.rightCols(m);
    const Eigen::RowVectorXd on_rest = weights.transpose() * segment.rows;
    return (on_slow * slow.bottomRows(m) + on_rest * rest).transpose();
  };
  const Basis bu = cubic_basis(x), bv = cubic_basis(y);
  jet.point = points.limit + combine(bu, bv);
  if (order > 0) {
    const Basis du = cubic_basis_d1(x), dv = cubic_basis_d1(y);
    jet.du = scale * combine(du, bv);
    jet.dv = scale * combine(bu, dv);
    if (order > 1) {
      jet.duu = scale * scale * combine(cubic_basis_d2(x), bv);
      jet.duv = scale * scale * combine(du, dv);
      jet.dvv = scale * scale * combine(bu, cubic_basis_d2(y));
    }
  }
  return jet;
}

Vector3d CornerBasis::corner_normal(const CornerPoints& points) const {
  if (!tangent_.defined) return Vector3d::Zero();
  const Vector3d a = points.slow.transpose() * tangent_.a, b = points.slow.transpose() * tangent_.b;
  return tangent_.sign * a.cross(b);
}

void CornerBasis::find_tangent_rule() {
  const auto& blocks = spectrum_.blocks;
  const Eigen::Index m = right_.cols();
  if (blocks.size() < 2) return;
  const SlowBlock& first = blocks[1];
  Eigen::VectorXd pattern_a = Eigen::VectorXd::Unit(m, first.begin), pattern_b;
  tangent_.a = pattern_a;
  if (first.size == 2 && !first.coupled) {
    tangent_.b = pattern_b = Eigen::VectorXd::Unit(m, first.begin + 1);
  } else if (first.size == 1 && blocks.size() > 2 && blocks[2].size == 1) {
    tangent_.b = pattern_b = Eigen::VectorXd::Unit(m, blocks[2].begin);
  } else if (first.size == 1 && blocks.size() > 2 && blocks[2].coupled) {
    // A Jordan block: after k steps its nilpotent part leads by a factor k. Of rank one, it maps
    // everything on one eigenvector (design: trap 5, the osculating plane of a crease).
    const SlowBlock& second = blocks[2];
    const Eigen::MatrixXd nilpotent =
        second.action - second.eigenvalue * Eigen::MatrixXd::Identity(second.size, second.size);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(nilpotent,
                                                Eigen::ComputeThinU | Eigen::ComputeThinV);
    if (svd.singularValues()[1] > 1e-6 * svd.singularValues()[0]) return;
    tangent_.b = pattern_b = Eigen::VectorXd::Zero(m);
    tangent_.b.segment(second.begin, second.size) = svd.matrixV().col(0);
    pattern_b.segment(second.begin, second.size) = svd.matrixU().col(0);
  } else {
    return;
  }
  // The map of the two leading patterns must not fold; its orientation is the normal's sign.
  double orientation = 0.0;
  for (const RingSegment& segment : segments_) {
    const Weights16 du = tensor_weights(cubic_basis_d1(0.5), cubic_basis(0.5));
    const Weights16 dv = tensor_weights(cubic_basis(0.5), cubic_basis_d1(0.5));
    const Weights16 a = segment.slow * pattern_a, b = segment.slow * pattern_b;
    const double jacobian = du.dot(a) * dv.dot(b) - dv.dot(a) * du.dot(b);
    if (jacobian * orientation < 0.0) return;
    orientation = jacobian;
  }
  tangent_.sign = orientation < 0.0 ? -1.0 : 1.0;
  tangent_.defined = true;
}

CornerRing::CornerRing(const CornerBasis& basis, const CornerPoints& points)
    : basis_(basis), origin_(points), slow_(points.slow), rest_(points.rest) {
  slow_.row(0).setZero();
}

Eigen::Matrix<double, Eigen::Dynamic, 3> CornerRing::points() const {
  return (basis_.right_ * slow_ + rest_).rowwise() + origin_.limit.transpose();
}

BicubicPoints CornerRing::segment_points(int segment) const {
  const RingSegment& s = basis_.segments_[segment];
  const Eigen::Matrix<double, 16, 3> values = s.slow * slow_ + s.rows * rest_;
  BicubicPoints result;
  for (int i = 0; i < 16; ++i) result[i] = origin_.limit + values.row(i).transpose();
  return result;
}

void CornerRing::advance() {
  for (const SlowBlock& block : basis_.spectrum_.blocks) {
    auto rows = slow_.middleRows(block.begin, block.size);
    if (block.coupled) {
      rows = (block.action * rows).eval();
    } else {
      rows *= block.eigenvalue;
    }
  }
  rest_ = (basis_.A_ * rest_).eval();
}

}  // namespace hull
