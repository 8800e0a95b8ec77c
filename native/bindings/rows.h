// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "bindings/arrays.h"

namespace hull::bindings {

// (n, kColumns) of whole numbers.
template <std::size_t kColumns>
py::array_t<int> rows_of(const std::vector<std::array<int, kColumns>>& rows) {
  py::array_t<int> array(
      {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(kColumns)});
  int* out = array.mutable_data();
  for (const auto& row : rows) out = std::copy(row.begin(), row.end(), out);
  return array;
}

}  // namespace hull::bindings
