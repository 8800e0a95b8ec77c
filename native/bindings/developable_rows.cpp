// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <stdexcept>

#include "bindings/arrays.h"
#include "bindings/production_classes.h"
#include "production/developable/row_development.h"

namespace hull::bindings {
namespace {

using production::DevelopedRow;
using production::RuledRow;

// A row with its surface, whose points it starts from.
struct OneRow {
  surface::LimitSurface surface;
  RuledRow row;

  std::vector<Vector3d> control(const py::object& points) const {
    if (points.is_none()) return surface.mesh().points();
    std::vector<Vector3d> given = points_from(points.cast<DoubleArray>(), "points");
    if (given.size() != surface.mesh().points().size()) {
      throw std::invalid_argument("points must have a row for each control point of the surface.");
    }
    return given;
  }
};

py::array_t<double> rulings_of(const OneRow& one, int count, const py::object& points) {
  if (count < 1 || count > 1000) throw std::invalid_argument("count must be from 1 to 1,000.");
  const std::vector<Vector3d> control = one.control(points);
  std::vector<Vector3d> ends;
  for (int k = 0; k < one.row.span_count(); ++k) {
    const production::BezierChain a({one.row.curve(k, false, control)});
    const production::BezierChain b({one.row.curve(k, true, control)});
    for (int i = 0; i <= count; ++i) {
      const double t = static_cast<double>(i) / count;
      ends.push_back(a.at(t).point);
      ends.push_back(b.at(t).point);
    }
  }
  return to_array(ends).reshape(
      {static_cast<py::ssize_t>(ends.size() / 2), py::ssize_t{2}, py::ssize_t{3}});
}

py::array_t<double> warps_of(const OneRow& one, const py::object& points) {
  const std::vector<Vector3d> control = one.control(points);
  py::array_t<double> warps(one.row.span_count());
  for (int k = 0; k < one.row.span_count(); ++k) {
    warps.mutable_at(k) =
        production::largest_warp(one.row.curve(k, false, control), one.row.curve(k, true, control))
            .bound;
  }
  return warps;
}

DevelopedRow develop(const OneRow& one, double warp, double distance, const py::object& locked,
                     const py::object& held_points, const DoubleArray& held_normals,
                     const py::object& points) {
  production::RowLimits limits{warp, distance, integers_from(locked, "locked"), {}};
  const std::vector<int> held = integers_from(held_points, "held_points");
  const std::vector<Vector3d> normals = points_from(held_normals, "held_normals");
  if (held.size() != normals.size()) {
    throw std::invalid_argument("held_points and held_normals must be of equal length.");
  }
  for (std::size_t i = 0; i < held.size(); ++i) limits.held.emplace_back(held[i], normals[i]);
  const std::vector<Vector3d> control = one.control(points);
  const py::gil_scoped_release release;
  return production::developed_row(one.surface, one.row, control, limits);
}

}  // namespace

void bind_developable_rows(py::module_& module) {
  py::class_<DevelopedRow>(module, "DevelopedRow", "What came of RuledRow.develop().")
      .def_property_readonly(
          "points", [](const DevelopedRow& d) { return to_array(d.points); },
          "(n, 3), m: all control points.")
      .def_readonly("before", &DevelopedRow::before, "rad/m: no ruling had more warp.")
      .def_readonly("after", &DevelopedRow::after, "rad/m: no ruling has more warp.")
      .def_readonly("distance", &DevelopedRow::distance, "m: of the creases from where they were.")
      .def_readonly("iterations", &DevelopedRow::iterations, "Steps taken.")
      .def_readonly("reached", &DevelopedRow::reached, "Whether `after` is within the limit.");

  py::class_<OneRow>(
      module, "RuledRow",
      "Faces of a control mesh between two chains of creases or borders: surfaces "
      "of straight rulings between equal parameters of the creases' curves. It keeps to "
      "the surface as it is when made; points= tells of others.")
      .def(py::init([](const surface::LimitSurface& surface, const py::object& faces) {
             RuledRow row(surface, integers_from(faces, "faces"));
             // A copy of the surface, as it keeps to that.
             return OneRow{surface, std::move(row)};
           }),
           py::arg("surface"), py::arg("faces"),
           "faces: (k,) of the control mesh. ValueError for one without four points, or without "
           "creases or borders along two opposite sides, where a crease fades out, and for one "
           "whose surface is not just its rulings: where creases bend or meet at a point beside "
           "the row, or the face beyond has not four points, unless all is flat there.")
      .def_property_readonly(
          "points",
          [](const OneRow& one) {
            std::vector<int> own;
            for (std::size_t i = 0; i < one.row.points().size(); ++i) {
              if (one.row.is_own()[i]) own.push_back(one.row.points()[i]);
            }
            return own;
          },
          "Control points of its creases.")
      .def("warps", &warps_of, py::arg("points") = py::none(),
           "(k,) of each face, rad/m: no ruling has more warp. points (n, 3): control points in "
           "place of the surface's. Infinite where rulings have no length.")
      .def("rulings", &rulings_of, py::arg("count") = 4, py::arg("points") = py::none(),
           "(m, 2, 3), m: both ends of `count` + 1 rulings of each face. points: as of warps().")
      .def("develop", &develop, py::arg("warp"), py::arg("distance"), py::kw_only(),
           py::arg("locked") = py::tuple(), py::arg("held_points") = py::tuple(),
           py::arg("held_normals") = py::tuple(), py::arg("points") = py::none(),
           "DevelopedRow: the creases' control points moved, along the creases first, until no "
           "ruling has more warp (rad/m) than the limit, while the creases stay within a distance, "
           "m, of where they were. locked (n,): control points that stay; so do ends of creases. "
           "held_points (h,), held_normals (h, 3): points that move across their normal only. "
           "points: as of warps(). ValueError for limits that are not above 0, and where rulings "
           "have no length.");
}

}  // namespace hull::bindings
