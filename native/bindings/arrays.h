// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

// NumPy arrays in and out: shapes and ranges are checked here, so that nothing behind them can be
// reached by a malformed call. What does not fit raises ValueError naming the argument and the
// shape wanted.
namespace hull::bindings {

namespace py = pybind11;

// An argument that is to be an array of real numbers, or nested lists of them; taken for one by the
// functions below, which know its name. Complex numbers, text and dates are none: NumPy would drop
// imaginary parts and read numbers out of text.
class DoubleArray {
 public:
  using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;

  DoubleArray() = default;
  explicit DoubleArray(py::object given) : given_(std::move(given)) {}

  Values values(const char* name) const;

 private:
  py::object given_;
};

// (3,) -> a point.
Eigen::Vector3d point_from(const DoubleArray& array, const char* name);
// (n, 3) -> n points.
std::vector<Eigen::Vector3d> points_from(const DoubleArray& array, const char* name);
// (n,) -> n numbers.
std::vector<double> numbers_from(const DoubleArray& array, const char* name);
// (n, 2) -> n pairs; each number in [0, 1].
std::vector<Eigen::Vector2d> parameters_from(const DoubleArray& array, const char* name);
// Arrays or nested lists. (n,) of whole numbers; no wrapping of numbers that int32 can't hold, no
// fractions.
std::vector<int> integers_from(const py::object& array, const char* name);
// (n, 2) of whole numbers.
std::vector<std::array<int, 2>> pairs_from(const py::object& array, const char* name);
// (m, 3) of whole numbers, corners of triangles, each one of so many points.
std::vector<std::array<int, 3>> triangles_from(const py::object& array, std::size_t point_count);

py::array_t<double> to_array(const std::vector<Eigen::Vector3d>& points);
py::array_t<double> to_array(const std::vector<Eigen::Vector2d>& pairs);
py::array_t<double> to_array(const std::vector<double>& values);
py::array_t<int> to_array(const std::vector<int>& values);
py::array_t<int> to_array(const std::vector<std::array<int, 2>>& pairs);

}  // namespace hull::bindings

template <>
struct pybind11::detail::type_caster<hull::bindings::DoubleArray> {
  PYBIND11_TYPE_CASTER(hull::bindings::DoubleArray, const_name("numpy.ndarray[numpy.float64]"));

  bool load(handle source, bool) {
    value = hull::bindings::DoubleArray(reinterpret_borrow<object>(source));
    return true;
  }
};
