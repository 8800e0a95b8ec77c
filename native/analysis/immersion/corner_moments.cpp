// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/corner_moments.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/arithmetic/gauss.h"

namespace hull {
namespace {

constexpr int kExactRings = 2;  // rings integrated by the exact rule; smaller ones by the small
constexpr int kMostRings = 60;
constexpr std::size_t kMostRatios = 6;

// The oriented area of a bicubic span as a form of its 16 points: ∫ N_a,u N_b,v, antisymmetric
// part.
Eigen::Matrix<double, 16, 16> span_area_form() {
  Eigen::Matrix4d slopes = Eigen::Matrix4d::Zero();  // ∫ N_i' N_k
  const GaussRule rule = gauss_rule(3);              // degree 5
  for (std::size_t n = 0; n < rule.nodes.size(); ++n) {
    const Basis value = cubic_basis(rule.nodes[n]), slope = cubic_basis_d1(rule.nodes[n]);
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) slopes(i, k) += rule.weights[n] * slope[i] * value[k];
    }
  }
  Eigen::Matrix<double, 16, 16> form;
  for (int a = 0; a < 16; ++a) {
    for (int b = 0; b < 16; ++b) form(a, b) = slopes(a % 4, b % 4) * slopes(b / 4, a / 4);
  }
  return 0.5 * (form - form.transpose());
}

// Moduli of the local matrix's largest eigenvalues but the 1, falling.
std::vector<double> largest_moduli(const CornerBasis& basis) {
  std::vector<double> moduli;
  for (const SlowBlock& block : basis.spectrum().blocks) {
    if (block.begin > 0) moduli.push_back(std::abs(block.eigenvalue));
  }
  moduli.push_back(basis.spectrum().rest);
  return moduli;
}

// The largest products of `factors` of the moduli, those that hardly differ taken together.
std::vector<double> largest_products(const std::vector<double>& moduli, int factors) {
  constexpr double kDistinct = 0.98;
  std::vector<double> products{1.0};
  for (int k = 0; k < factors; ++k) {
    std::vector<double> longer;
    for (double product : products) {
      for (double modulus : moduli) longer.push_back(product * modulus);
    }
    std::sort(longer.begin(), longer.end(), std::greater<>());
    products.clear();
    for (double product : longer) {
      if (products.size() == kMostRatios) break;
      if (products.empty() || product < kDistinct * products.back()) products.push_back(product);
    }
  }
  return products;
}

// Limit of sums whose differences to it are combinations of powers of known ratios: each column of
// the table is free of one ratio more.
template <class Value>
class Extrapolation {
 public:
  explicit Extrapolation(const std::vector<double>& ratios) : ratios_(ratios) {}

  // The limit as far as this next sum tells.
  const Value& add(const Value& sum) {
    Value next = sum;
    for (std::size_t k = 0; k < size_; ++k) {
      const Value before = row_[k];
      row_[k] = next;
      next = (next - ratios_[k] * before) / (1.0 - ratios_[k]);
    }
    row_[size_] = next;
    if (size_ < ratios_.size()) return row_[size_++];
    return row_[size_];
  }

 private:
  const std::vector<double>& ratios_;
  std::array<Value, kMostRatios + 1> row_;
  std::size_t size_ = 0;  // columns of the last row but one
};

}  // namespace

AreaForm::AreaForm(const CornerBasis& basis) {
  static const Eigen::Matrix<double, 16, 16> span = span_area_form();
  G_.setZero(basis.point_count(), basis.point_count());
  for (const RingSegment& segment : basis.segments()) {
    G_ += segment.rows.transpose() * span * segment.rows;
  }
  // ∑ (Aᵏ)ᵀ G_ring Aᵏ by doubling: terms fall at least like 0.8², so that 2⁸ are plenty.
  Eigen::MatrixXd power = basis.matrix();
  for (int k = 0; k < 8; ++k) {
    G_ += (power.transpose() * G_ * power).eval();
    power = (power * power).eval();
  }
}

Vector3d AreaForm::operator()(const std::vector<Vector3d>& points) const {
  // Constants drop out; without them less is lost to rounding.
  Eigen::Matrix<double, Eigen::Dynamic, 3> q(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    q.row(i) = (points[i] - points.front()).transpose();
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 3> other = G_.lazyProduct(q);
  Vector3d sum = Vector3d::Zero();
  for (Eigen::Index i = 0; i < q.rows(); ++i) {
    sum += q.row(i).transpose().cross(other.row(i).transpose());
  }
  return sum;
}

CornerSeries::CornerSeries(const CornerBasis& basis) : area_form(basis) {
  const std::vector<double> moduli = largest_moduli(basis);
  area_ratios = largest_products(moduli, 2);
  first_ratios = largest_products(moduli, 3);
  second_ratios = largest_products(moduli, 4);
}

ShellMoments corner_moments(CornerRing& ring, const CornerBasis& basis, const CornerSeries& series,
                            const Vector3d& origin, const CornerTolerance& tolerance) {
  const Vector3d& limit = ring.limit();
  // The area elements' square root leaves the leading ratios as they are.
  Extrapolation<double> area(series.area_ratios);
  Extrapolation<Eigen::Matrix3d> first(series.first_ratios);
  Extrapolation<Eigen::Matrix<double, 6, 3>> second(series.second_ratios);
  ShellMoments sum;    // about the corner
  ShellMoments whole;  // with what is beyond the rings summed so far
  for (int k = 0; k < kMostRings; ++k) {
    const SpanRule rule = k < kExactRings ? SpanRule::kExact : SpanRule::kSmall;
    for (int s = 0; s < basis.segment_count(); ++s) {
      sum += span_moments({ring.segment_points(s), limit}, rule, tolerance.area);
    }
    ring.advance();
    const ShellMoments before = whole;
    whole = sum;
    whole.area = area.add(sum.area);
    whole.first = first.add(sum.first);
    whole.second = second.add(sum.second);
    // The change is the error before this ring, larger than that which is left.
    const double area_change = std::abs(whole.area - before.area);
    whole.area_error += area_change;
    if ((whole.first - before.first).norm() < tolerance.first && area_change < tolerance.area) {
      break;
    }
  }
  whole.normal += series.area_form(ring.points());
  return moved(whole, limit - origin);
}

}  // namespace hull
