// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace hull::analysis {

// A list of at most `kCapacity` values, without memory of its own on the heap.
template <class Value, std::size_t kCapacity>
class SmallList {
 public:
  void push_back(const Value& value) {
    assert(size_ < kCapacity);
    values_[size_++] = value;
  }
  // Into a rising list; what is there already is not put in again.
  void insert(const Value& value) {
    std::size_t place = size_;
    while (place > 0 && value < values_[place - 1]) --place;
    if (place > 0 && values_[place - 1] == value) return;
    assert(size_ < kCapacity);
    for (std::size_t i = size_; i > place; --i) values_[i] = values_[i - 1];
    values_[place] = value;
    ++size_;
  }
  bool full() const { return size_ == kCapacity; }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const Value& front() const { return values_[0]; }
  const Value& operator[](std::size_t i) const { return values_[i]; }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.begin() + size_; }

 private:
  std::array<Value, kCapacity> values_{};
  std::size_t size_ = 0;
};

}  // namespace hull::analysis
