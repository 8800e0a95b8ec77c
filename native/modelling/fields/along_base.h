// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/vectors.h"

namespace hull::modelling {

// A value with its slope along the base, per m.
template <class Value>
struct ValueAlong {
  Value value, slope;
};

// A quantity of a field that is constant, or varies along the length of the base: the cubic spline
// with two continuous derivatives and no bend at its ends through given values; beyond the first
// and last it stays as there.
template <class Value>
class AlongBase {
 public:
  explicit AlongBase(const Value& constant) : values_{constant} {}

  // `lengths`, m, rise; as many values. Throws std::invalid_argument else, and for no numbers.
  AlongBase(std::vector<double> lengths, std::vector<Value> values);

  bool is_constant() const { return lengths_.empty(); }
  const std::vector<double>& lengths() const { return lengths_; }
  const std::vector<Value>& values() const { return values_; }
  ValueAlong<Value> at(double length) const;

 private:
  std::vector<double> lengths_;
  std::vector<Value> values_, bends_;  // second derivatives at the values
};

extern template class AlongBase<double>;
extern template class AlongBase<Vector3d>;

}  // namespace hull::modelling
