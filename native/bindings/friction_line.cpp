// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/friction_line.h"

#include "bindings/resistance_classes.h"

namespace hull::bindings {

namespace py = pybind11;

void bind_friction_line(py::module_& module) {
  module.def("ittc_1957", &resistance::ittc_1957, py::arg("reynolds_number"),
             "CF of the ITTC 1957 model-ship correlation line, 0.075 / (log10 Rn - 2)², on the "
             "wetted surface. ValueError unless the Reynolds number is above 1000.");
}

}  // namespace hull::bindings
