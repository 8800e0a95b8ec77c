// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tolerances.h"

#include <pybind11/pybind11.h>

namespace hull::bindings {

void bind_tolerances(pybind11::module_& module) {
  pybind11::module_ tolerances = module.def_submodule(
      "tolerances",
      "What counts as equal, flat, or in a plane, as parts of ControlMesh.size; "
      "native/mesh/tolerances.h tells why. ON_CENTRE_PLANE: points of a half hull are on the "
      "centre plane. NEAR_CENTRE_PLANE: borders along it were probably meant to be on it. "
      "AT_CENTRE_LINE: lines are those of the centre line in plans and tables. IN_PLANE: points "
      "lie in one plane, of models in single precision. IN_SECTION: parts of the surface lie in "
      "the plane of a section that is drawn. SAME_POSITION: positions asked for are the same.");
  tolerances.attr("ON_CENTRE_PLANE") = kOnCentrePlane;
  tolerances.attr("NEAR_CENTRE_PLANE") = kNearCentrePlane;
  tolerances.attr("AT_CENTRE_LINE") = kAtCentreLine;
  tolerances.attr("IN_PLANE") = kInPlane;
  tolerances.attr("IN_SECTION") = kInSection;
  tolerances.attr("SAME_POSITION") = kSamePosition;
}

}  // namespace hull::bindings
