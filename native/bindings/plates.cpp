// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <map>
#include <stdexcept>

#include "bindings/arrays.h"
#include "bindings/production_classes.h"
#include "bindings/progress.h"
#include "bindings/rows.h"
#include "production/plates/flat_plate.h"

namespace hull::bindings {

using production::FlatPlate;
using production::Plating;
using production::SurfaceCurve;

namespace {

// A plate with the plating that it is of.
struct OnePlate {
  std::shared_ptr<const Plating> plating;
  int number;
  const production::Plate& plate() const { return plating->plates[number]; }
  std::string name_of(int curve) const {
    return curve < 0 ? "" : plating->shell->curves[curve].name;
  }
};

struct OneFlatPlate {
  OnePlate of;
  FlatPlate flat;
};

// Sides as pairs of name and points; a butt of both sides of the ship is one.
template <class Point>
py::list named_sides(const OnePlate& one, const std::vector<production::PlateSide>& loop,
                     std::vector<std::vector<Point>> lines) {
  std::vector<std::pair<std::string, std::vector<Point>>> joined;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const bool goes_on =
        i > 0 && loop[i].mirrored && !loop[i - 1].mirrored && loop[i].curve == loop[i - 1].curve;
    if (!goes_on) joined.emplace_back(one.name_of(loop[i].curve), std::vector<Point>());
    auto& line = joined.back().second;
    line.insert(line.end(), lines[i].begin() + (goes_on ? 1 : 0), lines[i].end());
  }
  // Where the loop begins within such a butt, its last line goes on as the first.
  if (joined.size() > 1 && loop.back().mirrored && loop.back().curve == loop.front().curve) {
    auto& first = joined.front().second;
    first.insert(first.begin(), joined.back().second.begin(), joined.back().second.end() - 1);
    joined.pop_back();
  }
  py::list sides;
  for (const auto& [name, line] : joined) sides.append(py::make_tuple(name, to_array(line)));
  return sides;
}

py::list plate_sides(const OnePlate& one) {
  py::list loops;
  for (const auto& loop : one.plate().loops) {
    std::vector<std::vector<Vector3d>> lines;
    for (const production::PlateSide& side : loop) {
      lines.push_back(production::side_points(*one.plating->shell, side));
    }
    loops.append(named_sides(one, loop, std::move(lines)));
  }
  return loops;
}

// Cells that the plate has triangles in, rising, and the area of these in each.
py::tuple plate_cells(const OnePlate& one) {
  std::map<int, double> areas;
  const production::ShellMesh& mesh = one.plating->shell->mesh;
  for (const int number : one.plate().triangles) {
    const production::ShellTriangle& t = mesh.triangles[number];
    const Vector3d& a = mesh.points[t.points[0]];
    const Vector3d normal = (mesh.points[t.points[1]] - a).cross(mesh.points[t.points[2]] - a);
    areas[t.cell] += 0.5 * normal.norm();
  }
  std::vector<int> cells;
  std::vector<double> parts;
  for (const auto& [cell, area] : areas) {
    cells.push_back(cell);
    parts.push_back(area);
  }
  return py::make_tuple(to_array(cells), to_array(parts));
}

// Of the outline, and of each hole.
py::list flat_plate_loops(const OneFlatPlate& one) {
  auto lines = production::flat_sides(one.flat, one.of.plate());
  py::list loops;
  for (std::size_t k = 0; k < lines.size(); ++k)
    loops.append(named_sides(one.of, one.of.plate().loops[k], std::move(lines[k])));
  return loops;
}

py::list marks_of(const OneFlatPlate& one, const SurfaceCurve& curve) {
  production::require_on(one.of.plating->shell->surface, curve);
  py::list marks;
  for (const production::FlatMark& mark : production::flat_marks(one.flat, curve)) {
    marks.append(py::make_tuple(to_array(mark.points), to_array(mark.on_hull)));
  }
  return marks;
}

py::array_t<double> flat_places(const OneFlatPlate& one, const py::object& cells,
                                const DoubleArray& uv) {
  const std::vector<int> numbers = integers_from(cells, "cells");
  const std::vector<Eigen::Vector2d> at = parameters_from(uv, "uv");
  if (numbers.size() != at.size()) {
    throw std::invalid_argument("cells and uv must be of equal length.");
  }
  std::vector<Eigen::Vector2d> places;
  const int count = one.of.plating->shell->surface.cell_count();
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (numbers[i] < 0 || numbers[i] >= count) {
      throw std::invalid_argument("cells[" + std::to_string(i) + "] is no cell of the surface.");
    }
    places.push_back(production::flat_place(one.flat, {numbers[i], at[i].x(), at[i].y()})
                         .value_or(Eigen::Vector2d::Constant(std::nan(""))));
  }
  return to_array(places);
}

void bind_flat_plate(py::module_& module) {
  py::class_<OneFlatPlate>(module, "FlatPlate",
                           "A plate laid out on a plane, as seen from the water, its longer way "
                           "along x, from (0, 0) on.")
      .def_property_readonly(
          "developed",
          [](const OneFlatPlate& one) {
            return one.flat.expansion == production::Expansion::kDeveloped;
          },
          "Whether it was developed without any strain; else it has the least energy of strain.")
      .def_property_readonly(
          "sides", [](const OneFlatPlate& one) { return py::list(flat_plate_loops(one)[0]); },
          "Of the outline, counter-clockwise: a list of pairs, the name of the curve there (\"\" "
          "on the hull's border) and points (k, 2), m.")
      .def_property_readonly(
          "holes",
          [](const OneFlatPlate& one) {
            const py::list loops = flat_plate_loops(one);
            return py::list(loops[py::slice(1, static_cast<py::ssize_t>(loops.size()), 1)]);
          },
          "Sides of each hole, as sides, but clockwise.")
      .def_property_readonly(
          "area", [](const OneFlatPlate& one) { return one.flat.area; }, "m².")
      .def_property_readonly(
          "stretch",
          [](const OneFlatPlate& one) {
            return py::make_tuple(one.flat.least_stretch, one.flat.largest_stretch);
          },
          "(least, largest): length on the hull over length on the flat plate, of all places and "
          "directions.")
      .def_property_readonly(
          "points", [](const OneFlatPlate& one) { return to_array(one.flat.nodes); },
          "(n, 2), m: nodes of the map of stretch.")
      .def_property_readonly(
          "triangles",
          [](const OneFlatPlate& one) {
            std::vector<std::array<int, 3>> rows;
            for (const auto& e : one.flat.mesh.elements) {
              rows.push_back({e.nodes[0], e.nodes[1], e.nodes[2]});
            }
            const int n = one.flat.mesh.node_count;
            for (std::size_t i = 0; one.flat.axis && i < one.flat.mesh.elements.size(); ++i) {
              // The mirror image turns the other way round, so two corners change places.
              rows.push_back({rows[i][1] + n, rows[i][0] + n, rows[i][2] + n});
            }
            return rows_of(rows);
          },
          "(k, 3) points.")
      .def_property_readonly(
          "stretches",
          [](const OneFlatPlate& one) {
            std::vector<Eigen::Vector2d> all = one.flat.stretches;
            if (one.flat.axis) all.insert(all.end(), all.begin(), all.end());
            return to_array(all);
          },
          "(k, 2) in the middles of triangles: the principal stretches, smaller first.")
      .def_property_readonly(
          "rolling_angle", [](const OneFlatPlate& one) { return one.flat.rolling_angle; },
          "rad from x: the direction of the roll by which the plate gets most of its bend.")
      .def_property_readonly(
          "rolling_radius", [](const OneFlatPlate& one) { return one.flat.rolling_radius; },
          "m, of that bend in the mean; infinite for a plane.")
      .def_property_readonly(
          "iterations", [](const OneFlatPlate& one) { return one.flat.iterations; },
          "Steps to the least energy.")
      .def_property_readonly(
          "stretch_error", [](const OneFlatPlate& one) { return one.flat.stretch_error; },
          "How far the least and largest stretch may be off, by how they changed as the map's "
          "cells were halved.")
      .def_property_readonly(
          "converged", [](const OneFlatPlate& one) { return one.flat.converged; },
          "Whether the energy is the least to rounding, and stretch_error below 0.0005.")
      .def("marks", &marks_of, py::arg("curve"),
           "The parts of a SurfaceCurve on the plate: a list of pairs, points on the flat plate "
           "(k, 2) and the same on the hull (k, 3), m. ValueError for a curve that is not on the "
           "surface as the plate was made of it.")
      .def("places", &flat_places, py::arg("cells"), py::arg("uv"),
           "Where places of the hull, cells (n,) and uv (n, 2), are on the flat plate: (n, 2), m; "
           "NaN beside the plate.");
}

void bind_plate(py::module_& module) {
  py::class_<OnePlate>(module, "Plate", "A region of the exact surface between seams and butts.")
      .def_readonly("number", &OnePlate::number, "In its Plating, from aft forward.")
      .def_property_readonly(
          "across", [](const OnePlate& one) { return one.plate().across; },
          "Whether it goes on to the other side of the centre plane: all is of both sides then.")
      .def_property_readonly(
          "centre_knuckle", [](const OnePlate& one) { return one.plate().centre_knuckle; },
          "rad: by how much it and its mirror image are bent in the centre plane, where "
          "across_centre asks for such plates; they are one up to largest_knuckle. None of others.")
      .def_property_readonly(
          "area", [](const OnePlate& one) { return one.plate().area; }, "m², of the exact surface.")
      .def_property_readonly(
          "centre", [](const OnePlate& one) { return one.plate().centre; }, "(3,) of the area, m.")
      .def_property_readonly(
          "box",
          [](const OnePlate& one) {
            return to_array(std::vector<Vector3d>{one.plate().box.min(), one.plate().box.max()});
          },
          "(2, 3): least and largest x, y, z of the points of its triangles, m.")
      .def_property_readonly(
          "loops", &plate_sides,
          "Its borders, the longest first, counter-clockwise seen from the water: lists of pairs, "
          "the name of the curve there (\"\" on the hull's border) and points (k, 3), m.")
      .def_property_readonly("cells", &plate_cells,
                             "(cells, areas), both (k,): the surface's cells that the plate has a "
                             "part of, rising, and "
                             "how large that is by its flat triangles, m²; of one side.")
      .def(
          "flat",
          [](const OnePlate& one, double poisson) {
            return OneFlatPlate{one, production::flat_plate(*one.plating, one.plate(), poisson)};
          },
          py::arg("poisson") = 0.3, py::call_guard<py::gil_scoped_release>(),
          "The FlatPlate: developed where the surface is developable, otherwise by the least "
          "energy of strain of an elastic sheet with Poisson's ratio. ValueError for a plate "
          "closed around the hull or bent far round, and for a ratio outside of [0, 0.5].");
}

}  // namespace

void bind_plates(py::module_& module) {
  bind_flat_plate(module);
  bind_plate(module);
  module.attr("LARGEST_KNUCKLE") = production::kLargestKnuckle;
  module.def(
      "plates",
      [](const surface::LimitSurface& surface, const std::vector<SurfaceCurve>& curves,
         std::optional<double> size, double largest_knuckle, bool across_centre,
         std::optional<py::list> left_out, const py::object& progress) {
        const production::PlatingOptions options{size.value_or(0.005 * surface.mesh().size()),
                                                 largest_knuckle, across_centre,
                                                 left_out.has_value(), progress_from(progress)};
        std::shared_ptr<const Plating> plating;
        {
          const py::gil_scoped_release release;
          plating = std::make_shared<const Plating>(production::plating(surface, curves, options));
        }
        for (const production::LooseStretch& loose : plating->loose) {
          left_out->append(
              py::make_tuple(plating->shell->curves[loose.curve].name, loose.length, loose.middle));
        }
        std::vector<OnePlate> all;
        for (int i = 0; i < static_cast<int>(plating->plates.size()); ++i) {
          all.push_back({plating, i});
        }
        return all;
      },
      py::arg("surface"), py::arg("curves"), py::kw_only(), py::arg("size") = py::none(),
      py::arg("largest_knuckle") = production::kLargestKnuckle, py::arg("across_centre") = false,
      py::arg("left_out") = py::none(), py::arg("progress") = py::none(),
      "The plates of a LimitSurface between curves (SurfaceCurve) and the surface's borders: a "
      "list of Plate, from aft forward. Their areas are those of the exact regions; they sum to "
      "the surface's. size: of the triangles by which plates are laid out, m; by default 0.005 of "
      "the mesh's size. largest_knuckle (rad; default 0.5°): what a plate may bend by along a "
      "line. across_centre: of half a hull, plates that end in the centre plane without a knuckle, "
      "and "
      "face up, down or along the ship, are one with their mirror image. left_out: a list; where "
      "it is given, stretches of curves that end within a plate are left out, and (name of the "
      "curve, length in m, place (3,)) is added to it for each curve. progress: called with the "
      "share done; what it raises ends the task. ValueError for a "
      "plate over a knuckle; for a curve with the same plate on both sides, as one that ends "
      "within a plate, without left_out or where it is a knuckle; for one that is not on the "
      "surface as it is.");
}

}  // namespace hull::bindings
