// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

namespace hull::bindings {

// What Python gave as a Value; ValueError with these words if it is none.
template <class Value>
Value cast_or_refuse(const pybind11::handle& given, const std::string& words) {
  try {
    return given.cast<Value>();
  } catch (const pybind11::cast_error&) {
    throw std::invalid_argument(words);
  }
}

}  // namespace hull::bindings
