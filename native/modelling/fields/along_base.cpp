// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/along_base.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hull::modelling {
namespace {

double zero_of(double) { return 0.0; }
Vector3d zero_of(const Vector3d&) { return Vector3d::Zero(); }
bool is_finite(double value) { return std::isfinite(value); }
bool is_finite(const Vector3d& value) { return value.allFinite(); }

// Second derivatives at the values of the natural cubic spline.
template <class Value>
std::vector<Value> spline_bends(const std::vector<double>& x, const std::vector<Value>& y) {
  const std::size_t n = x.size();
  // The tridiagonal system by elimination, downwards and back; the ends' bends stay 0.
  std::vector<Value> bends(n, zero_of(y[0]));
  std::vector<double> middle(n, 1.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = x[i] - x[i - 1], after = x[i + 1] - x[i];
    const double factor = i > 1 ? before / middle[i - 1] : 0.0;
    middle[i] = 2.0 * (before + after) - factor * (i > 1 ? before : 0.0);
    bends[i] = 6.0 * ((y[i + 1] - y[i]) / after - (y[i] - y[i - 1]) / before);
    if (i > 1) bends[i] -= factor * bends[i - 1];
  }
  for (std::size_t i = n - 1; i-- > 1;) {
    const double after = x[i + 1] - x[i];
    bends[i] = (bends[i] - after * bends[i + 1]) / middle[i];
  }
  return bends;
}

}  // namespace

template <class Value>
AlongBase<Value>::AlongBase(std::vector<double> lengths, std::vector<Value> values)
    : lengths_(std::move(lengths)), values_(std::move(values)) {
  if (lengths_.empty() || lengths_.size() != values_.size()) {
    throw std::invalid_argument("There must be as many values along the base as lengths, " +
                                std::to_string(lengths_.size()) + ", and one at least.");
  }
  for (std::size_t i = 0; i < lengths_.size(); ++i) {
    const bool rises = i == 0 || lengths_[i] > lengths_[i - 1];
    if (!std::isfinite(lengths_[i]) || !is_finite(values_[i]) || !rises) {
      throw std::invalid_argument("Length or value " + std::to_string(i) +
                                  " along the base is no number, or the lengths do not rise.");
    }
  }
  bends_ = spline_bends(lengths_, values_);
}

template <class Value>
ValueAlong<Value> AlongBase<Value>::at(double length) const {
  if (is_constant() || !(length > lengths_.front())) {
    return {values_.front(), zero_of(values_.front())};
  }
  if (!(length < lengths_.back())) return {values_.back(), zero_of(values_.front())};
  // Strictly between the first and the last length: there is a value on either side.
  const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), length);
  const std::size_t i = static_cast<std::size_t>(after - lengths_.begin()) - 1;
  const double step = lengths_[i + 1] - lengths_[i];
  const double b = (length - lengths_[i]) / step, a = 1.0 - b, sixth = step / 6.0;
  // Linear between the values, and two cubics that are zero at both and have the bends there.
  const Value value =
      a * values_[i] + b * values_[i + 1] +
      sixth * step * ((a * a * a - a) * bends_[i] + (b * b * b - b) * bends_[i + 1]);
  const Value slope =
      (values_[i + 1] - values_[i]) / step +
      sixth * ((3.0 * b * b - 1.0) * bends_[i + 1] - (3.0 * a * a - 1.0) * bends_[i]);
  return {value, slope};
}

template class AlongBase<double>;
template class AlongBase<Vector3d>;

}  // namespace hull::modelling
