// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/surface_places.h"

#include <memory>
#include <stdexcept>

namespace hull::bindings {
namespace {

using modelling::SurfacePlaces;

template <class Value, class Get>
std::vector<Value> of_places(const SurfacePlaces& places, const Get& get) {
  std::vector<Value> result;
  for (int k = 0; k < places.count(); ++k) result.push_back(get(k));
  return result;
}

std::unique_ptr<SurfacePlaces> made(const surface::LimitSurface& surface, int per_side,
                                    const SurfacePlaces* places) {
  const py::gil_scoped_release release;
  if (places) return std::make_unique<SurfacePlaces>(surface, places->weights());
  return std::make_unique<SurfacePlaces>(surface, per_side);
}

}  // namespace

std::vector<Eigen::Matrix3d> gradients_from(const DoubleArray& given) {
  const DoubleArray::Values array = given.values("gradients");
  const bool fits = array.ndim() == 3 && array.shape(1) == 3 && array.shape(2) == 3;
  if (!fits && array.size() > 0) {
    throw std::invalid_argument("gradients must have shape (n, 3, 3).");
  }
  std::vector<Eigen::Matrix3d> gradients(static_cast<std::size_t>(array.size() / 9));
  const double* data = array.data();
  for (Eigen::Matrix3d& item : gradients) {
    item = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data);
    data += 9;
  }
  return gradients;
}

py::array_t<double> positions(const SurfacePlaces& places) {
  return to_array(of_places<Vector3d>(places, [&](int k) { return places.position(k); }));
}

py::array_t<int> cells(const SurfacePlaces& places) {
  return to_array(of_places<int>(places, [&](int k) { return places.cell(k); }));
}

py::array_t<double> areas(const SurfacePlaces& places) {
  return to_array(of_places<double>(places, [&](int k) { return places.area(k); }));
}

void bind_surface_places(py::module_& module) {
  py::class_<SurfacePlaces>(
      module, "SurfacePlaces",
      "Places all over a surface, each with the area that it stands for: sums over them are "
      "integrals. Where Reshape wants to know the shifts. They keep to the surface as it is when "
      "made.")
      .def(py::init(&made), py::arg("surface"), py::kw_only(), py::arg("per_side") = 3,
           py::arg("places") = py::none(),
           "per_side: places a side of each bicubic piece, 2 or 3; 2 are enough for what is smooth "
           "over a cell. places: those of a surface that differs in its "
           "control points only, by which these are much sooner made; per_side is theirs then. "
           "ValueError where it differs otherwise.")
      .def_property_readonly("positions", &positions, "(k, 3), m.")
      .def_property_readonly("cells", &cells, "(k,)")
      .def_property_readonly("areas", &areas, "(k,), m².")
      .def(
          "points_beyond",
          [](const SurfacePlaces& places, const DoubleArray& shifts) {
            return to_array(places.points_beyond(points_from(shifts, "shifts")));
          },
          py::arg("shifts"),
          "(l,) the control points on which no place depends whose wanted shift, of (k, 3), is not "
          "zero to the last bit: beyond the extent of a shift. Locked in a Reshape, they and the "
          "surface around them stay bit by bit.");
  module.def(
      "first_folded",
      [](const DoubleArray& gradients) -> py::object {
        const int folded = modelling::first_folded(gradients_from(gradients));
        return folded < 0 ? py::object(py::none()) : py::int_(folded);
      },
      py::arg("gradients"),
      "The index of the first of the gradients (k, 3, 3) of a shift, its components' derivatives "
      "(rows) by x, y and z, that folds space, det(1 + gradient) <= 0, or is no number; None: all "
      "is well.");
}

}  // namespace hull::bindings
