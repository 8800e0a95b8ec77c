// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/shown_points.h"

#include <algorithm>

#include "bindings/arrays.h"

namespace hull::bindings {
namespace {

// A view of the object's own numbers, which stay where they are.
py::array_t<float> coordinates(const py::object& self) {
  const std::vector<float>& numbers = self.cast<const surface::ShownPoints&>().coordinates();
  // The numbers stay at one address, as room for all images was kept when they were made; the view
  // keeps their owner alive.
  py::array_t<float> view({static_cast<py::ssize_t>(numbers.size() / 3), py::ssize_t{3}},
                          numbers.data(), self);
  view.attr("flags").attr("writeable") = false;
  return view;
}

py::array_t<bool> shared(const surface::ShownPoints& points) {
  py::array_t<bool> flags(static_cast<py::ssize_t>(points.shared().size()));
  std::transform(points.shared().begin(), points.shared().end(), flags.mutable_data(),
                 [](char flag) { return flag != 0; });
  return flags;
}

}  // namespace

void bind_shown_points(py::module_& module) {
  py::class_<surface::ShownPoints>(
      module, "ShownPoints",
      "The points of LimitSurface.tessellate(n) as programs that show them keep them: in single "
      "precision, in units of their own, of both sides. They follow a surface whose points move; "
      "only those of cells that have moved are computed again, by update(); before that they stay "
      "as they are when made, or were updated last.\n\n"
      "First come the points of the tessellation, in its order, then the mirror images (x, -y, z) "
      "of those that are off the centre plane. Points nearer to it than tolerances.ON_CENTRE_PLANE "
      "of the mesh's size are put on it, and both sides share them.")
      .def(py::init([](const surface::LimitSurface& surface, int n, bool mirrored,
                       double metres_per_unit) {
             const py::gil_scoped_release release;
             return surface::ShownPoints(surface, n, mirrored, metres_per_unit);
           }),
           py::arg("surface"), py::arg("n"), py::kw_only(), py::arg("mirrored"),
           py::arg("metres_per_unit") = 1.0, py::keep_alive<1, 2>(),
           "mirrored: whether the surface is one side of a hull, and the other is its image.")
      .def("update", &surface::ShownPoints::update, py::call_guard<py::gil_scoped_release>(),
           "After surface.set_points(). Returns whether both sides share the same points as "
           "before; if not, the images are numbered anew. Until then coordinates and shared tell "
           "what was shown last.")
      .def_property_readonly("coordinates", &coordinates,
                             "(m, 3) float32, in the units asked for; a view that the next "
                             "update() changes.")
      .def_property_readonly("shared", &shared,
                             "(k,) which points of the tessellation both sides share; all of them "
                             "where nothing is mirrored.");
}

}  // namespace hull::bindings
