// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/plot.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bindings/arrays.h"
#include "bindings/paper_names.h"
#include "drawing/plots/plot_layout.h"

namespace hull::bindings {

namespace py = pybind11;

namespace {

using Rgb = std::array<double, 3>;

drawing::LineStyle style_from(const std::string& name) {
  if (name == "solid") return drawing::LineStyle::kSolid;
  if (name == "dashed") return drawing::LineStyle::kDashed;
  if (name == "dotted") return drawing::LineStyle::kDotted;
  if (name == "chain") return drawing::LineStyle::kChain;
  throw std::invalid_argument("style is \"solid\", \"dashed\", \"dotted\" or \"chain\", not \"" +
                              name + "\".");
}

std::optional<drawing::Ink> colour_from(const std::optional<Rgb>& colour) {
  if (!colour) return std::nullopt;
  for (const double part : *colour) {
    if (!(part >= 0.0 && part <= 1.0)) {
      throw std::invalid_argument("a colour is (red, green, blue), each in [0, 1], not " +
                                  std::to_string(part) + ".");
    }
  }
  return drawing::Ink{(*colour)[0], (*colour)[1], (*colour)[2]};
}

drawing::PlotAxis axis_from(std::string label, std::string unit,
                            const std::optional<std::pair<double, double>>& range, bool from_zero) {
  drawing::PlotAxis axis{std::move(label), std::move(unit), std::nullopt, from_zero};
  if (range) axis.range = drawing::PlotRange{range->first, range->second};
  return axis;
}

int add_curve(drawing::Plot& plot, const std::string& name, const DoubleArray& x,
              const DoubleArray& y, const std::string& symbol, int x_axis,
              const std::optional<Rgb>& colour, const std::string& style, bool guide) {
  plot.curves.push_back({name, symbol, numbers_from(x, "x"), numbers_from(y, "y"), x_axis,
                         colour_from(colour), style_from(style), guide});
  return static_cast<int>(plot.curves.size()) - 1;
}

py::tuple to_tuple(const drawing::Ink& colour) {
  return py::make_tuple(colour.red, colour.green, colour.blue, colour.opacity);
}

py::list strokes_of(const drawing::Sheet& sheet) {
  py::list strokes;
  for (const drawing::Stroke& stroke : sheet.strokes) {
    py::tuple dashes;
    if (stroke.pen.dashes != drawing::Dashes{}) dashes = py::cast(stroke.pen.dashes);
    strokes.append(py::make_tuple(to_array(stroke.points), to_tuple(stroke.pen.colour),
                                  stroke.pen.width, dashes));
  }
  return strokes;
}

py::list fills_of(const std::vector<drawing::Fill>& fills) {
  py::list all;
  for (const drawing::Fill& fill : fills) {
    all.append(py::make_tuple(to_array(fill.points), to_tuple(fill.colour)));
  }
  return all;
}

py::list labels_of(const drawing::Sheet& sheet) {
  py::list labels;
  for (const drawing::Label& label : sheet.labels) {
    py::dict entry;
    entry["text"] = label.text;
    entry["size"] = label.size;
    entry["bold"] = label.bold;
    entry["colour"] = to_tuple(label.ink);
    entry["knockout"] = label.knockout;
    entry["descent"] = label.descent;
    entry["centre"] = py::make_tuple(label.box.centre.x(), label.box.centre.y());
    entry["half"] = py::make_tuple(label.box.half.x(), label.box.half.y());
    entry["angle"] = label.box.angle;
    labels.append(entry);
  }
  return labels;
}

void bind_description(py::module_& module) {
  py::class_<drawing::Plot>(
      module, "Plot",
      "A diagram of curves over axes: what is to be drawn, in the units of its axes. "
      "All curves share the y axis; several x axes share the grid.")
      .def(py::init([](const std::string& title, const std::vector<std::string>& subtitles) {
             drawing::Plot plot;
             plot.title = title;
             plot.subtitles = subtitles;
             return plot;
           }),
           py::arg("title") = "", py::arg("subtitles") = std::vector<std::string>{})
      .def(
          "add_x_axis",
          [](drawing::Plot& plot, std::string label, std::string unit,
             const std::optional<std::pair<double, double>>& range, bool from_zero) {
            plot.x_axes.push_back(axis_from(std::move(label), std::move(unit), range, from_zero));
            return static_cast<int>(plot.x_axes.size()) - 1;
          },
          py::arg("label"), py::arg("unit") = "", py::kw_only(), py::arg("range") = py::none(),
          py::arg("from_zero") = false,
          "Its number. range: (low, high), else what the curves need; from_zero shows zero too.")
      .def(
          "set_y_axis",
          [](drawing::Plot& plot, std::string label, std::string unit,
             const std::optional<std::pair<double, double>>& range, bool from_zero) {
            plot.y_axis = axis_from(std::move(label), std::move(unit), range, from_zero);
          },
          py::arg("label"), py::arg("unit") = "", py::kw_only(), py::arg("range") = py::none(),
          py::arg("from_zero") = false)
      .def("add_curve", &add_curve, py::arg("name"), py::arg("x"), py::arg("y"), py::kw_only(),
           py::arg("symbol") = "", py::arg("x_axis") = 0, py::arg("colour") = py::none(),
           py::arg("style") = "solid", py::arg("guide") = false,
           "A curve through points x (n,), y (n,); its number. A number that is not finite "
           "interrupts it. symbol: a short text set on the curve. colour: (red, green, blue) in "
           "[0, 1]. style: \"solid\", \"dashed\", \"dotted\" or \"chain\". guide: thin, and the "
           "axes are not widened for it. Without a name it is not in the legend.")
      .def(
          "add_marker",
          [](drawing::Plot& plot, double x, double y, const std::string& label, int curve) {
            plot.markers.push_back({x, y, label, curve});
          },
          py::arg("x"), py::arg("y"), py::arg("label"), py::kw_only(), py::arg("curve") = -1,
          "A dot with a text, in the scale and colour of a curve.")
      .def(
          "add_line",
          [](drawing::Plot& plot, const std::optional<double>& x, const std::optional<double>& y,
             const std::string& label) {
            if (x.has_value() == y.has_value()) {
              throw std::invalid_argument("a line needs either x or y.");
            }
            plot.lines.push_back({x ? *x : *y, x.has_value(), label});
          },
          py::kw_only(), py::arg("x") = py::none(), py::arg("y") = py::none(),
          py::arg("label") = "", "A line across the diagram, at an x of the first axis or at a y.")
      .def(
          "add_area",
          [](drawing::Plot& plot, int curve, double from, double to, const std::string& label) {
            plot.areas.push_back({curve, from, to, label});
          },
          py::arg("curve"), py::arg("start"), py::arg("end"), py::arg("label"),
          "Shades what is between a curve and y = 0 from one x to another.")
      .def(
          "add_bar",
          [](drawing::Plot& plot, double length, const std::string& label) {
            plot.bars.push_back({length, label});
          },
          py::arg("length"), py::arg("label"),
          "A bar below the diagram that shows what a length along the first x axis stands for.")
      .def_readonly("title", &drawing::Plot::title)
      .def_readonly("subtitles", &drawing::Plot::subtitles)
      .def_property_readonly("curve_names",
                             [](const drawing::Plot& plot) {
                               std::vector<std::string> names;
                               for (const drawing::PlotCurve& curve : plot.curves) {
                                 names.push_back(curve.name);
                               }
                               return names;
                             })
      .def(
          "__eq__", [](const drawing::Plot& a, const drawing::Plot& b) { return a == b; },
          py::is_operator());
}

void bind_sheet(py::module_& module) {
  py::class_<drawing::PlotSheet>(
      module, "PlotSheet",
      "A plot laid out: lines, areas and texts in mm, from the page's upper left "
      "corner, x to the right, y down. Colours are (red, green, blue, opacity). "
      "Drawn in the order areas, strokes, patches, labels.")
      .def_readonly("width", &drawing::PlotSheet::width, "mm.")
      .def_readonly("height", &drawing::PlotSheet::height, "mm.")
      .def_property_readonly(
          "strokes", [](const drawing::PlotSheet& sheet) { return strokes_of(sheet); },
          "[(points (n, 2), colour, width in mm, dashes in mm or ())].")
      .def_property_readonly(
          "areas", [](const drawing::PlotSheet& sheet) { return fills_of(sheet.areas); },
          "[(points (n, 2) of a polygon, colour)].")
      .def_property_readonly(
          "patches", [](const drawing::PlotSheet& sheet) { return fills_of(sheet.patches); },
          "As areas, above the strokes.")
      .def_property_readonly(
          "labels", [](const drawing::PlotSheet& sheet) { return labels_of(sheet); },
          "Dictionaries: text; size, the font's em; bold; colour; knockout, whether paper is "
          "blanked beneath; descent, from the box's lower side up to the baseline; centre and half "
          "(width, height) of the box; angle in radians, from x towards y, about the centre.")
      .def_property_readonly(
          "diagram",
          [](const drawing::PlotSheet& sheet) {
            const auto& area = sheet.frame.area;
            return py::make_tuple(area.min().x(), area.min().y(), area.max().x(), area.max().y());
          },
          "(left, top, right, bottom) of the rectangle between the axes.");
}

}  // namespace

void bind_plot(py::module_& module) {
  bind_description(module);
  bind_sheet(module);
  module.def(
      "lay_out_plot",
      [](const drawing::Plot& plot, double width_mm, double height_mm, double margin_mm) {
        return drawing::lay_out_plot(plot, {width_mm, height_mm, margin_mm});
      },
      py::arg("plot"), py::kw_only(), py::arg("width_mm"), py::arg("height_mm"),
      py::arg("margin_mm") = 3.0, py::call_guard<py::gil_scoped_release>(),
      "Everything in its place on a page. Raises ValueError when 40 mm do not remain between the "
      "margins, or naming what of the plot cannot be drawn.");
  module.def(
      "write_plot",
      [](const drawing::Plot& plot, const std::filesystem::path& path, const std::string& paper) {
        const drawing::Paper chosen = paper_from(paper);
        const py::gil_scoped_release release;
        drawing::write_plot(plot, path.string(), chosen);
      },
      py::arg("plot"), py::arg("path"), py::kw_only(), py::arg("paper") = "A4",
      "Draw a plot on paper; the ending of path chooses PDF, SVG or PNG. paper: \"A4\" to \"A0\", "
      "landscape. Raises ValueError naming what cannot be drawn, OSError if the file can't be "
      "written; one of the same name is then untouched.");
}

}  // namespace hull::bindings
