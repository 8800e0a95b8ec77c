// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "bindings/companion_module.h"
#include "conversion/exact_conversion.h"
#include "conversion/per_cell.h"
#include "exchange/step_file.h"

namespace py = pybind11;

namespace hull::bindings {
namespace {

py::dict to_dict(const StepReport& report) {
  py::array_t<double> box({2, 3});
  for (int axis = 0; axis < 3; ++axis) {
    box.mutable_at(0, axis) = report.box_min(axis);
    box.mutable_at(1, axis) = report.box_max(axis);
  }
  py::dict dict;
  dict["valid"] = report.valid;
  dict["solids"] = report.solids;
  dict["shells"] = report.shells;
  dict["faces"] = report.faces;
  dict["edges"] = report.edges;
  dict["free_edges"] = report.free_edges;
  dict["free_edge_length"] = report.free_edge_length;
  dict["area"] = report.area;
  dict["volume"] = report.volume;
  dict["box"] = box;
  dict["product"] = report.product;
  dict["cells_left_out"] = report.cells_left_out;
  return dict;
}

StepReport write(const PatchSet& patches, const std::filesystem::path& path,
                 const std::string& name, bool mirrored) {
  const py::gil_scoped_release release;
  return write_step(patches, path.string(), {.name = name, .mirrored = mirrored});
}

StepReport convert_and_write(const LimitSurface& surface, const std::filesystem::path& path,
                             const std::string& name, bool mirrored, const std::string& conversion,
                             double tolerance) {
  if (conversion != "exact" && conversion != "per_cell") {
    throw std::invalid_argument("conversion must be \"exact\" or \"per_cell\", not \"" +
                                conversion + "\".");
  }
  const py::gil_scoped_release release;
  const PatchSet patches = conversion == "exact" ? exact_patches(surface, {.tolerance = tolerance})
                                                 : fit_per_cell(surface);
  return write_step(patches, path.string(), {.name = name, .mirrored = mirrored});
}

StepReport read(const std::filesystem::path& path) {
  const py::gil_scoped_release release;
  return read_step_report(path.string());
}

}  // namespace
}  // namespace hull::bindings

PYBIND11_MODULE(_exchange, module) {
  using namespace hull::bindings;
  module.doc() = "Files of CAD systems, by way of Open CASCADE.";
  join_core(module);

  module.def(
      "write_step",
      [](const hull::PatchSet& patches, const std::filesystem::path& path, const std::string& name,
         bool mirrored) { return to_dict(write(patches, path, name, mirrored)); },
      py::arg("patches"), py::arg("path"), py::kw_only(), py::arg("name") = "hull",
      py::arg("mirrored") = false,
      "Write patches as a STEP file (AP214, metres): one shell whose faces share their edges, a "
      "solid where it is closed. mirrored adds the image on y = 0, joined along the centre line. "
      "The file is complete and read back, or it is not there and one of the same name is "
      "untouched. Returns the report of read_step_report. Raises ValueError if the patches "
      "make no valid shape, OSError if the file can't be written.");
  module.def(
      "write_step",
      [](const hull::LimitSurface& surface, const std::filesystem::path& path,
         const std::string& name, bool mirrored, const std::string& conversion, double tolerance) {
        return to_dict(convert_and_write(surface, path, name, mirrored, conversion, tolerance));
      },
      py::arg("surface"), py::arg("path"), py::kw_only(), py::arg("name") = "hull",
      py::arg("mirrored") = false, py::arg("conversion") = "exact", py::arg("tolerance") = 1e-6,
      "The same for a surface, which is converted first: \"exact\" as by exact_patches() with the "
      "tolerance, \"per_cell\" as by fit_per_cell().");
  module.def(
      "read_step_report", [](const std::filesystem::path& path) { return to_dict(read(path)); },
      py::arg("path"),
      "What Open CASCADE finds in a STEP file, as a dict: valid (its own check), numbers of "
      "solids, "
      "shells, faces, edges and free_edges (with one face), free_edge_length (m), area (m2), "
      "volume "
      "(m3, or None unless closed), box (2, 3; m), product (its name), and from write_step "
      "cells_left_out (cells without area). Raises OSError if the file can't be read.");
}
