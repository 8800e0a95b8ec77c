// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/bend_sums.h"

#include <memory>
#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/classes.h"
#include "surface/limit_surface.h"

namespace hull::bindings {
namespace {

using modelling::BendPlace;
using modelling::BendSums;

struct BoundBendSums {
  BendSums sums;
  int point_count, cell_count;
};

py::tuple sum_of(const BoundBendSums& self, const DoubleArray& points, const py::object& cells,
                 const DoubleArray& uv, const DoubleArray& along, const DoubleArray& out,
                 bool is_cut) {
  const std::vector<Vector3d> control = points_from(points, "points");
  const std::vector<int> own = integers_from(cells, "cells");
  const std::vector<Eigen::Vector2d> at = parameters_from(uv, "uv");
  const std::vector<Vector3d> directions = points_from(along, "along");
  const std::vector<Vector3d> outs = points_from(out, "out");
  if (static_cast<int>(control.size()) != self.point_count) {
    throw std::invalid_argument("There must be " + std::to_string(self.point_count) +
                                " control points, not " + std::to_string(control.size()) + ".");
  }
  if (own.size() != at.size() || own.size() != directions.size() || own.size() != outs.size()) {
    throw std::invalid_argument("cells, uv, along and out must be of equal length.");
  }
  std::vector<BendPlace> places;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i] < 0 || own[i] >= self.cell_count) {
      throw std::invalid_argument("There is no cell " + std::to_string(own[i]) + ".");
    }
    places.push_back({own[i], at[i].x(), at[i].y(), directions[i], outs[i]});
  }
  const modelling::MoveCondition found =
      is_cut ? self.sums.of_sections(control, places) : self.sums.of_own_lines(control, places);
  return py::make_tuple(to_array(found.points), to_array(found.slopes));
}

}  // namespace

void bind_bend_sums(py::module_& module) {
  py::class_<BoundBendSums>(
      module, "BendSums",
      "How the bends of lines on a LimitSurface change with its control points: prepared once for "
      "all surfaces of one mesh but for its points.")
      .def(py::init([](const surface::LimitSurface& surface) {
             return std::make_unique<BoundBendSums>(
                 BoundBendSums{BendSums(surface), static_cast<int>(surface.mesh().points().size()),
                               surface.cell_count()});
           }),
           py::arg("surface"))
      .def("sum", &sum_of, py::arg("points"), py::arg("cells"), py::arg("uv"), py::arg("along"),
           py::arg("out"), py::kw_only(), py::arg("is_cut") = true,
           "(control points (k,), slopes (k, 3)), as conditions of moves have them: the sum over "
           "places of out · the change of the second derivative along a line. points (n, 3): of "
           "the control mesh; cells (m,), uv (m, 2): places; along (m, 3): unit tangents of the "
           "line; out (m, 3). is_cut: the line is cut out by a plane: what moves along the surface "
           "does not count; otherwise it goes with the surface, as a crease does. Places right at "
           "irregular points count nothing. ValueError for what is none of these.");
}

}  // namespace hull::bindings
