// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/planes.h"

#include <cmath>
#include <stdexcept>

namespace hull::bindings {

analysis::Axis axis_from(const std::string& name) {
  if (name == "x") return analysis::Axis::kX;
  if (name == "y") return analysis::Axis::kY;
  if (name == "z") return analysis::Axis::kZ;
  throw std::invalid_argument("An axis is \"x\", \"y\" or \"z\", not \"" + name + "\".");
}

analysis::Plane plane_from(const Vector3d& normal, double offset, const std::string& name) {
  const double length = normal.norm();
  if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(offset)) {
    std::string message = name;
    message += " is no plane: its normal must not be zero, and all of its numbers finite.";
    throw std::invalid_argument(message);
  }
  return {normal / length, offset / length};
}

analysis::Plane plane_from(const DoubleArray& given, const char* name) {
  const DoubleArray::Values array = given.values(name);
  if (array.ndim() != 1 || array.shape(0) != 4) {
    std::string message = name;
    message += " has to be of shape (4,): a normal x, y, z and an offset, for normal·p = offset.";
    throw std::invalid_argument(message);
  }
  return plane_from({array.at(0), array.at(1), array.at(2)}, array.at(3), name);
}

std::vector<analysis::Plane> planes_from(const DoubleArray& given) {
  const DoubleArray::Values array = given.values("planes");
  if (array.ndim() != 2 || array.shape(1) != 4) {
    throw std::invalid_argument(
        "planes has to be of shape (n, 4): normals x, y, z and offsets of planes normal·p = "
        "offset.");
  }
  const auto numbers = array.unchecked<2>();
  std::vector<analysis::Plane> planes;
  for (py::ssize_t i = 0; i < numbers.shape(0); ++i) {
    const Vector3d normal(numbers(i, 0), numbers(i, 1), numbers(i, 2));
    std::string name = "planes[";
    name += std::to_string(i);
    name += ']';
    planes.push_back(plane_from(normal, numbers(i, 3), name));
  }
  return planes;
}

py::array_t<double> to_array(const analysis::Plane& plane) {
  return to_array(
      std::vector<double>{plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset});
}

}  // namespace hull::bindings
