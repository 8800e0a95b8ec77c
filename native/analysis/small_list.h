// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cassert>
#include <cstddef>

namespace hull {

// A list of at most `kCapacity` values, without memory of its own on the heap.
template <class Value, std::size_t kCapacity>
class SmallList {
 public:
  void push_back(const Value& value) {
    assert(size_ < kCapacity);
    values_[size_++] = value;
  }
  void resize(std::size_t size) { size_ = size; }
  bool full() const { return size_ == kCapacity; }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const Value& front() const { return values_[0]; }
  const Value& operator[](std::size_t i) const { return values_[i]; }
  auto begin() { return values_.begin(); }
  auto end() { return values_.begin() + size_; }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.begin() + size_; }

 private:
  std::array<Value, kCapacity> values_{};
  std::size_t size_ = 0;
};

}  // namespace hull
