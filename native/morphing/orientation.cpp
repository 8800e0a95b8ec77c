// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/orientation.h"

#include <array>
#include <cmath>

namespace hull::morphing {
namespace {

// A sum of doubles without rounding: components that do not overlap, the least first.
class ExactSum {
 public:
  void add_product(double x, double y) {
    const double product = x * y;
    // What rounding took off the product, exactly.
    add(std::fma(x, y, -product));
    add(product);
  }

  // All but the last component together are less than its last bit.
  double value() const {
    double sum = 0.0;
    for (int i = 0; i < count_; ++i) sum += components_[i];
    return sum;
  }

 private:
  // Shewchuk 1997, theorem 10 (GROW-EXPANSION).
  void add(double x) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      const double y = components_[i];
      // The sum, and what rounding took off it, whichever of both is larger.
      const double sum = x + y;
      const double part = sum - x;
      const double rest = (x - (sum - part)) + (y - part);
      if (rest != 0.0) components_[kept++] = rest;
      x = sum;
    }
    if (x != 0.0) components_[kept++] = x;
    count_ = kept;
  }

  // Six products of two components each.
  std::array<double, 12> components_;
  int count_ = 0;
};

double exact_orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  // The determinant multiplied out, of coordinates as they are: a difference of two would be
  // rounded.
  ExactSum sum;
  sum.add_product(a.x(), b.y());
  sum.add_product(-a.y(), b.x());
  sum.add_product(b.x(), c.y());
  sum.add_product(-b.y(), c.x());
  sum.add_product(c.x(), a.y());
  sum.add_product(-c.y(), a.x());
  return sum.value();
}

}  // namespace

double orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double area = left - right;
  // The error is less than 3.4e-16 of the sum of both products' sizes.
  if (std::abs(area) > 1e-2 * (std::abs(left) + std::abs(right))) return area;
  // The order decides on the last bit of the value.
  const bool swapped = b.x() < a.x() || (b.x() == a.x() && b.y() < a.y());
  return swapped ? -exact_orientation(b, a, c) : exact_orientation(a, b, c);
}

}  // namespace hull::morphing
