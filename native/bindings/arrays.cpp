// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/arrays.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace hull::bindings {
namespace {

std::string shape_of(const py::array& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

// `columns` 0: a one-dimensional array. An empty one may have any shape.
void check_shape(const py::array& array, int columns, const char* name) {
  const bool fits =
      columns == 0 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == columns;
  if (fits || array.size() == 0) return;
  const std::string wanted = columns == 0 ? "(n,)" : "(n, " + std::to_string(columns) + ")";
  throw std::invalid_argument(std::string(name) + " must have shape " + wanted + ", not " +
                              shape_of(array) + ".");
}

py::array array_from(const py::object& object, const char* name) {
  const py::array array = py::array::ensure(object);
  if (!array) throw std::invalid_argument(std::string(name) + " must be an array of numbers.");
  return array;
}

std::vector<int> whole_numbers(const py::array& array, const char* name) {
  if (array.size() == 0) return {};
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u' && kind != 'b') {
    throw std::invalid_argument(std::string(name) + " must be an array of whole numbers.");
  }
  // Through 64 bits, as a cast to 32 would wrap what is out of range.
  const auto wide = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(array);
  std::vector<int> values(static_cast<std::size_t>(wide.size()));
  const std::int64_t* data = wide.data();
  for (std::size_t i = 0; i < values.size(); ++i) {
    // What 64 bits with a sign can't hold wraps to below zero.
    const bool wrapped = kind == 'u' && data[i] < 0;
    if (wrapped || data[i] < std::numeric_limits<int>::min() ||
        data[i] > std::numeric_limits<int>::max()) {
      const std::string number =
          wrapped ? std::to_string(static_cast<std::uint64_t>(data[i])) : std::to_string(data[i]);
      throw std::invalid_argument(std::string(name) + " holds " + number +
                                  ", which is out of range.");
    }
    values[i] = static_cast<int>(data[i]);
  }
  return values;
}

// NumPy makes a number of each object; of text, too.
bool holds_text(const py::array& array) {
  for (const py::handle item : array.attr("flat")) {
    if (py::isinstance<py::str>(item) || py::isinstance<py::bytes>(item)) return true;
  }
  return false;
}

template <class Item, class Scalar, int kColumns>
py::array_t<Scalar> rows_to_array(const std::vector<Item>& rows) {
  // Rows without padding follow one another as the array has them.
  static_assert(sizeof(Item) == kColumns * sizeof(Scalar));
  py::array_t<Scalar> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{kColumns}});
  if (!rows.empty()) std::memcpy(array.mutable_data(), rows.data(), rows.size() * sizeof(Item));
  return array;
}

}  // namespace

DoubleArray::Values DoubleArray::values(const char* name) const {
  const auto refuse = [name](const std::string& found) {
    throw std::invalid_argument(std::string(name) + " must be an array of real numbers" + found +
                                ".");
  };
  // ensure() swallows NumPy's own error, so that ours names the argument.
  const py::array array = py::array::ensure(given_);
  if (!given_ || given_.is_none() || !array) refuse("");
  const char kind = array.dtype().kind();
  if (kind == 'c') refuse(", not of complex ones");
  if (kind == 'U' || kind == 'S' || (kind == 'O' && holds_text(array))) refuse(", not of text");
  // Objects may be numbers of any kind, as of nested lists of unequal types; NumPy's cast then
  // finds those that are none.
  if (std::strchr("biufO", kind) == nullptr) refuse("");
  const Values values = Values::ensure(array);
  if (!values) refuse("");
  return values;
}

Eigen::Vector3d point_from(const DoubleArray& given, const char* name) {
  const DoubleArray::Values array = given.values(name);
  if (array.ndim() == 1 && array.size() == 3) {
    return Eigen::Map<const Eigen::Vector3d>(array.data());
  }
  throw std::invalid_argument(std::string(name) + " must have shape (3,), not " + shape_of(array) +
                              ".");
}

std::vector<Eigen::Vector3d> points_from(const DoubleArray& given, const char* name) {
  const DoubleArray::Values array = given.values(name);
  check_shape(array, 3, name);
  std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(array.size() / 3));
  const double* data = array.data();
  for (auto& item : points) {
    for (double& number : item) number = *data++;
  }
  return points;
}

std::vector<double> numbers_from(const DoubleArray& given, const char* name) {
  const DoubleArray::Values array = given.values(name);
  check_shape(array, 0, name);
  return std::vector<double>(array.data(), array.data() + array.size());
}

std::vector<Eigen::Vector2d> parameters_from(const DoubleArray& given, const char* name) {
  const DoubleArray::Values array = given.values(name);
  check_shape(array, 2, name);
  std::vector<Eigen::Vector2d> pairs(static_cast<std::size_t>(array.size() / 2));
  const double* data = array.data();
  for (auto& item : pairs) {
    for (double& number : item) number = *data++;
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    // Written so that NaN fails too.
    if (pairs[i].minCoeff() >= 0.0 && pairs[i].maxCoeff() <= 1.0) continue;
    throw std::invalid_argument(std::string(name) + "[" + std::to_string(i) +
                                "] is outside of [0, 1].");
  }
  return pairs;
}

std::vector<int> integers_from(const py::object& object, const char* name) {
  const py::array array = array_from(object, name);
  check_shape(array, 0, name);
  return whole_numbers(array, name);
}

std::vector<std::array<int, 2>> pairs_from(const py::object& object, const char* name) {
  const py::array array = array_from(object, name);
  check_shape(array, 2, name);
  const std::vector<int> flat = whole_numbers(array, name);
  std::vector<std::array<int, 2>> pairs(flat.size() / 2);
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {flat[2 * i], flat[2 * i + 1]};
  return pairs;
}

std::vector<std::array<int, 3>> triangles_from(const py::object& array, std::size_t point_count) {
  const auto rows = py::array::ensure(array);
  if (!rows || rows.ndim() != 2 || rows.shape(1) != 3) {
    throw std::invalid_argument("triangles must have shape (n, 3).");
  }
  // Laid out in one row after the shape is known.
  const std::vector<int> corners = integers_from(rows.attr("ravel")(), "triangles");
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(corners.size() / 3);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    for (const int corner : triangles.back()) {
      if (corner >= 0 && corner < static_cast<int>(point_count)) continue;
      throw std::invalid_argument("Triangle " + std::to_string(i / 3) + " has the corner " +
                                  std::to_string(corner) + ", which is no point.");
    }
  }
  return triangles;
}

py::array_t<double> to_array(const std::vector<Eigen::Vector3d>& points) {
  return rows_to_array<Eigen::Vector3d, double, 3>(points);
}

py::array_t<double> to_array(const std::vector<Eigen::Vector2d>& pairs) {
  return rows_to_array<Eigen::Vector2d, double, 2>(pairs);
}

py::array_t<double> to_array(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::array_t<int> to_array(const std::vector<int>& values) {
  return py::array_t<int>(static_cast<py::ssize_t>(values.size()), values.data());
}

py::array_t<int> to_array(const std::vector<std::array<int, 2>>& pairs) {
  return rows_to_array<std::array<int, 2>, int, 2>(pairs);
}

}  // namespace hull::bindings
