// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/shop_drawing.h"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <stdexcept>
#include <variant>

#include "bindings/arrays.h"
#include "bindings/paper_names.h"
#include "drawing/shop/shop_drawing.h"
#include "drawing/shop/shop_pens.h"

namespace hull::bindings {

using drawing::ShopDrawing;

namespace {

using PaperChoice = std::variant<std::string, std::pair<double, double>>;

drawing::PaperSize paper_choice(const PaperChoice& paper) {
  if (const auto* name = std::get_if<std::string>(&paper)) {
    return drawing::paper_size(paper_from(*name));
  }
  const auto& [width, height] = std::get<std::pair<double, double>>(paper);
  return drawing::own_paper_size(width, height);
}

// (k, 2), finite.
std::vector<Eigen::Vector2d> plane_points(const DoubleArray& array, const char* name) {
  const auto values = array.values(name);
  if (values.ndim() != 2 || values.shape(1) != 2 || values.shape(0) < 2) {
    throw std::invalid_argument(std::string(name) + " must have shape (k, 2), k at least 2.");
  }
  std::vector<Eigen::Vector2d> points;
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    points.emplace_back(values.at(i, 0), values.at(i, 1));
    if (!points.back().allFinite()) {
      throw std::invalid_argument(std::string(name) + " has numbers that are not finite.");
    }
  }
  return points;
}

}  // namespace

void bind_shop_drawing(py::module_& module) {
  py::class_<ShopDrawing>(module, "ShopDrawing",
                          "A drawing for the shop at true size: plates, templates, frames.")
      .def(py::init([](std::string title, std::vector<std::pair<std::string, std::string>> rows) {
             return ShopDrawing{std::move(title), std::move(rows), {}, {}};
           }),
           py::arg("title"), py::arg("rows") = py::list(),
           "rows: up to 16 pairs (name, value) below the title of the first sheet.")
      .def_readonly("title", &ShopDrawing::title, "On every sheet.")
      .def_property_readonly(
          "lines",
          [](const ShopDrawing& self) {
            py::list lines;
            for (const drawing::ShopLine& line : self.lines) {
              const std::string layer(drawing::shop_pen(line.layer).pen.layer);
              lines.append(py::make_tuple(layer, to_array(line.points)));
            }
            return lines;
          },
          "A list of (layer, points (k, 2) in mm at true size).")
      .def(
          "add_line",
          [](ShopDrawing& self, const std::string& layer, const DoubleArray& points) {
            self.lines.push_back({drawing::shop_layer(layer), plane_points(points, "points")});
          },
          py::arg("layer"), py::arg("points"),
          "A polyline (k, 2), mm at true size, y up, on a layer: \"OUTLINE\", \"FRAMES\", "
          "\"WATERLINES\", \"BUTTOCKS\", \"SEAMS\", \"ROLLING\", \"SHELL\", \"BASE\", "
          "\"STRETCH\" or \"HIDDEN\".")
      .def(
          "add_text",
          [](ShopDrawing& self, const std::string& text, const Eigen::Vector2d& position,
             double size, double angle, double lift) {
            if (!position.allFinite() || !std::isfinite(angle) || !std::isfinite(lift) ||
                !(size > 0.0)) {
              throw std::invalid_argument("A text needs a finite place and angle and a size.");
            }
            self.texts.push_back({text, position, size, angle, lift});
          },
          py::arg("text"), py::arg("position"), py::kw_only(), py::arg("size") = 5.0,
          py::arg("angle") = 0.0, py::arg("lift") = 0.0,
          "Words around a position (2,), mm at true size; size in mm on paper, angle in rad, lift "
          "by how much they are above it, mm on paper.")
      .def(
          "add",
          [](ShopDrawing& self, const ShopDrawing& other, const Eigen::Vector2d& shift) {
            if (!shift.allFinite()) throw std::invalid_argument("shift must be finite.");
            for (drawing::ShopLine line : other.lines) {
              for (Eigen::Vector2d& p : line.points) p += shift;
              self.lines.push_back(std::move(line));
            }
            for (drawing::ShopText text : other.texts) {
              text.position += shift;
              self.texts.push_back(std::move(text));
            }
          },
          py::arg("other"), py::arg("shift"),
          "Lines and words of another drawing, shifted by (2,) mm.")
      .def(
          "write",
          [](const ShopDrawing& self, const std::filesystem::path& path, const PaperChoice& paper,
             double scale) {
            const drawing::PaperSize size = paper_choice(paper);
            const py::gil_scoped_release release;
            drawing::write_shop_drawing(self, size, scale, path.string());
          },
          py::arg("path"), py::kw_only(), py::arg("paper") = "A3", py::arg("scale") = 1.0,
          "Writes the drawing, completely or not at all, by the end of the path's name: .pdf, a "
          "first sheet with all of it and then the sheets into which it is divided at the scale, "
          "which are trimmed at corner marks and abut there; .svg, one sheet; .dxf, in mm at true "
          "size whatever the scale. paper: \"A4\" to \"A0\" or (width, height) in mm. ValueError "
          "for another ending, for no lines, and for more than 400 sheets; OSError if the file "
          "can't be written.");
  module.def(
      "write_shop_booklet",
      [](const std::vector<ShopDrawing>& drawings, const std::filesystem::path& path,
         const PaperChoice& paper) {
        const drawing::PaperSize size = paper_choice(paper);
        const py::gil_scoped_release release;
        drawing::write_shop_booklet(drawings, size, path.string());
      },
      py::arg("drawings"), py::arg("path"), py::kw_only(), py::arg("paper") = "A3",
      "Writes many ShopDrawings as the pages of one .pdf, each at the largest usual scale at which "
      "it fits. paper: as ShopDrawing.write(). ValueError for no drawings, drawings without lines "
      "and another ending; OSError if the file can't be written.");
}

}  // namespace hull::bindings
