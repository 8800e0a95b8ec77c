// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/bernstein.h"

#include <cassert>

#include "analysis/arithmetic/bracketed_root.h"

namespace hull::production {
namespace {

double binomial(std::size_t n, std::size_t k) {
  double value = 1.0;
  // Each partial value is a binomial coefficient itself, so that every division leaves no rest.
  for (std::size_t i = 1; i <= k; ++i) value = value * static_cast<double>(n - k + i) / i;
  return value;
}

constexpr int kDeepest = 40;  // halvings, at double roots

void add_sign_changes(const Bernstein& p, const Bernstein& whole, double begin, double size,
                      int deep, std::vector<double>& roots) {
  int changes = 0;
  // Variation diminishing: there are as many roots as changes of sign among the coefficients, or
  // fewer by an even number; none without a change, just one with a single change.
  for (std::size_t i = 1; i < p.size(); ++i) changes += (p[i] > 0.0) != (p[i - 1] > 0.0);
  if (changes == 0 || deep > kDeepest) return;
  const double low = p.front(), high = p.back();
  // Sought in the whole polynomial, not in the part, whose coefficients have the rounding of all
  // halvings.
  if (changes == 1) {
    roots.push_back(analysis::bracketed_root([&](double t) { return value(whole, t); }, begin, low,
                                             begin + size, high, 1e-16));
    return;
  }
  const auto [left, right] = halves(p);
  add_sign_changes(left, whole, begin, 0.5 * size, deep + 1, roots);
  add_sign_changes(right, whole, begin + 0.5 * size, 0.5 * size, deep + 1, roots);
}

}  // namespace

Bernstein product(const Bernstein& a, const Bernstein& b) {
  const std::size_t m = a.size() - 1, n = b.size() - 1;
  Bernstein result(m + n + 1, 0.0);
  for (std::size_t i = 0; i <= m; ++i) {
    // B_i of degree m times B_j of degree n is this part of B_(i + j) of degree m + n.
    for (std::size_t j = 0; j <= n; ++j) {
      result[i + j] += binomial(m, i) * binomial(n, j) / binomial(m + n, i + j) * a[i] * b[j];
    }
  }
  return result;
}

Bernstein sum(const Bernstein& a, const Bernstein& b, double factor) {
  assert(a.size() == b.size());
  Bernstein result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] += factor * b[i];
  return result;
}

Bernstein dot(const BernsteinVector& a, const BernsteinVector& b) {
  return sum(sum(product(a[0], b[0]), product(a[1], b[1])), product(a[2], b[2]));
}

BernsteinVector cross(const BernsteinVector& a, const BernsteinVector& b) {
  const auto part = [&](int i, int j) {
    return sum(product(a[i], b[j]), product(a[j], b[i]), -1.0);
  };
  return {part(1, 2), part(2, 0), part(0, 1)};
}

double value(const Bernstein& polynomial, double t) {
  Bernstein c = polynomial;
  for (std::size_t n = c.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) c[i] += t * (c[i + 1] - c[i]);
  }
  return c[0];
}

std::array<Bernstein, 2> halves(const Bernstein& polynomial) {
  Bernstein c = polynomial, low, high(polynomial.size());
  // Round by round c's first coefficient is one of the lower half, its last one of the upper half.
  for (std::size_t n = c.size(); n > 0; --n) {
    low.push_back(c[0]);
    high[n - 1] = c[n - 1];
    for (std::size_t i = 0; i + 1 < n; ++i) c[i] = 0.5 * (c[i] + c[i + 1]);
  }
  return {low, high};
}

std::vector<double> sign_changes(const Bernstein& polynomial) {
  std::vector<double> roots;
  add_sign_changes(polynomial, polynomial, 0.0, 1.0, 0, roots);
  return roots;
}

}  // namespace hull::production
