// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/limit_surface.h"

#include <pybind11/stl.h>

#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/places.h"
#include "surface/coarsened_mesh.h"
#include "surface/parallel_for.h"
#include "surface/refined_mesh.h"
#include "surface/sampling/grid_samples.h"

namespace hull::bindings {

Places places_from(const surface::LimitSurface& surface, const py::object& cells,
                   const DoubleArray& uv) {
  Places places{integers_from(cells, "cells"), parameters_from(uv, "uv")};
  if (places.cells.size() != places.uv.size()) {
    throw std::invalid_argument("cells and uv must be of equal length, not " +
                                std::to_string(places.cells.size()) + " and " +
                                std::to_string(places.uv.size()) + ".");
  }
  for (std::size_t i = 0; i < places.cells.size(); ++i) {
    if (places.cells[i] >= 0 && places.cells[i] < surface.cell_count()) continue;
    throw std::invalid_argument("cells[" + std::to_string(i) + "] is " +
                                std::to_string(places.cells[i]) + ", but the cells are 0 to " +
                                std::to_string(surface.cell_count() - 1) + ".");
  }
  return places;
}

namespace {

surface::Scheme scheme_from(const std::string& name) {
  if (name == "biermann") return surface::Scheme::kBiermann;
  if (name == "catmull_clark") return surface::Scheme::kCatmullClark;
  throw std::invalid_argument("scheme is \"biermann\" or \"catmull_clark\", not \"" + name + "\".");
}

// Bases of irregular corners, shared by all surfaces of the process.
const std::shared_ptr<surface::BasisCache>& shared_bases() {
  static const auto cache = std::make_shared<surface::BasisCache>();
  return cache;
}

template <class Function>
py::array_t<double> at_places(const surface::LimitSurface& surface, const py::object& cells,
                              const DoubleArray& uv, const Function& function) {
  const Places places = places_from(surface, cells, uv);
  std::vector<Vector3d> values(places.cells.size());
  {
    const py::gil_scoped_release release;
    surface::parallel_for(
        values.size(), surface::kAllProcessors, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            values[i] = function(places.cells[i], places.uv[i].x(), places.uv[i].y());
          }
        });
  }
  return to_array(values);
}

int checked_order(int order) {
  if (order >= 0 && order <= 2) return order;
  throw std::invalid_argument("derivatives is 0, 1 or 2, not " + std::to_string(order) + ".");
}

py::tuple evaluate(const surface::LimitSurface& surface, const py::object& cells,
                   const DoubleArray& uv, int derivatives) {
  const Places places = places_from(surface, cells, uv);
  const int order = checked_order(derivatives);
  constexpr int kArrays[] = {1, 3, 6};
  std::vector<std::vector<Vector3d>> values(kArrays[order],
                                            std::vector<Vector3d>(places.cells.size()));
  {
    const py::gil_scoped_release release;
    surface::parallel_for(
        places.cells.size(), surface::kAllProcessors, [&](std::size_t begin, std::size_t end) {
          surface::SurfaceJet jet;
          const Vector3d* parts[] = {&jet.point, &jet.du, &jet.dv, &jet.duu, &jet.duv, &jet.dvv};
          for (std::size_t i = begin; i < end; ++i) {
            surface.evaluate(places.cells[i], places.uv[i].x(), places.uv[i].y(), order, jet);
            for (std::size_t k = 0; k < values.size(); ++k) values[k][i] = *parts[k];
          }
        });
  }
  py::tuple result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) result[k] = to_array(values[k]);
  return result;
}

py::tuple evaluate_on_grid(const surface::LimitSurface& surface, int n, int derivatives) {
  surface::GridSamples samples;
  {
    const py::gil_scoped_release release;
    surface::evaluate_grid(surface, n, derivatives, samples, surface::kAllProcessors);
  }
  std::vector<const std::vector<Vector3d>*> parts{&samples.points};
  if (derivatives > 0) parts.insert(parts.end(), {&samples.du, &samples.dv});
  if (derivatives > 1) parts.insert(parts.end(), {&samples.duu, &samples.duv, &samples.dvv});
  py::tuple result(parts.size());
  for (std::size_t k = 0; k < parts.size(); ++k) {
    result[k] = to_array(*parts[k]).reshape({surface.cell_count(), n + 1, n + 1, 3});
  }
  return result;
}

void bind_coarsened_mesh(py::module_& module) {
  using C = surface::CoarsenedMesh;
  py::class_<C>(module, "CoarsenedMesh", "What LimitSurface.coarsened_mesh() returns.")
      .def_readonly("mesh", &C::mesh, "The coarser ControlMesh, with all tags.")
      .def_property_readonly(
          "points", [](const C& c) { return to_array(c.points); },
          "(n,) the points of the finer mesh that became its points.")
      .def_property_readonly(
          "faces",
          [](const C& c) {
            std::vector<int> faces;
            for (int h : c.cells) faces.push_back(h / 4);
            return to_array(faces);
          },
          "(cells,) the face of the finer mesh that is each of its cells, in the order of cells.")
      .def_readonly("rms", &C::rms,
                    "m, of the distances of the finer mesh's points from where the coarser one, "
                    "subdivided, has them.")
      .def_readonly("largest", &C::largest, "m, of these.")
      .def_readonly("largest_point", &C::largest_point, "The point of the finer mesh with it.");
}

}  // namespace

void bind_limit_surface(py::module_& module) {
  bind_coarsened_mesh(module);
  py::class_<surface::LimitSurface>(
      module, "LimitSurface",
      "The exact limit surface of a control mesh: a function of a cell and (u, v) in [0, 1]^2.\n\n"
      "Cells come in the order (face of the control mesh, corner of that face); (0, 0) is at the "
      "corner, (1, 0) halfway along the edge to the next corner, (1, 1) at the face's centre. "
      "Positions are exact to about 1e-14 of the mesh's size. Large arrays of places are shared "
      "out "
      "among the processors, which does not change the results. copy.copy() gives a surface of its "
      "own, of the same layout, much sooner than a new one is made.")
      .def(py::init([](const mesh::ControlMesh& mesh, const std::string& scheme) {
             // Everything that may be refused by name, before the GIL is released.
             const surface::Scheme chosen = scheme_from(scheme);
             const py::gil_scoped_release release;
             return surface::LimitSurface(mesh, chosen, shared_bases());
           }),
           py::arg("mesh"), py::arg("scheme") = "biermann",
           "scheme: \"biermann\" (tangent planes at creases) or \"catmull_clark\" (as Blender's "
           "Subdivision Surface modifier).")
      // No copy: it is asked for with every move of a point.
      .def_property_readonly("mesh", &surface::LimitSurface::mesh,
                             "The surface's own: after set_points() it has the points then set, "
                             "also where it was asked for before. mesh.with_points(mesh.points) "
                             "keeps those of now.")
      .def_property_readonly("scheme",
                             [](const surface::LimitSurface& s) {
                               return s.scheme() == surface::Scheme::kBiermann ? "biermann"
                                                                               : "catmull_clark";
                             })
      .def_property_readonly("cell_count", &surface::LimitSurface::cell_count)
      .def(
          "refined_mesh",
          [](const surface::LimitSurface& surface) {
            const py::gil_scoped_release release;
            return surface::refined_mesh(surface);
          },
          "The ControlMesh subdivided once by the scheme, with all tags: its surface is the same. "
          "Its faces are the cells, in their order, of four points each: the corner, the middle of "
          "the edge to the next corner, the face's, the middle of the edge to the one before. Its "
          "points are those of the mesh's points, then of its faces, then of its edges.")
      .def("coarsened_mesh", &surface::coarsened_mesh, py::call_guard<py::gil_scoped_release>(),
           "The reverse of refined_mesh(): the CoarsenedMesh that this surface's was subdivided "
           "from. Where its points were moved since, the sum of squares of the distances from "
           "where the coarser mesh has them is least. Raises ValueError, naming a point, where "
           "faces and creases are no subdivided ones.")
      .def(
          "positions",
          [](const surface::LimitSurface& surface, const py::object& cells, const DoubleArray& uv) {
            return at_places(surface, cells, uv, [&](int cell, double u, double v) {
              return surface.position(cell, u, v);
            });
          },
          py::arg("cells"), py::arg("uv"), "cells: (k,), uv: (k, 2). Returns (k, 3), m.")
      .def(
          "set_points",
          [](surface::LimitSurface& surface, const DoubleArray& points) {
            std::vector<Vector3d> moved = points_from(points, "points");
            const py::gil_scoped_release release;
            surface.set_points(std::move(moved));
          },
          py::arg("points"),
          "Moves the control points to (n, 3), m, on the same topology. Not to be called while "
          "another thread uses the surface. HullBody and MoveWatch of this surface refuse to "
          "answer until their update(); FormNumbers, MichellIntegral and HullCurves for good, and "
          "are made anew. All else keeps to the points that it was made of, ShownPoints until "
          "their update(), SurfaceTree until its refit().")
      // Layout and bases are shared, control points are its own.
      .def("__copy__", [](const surface::LimitSurface& surface) { return surface; })
      .def_property_readonly("revision", &surface::LimitSurface::revision,
                             "How often set_points() was called.")
      .def("evaluate", &evaluate, py::arg("cells"), py::arg("uv"), py::arg("derivatives") = 0,
           "cells: (k,), uv: (k, 2). Returns a tuple of (k, 3) arrays: the points; with "
           "derivatives=1 also those by u and v, with 2 also by uu, uv and vv, in m. Derivatives "
           "are with respect to the cell's (u, v); they do not exist at irregular corners and are "
           "zero there.")
      .def("evaluate_grid", &evaluate_on_grid, py::arg("n"), py::arg("derivatives") = 0,
           "The same on the grid (i/n, j/n) of every cell, n 1 to 256: arrays of shape (cells, "
           "n + 1, n + 1, 3), first index i along u.")
      .def(
          "normals",
          [](const surface::LimitSurface& surface, const py::object& cells, const DoubleArray& uv) {
            return at_places(surface, cells, uv, [&](int cell, double u, double v) {
              return surface.normal(cell, u, v);
            });
          },
          py::arg("cells"), py::arg("uv"),
          "cells: (k,), uv: (k, 2). Returns (k, 3) unit normals; zero where the surface has no "
          "tangent plane.");
}

}  // namespace hull::bindings
