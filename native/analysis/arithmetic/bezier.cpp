// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/arithmetic/bezier.h"

#include <algorithm>
#include <cmath>

namespace hull::analysis {
namespace {

// The two halves of a cubic (de Casteljau at 1/2).
std::array<BezierCubic, 2> halves(const BezierCubic& c) {
  const double ab = 0.5 * (c[0] + c[1]), bc = 0.5 * (c[1] + c[2]), cd = 0.5 * (c[2] + c[3]);
  const double abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
  return {BezierCubic{c[0], ab, abc, middle}, BezierCubic{middle, bcd, cd, c[3]}};
}

int count_sign_changes(const BezierCubic& c) {
  int changes = 0;
  // By the variation-diminishing property a cubic has no more roots than its coefficients have
  // changes of sign, and as many but for an even number.
  for (int i = 0; i < 3; ++i) changes += (c[i] >= 0.0) != (c[i + 1] >= 0.0);
  return changes;
}

void collect_roots(const BezierCubic& c, double begin, double size, Roots& roots) {
  const int changes = count_sign_changes(c);
  // A cubic has three roots at most; rounded halves may show more changes of sign.
  if (changes == 0 || roots.full()) return;
  if (changes == 1) {
    roots.push_back(begin + size * monotonic_root(c));
    return;
  }
  // Two changes that no halving parts: a double root, which is none unless the ends differ.
  if (size < 1e-13) {
    if ((c[0] >= 0.0) != (c[3] >= 0.0)) roots.push_back(begin + 0.5 * size);
    return;
  }
  const std::array<BezierCubic, 2> parts = halves(c);
  collect_roots(parts[0], begin, 0.5 * size, roots);
  collect_roots(parts[1], begin + 0.5 * size, 0.5 * size, roots);
}

// Uniform knots: ends are (1, 4, 1) / 6, inner points at the thirds of the control polygon's middle
// leg.
BezierCubic bezier_from_bspline(double p0, double p1, double p2, double p3) {
  return {(p0 + 4.0 * p1 + p2) / 6.0, (2.0 * p1 + p2) / 3.0, (p1 + 2.0 * p2) / 3.0,
          (p1 + 4.0 * p2 + p3) / 6.0};
}

}  // namespace

double evaluate(const BezierCubic& c, double t) {
  const double s = 1.0 - t;
  return s * s * (s * c[0] + 3.0 * t * c[1]) + t * t * (3.0 * s * c[2] + t * c[3]);
}

double monotonic_root(const double* c) {
  if ((c[0] >= 0.0) == (c[3] >= 0.0)) return std::abs(c[0]) < std::abs(c[3]) ? 0.0 : 1.0;
  const double p1 = 3.0 * (c[1] - c[0]), p2 = 3.0 * (c[0] - 2.0 * c[1] + c[2]);
  const double p3 = c[3] - c[0] + 3.0 * (c[1] - c[2]);
  double low = 0.0, high = 1.0, t = c[0] / (c[0] - c[3]);
  // An end at zero counts as positive: the sign may change elsewhere.
  if (c[0] == 0.0 || c[3] == 0.0) t = 0.5;
  for (int i = 0; i < 60; ++i) {
    const double value = c[0] + t * (p1 + t * (p2 + t * p3));
    if (value == 0.0) return t;
    ((value >= 0.0) == (c[0] >= 0.0) ? low : high) = t;
    const double slope = p1 + t * (2.0 * p2 + t * 3.0 * p3);
    double next = t - value / slope;
    // Also where the slope is zero: what is not a number is in no bracket.
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double change = std::abs(next - t);
    t = next;
    if (change < 1e-15) break;
  }
  return t;
}

Roots sign_changes(const BezierCubic& cubic) {
  Roots roots;
  collect_roots(cubic, 0.0, 1.0, roots);
  return roots;
}

BezierBicubic BezierBicubic::from_bspline(const std::array<double, 16>& p) {
  // The tensor product: along u in each row, then along v in each column.
  std::array<double, 16> rows, result;
  for (int j = 0; j < 4; ++j) {
    const BezierCubic row = bezier_from_bspline(p[4 * j], p[4 * j + 1], p[4 * j + 2], p[4 * j + 3]);
    for (int i = 0; i < 4; ++i) rows[4 * j + i] = row[i];
  }
  for (int i = 0; i < 4; ++i) {
    const BezierCubic column = bezier_from_bspline(rows[i], rows[4 + i], rows[8 + i], rows[12 + i]);
    for (int j = 0; j < 4; ++j) result[4 * j + i] = column[j];
  }
  return BezierBicubic(result);
}

double BezierBicubic::lowest() const { return *std::min_element(c_.begin(), c_.end()); }
double BezierBicubic::highest() const { return *std::max_element(c_.begin(), c_.end()); }

BezierCubic BezierBicubic::along_v(double u) const {
  BezierCubic cubic;
  for (int j = 0; j < 4; ++j) {
    cubic[j] = evaluate({c_[4 * j], c_[4 * j + 1], c_[4 * j + 2], c_[4 * j + 3]}, u);
  }
  return cubic;
}

BezierCubic BezierBicubic::along_u(double v) const {
  BezierCubic cubic;
  for (int i = 0; i < 4; ++i) cubic[i] = evaluate({c_[i], c_[4 + i], c_[8 + i], c_[12 + i]}, v);
  return cubic;
}

std::array<double, 2> BezierBicubic::slope_bounds_v() const {
  std::array<double, 2> bounds{c_[4] - c_[0], c_[4] - c_[0]};
  // A third of the slope: differences of neighbours hold those of the surface between them.
  for (int k = 0; k < 12; ++k) {
    const double difference = c_[k + 4] - c_[k];
    bounds = {std::min(bounds[0], difference), std::max(bounds[1], difference)};
  }
  return bounds;
}

std::array<double, 2> BezierBicubic::slope_bounds_u() const {
  return transposed().slope_bounds_v();
}

BezierBicubic BezierBicubic::transposed() const {
  BezierBicubic result;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) result.c_[4 * j + i] = c_[4 * i + j];
  }
  return result;
}

BezierBicubic BezierBicubic::quarter(int i, int j) const {
  BezierBicubic half, result;
  for (int k = 0; k < 4; ++k) {
    const BezierCubic row = halves({c_[4 * k], c_[4 * k + 1], c_[4 * k + 2], c_[4 * k + 3]})[i];
    for (int a = 0; a < 4; ++a) half.c_[4 * k + a] = row[a];
  }
  for (int a = 0; a < 4; ++a) {
    const BezierCubic column =
        halves({half.c_[a], half.c_[4 + a], half.c_[8 + a], half.c_[12 + a]})[j];
    for (int k = 0; k < 4; ++k) result.c_[4 * k + a] = column[k];
  }
  return result;
}

}  // namespace hull::analysis
