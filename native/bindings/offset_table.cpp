// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/offsets/offset_table.h"

#include <pybind11/stl.h>

#include "bindings/arrays.h"

namespace hull::bindings {
namespace {

using T = analysis::OffsetTable;

template <class Value, class Take>
py::array_t<Value> grid(const std::vector<analysis::Offset>& offsets, std::size_t rows,
                        std::size_t columns, const Take& take) {
  py::array_t<Value> array({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)});
  Value* out = array.mutable_data();
  for (const analysis::Offset& offset : offsets) *out++ = take(offset);
  return array;
}

py::array_t<double> values(const std::vector<analysis::Offset>& offsets, const T& t,
                           std::size_t columns) {
  return grid<double>(offsets, t.stations.size(), columns,
                      [](const analysis::Offset& offset) { return offset.value; });
}

py::array_t<bool> marks(const std::vector<analysis::Offset>& offsets, const T& t,
                        std::size_t columns) {
  return grid<bool>(offsets, t.stations.size(), columns,
                    [](const analysis::Offset& offset) { return offset.on_knuckle; });
}

}  // namespace

void bind_offset_table(py::module_& module) {
  using F = analysis::FeatureOffsets;
  py::class_<F>(module, "FeatureOffsets",
                "Where a crease or border that runs along the hull meets the stations.")
      .def_readonly("name", &F::name, "\"Deck edge\", \"Knuckle 1\", ...")
      .def_property_readonly(
          "kind",
          [](const F& f) { return f.kind == surface::CreaseKind::kBorder ? "border" : "crease"; },
          "\"border\" or \"crease\".")
      .def_property_readonly(
          "half_breadths", [](const F& f) { return to_array(f.half_breadths); },
          "(s,) m; NaN at stations that it does not reach.")
      .def_property_readonly(
          "heights", [](const F& f) { return to_array(f.heights); }, "(s,) m, likewise.");

  py::class_<T>(module, "OffsetTable",
                "Half-breadths and heights of a hull's port half at its stations, m. Arrays have a "
                "row for each station; NaN where it has no such point.")
      .def_property_readonly(
          "stations", [](const T& t) { return to_array(t.stations); }, "(s,) x, m.")
      .def_property_readonly(
          "waterlines", [](const T& t) { return to_array(t.waterlines); }, "(w,) z, m.")
      .def_property_readonly(
          "buttocks", [](const T& t) { return to_array(t.buttocks); }, "(b,) y, m.")
      .def_property_readonly(
          "half_breadths",
          [](const T& t) { return values(t.half_breadths, t, t.waterlines.size()); },
          "(s, w) the largest y of the station at the waterline's height.")
      .def_property_readonly(
          "half_breadth_on_knuckle",
          [](const T& t) { return marks(t.half_breadths, t, t.waterlines.size()); },
          "(s, w) whether that point is on a knuckle.")
      .def_property_readonly(
          "heights", [](const T& t) { return values(t.heights, t, t.buttocks.size()); },
          "(s, b) the lowest z of the station at the buttock.")
      .def_property_readonly(
          "height_on_knuckle", [](const T& t) { return marks(t.heights, t, t.buttocks.size()); },
          "(s, b) whether that point is on a knuckle.")
      .def_readonly("features", &T::features, "List of FeatureOffsets, from below upwards.");

  module.def("offset_table", &analysis::offset_table, py::arg("surface"), py::kw_only(),
             py::arg("stations"), py::arg("waterlines"), py::arg("buttocks"),
             py::arg("mirrored") = true, py::call_guard<py::gil_scoped_release>(),
             "The OffsetTable at stations x, waterlines z and buttocks y >= 0 (m); the buttock 0 "
             "gives the heights of keel, stem and stern. Values are of the surface to 1e-7 of the "
             "mesh's size where the station crosses the waterline or buttock at an angle; where "
             "the hull is flat there, the flat part's edge. Raises ValueError for a position that "
             "is not finite, a negative buttock, more than 1000 of a kind, and a surface without "
             "a port side. mirrored: the surface is the port half, which counts twice; a whole "
             "hull may reach further to starboard.");
}

}  // namespace hull::bindings
