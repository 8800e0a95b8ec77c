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
#include "drawing/collect_lines.h"

namespace py = pybind11;

namespace hull::bindings {
namespace {

using Positions = DoubleArray;

Paper paper_from(const std::string& name) {
  if (name == "A4") return Paper::kA4;
  if (name == "A3") return Paper::kA3;
  if (name == "A2") return Paper::kA2;
  if (name == "A1") return Paper::kA1;
  if (name == "A0") return Paper::kA0;
  throw std::invalid_argument("paper is \"A4\", \"A3\", \"A2\", \"A1\" or \"A0\", not \"" + name +
                              "\".");
}

std::vector<double> positions_from(const Positions& array, const char* name) {
  if (array.ndim() != 1) {
    throw std::invalid_argument(std::string(name) + " must have shape (n,), not " +
                                std::to_string(array.ndim()) + " dimensions.");
  }
  return {array.data(), array.data() + array.size()};
}

}  // namespace
}  // namespace hull::bindings

PYBIND11_MODULE(_drawing, module) {
  using namespace hull::bindings;
  module.doc() = "Drawings on paper, by way of Cairo.";
  join_core(module);

  module.def(
      "write_lines_drawing",
      [](const hull::LimitSurface& surface, const std::filesystem::path& path,
         const Positions& stations, const Positions& waterlines, const Positions& buttocks,
         bool mirrored, const std::optional<double>& draft, const std::optional<double>& length,
         const std::optional<double>& station_spacing, const std::string& title,
         const std::vector<std::pair<std::string, std::string>>& particulars,
         const std::string& paper) {
        hull::LinesOptions options;
        options.stations = positions_from(stations, "stations");
        options.waterlines = positions_from(waterlines, "waterlines");
        options.buttocks = positions_from(buttocks, "buttocks");
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
