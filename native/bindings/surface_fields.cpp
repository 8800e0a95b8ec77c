// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/fairness/colour_scale.h"
#include "bindings/arrays.h"
#include "bindings/places.h"

namespace hull::bindings {
namespace {

constexpr std::pair<const char*, analysis::FieldKind> kKinds[] = {
    {"gaussian", analysis::FieldKind::kGaussian}, {"mean", analysis::FieldKind::kMean},
    {"maximum", analysis::FieldKind::kMaximum},   {"minimum", analysis::FieldKind::kMinimum},
    {"slope", analysis::FieldKind::kSlope},       {"distance", analysis::FieldKind::kDistance}};

analysis::FieldKind kind_from(const std::string& name) {
  for (const auto& [known, kind] : kKinds) {
    if (name == known) return kind;
  }
  throw std::invalid_argument(
      "kind is \"gaussian\", \"mean\", \"maximum\", \"minimum\", \"slope\" or, of a colour scale, "
      "\"distance\", not \"" +
      name + "\".");
}

// Of those that are of one surface alone.
analysis::FieldKind computed_kind_from(const std::string& name) {
  const analysis::FieldKind kind = kind_from(name);
  if (kind != analysis::FieldKind::kDistance) return kind;
  throw std::invalid_argument("A distance is that of two surfaces: see surface_distances().");
}

analysis::ColourScale::Mapping mapping_from(const std::string& name) {
  if (name == "linear") return analysis::ColourScale::Mapping::kLinear;
  if (name == "logarithmic") return analysis::ColourScale::Mapping::kLogarithmic;
  throw std::invalid_argument("mapping is \"linear\" or \"logarithmic\", not \"" + name + "\".");
}

Vector3d slope_direction(const std::optional<DoubleArray>& array) {
  if (!array) return Vector3d::UnitZ();
  const Vector3d direction = point_from(*array, "direction");
  const double length = direction.norm();
  if (!(length > 0.0) || !std::isfinite(length)) {
    throw std::invalid_argument("direction must not be zero, and be finite.");
  }
  return direction / length;
}

py::array_t<double> colour_array(const std::vector<analysis::Colour>& colours) {
  py::array_t<double> array({static_cast<py::ssize_t>(colours.size()), py::ssize_t{3}});
  double* out = array.mutable_data();
  for (const analysis::Colour& colour : colours) out = std::copy(colour.begin(), colour.end(), out);
  return array;
}

analysis::ColourScale scale_from(const DoubleArray& array, const std::string& kind,
                                 const std::optional<DoubleArray>& weights,
                                 const std::string& mapping, double percentile,
                                 const std::optional<std::array<double, 2>>& limits) {
  const analysis::FieldKind field = kind_from(kind);
  const analysis::ColourScale::Mapping chosen = mapping_from(mapping);
  if (limits) return {field, chosen, (*limits)[0], (*limits)[1]};
  return analysis::ColourScale::fit(
      numbers_from(array, "values"),
      weights ? numbers_from(*weights, "weights") : std::vector<double>{}, field, chosen,
      percentile);
}

template <class Value>
std::vector<Value> of_ticks(const analysis::ColourScale& scale,
                            Value analysis::ColourScale::Tick::*member) {
  std::vector<Value> values;
  for (const auto& tick : scale.ticks()) values.push_back(tick.*member);
  return values;
}

void bind_scale(py::module_& module) {
  py::class_<analysis::ColourScale>(
      module, "ColourScale",
      "From values of a field to colours, and to a legend. Curvatures and distances are blue "
      "below zero, nearly white at zero and orange above; slopes go from dark "
      "to light. Both can be read with any common colour blindness.")
      .def_property_readonly("low", &analysis::ColourScale::low,
                             "The value at position 0: 1/m², 1/m, rad or m.")
      .def_property_readonly("high", &analysis::ColourScale::high, "The value at position 1.")
      .def_property_readonly("signed", &analysis::ColourScale::is_signed,
                             "Whether 0 is in the middle and the range as wide to both sides.")
      .def_property_readonly("mapping",
                             [](const analysis::ColourScale& s) {
                               return s.mapping() == analysis::ColourScale::Mapping::kLinear
                                          ? "linear"
                                          : "logarithmic";
                             })
      .def_property_readonly("unit", &analysis::ColourScale::unit,
                             "Of the legend: \"1/m²\", \"1/m\", \"°\", \"mm\".")
      .def(
          "normalised",
          [](const analysis::ColourScale& s, const DoubleArray& array) {
            std::vector<double> values = numbers_from(array, "values");
            for (double& value : values) value = s.position(value);
            return to_array(values);
          },
          py::arg("values"), "Positions (k,) in [0, 1] of values (k,); NaN stays NaN.")
      .def(
          "colours",
          [](const analysis::ColourScale& s, const DoubleArray& array) {
            std::vector<analysis::Colour> colours;
            for (const double value : numbers_from(array, "values")) {
              colours.push_back(s.colour(value));
            }
            return colour_array(colours);
          },
          py::arg("values"), "sRGB (k, 3), each in [0, 1], of values (k,); grey for NaN.")
      .def(
          "legend_colours",
          [](const analysis::ColourScale& s, int n) {
            if (n < 2) throw std::invalid_argument("A legend has 2 colours or more.");
            std::vector<analysis::Colour> colours;
            for (int i = 0; i < n; ++i) colours.push_back(s.colour_at(i / (n - 1.0)));
            return colour_array(colours);
          },
          py::arg("n"), "sRGB (n, 3) at even positions from 0 to 1.")
      .def_property_readonly(
          "tick_values",
          [](const analysis::ColourScale& s) {
            return to_array(of_ticks(s, &analysis::ColourScale::Tick::value));
          },
          "(n,) round numbers in `unit`, rising.")
      .def_property_readonly(
          "tick_positions",
          [](const analysis::ColourScale& s) {
            return to_array(of_ticks(s, &analysis::ColourScale::Tick::position));
          },
          "(n,) in [0, 1].")
      .def_property_readonly(
          "tick_labels",
          [](const analysis::ColourScale& s) {
            return of_ticks(s, &analysis::ColourScale::Tick::label);
          },
          "List of n texts, without the unit.");
}

}  // namespace

void bind_surface_fields(py::module_& module) {
  bind_scale(module);
  module.def(
      "surface_field",
      [](const surface::LimitSurface& surface, const surface::Tessellation& tessellation,
         const std::string& kind, const std::optional<DoubleArray>& direction) {
        const analysis::FieldKind field = computed_kind_from(kind);
        const Vector3d along = slope_direction(direction);
        for (const int cell : tessellation.normal_cells) {
          if (cell < surface.cell_count()) continue;
          throw std::invalid_argument("The tessellation is not of this surface: make it anew.");
        }
        std::vector<double> values;
        {
          const py::gil_scoped_release release;
          values = analysis::surface_field(surface, tessellation, field, along);
        }
        return to_array(values);
      },
      py::arg("surface"), py::arg("tessellation"), py::kw_only(), py::arg("kind"),
      py::arg("direction") = py::none(),
      "A value (l,) for each of the tessellation's normals, so that both sides of a crease have "
      "their own: values[tessellation.normal_indices] are those of the quadrilaterals' corners.\n\n"
      "kind: \"gaussian\" curvature (1/m²), \"mean\", \"maximum\" or \"minimum\" (1/m; positive "
      "where the surface bulges into the water), or \"slope\": the angle (rad) between the normal "
      "and direction (3,), by default up. Values at irregular knots, where curvature may diverge, "
      "are means of their neighbours; NaN only for slopes where there is no tangent plane. "
      "ValueError for an unknown kind, a direction of no length, a tessellation of another "
      "surface.");
  module.def(
      "surface_field_at",
      [](const surface::LimitSurface& surface, const py::object& cells, const DoubleArray& uv,
         const std::string& kind, const std::optional<DoubleArray>& direction) {
        const analysis::FieldKind field = computed_kind_from(kind);
        const Vector3d along = slope_direction(direction);
        const Places places = places_from(surface, cells, uv);
        std::vector<double> values;
        {
          const py::gil_scoped_release release;
          values = analysis::surface_field(surface, places.cells, places.uv, field, along);
        }
        return to_array(values);
      },
      py::arg("surface"), py::arg("cells"), py::arg("uv"), py::kw_only(), py::arg("kind"),
      py::arg("direction") = py::none(),
      "The same (k,) at places: cells (k,), uv (k, 2). At irregular knots that at 2^-20 in u and v "
      "beside; NaN where there is no tangent plane.");
  module.def(
      "field_weights",
      [](const surface::Tessellation& tessellation) {
        return to_array(analysis::field_weights(tessellation));
      },
      py::arg("tessellation"),
      "The area (l,) in m² that each of the tessellation's normals stands for.");
  module.def(
      "colour_scale", &scale_from, py::arg("values"), py::kw_only(), py::arg("kind"),
      py::arg("weights") = py::none(), py::arg("mapping") = "linear", py::arg("percentile") = 0.98,
      py::arg("limits") = py::none(),
      "A ColourScale for values (k,) of a surface_field() of that kind, or of kind \"distance\" of "
      "surface_distances(). Its range is what "
      "the part `percentile` of the area stays within, by weights (k,), see "
      "field_weights(); or limits: (low, high), in 1/m², 1/m, rad or m. Curvatures "
      "and distances: as wide to both sides of 0.\n\n"
      "mapping: \"linear\", or \"logarithmic\": to both signs, nearly linear below 1/1000 "
      "of the range. ValueError for unknown names, weights of another length, a percentile "
      "outside of (0, 1], limits that do not rise.");
}

}  // namespace hull::bindings
