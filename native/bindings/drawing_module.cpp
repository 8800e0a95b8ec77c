// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/arrays.h"
#include "bindings/companion_module.h"
#include "bindings/paper_names.h"
#include "bindings/plot.h"
#include "bindings/progress.h"
#include "bindings/shop_drawing.h"
#include "bindings/unmade_instances.h"
#include "drawing/lines_plan/collect_lines.h"

namespace py = pybind11;

namespace hull::bindings {
namespace {

// Pairs of name and value.
using Rows = std::vector<std::pair<std::string, std::string>>;

std::vector<drawing::Particular> particulars_from(const Rows& rows) {
  std::vector<drawing::Particular> particulars;
  for (const auto& [name, value] : rows) particulars.push_back({name, value});
  return particulars;
}

// "A3", or width and height in mm.
using PaperName = std::variant<std::string, std::pair<double, double>>;

drawing::PaperSize sheet_from(const PaperName& paper) {
  if (const auto* name = std::get_if<std::string>(&paper)) {
    return drawing::paper_size(paper_from(*name));
  }
  const auto& [width, height] = std::get<std::pair<double, double>>(paper);
  return drawing::own_paper_size(width, height);
}

dxf::DxfUnit dxf_unit_from(const std::string& name) {
  if (name == "m") return dxf::DxfUnit::kMetre;
  if (name == "mm") return dxf::DxfUnit::kMillimetre;
  throw std::invalid_argument("dxf_unit is \"m\" or \"mm\", not \"" + name + "\".");
}

}  // namespace
}  // namespace hull::bindings

PYBIND11_MODULE(_drawing, module) {
  using namespace hull::bindings;
  module.doc() = "Drawings on paper, by way of Cairo.";
  join_core(module);
  bind_plot(module);
  bind_shop_drawing(module);

  module.def(
      "write_lines_plan",
      [](const hull::surface::LimitSurface& surface, const std::filesystem::path& path,
         const DoubleArray& stations, const DoubleArray& waterlines, const DoubleArray& buttocks,
         const std::vector<std::pair<double, double>>& diagonals, bool mirrored,
         const std::optional<double>& draft, const std::optional<double>& length,
         const std::optional<double>& station_spacing, const std::optional<double>& frame_spacing,
         bool offsets, const std::string& title, const Rows& title_rows, const Rows& particulars,
         const PaperName& paper, const std::optional<double>& scale, const std::string& dxf_unit,
         const std::optional<double>& tolerance, const py::object& progress) {
        hull::drawing::LinesOptions options;
        options.progress = progress_from(progress);
        options.stations = numbers_from(stations, "stations");
        options.waterlines = numbers_from(waterlines, "waterlines");
        options.buttocks = numbers_from(buttocks, "buttocks");
        for (const auto& [height, angle] : diagonals) options.diagonals.push_back({height, angle});
        options.mirrored = mirrored;
        options.draft = draft;
        options.length = length;
        options.station_spacing = station_spacing;
        options.frame_spacing = frame_spacing;
        options.offsets = offsets;
        options.title = title;
        options.title_rows = particulars_from(title_rows);
        options.particulars = particulars_from(particulars);
        options.paper = sheet_from(paper);
        options.scale_denominator = scale;
        options.dxf_unit = dxf_unit_from(dxf_unit);
        options.tolerance = tolerance;
        const py::gil_scoped_release release;
        hull::drawing::write_lines_drawing(surface, options, path.string());
      },
      py::arg("surface"), py::arg("path"), py::kw_only(), py::arg("stations"),
      py::arg("waterlines"), py::arg("buttocks"), py::arg("diagonals"), py::arg("mirrored"),
      py::arg("draft"), py::arg("length"), py::arg("station_spacing"), py::arg("frame_spacing"),
      py::arg("offsets"), py::arg("title"), py::arg("title_rows"), py::arg("particulars"),
      py::arg("paper"), py::arg("scale"), py::arg("dxf_unit"), py::arg("tolerance"),
      py::arg("progress"),
      "What write_lines_drawing does with all positions in m and all options given.");
  refuse_unmade_instances(module);
}
