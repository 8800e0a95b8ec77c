// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/corner_moments.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/arithmetic/gauss.h"

namespace hull::analysis {
namespace {

constexpr int kMostRings = 60;
// Three nodes are exact for the area of flat spans. Of the excess over that, this share is what
// they may leave out on the inner rings, which have a sixteenth of it.
constexpr double kUneven = 1e-3;
constexpr std::size_t kMostRatios = 6;

// The oriented area of a bicubic span as a form of its 16 points: ∫ N_a,u N_b,v, antisymmetric
// part.
Eigen::Matrix<double, 16, 16> span_area_form() {
  Eigen::Matrix4d slopes = Eigen::Matrix4d::Zero();  // ∫ N_i' N_k
  const GaussRule rule = gauss_rule(3);              // degree 5
  for (std::size_t n = 0; n < rule.nodes.size(); ++n) {
    const surface::Basis value = surface::cubic_basis(rule.nodes[n]),
                         slope = surface::cubic_basis_d1(rule.nodes[n]);
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) slopes(i, k) += rule.weights[n] * slope[i] * value[k];
    }
  }
  Eigen::Matrix<double, 16, 16> form;
  for (int a = 0; a < 16; ++a) {
    // Index 4 j + i: i along u, in which a is differentiated, and j along v, in which b is.
    for (int b = 0; b < 16; ++b) form(a, b) = slopes(a % 4, b % 4) * slopes(b / 4, a / 4);
  }
  return 0.5 * (form - form.transpose());
}

using Moduli = std::vector<double>;  // falling, each as often as it occurs

// Of the local matrix's largest eigenvalues but the 1.
Moduli largest_moduli(const surface::CornerBasis& basis) {
  Moduli moduli;
  for (const surface::DominantBlock& block : basis.spectrum().blocks) {
    if (block.begin > 0) moduli.insert(moduli.end(), block.size, std::abs(block.eigenvalue));
  }
  // What is not dominant falls like this at most; twice, as two such modes make a normal, too.
  moduli.insert(moduli.end(), 2, basis.spectrum().rest);
  return moduli;
}

// The largest of the values, those that hardly differ taken together.
Moduli largest(Moduli values) {
  constexpr double kDistinct = 0.98;
  std::sort(values.begin(), values.end(), std::greater<>());
  Moduli chosen;
  for (double value : values) {
    if (chosen.size() == kMostRatios) break;
    if (chosen.empty() || value < kDistinct * chosen.back()) chosen.push_back(value);
  }
  return chosen;
}

Moduli products(const Moduli& a, const Moduli& b) {
  Moduli all;
  for (double x : a) {
    for (double y : b) all.push_back(x * y);
  }
  return largest(all);
}

// Of the normals, cross products of two different modes, from the pair `first` on.
Moduli normal_moduli(const Moduli& modes, std::size_t first) {
  Moduli normals;
  for (std::size_t j = first; j < modes.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) normals.push_back(modes[i] * modes[j]);
  }
  return largest(normals);
}

// Of |n| - n·m = |n|(1 - cos), m the limit of the normal's direction: for a normal n₀ + d with
// small d across m, d²/2n₀ and higher powers.
Moduli excess_moduli(const Moduli& modes) {
  const Moduli across = normal_moduli(modes, 2);
  const double leading = modes[0] * modes[1];
  Moduli deviations = across;
  for (double& deviation : deviations) deviation /= leading;
  const Moduli squares = products(across, deviations);
  Moduli all = products(squares, deviations);
  all.insert(all.end(), squares.begin(), squares.end());
  return largest(all);
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

AreaForm::AreaForm(const surface::CornerBasis& basis) {
  static const Eigen::Matrix<double, 16, 16> span = span_area_form();
  const int n = basis.point_count();
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(n, n);
  for (const surface::RingSegment& segment : basis.segments()) {
    G += segment.rows.transpose() * span * segment.rows;
  }
  // ∑ (Aᵏ)ᵀ G_ring Aᵏ by doubling: terms fall at least like 0.8², so that 2⁸ are plenty.
  Eigen::MatrixXd power = basis.matrix();
  for (int k = 0; k < 8; ++k) {
    G += (power.transpose() * G * power).eval();
    power = (power * power).eval();
  }
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) above_.push_back(G(i, j) - G(j, i));
  }
}

Vector3d AreaForm::operator()(const std::vector<Vector3d>& points) const {
  // Constants drop out; without them less is lost to rounding.
  std::vector<Vector3d> q(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) q[i] = points[i] - points.front();
  Vector3d sum = Vector3d::Zero();
  const double* factor = above_.data();
  for (std::size_t i = 0; i < q.size(); ++i) {
    Vector3d partners = Vector3d::Zero();
    for (std::size_t j = i + 1; j < q.size(); ++j) partners += *factor++ * q[j];
    sum += q[i].cross(partners);
  }
  return sum;
}

CornerSeries::CornerSeries(const surface::CornerBasis& basis) : area_form(basis) {
  const Moduli modes = largest_moduli(basis);
  excess_ratios = basis.tangent_rule().defined ? excess_moduli(modes) : normal_moduli(modes, 1);
  first_ratios = products(normal_moduli(modes, 1), modes);
  second_ratios = products(first_ratios, modes);
}

namespace {

// How much a limit may still be off whose estimates have changed so much: changes go on falling
// geometrically, though not quite evenly.
double still_to_come(double change, double before) {
  constexpr double kFastest = 0.1;
  return before > 0.0 ? change * std::clamp(2.0 * change / before, kFastest, 1.0) : change;
}

}  // namespace

ShellMoments corner_moments(surface::CornerRing& ring, const surface::CornerBasis& basis,
                            const surface::CornerPoints& points, const CornerSeries& series,
                            const Vector3d& origin, const CornerRules& rules) {
  const Vector3d& limit = ring.limit();
  // Exact. Its part along the corner's normal is the part of the area that falls slowest: only the
  // excess over that is extrapolated.
  const Vector3d normal = series.area_form(ring.points());
  const bool has_area = std::isfinite(rules.area);
  // Zero where there is no tangent plane: then the excess is the whole area.
  const Vector3d direction =
      has_area ? basis.corner_normal(points).normalized() : Vector3d(Vector3d::Zero());
  Extrapolation<double> excess(series.excess_ratios);
  Extrapolation<Eigen::Matrix3d> first(series.first_ratios);
  Extrapolation<Eigen::Matrix<double, 6, 3>> second(series.second_ratios);
  SpanRule inner = rules.inner;
  ShellMoments sum;    // about the corner
  ShellMoments whole;  // with what is beyond the rings summed so far
  double area_change = 0.0, first_change = 0.0;
  for (int k = 0; k < kMostRings; ++k) {
    if (k > 0) ring.advance();
    for (int s = 0; s < basis.segment_count(); ++s) {
      const surface::BicubicPoints span = ring.segment_points(s);
      // The outermost ring's area is refined until its error is small; the others, which have a
      // sixteenth of the excess, take it by their rule alone.
      sum += k == 0 || !has_area
                 ? span_moments({span, limit}, k == 0 ? rules.outer : inner, rules.area)
                 : span_moments({span, limit}, inner);
    }
    const double sum_excess = sum.area - direction.dot(sum.normal);
    if (k == 0 && has_area && inner == SpanRule::kSmall && kUneven * sum_excess < rules.area) {
      inner = SpanRule::kSmallest;
    }
    const ShellMoments before = whole;
    whole = sum;
    if (has_area) whole.area = excess.add(sum_excess) + direction.dot(normal);
    whole.first = first.add(sum.first);
    whole.second = second.add(sum.second);
    const double area_before = area_change, first_before = first_change;
    area_change = std::abs(whole.area - before.area);
    first_change = (whole.first - before.first).norm();
    const double area_error = still_to_come(area_change, area_before);
    const double first_error = still_to_come(first_change, first_before);
    whole.area_error += area_error;
    whole.volume_error = first_error;
    if (k > 0 && area_error < rules.area && first_error < rules.first) break;
  }
  whole.normal = normal;
  return moved(whole, limit - origin);
}

}  // namespace hull::analysis
