// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "bindings/arrays.h"
#include "bindings/companion_module.h"
#include "bindings/figure_sheet.h"
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

// The first number, positions in m, names.
using Frames = std::tuple<int, std::vector<double>, std::vector<std::string>>;

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

drawing::LengthUnit length_unit_from(const std::string& name) {
  if (name == "m") return drawing::LengthUnit::kMetre;
  if (name == "ft") return drawing::LengthUnit::kFoot;
  throw std::invalid_argument("lengths_in is \"m\" or \"ft\", not \"" + name + "\".");
}

drawing::PlanViews views_from(const std::vector<std::string>& names) {
  drawing::PlanViews views{false, false, false};
  for (const std::string& name : names) {
    if (name == "profile") {
      views.profile = true;
    } else if (name == "half_breadth") {
      views.half_breadth = true;
    } else if (name == "body_plan") {
      views.body_plan = true;
    } else {
      throw std::invalid_argument(
          "A view is \"profile\", \"half_breadth\" or \"body_plan\", not \"" + name + "\".");
    }
  }
  return views;
}

using SpaceCurve = std::tuple<std::string, DoubleArray, DoubleArray>;

int layer_of(dxf::DxfDrawing& drawing, const std::string& name) {
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    if (drawing.layers[i].name == name) return static_cast<int>(i);
  }
  const bool is_name = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '-' || c == '_';
  });
  if (!is_name) {
    throw std::invalid_argument("A layer's name has letters, digits, - and _, unlike \"" + name +
                                "\".");
  }
  const int count = static_cast<int>(drawing.layers.size());
  // The first seven of AutoCAD's colours in turn.
  drawing.layers.push_back({name, 1 + count % 7, 0.25});
  return count;
}

void check_finite(const dxf::DxfSpaceSpline& spline) {
  const auto is_finite = [](const auto& point) { return point.allFinite(); };
  if (std::all_of(spline.points.begin(), spline.points.end(), is_finite) &&
      std::all_of(spline.knots.begin(), spline.knots.end(),
                  [](double k) { return std::isfinite(k); })) {
    return;
  }
  throw std::invalid_argument("A curve has knots or control points that are not finite.");
}

dxf::DxfDrawing drawing_of(const std::vector<SpaceCurve>& curves, dxf::DxfUnit unit) {
  if (curves.empty()) throw std::invalid_argument("There is no curve to be written.");
  dxf::DxfDrawing drawing;
  drawing.unit = unit;
  const double factor = unit == dxf::DxfUnit::kMillimetre ? 1000.0 : 1.0;
  for (const auto& [layer, knots, points] : curves) {
    dxf::DxfSpaceSpline spline{layer_of(drawing, layer), points_from(points, "control points"),
                               numbers_from(knots, "knots")};
    check_finite(spline);
    const bool rises = std::is_sorted(spline.knots.begin(), spline.knots.end());
    if (spline.points.size() < 4 || spline.knots.size() != spline.points.size() + 4 || !rises) {
      throw std::invalid_argument(
          "A cubic B-spline has four points or more, and four more knots, which rise.");
    }
    for (Eigen::Vector3d& point : spline.points) point *= factor;
    drawing.space_splines.push_back(std::move(spline));
  }
  return drawing;
}

}  // namespace
}  // namespace hull::bindings

PYBIND11_MODULE(_drawing, module) {
  using namespace hull::bindings;
  module.doc() = "Drawings on paper, by way of Cairo.";
  join_core(module);
  bind_plot(module);
  bind_figure_sheet(module);
  bind_shop_drawing(module);

  module.def(
      "write_lines_plan",
      [](const hull::surface::LimitSurface& surface, const std::filesystem::path& path,
         const DoubleArray& stations, const DoubleArray& waterlines, const DoubleArray& buttocks,
         const std::vector<std::pair<double, double>>& diagonals, bool mirrored,
         const std::optional<double>& draft, const std::optional<double>& length,
         const std::optional<double>& station_spacing, const std::optional<double>& frame_spacing,
         const std::optional<Frames>& frames, bool in_frames, bool offsets,
         const std::string& title, const Rows& title_rows, const Rows& particulars,
         const PaperName& paper, const std::optional<double>& scale, const std::string& dxf_unit,
         const std::optional<double>& tolerance, const std::vector<std::string>& views,
         const std::string& lengths_in, const py::object& progress) {
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
        if (frames) {
          const auto& [first, positions, names] = *frames;
          options.frames = hull::drawing::PlanFrames{first, positions, names};
        }
        options.in_frames = in_frames;
        options.offsets = offsets;
        options.title = title;
        options.title_rows = particulars_from(title_rows);
        options.particulars = particulars_from(particulars);
        options.paper = sheet_from(paper);
        options.scale_denominator = scale;
        options.dxf_unit = dxf_unit_from(dxf_unit);
        options.tolerance = tolerance;
        options.views = views_from(views);
        options.unit = length_unit_from(lengths_in);
        const py::gil_scoped_release release;
        hull::drawing::write_lines_drawing(surface, options, path.string());
      },
      py::arg("surface"), py::arg("path"), py::kw_only(), py::arg("stations"),
      py::arg("waterlines"), py::arg("buttocks"), py::arg("diagonals"), py::arg("mirrored"),
      py::arg("draft"), py::arg("length"), py::arg("station_spacing"), py::arg("frame_spacing"),
      py::arg("frames"), py::arg("in_frames"), py::arg("offsets"), py::arg("title"),
      py::arg("title_rows"), py::arg("particulars"), py::arg("paper"), py::arg("scale"),
      py::arg("dxf_unit"), py::arg("tolerance"), py::arg("views"), py::arg("lengths_in"),
      py::arg("progress"),
      "What write_lines_drawing does with all positions in m and all options given.");
  module.def(
      "write_curves_dxf",
      [](const std::vector<SpaceCurve>& curves, const std::filesystem::path& path,
         const std::string& unit) {
        const hull::dxf::DxfDrawing drawing = drawing_of(curves, dxf_unit_from(unit));
        const py::gil_scoped_release release;
        hull::dxf::write_dxf(drawing, path.string());
      },
      py::arg("curves"), py::arg("path"), py::kw_only(), py::arg("unit") = "m",
      "Writes cubic B-spline curves in space as a DXF file (release 2000), at true size in \"m\" "
      "or "
      "\"mm\". curves: (layer, knots (n + 4,), control points (n, 3) in m) each; a layer's name "
      "has "
      "letters, digits, - and _. The file is complete, or one of the same name is untouched. "
      "ValueError for no curves and what are none; OSError if it can't be written.");
  refuse_unmade_instances(module);
}
