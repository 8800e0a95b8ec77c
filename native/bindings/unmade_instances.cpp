// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings/unmade_instances.h"

namespace hull::bindings {
namespace {

void* refuse(std::size_t) {
  throw pybind11::type_error(
      "An object of hull_native was used before the __init__() of its class was called: a subclass "
      "with an __init__() of its own must call super().__init__(...) first.");
}

}  // namespace

void refuse_unmade_instances(pybind11::module_& module) {
  for (const auto& [name, value] : module.attr("__dict__").cast<pybind11::dict>()) {
    if (!pybind11::isinstance<pybind11::type>(value)) continue;
    auto* type = reinterpret_cast<PyTypeObject*>(value.ptr());
    // pybind11 casts an instance without an object to one of uninitialised memory, for constructors
    // in the manner of its first version. This is what allocates it then, and serves nothing else.
    if (auto* info = pybind11::detail::get_type_info(type)) info->operator_new = &refuse;
  }
}

}  // namespace hull::bindings
