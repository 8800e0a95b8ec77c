// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/discs.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace hull::bindings {
namespace {

void check_rows(const py::array& array, py::ssize_t columns, const char* name) {
  if (array.ndim() == 2 && array.shape(1) == columns) return;
  throw std::invalid_argument(std::string(name) + " must have shape (n, " +
                              std::to_string(columns) + ").");
}

}  // namespace

std::vector<morphing::Triangle> triangles_from(const py::object& object, const char* name) {
  py::array array = py::array::ensure(object);
  if (!array) throw std::invalid_argument(std::string(name) + " must be an array of numbers.");
  check_rows(array, 3, name);
  const std::vector<int> flat = integers_from(array.attr("ravel")(), name);
  std::vector<morphing::Triangle> triangles(flat.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    triangles[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
  }
  return triangles;
}

std::vector<morphing::Vector2d> places_from(const DoubleArray& given, const char* name) {
  const DoubleArray::Values array = given.values(name);
  check_rows(array, 2, name);
  std::vector<morphing::Vector2d> places(static_cast<std::size_t>(array.shape(0)));
  const double* data = array.data();
  for (auto& place : places) {
    for (double& number : place) number = *data++;
  }
  return places;
}

py::array_t<int> triangle_array(const std::vector<morphing::Triangle>& triangles) {
  py::array_t<int> array({static_cast<py::ssize_t>(triangles.size()), py::ssize_t{3}});
  if (!triangles.empty()) {
    std::memcpy(array.mutable_data(), triangles.data(), triangles.size() * sizeof(triangles[0]));
  }
  return array;
}

}  // namespace hull::bindings
