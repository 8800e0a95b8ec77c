// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

namespace hull::surface {

// What a control point counts for in a point of the surface.
struct PointWeight {
  int point;
  double weight;
};

// Weights of control points, by rising number: a value that the subdivision rules can be run on.
class WeightRow {
 public:
  WeightRow() = default;
  explicit WeightRow(int point) : entries_{{point, 1.0}} {}

  const std::vector<PointWeight>& entries() const { return entries_; }

  void add(const WeightRow& other, double factor) {
    std::vector<PointWeight> sum;
    sum.reserve(entries_.size() + other.entries_.size());
    auto a = entries_.begin();
    for (const PointWeight& b : other.entries_) {
      while (a != entries_.end() && a->point < b.point) sum.push_back(*a++);
      const bool is_shared = a != entries_.end() && a->point == b.point;
      sum.push_back({b.point, (is_shared ? a++->weight : 0.0) + b.weight * factor});
    }
    sum.insert(sum.end(), a, entries_.end());
    entries_ = std::move(sum);
  }

  WeightRow& operator+=(const WeightRow& other) {
    add(other, 1.0);
    return *this;
  }
  friend WeightRow operator+(WeightRow a, const WeightRow& b) { return a += b; }
  friend WeightRow operator*(WeightRow row, double factor) {
    for (PointWeight& entry : row.entries_) entry.weight *= factor;
    return row;
  }

 private:
  std::vector<PointWeight> entries_;
};

}  // namespace hull::surface
