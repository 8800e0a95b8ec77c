// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/figure_sheet.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "bindings/arrays.h"
#include "drawing/paper/canvas.h"
#include "drawing/paper/sheet_builder.h"
#include "drawing/paper/text_meter.h"
#include "drawing/pictures/seen_values.h"

namespace hull::bindings {

using drawing::SheetBuilder;
using Eigen::Vector2d;

namespace {

constexpr double kLargestSide = 10000.0;  // mm
constexpr int kMostDots = 20000;          // along a side of a picture

// Red, green and blue, and perhaps opacity.
using ColourNumbers = std::vector<double>;

drawing::Ink colour_from(const ColourNumbers& parts) {
  bool fits = parts.size() == 3 || parts.size() == 4;
  for (const double part : parts) fits = fits && part >= 0.0 && part <= 1.0;
  if (!fits) throw std::invalid_argument("A colour is 3 or 4 numbers between 0 and 1.");
  return {parts[0], parts[1], parts[2], parts.size() == 4 ? parts[3] : 1.0};
}

drawing::PagePath path_from(const DoubleArray& array) {
  const auto values = array.values("points");
  if (values.ndim() != 2 || values.shape(1) != 2) {
    throw std::invalid_argument("points must have shape (n, 2).");
  }
  drawing::PagePath path;
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    path.emplace_back(values.at(i, 0), values.at(i, 1));
    if (!path.back().allFinite()) {
      throw std::invalid_argument("points has numbers that are not finite.");
    }
  }
  return path;
}

SheetBuilder new_sheet(const std::string& title, double width, double height) {
  if (!(width > 0.0 && height > 0.0 && width <= kLargestSide && height <= kLargestSide)) {
    throw std::invalid_argument("The sides of a sheet are above 0 and at most 10 m.");
  }
  return SheetBuilder({title, width, height, {}, {}, {}, {}});
}

using DotArray = py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>;

void show(SheetBuilder& sheet, const Vector2d& corner, const Vector2d& size, const DotArray& dots) {
  if (dots.ndim() != 3 || dots.shape(2) != 3 || dots.size() == 0 || dots.shape(0) > kMostDots ||
      dots.shape(1) > kMostDots || !corner.allFinite() || !(size.minCoeff() > 0.0)) {
    throw std::invalid_argument(
        "A picture has dots (rows, columns, 3), up to 20 000 along a side, and a size.");
  }
  drawing::Picture picture{
      corner, size, static_cast<int>(dots.shape(1)), static_cast<int>(dots.shape(0)), {}};
  const std::uint8_t* at = dots.data();
  picture.dots.resize(static_cast<std::size_t>(picture.columns) * picture.rows);
  for (std::uint32_t& dot : picture.dots) {
    // 0xRRGGBB, as a Picture has them.
    dot = std::uint32_t{at[0]} << 16 | std::uint32_t{at[1]} << 8 | at[2];
    at += 3;
  }
  sheet.show(std::move(picture));
}

void draw_line(SheetBuilder& sheet, const DoubleArray& points, double width,
               const ColourNumbers& colour, const drawing::Dashes& dashes) {
  sheet.draw({width, colour_from(colour), dashes}, path_from(points));
}

void put_text(SheetBuilder& sheet, const Vector2d& at, const std::string& words, double size,
              const ColourNumbers& colour, double align, bool bold, bool blank) {
  if (!at.allFinite() || !(size > 0.0)) {
    throw std::invalid_argument("A text needs a finite place and a size.");
  }
  const drawing::TextStyle style{size, bold, colour_from(colour), blank};
  drawing::OrientedBox box = SheetBuilder::text_box(words, style, at);
  // The box is centred; it is moved by half its width to the right for 0, to the left for 1.
  box.centre.x() += (1.0 - 2.0 * align) * box.half.x();
  sheet.put_text(words, style, box);
}

using FloatArray = py::array_t<float, py::array::c_style | py::array::forcecast>;

drawing::ValuedTriangles valued_from(const DoubleArray& points, const FloatArray& values,
                                     const py::object& triangles) {
  drawing::ValuedTriangles given{points_from(points, "points"), {}, 0, {}};
  for (std::size_t i = 0; i < given.points.size(); ++i) {
    if (given.points[i].allFinite()) continue;
    throw std::invalid_argument("points[" + std::to_string(i) + "] is not finite.");
  }
  if (values.ndim() != 2 || values.shape(0) != static_cast<py::ssize_t>(given.points.size())) {
    throw std::invalid_argument("values must have shape (n, k), a row for each point.");
  }
  given.count = static_cast<int>(values.shape(1));
  given.values.assign(values.data(), values.data() + values.size());
  given.triangles = triangles_from(triangles, given.points.size());
  return given;
}

py::tuple seen(const DoubleArray& points, const FloatArray& values, const py::object& triangles,
               int width, int height) {
  if (width < 1 || height < 1 || width > kMostDots || height > kMostDots) {
    throw std::invalid_argument("A picture has 1 to 20 000 dots along a side.");
  }
  const drawing::ValuedTriangles given = valued_from(points, values, triangles);
  drawing::SeenValues found;
  {
    const py::gil_scoped_release release;
    found = drawing::seen_values(given, width, height);
  }
  const auto rows = static_cast<py::ssize_t>(found.dots.size());
  py::array_t<float> there({rows, py::ssize_t{given.count}});
  std::copy(found.values.begin(), found.values.end(), there.mutable_data());
  return py::make_tuple(to_array(found.dots), there);
}

}  // namespace

void bind_figure_sheet(py::module_& module) {
  py::class_<SheetBuilder>(module, "FigureSheet",
                           "A page that is drawn on: mm from its upper left corner, x to the "
                           "right, y down. Pictures are below areas, these below lines, these "
                           "below patches, and texts are above all. Colours are red, green, blue, "
                           "and perhaps opacity, 0 to 1.")
      .def(py::init(&new_sheet), py::arg("title"), py::arg("width"), py::arg("height"))
      .def("picture", &show, py::arg("corner"), py::arg("size"), py::arg("dots"),
           "dots (rows, columns, 3), 0 to 255, over a width and a height from a corner.")
      .def(
          "area",
          [](SheetBuilder& sheet, const DoubleArray& points, const ColourNumbers& colour) {
            sheet.shade(colour_from(colour), path_from(points));
          },
          py::arg("points"), py::arg("colour"), "A polygon (n, 2) that is filled.")
      .def("line", &draw_line, py::arg("points"), py::arg("width"), py::arg("colour"),
           py::arg("dashes") = drawing::Dashes{}, "A polyline (n, 2); dashes: four lengths, mm.")
      .def(
          "patch",
          [](SheetBuilder& sheet, const DoubleArray& points, const ColourNumbers& colour) {
            sheet.fill(colour_from(colour), path_from(points));
          },
          py::arg("points"), py::arg("colour"), "A polygon (n, 2) that is filled, above lines.")
      .def("text", &put_text, py::arg("at"), py::arg("words"), py::arg("size"), py::arg("colour"),
           py::arg("align"), py::arg("bold") = false, py::arg("blank") = false,
           "Words of an em of size mm, the middle of their capitals at a place: align 0 begins "
           "there, 0.5 is centred, 1 ends there. blank: what is below them is left out.")
      .def(
          "write",
          [](const SheetBuilder& sheet, const std::filesystem::path& path) {
            const py::gil_scoped_release release;
            // A copy is written: the page may be drawn on further.
            drawing::write_sheet(SheetBuilder(sheet).finish(), path.string());
          },
          py::arg("path"),
          "As .pdf, .svg or .png, completely or not at all. ValueError for another ending, OSError "
          "if the file can't be written.");
  module.def(
      "text_width",
      [](const std::string& words, double size, bool bold) {
        return drawing::text_size(words, size, bold).width;
      },
      py::arg("words"), py::arg("size"), py::arg("bold") = false,
      "Of words with an em of size mm, as drawings have them, mm.");
  module.def("seen_values", &seen, py::arg("points"), py::arg("values"), py::arg("triangles"),
             py::kw_only(), py::arg("width"), py::arg("height"),
             "(dots (s,), values (s, k)): of the dots that show triangles (m, 3), numbered row by "
             "row from above, the values (n, k) of what is nearest to the eye there, linear within "
             "triangles; points (n, 3) in dots, x to the right, y down, z towards the eye.");
}

}  // namespace hull::bindings
