// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/shape_fields.h"

#include <pybind11/stl.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "bindings/arrays.h"
#include "modelling/fields/field_curve.h"
#include "modelling/fields/geodesic_net.h"
#include "surface/creases/crease_curves.h"

namespace hull::bindings {
namespace {

using modelling::AlongBase;
using modelling::FieldCurve;
using modelling::ShapeField;
using modelling::ShapeFields;

// A constant, or a tuple (lengths, values).
template <class Value, class Read, class ReadAll>
AlongBase<Value> along_from(const py::object& given, const char* name, const Read& read,
                            const ReadAll& read_all) {
  if (!py::isinstance<py::tuple>(given)) return AlongBase<Value>(read(given));
  const auto parts = py::reinterpret_borrow<py::tuple>(given);
  if (parts.size() != 2) {
    throw std::invalid_argument(std::string(name) +
                                " must be constant, or a tuple of lengths along the base and "
                                "values there.");
  }
  return AlongBase<Value>(numbers_from(DoubleArray(parts[0]), name),
                          read_all(DoubleArray(parts[1])));
}

AlongBase<double> number_along(const py::object& given, const char* name) {
  const auto read = [&](const py::object& value) {
    const std::vector<double> one = numbers_from(DoubleArray(py::make_tuple(value)), name);
    // An empty list would pass as an array of no numbers.
    if (one.size() != 1) throw std::invalid_argument(std::string(name) + " must be one number.");
    return one[0];
  };
  return along_from<double>(given, name, read,
                            [&](const DoubleArray& values) { return numbers_from(values, name); });
}

AlongBase<Vector3d> vector_along(const py::object& given, const char* name) {
  // A vector written as a tuple of three numbers is constant.
  const bool is_constant = !py::isinstance<py::tuple>(given) || py::len(given) == 3;
  if (is_constant) return AlongBase<Vector3d>(point_from(DoubleArray(given), name));
  const auto read = [&](const py::object& value) { return point_from(DoubleArray(value), name); };
  return along_from<Vector3d>(given, name, read,
                              [&](const DoubleArray& values) { return points_from(values, name); });
}

struct FieldSettings {
  py::object extent, falloff;
  std::string axes;
  bool protects;
};

ShapeField field_from(const FieldSettings& settings) {
  ShapeField field;
  field.extent = number_along(settings.extent, "extent");
  field.kappa = number_along(settings.falloff, "falloff");
  field.protects = settings.protects;
  field.axes = {false, false, false};
  for (char axis : settings.axes) {
    if (axis < 'x' || axis > 'z') {
      throw std::invalid_argument("axes is made of the letters x, y and z, not '" + settings.axes +
                                  "'.");
    }
    field.axes[axis - 'x'] = true;
  }
  return field;
}

// At points, or at a FieldPlaces.
py::tuple shifts_at(const ShapeFields& fields, const py::object& points) {
  std::vector<modelling::FieldShift> found;
  if (py::isinstance<modelling::FieldPlaces>(points)) {
    // With the lock held: places are not for several threads at once.
    found = fields.at(points.cast<modelling::FieldPlaces&>());
  } else {
    const std::vector<Vector3d> at = points_from(DoubleArray(points), "points");
    const py::gil_scoped_release release;
    found = fields.at(at);
  }
  const auto count = static_cast<py::ssize_t>(found.size());
  py::array_t<double> shifts({count, py::ssize_t{3}});
  py::array_t<double> gradients({count, py::ssize_t{3}, py::ssize_t{3}});
  double *shift = shifts.mutable_data(), *gradient = gradients.mutable_data();
  for (const modelling::FieldShift& each : found) {
    for (int i = 0; i < 3; ++i) {
      *shift++ = each.shift[i];
      for (int j = 0; j < 3; ++j) *gradient++ = each.gradient(i, j);
    }
  }
  return py::make_tuple(shifts, gradients);
}

py::array_t<double> deltas_at(const ShapeFields& fields, int field, const DoubleArray& points) {
  const int count = static_cast<int>(fields.fields().size());
  if (field < 0 || field >= count) {
    throw std::invalid_argument("There is no field " + std::to_string(field) + ": there are " +
                                std::to_string(count) + ".");
  }
  std::vector<double> found;
  for (const Vector3d& p : points_from(points, "points")) found.push_back(fields.delta(field, p));
  return to_array(found);
}

void bind_field_curve(py::module_& module) {
  py::class_<FieldCurve>(module, "FieldCurve",
                         "A curve in space on which fields are based or to which they lead: cubic "
                         "arcs that may meet at knuckles, measured by its length.")
      .def(py::init([](const DoubleArray& points, const py::object& knuckles, bool closed) {
             return FieldCurve::through(points_from(points, "points"),
                                        integers_from(knuckles, "knuckles"), closed);
           }),
           py::arg("points"), py::kw_only(), py::arg("knuckles") = py::tuple(),
           py::arg("closed") = false,
           "Through points (n, 3), m, in order: between knuckles (indices of points; the ends are "
           "two) the cubic spline by chord length with free ends. ValueError for fewer than two "
           "points (three of a closed curve) and points that follow on themselves.")
      .def_static(
          "of_crease",
          [](const surface::CreaseCurve& crease) { return FieldCurve::of_spline(crease.spline()); },
          py::arg("crease"), "The same curve as a CreaseCurve.")
      .def_property_readonly("length", &FieldCurve::length, "m.")
      .def(
          "points_at",
          [](const FieldCurve& curve, const DoubleArray& lengths) {
            std::vector<Vector3d> points;
            for (double length : numbers_from(lengths, "lengths")) {
              points.push_back(curve.point_at(length));
            }
            return to_array(points);
          },
          py::arg("lengths"), "(k, 3), m: at lengths (k,), m, from the curve's beginning.")
      .def(
          "distances",
          [](const FieldCurve& curve, const DoubleArray& points) {
            std::vector<double> found;
            for (const Vector3d& p : points_from(points, "points")) {
              found.push_back(curve.foot(p).distance);
            }
            return to_array(found);
          },
          py::arg("points"), "(k,), m: of points (k, 3) from the curve.");
}

void bind_field(py::module_& module) {
  py::class_<ShapeField>(
      module, "ShapeField",
      "A field of influence around a base (Veelo 2004): it shifts what is near, or protects it. "
      "Its intensity is 1 at the base and falls smoothly to 0 at the extent.\n\n"
      "extent: m, positive. falloff: kappa of equation 3, from 0 (steep, a cusp at the base) to 1; "
      "above 0.9 curvature jumps at the extent. shift: m, of the base. Along a curve each may be a "
      "tuple (lengths (k,), values) for a spline by the length from the curve's beginning, m. "
      "protects: it keeps its base where it is instead. axes: the coordinates of shifts that it "
      "has a say in. ValueError for what is none of these.")
      .def_static(
          "at_point",
          [](const DoubleArray& point, const py::object& shift, const py::object& extent,
             const py::object& falloff, bool protects, const std::string& axes) {
            ShapeField field = field_from({extent, falloff, axes, protects});
            field.base = modelling::point_base(point_from(point, "point"));
            field.shift = vector_along(shift, "shift");
            return field;
          },
          py::arg("point"), py::arg("shift") = py::make_tuple(0.0, 0.0, 0.0), py::kw_only(),
          py::arg("extent"), py::arg("falloff") = 0.5, py::arg("protects") = false,
          py::arg("axes") = "xyz", "Around a point (3,), m.")
      .def_static(
          "at_plane",
          [](const DoubleArray& point, const DoubleArray& normal, const py::object& shift,
             const py::object& extent, const py::object& falloff, bool protects,
             const std::string& axes) {
            ShapeField field = field_from({extent, falloff, axes, protects});
            field.base =
                modelling::plane_base(point_from(point, "point"), point_from(normal, "normal"));
            field.shift = vector_along(shift, "shift");
            return field;
          },
          py::arg("point"), py::arg("normal"), py::arg("shift") = py::make_tuple(0.0, 0.0, 0.0),
          py::kw_only(), py::arg("extent"), py::arg("falloff") = 0.5, py::arg("protects") = false,
          py::arg("axes") = "xyz", "Around the plane through a point (3,), m, square to a normal.")
      .def_static(
          "along",
          [](const FieldCurve& curve, const py::object& shift, const py::object& extent,
             const py::object& falloff, bool protects, const std::string& axes) {
            ShapeField field = field_from({extent, falloff, axes, protects});
            field.base = modelling::curve_base(curve);
            field.shift = vector_along(shift, "shift");
            return field;
          },
          py::arg("curve"), py::arg("shift") = py::make_tuple(0.0, 0.0, 0.0), py::kw_only(),
          py::arg("extent"), py::arg("falloff") = 0.5, py::arg("protects") = false,
          py::arg("axes") = "xyz", "Around a FieldCurve.")
      .def_static(
          "of_region",
          [](const surface::LimitSurface& surface, const py::object& cells, const py::object& shift,
             const py::object& extent, const py::object& falloff, bool protects,
             const std::string& axes) {
            ShapeField field = field_from({extent, falloff, axes, protects});
            field.base = modelling::region_base(surface, integers_from(cells, "cells"));
            field.shift = vector_along(shift, "shift");
            return field;
          },
          py::arg("surface"), py::arg("cells"), py::arg("shift") = py::make_tuple(0.0, 0.0, 0.0),
          py::kw_only(), py::arg("extent"), py::arg("falloff") = 0.5, py::arg("protects") = false,
          py::arg("axes") = "xyz",
          "Around cells (k,) of a surface as it is now: all of them are base. Intensity falls from "
          "their rim by delta² (2 - delta) in place of delta, as curvature would jump at the rim "
          "else.")
      .def_static(
          "to_curve",
          [](const FieldCurve& curve, const FieldCurve& other, const py::object& extent,
             const py::object& falloff, const std::string& axes) {
            ShapeField field = field_from({extent, falloff, axes, false});
            field.change = std::make_shared<modelling::CurveChange>(curve, other);
            return field;
          },
          py::arg("curve"), py::arg("other"), py::kw_only(), py::arg("extent"),
          py::arg("falloff") = 0.5, py::arg("axes") = "xyz",
          "Around a FieldCurve, which becomes the other one: by lengths, and without a kink where "
          "the curves begin to differ. What they have in common at either end stays.")
      .def(
          "along_surface",
          [](const ShapeField& given,
             const std::shared_ptr<const modelling::GeodesicNet>& distances) {
            ShapeField field = given;
            if (!field.base) field.base = modelling::curve_base(field.change->curve());
            const py::gil_scoped_release release;
            field.base = modelling::along_surface(field.base, distances);
            return field;
          },
          py::arg("net"),
          "The same field with distances measured along a surface, by its GeodesicNet: asked "
          "for at points of that surface. ValueError for a base that is nowhere on it.");
}

}  // namespace

void bind_shape_fields(py::module_& module) {
  bind_field_curve(module);
  py::class_<modelling::GeodesicNet, std::shared_ptr<modelling::GeodesicNet>>(
      module, "GeodesicNet",
      "Distances along a surface as it is now, for ShapeField.along_surface: what is near through "
      "thin parts, or across the gap between two hulls, is far. Fronts march over a net of some "
      "50,000 points (Kimmel and Sethian 1998): within about two per cent.")
      .def(py::init<const surface::LimitSurface&, bool>(), py::arg("surface"), py::kw_only(),
           py::arg("mirrored") = false, py::call_guard<py::gil_scoped_release>(),
           "mirrored: the surface is a half, and ways lead over its image, too.");
  bind_field(module);
  py::class_<modelling::FieldPlaces>(
      module, "FieldPlaces",
      "Points (n, 3), m, at which fields are asked for again and again, as while a slider moves: "
      "where bases are nearest to them is kept, so that ShapeFields.at() takes a fraction of the "
      "time for other extents, falloffs or shifts.")
      .def(py::init([](const DoubleArray& points) {
             return std::make_unique<modelling::FieldPlaces>(points_from(points, "points"));
           }),
           py::arg("points"));
  py::class_<ShapeFields>(
      module, "ShapeFields",
      "Shape fields that together shift points of space. Protection comes first: within a "
      "protecting field no base gets all of its shift.")
      .def(py::init(
               [](const std::vector<ShapeField>& fields, bool mirrored, const std::string& blend) {
                 if (blend != "exact" && blend != "sum") {
                   throw std::invalid_argument("blend is 'exact' or 'sum', not '" + blend + "'.");
                 }
                 return std::make_unique<ShapeFields>(
                     fields, mirrored,
                     blend == "sum" ? modelling::FieldBlend::kSum : modelling::FieldBlend::kExact);
               }),
           py::arg("fields"), py::kw_only(), py::arg("mirrored") = false,
           py::arg("blend") = "exact",
           "mirrored: each works on both sides of the centre plane, as a half hull's must. blend: "
           "'exact': a base gets its own shift whatever other fields overlap there; 'sum': shifts "
           "add up (Veelo 2004, equation 2). ValueError, naming the field, for extents that are "
           "not positive, falloffs not from 0 to 1, and what is no number.")
      .def("at", &shifts_at, py::arg("points"),
           "(shifts (n, 3), m; gradients (n, 3, 3), of coordinate i by coordinate j of the point) "
           "at points (n, 3), m, or at FieldPlaces.")
      .def("deltas", &deltas_at, py::arg("field"), py::arg("points"),
           "(n,) distances of points (n, 3), m, from the base of a field, by its index, or from "
           "its image, divided by the extent.");
}

}  // namespace hull::bindings
