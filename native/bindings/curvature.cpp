// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/curvature.h"

#include <algorithm>
#include <cstdint>

#include "bindings/arrays.h"
#include "bindings/places.h"
#include "surface/parallel_for.h"

namespace hull::bindings {
namespace {

// Curvatures at many places.
struct Curvatures {
  std::vector<double> maximum, minimum, gaussian, mean;
  std::vector<Vector3d> maximum_directions, minimum_directions;
  std::vector<std::uint8_t> defined, at_irregular_knot;

  void add(const surface::Curvature& c) {
    maximum.push_back(c.maximum);
    minimum.push_back(c.minimum);
    gaussian.push_back(c.gaussian());
    mean.push_back(c.mean());
    maximum_directions.push_back(c.maximum_direction);
    minimum_directions.push_back(c.minimum_direction);
    defined.push_back(c.defined);
    at_irregular_knot.push_back(c.at_irregular_knot);
  }
};

Curvatures curvatures(const surface::LimitSurface& surface, const py::object& cells,
                      const DoubleArray& uv) {
  const Places places = places_from(surface, cells, uv);
  const py::gil_scoped_release release;
  std::vector<surface::Curvature> each(places.cells.size());
  surface::parallel_for(
      each.size(), surface::kAllProcessors, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          each[i] =
              surface::curvature(surface, places.cells[i], places.uv[i].x(), places.uv[i].y());
        }
      });
  Curvatures result;
  for (const surface::Curvature& c : each) result.add(c);
  return result;
}

template <class Value>
auto array_of(std::vector<Value> Curvatures::*member) {
  return [member](const Curvatures& c) { return to_array(c.*member); };
}

auto flags_of(std::vector<std::uint8_t> Curvatures::*member) {
  return [member](const Curvatures& c) {
    py::array_t<bool> flags(static_cast<py::ssize_t>((c.*member).size()));
    std::copy((c.*member).begin(), (c.*member).end(), flags.mutable_data());
    return flags;
  };
}

}  // namespace

void bind_curvature(py::module_& module) {
  py::class_<Curvatures>(
      module, "Curvatures",
      "Curvature of a surface at k places. Positive where it bulges to the side of its normal, as "
      "a "
      "hull does into the water; hollow is negative.\n\n"
      "Where derivatives are parallel or vanish (`defined` is False) all else is zero. At "
      "irregular knots the "
      "surface is only C1: its curvature diverges, vanishes, or depends on the direction of "
      "approach. There the value is that at 2^-20 in u and v from the knot, and "
      "`at_irregular_knot` is True.")
      .def_property_readonly("maximum", array_of(&Curvatures::maximum),
                             "(k,) larger principal curvature, 1/m.")
      .def_property_readonly("minimum", array_of(&Curvatures::minimum),
                             "(k,) smaller principal curvature, 1/m; a hollow's is negative.")
      .def_property_readonly(
          "maximum_directions", array_of(&Curvatures::maximum_directions),
          "(k, 3) unit tangents along which the curvature is `maximum`; any where both are equal.")
      .def_property_readonly("minimum_directions", array_of(&Curvatures::minimum_directions),
                             "(k, 3) unit tangents at right angles to these.")
      .def_property_readonly("gaussian", array_of(&Curvatures::gaussian),
                             "(k,) maximum * minimum, 1/m^2.")
      .def_property_readonly("mean", array_of(&Curvatures::mean),
                             "(k,) (maximum + minimum) / 2, 1/m.")
      .def_property_readonly("defined", flags_of(&Curvatures::defined),
                             "(k,) whether the derivatives there span a tangent plane.")
      .def_property_readonly("at_irregular_knot", flags_of(&Curvatures::at_irregular_knot),
                             "(k,) whether the value is one from beside an irregular knot.");

  const py::object surface = module.attr("LimitSurface");
  // Added to the class that is bound elsewhere: each subject has a file of its own.
  surface.attr("curvature") = py::cpp_function(
      &curvatures, py::name("curvature"), py::is_method(surface), py::arg("cells"), py::arg("uv"),
      "Principal curvatures and directions, Gaussian and mean curvature as Curvatures. cells: "
      "(k,), "
      "uv: (k, 2).");
}

}  // namespace hull::bindings
