// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bindings/arrays.h"
#include "bindings/companion_module.h"
#include "bindings/paper_names.h"
#include "bindings/plot.h"
#include "drawing/collect_lines.h"

namespace py = pybind11;

PYBIND11_MODULE(_drawing, module) {
  using namespace hull::bindings;
  module.doc() = "Drawings on paper, by way of Cairo.";
  join_core(module);
  bind_plot(module);

  module.def(
      "write_lines_drawing",
      [](const hull::LimitSurface& surface, const std::filesystem::path& path,
         const DoubleArray& stations, const DoubleArray& waterlines, const DoubleArray& buttocks,
         bool mirrored, const std::optional<double>& draft, const std::optional<double>& length,
         const std::optional<double>& station_spacing, const std::string& title,
         const std::vector<std::pair<std::string, std::string>>& particulars,
         const std::string& paper) {
        hull::LinesOptions options;
        options.stations = numbers_from(stations, "stations");
        options.waterlines = numbers_from(waterlines, "waterlines");
        options.buttocks = numbers_from(buttocks, "buttocks");
        options.mirrored = mirrored;
        options.draft = draft;
        options.length = length;
        options.station_spacing = station_spacing;
        options.title = title;
        for (const auto& [name, value] : particulars) options.particulars.push_back({name, value});
        options.paper = paper_from(paper);
        const py::gil_scoped_release release;
        hull::write_lines_drawing(surface, options, path.string());
      },
      py::arg("surface"), py::arg("path"), py::kw_only(), py::arg("stations"),
      py::arg("waterlines"), py::arg("buttocks"), py::arg("mirrored"),
      py::arg("draft") = py::none(), py::arg("length") = py::none(),
      py::arg("station_spacing") = py::none(), py::arg("title") = "",
      py::arg("particulars") = std::vector<std::pair<std::string, std::string>>{},
      py::arg("paper") = "A3",
      "Draw body plan, profile and half-breadth plan at one scale on one sheet; the ending of path "
      "chooses PDF, SVG or PNG. stations (x), waterlines (z) and buttocks (y >= 0) are (n,) "
      "positions in m, in any order. mirrored: the surface is the half y >= 0. draft (m) adds the "
      "design waterline, length (m, between perpendiculars from x = 0) AP and FP. A station is "
      "numbered by its x in units of station_spacing (m; default: the stations' distance, where "
      "all are multiples of it). particulars: up to 16 pairs (name, value) of texts for the title "
      "block. paper: \"A4\" to \"A0\". Raises ValueError if nothing can be drawn, OSError if the "
      "file can't be written; one of the same name is then untouched.");
}
