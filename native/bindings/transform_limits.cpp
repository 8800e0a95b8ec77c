// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/transform_limits.h"

#include <string>
#include <utility>

#include "bindings/move_limits.h"

namespace hull::bindings {

void bind_transform_limits(py::module_& module) {
  py::class_<LimitArguments>(module, "TransformLimits",
                             "What stays, and how, while a hull is transformed.")
      .def(py::init([](const py::object& locked, const py::object& held_points,
                       const DoubleArray& held_normals, const py::object& tied,
                       const DoubleArray& tied_directions, const py::iterable& kept,
                       const py::iterable& rigid) {
             modelling::ReshapeLimits own =
                 limits_from(locked, held_points, held_normals, tied, tied_directions, kept);
             modelling::TransformLimits limits{
                 std::move(own.limits), std::move(own.tied), std::move(own.kept), {}};
             for (const py::handle group : rigid) {
               const std::string name = "rigid[" + std::to_string(limits.rigid.size()) + "]";
               limits.rigid.push_back(
                   integers_from(py::reinterpret_borrow<py::object>(group), name.c_str()));
             }
             return LimitArguments(std::move(limits));
           }),
           py::kw_only(), py::arg("locked") = py::tuple(), py::arg("held_points") = py::tuple(),
           py::arg("held_normals") = py::tuple(), py::arg("tied") = py::tuple(),
           py::arg("tied_directions") = py::tuple(), py::arg("kept") = py::tuple(),
           py::arg("rigid") = py::tuple(),
           "locked, held_points, held_normals, tied, tied_directions, kept: as for Reshape. rigid: "
           "groups of "
           "control points that move along the ship as one, as transoms and bulbs; a group with "
           "a locked point, or one held in a plane that is not along the ship, stays. Sections "
           "that are inflated leave rigid groups where they are.");
  module.def(
      "plane_ends",
      [](const surface::LimitSurface& surface) {
        py::list groups;
        for (const std::vector<int>& group : modelling::plane_ends(surface)) {
          groups.append(to_array(group));
        }
        return groups;
      },
      py::arg("surface"),
      "The control points of faces in planes across the ship, as of a transom: an array for each "
      "that hangs together, for TransformLimits.");
}

}  // namespace hull::bindings
