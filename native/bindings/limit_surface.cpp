// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/limit_surface.h"

#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/classes.h"

namespace hull::bindings {
namespace {

Scheme scheme_from(const std::string& name) {
  if (name == "biermann") return Scheme::kBiermann;
  if (name == "catmull_clark") return Scheme::kCatmullClark;
  throw std::invalid_argument("scheme is \"biermann\" or \"catmull_clark\", not \"" + name + "\".");
}

// Bases of irregular corners, shared by all surfaces of the process.
const std::shared_ptr<BasisCache>& shared_bases() {
  static const auto cache = std::make_shared<BasisCache>();
  return cache;
}

struct Places {
  std::vector<int> cells;
  std::vector<Eigen::Vector2d> uv;
};

Places places_from(const LimitSurface& surface, const py::object& cells, const DoubleArray& uv) {
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

template <class Function>
py::array_t<double> at_places(const LimitSurface& surface, const py::object& cells,
                              const DoubleArray& uv, const Function& function) {
  const Places places = places_from(surface, cells, uv);
  std::vector<Vector3d> values(places.cells.size());
  {
    const py::gil_scoped_release release;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = function(places.cells[i], places.uv[i].x(), places.uv[i].y());
    }
  }
  return to_array(values);
}

}  // namespace

void bind_limit_surface(py::module_& module) {
  py::class_<LimitSurface>(
      module, "LimitSurface",
      "The exact limit surface of a control mesh: a function of a cell and (u, v) in [0, 1]^2.\n\n"
      "Cells come in the order (face of the control mesh, corner of that face); (0, 0) is at the "
      "corner, (1, 0) halfway along the edge to the next corner, (1, 1) at the face's centre. "
      "Positions are exact to about 1e-14 of the mesh's size. Immutable.")
      .def(py::init([](const ControlMesh& mesh, const std::string& scheme) {
             const Scheme chosen = scheme_from(scheme);
             const py::gil_scoped_release release;
             return LimitSurface(mesh, chosen, shared_bases());
           }),
           py::arg("mesh"), py::arg("scheme") = "biermann",
           "scheme: \"biermann\" (tangent planes at creases) or \"catmull_clark\" (as Blender's "
           "Subdivision Surface modifier).")
      .def_property_readonly("mesh", &LimitSurface::mesh)
      .def_property_readonly("scheme",
                             [](const LimitSurface& s) {
                               return s.scheme() == Scheme::kBiermann ? "biermann"
                                                                      : "catmull_clark";
                             })
      .def_property_readonly("cell_count", &LimitSurface::cell_count)
      .def(
          "positions",
          [](const LimitSurface& surface, const py::object& cells, const DoubleArray& uv) {
            return at_places(surface, cells, uv, [&](int cell, double u, double v) {
              return surface.position(cell, u, v);
            });
          },
          py::arg("cells"), py::arg("uv"), "cells: (k,), uv: (k, 2). Returns (k, 3), m.")
      .def(
          "normals",
          [](const LimitSurface& surface, const py::object& cells, const DoubleArray& uv) {
            return at_places(surface, cells, uv, [&](int cell, double u, double v) {
              return surface.normal(cell, u, v);
            });
          },
          py::arg("cells"), py::arg("uv"),
          "cells: (k,), uv: (k, 2). Returns (k, 3) unit normals; zero where the surface has no "
          "tangent plane.");
}

}  // namespace hull::bindings
