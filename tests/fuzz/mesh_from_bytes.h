// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

#include "mesh/mesh_check.h"

namespace hull::fuzz {

// Numbers drawn from a string of bytes; zeros when it has ended. Each statement draws once, so that
// any compiler makes the same of the same bytes.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}

  bool at_end() const { return data_ == end_; }
  int byte() { return at_end() ? 0 : *data_++; }
  // 0 <= result < count, or 0.
  int below(int count) {
    const int high = byte(), drawn = 256 * high + byte();
    return count > 0 ? drawn % count : 0;
  }
  // Tame numbers in [-2, 2], now and then one that is not.
  double number();
  Eigen::Vector3d point();

 private:
  const std::uint8_t* data_;
  const std::uint8_t* end_;
};

// A small mesh told by the bytes: arrays without any sense, or a sound mesh of testing:: with edits
// that keep it sound (faces cut, joined, extruded; creases; points moved) or may not (faces turned,
// points welded, indices changed). At most about 1500 face corners.
mesh::MeshArrays mesh_from_bytes(ByteReader& bytes);

}  // namespace hull::fuzz
