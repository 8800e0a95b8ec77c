// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include "bindings/arrays.h"
#include "bindings/cad_geometry.h"
#include "bindings/casts.h"
#include "bindings/companion_module.h"
#include "bindings/progress.h"
#include "bindings/unmade_instances.h"
#include "conversion/exact/exact_conversion.h"
#include "conversion/per_cell/per_cell.h"
#include "conversion/place_error.h"
#include "exchange/iges_file.h"
#include "exchange/step/step_file.h"

namespace py = pybind11;

namespace hull::bindings {
namespace {

using WriteFile = exchange::CadReport (*)(const conversion::PatchSet&, const std::string&,
                                          const exchange::CadOptions&);

// How much of the time of both a conversion takes.
constexpr double kConverted = 0.1;

py::list regions_of(const exchange::CadReport& report) {
  py::list regions;
  for (const exchange::CadRegion& region : report.regions) {
    py::dict dict;
    dict["name"] = region.name;
    dict["colour"] = py::none();
    if (region.colour) {
      const analysis::Colour& c = *region.colour;
      dict["colour"] = py::make_tuple(c[0], c[1], c[2]);
    }
    dict["faces"] = region.faces;
    dict["area"] = region.area;
    regions.append(dict);
  }
  return regions;
}

py::dict to_dict(const exchange::CadReport& report) {
  py::array_t<double> box({2, 3});
  for (int axis = 0; axis < 3; ++axis) {
    box.mutable_at(0, axis) = report.box_min(axis);
    box.mutable_at(1, axis) = report.box_max(axis);
  }
  py::dict dict;
  dict["format"] = report.format;
  dict["unit"] = report.unit;
  dict["product"] = report.product;
  dict["valid"] = report.valid;
  dict["closed"] = report.closed;
  dict["solids"] = report.solids;
  dict["shells"] = report.shells;
  dict["faces"] = report.faces;
  dict["edges"] = report.edges;
  dict["free_edges"] = report.free_edges;
  dict["free_edge_length"] = report.free_edge_length;
  dict["area"] = report.area;
  dict["volume"] = report.volume;
  dict["box"] = box;
  dict["curves"] = report.curves;
  dict["regions"] = regions_of(report);
  dict["layers"] = report.layers;
  dict["cells_left_out"] = report.cells_left_out;
  dict["warnings"] = report.warnings;
  dict["bytes"] = report.bytes;
  return dict;
}

exchange::StepSchema schema_from(const std::string& name) {
  if (name == "AP214") return exchange::StepSchema::kAp214;
  if (name == "AP242") return exchange::StepSchema::kAp242;
  throw std::invalid_argument("schema must be \"AP214\" or \"AP242\", not \"" + name + "\".");
}

analysis::Colour colour_from(const std::string& region, const py::handle& value) {
  const std::string words =
      "colours[\"" + region + "\"] must be three numbers from 0 to 1: red, green, blue.";
  const auto numbers = cast_or_refuse<std::vector<double>>(value, words);
  for (double number : numbers) {
    if (numbers.size() == 3 && number >= 0.0 && number <= 1.0) continue;
    throw std::invalid_argument(words);
  }
  if (numbers.empty()) throw std::invalid_argument("colours[\"" + region + "\"] is empty.");
  return {numbers[0], numbers[1], numbers[2]};
}

exchange::CadCurve curve_from(const py::handle& value) {
  const std::string words =
      "A curve must be (name, layer, spline) or (name, layer, knots, control_points).";
  const auto parts = value.cast<py::tuple>();
  const bool is_spline = parts.size() == 3 && py::hasattr(parts[2], "knots") &&
                         py::hasattr(parts[2], "control_points");
  if (!is_spline && parts.size() != 4) throw std::invalid_argument(words);
  exchange::CadCurve curve{cast_or_refuse<std::string>(parts[0], words),
                           cast_or_refuse<std::string>(parts[1], words),
                           {}};
  const py::object knots = parts.size() == 4 ? py::object(parts[2]) : parts[2].attr("knots");
  const py::object points =
      parts.size() == 4 ? py::object(parts[3]) : parts[2].attr("control_points");
  curve.curve.knots = numbers_from(DoubleArray(knots), "knots");
  curve.curve.points = points_from(DoubleArray(points), "control_points");
  // What is none is refused with the curve.
  curve.curve.degree =
      static_cast<int>(curve.curve.knots.size()) - static_cast<int>(curve.curve.points.size()) - 1;
  return curve;
}

struct Arguments {
  std::string name, unit;
  bool mirrored, solid;
  py::object regions, colours;
  py::iterable curves;
  std::vector<analysis::Appendage> appendages;
  py::object progress;
};

exchange::CadOptions options_from(const Arguments& arguments, const std::string& schema) {
  exchange::CadOptions options;
  options.schema = schema_from(schema);
  options.name = arguments.name;
  options.unit = exchange::cad_unit_from(arguments.unit);
  options.mirrored = arguments.mirrored;
  options.solid = arguments.solid;
  if (!arguments.regions.is_none()) {
    options.regions = cast_or_refuse<std::vector<std::string>>(
        arguments.regions, "regions must be a list of names, one for each patch.");
  }
  if (!arguments.colours.is_none()) {
    const std::string words = "colours must be a dict of the names of regions to (r, g, b).";
    for (const auto& [region, colour] : arguments.colours.cast<py::dict>()) {
      const auto text = cast_or_refuse<std::string>(region, words);
      options.colours[text] = colour_from(text, colour);
    }
  }
  for (const py::handle& curve : arguments.curves) options.curves.push_back(curve_from(curve));
  options.appendages = arguments.appendages;
  options.progress = progress_from(arguments.progress);
  return options;
}

py::dict write(WriteFile write_file, const conversion::PatchSet& patches,
               const std::filesystem::path& path, const exchange::CadOptions& options) {
  exchange::CadReport report;
  {
    const py::gil_scoped_release release;
    report = write_file(patches, path.string(), options);
  }
  return to_dict(report);
}

py::dict convert_and_write(WriteFile write_file, const surface::LimitSurface& surface,
                           const std::filesystem::path& path, const std::string& conversion,
                           double tolerance, exchange::CadOptions options) {
  if (conversion != "exact" && conversion != "per_cell") {
    throw std::invalid_argument("conversion must be \"exact\" or \"per_cell\", not \"" +
                                conversion + "\".");
  }
  exchange::CadReport report;
  {
    const py::gil_scoped_release release;
    // part_of() refers to it, so it has to be there as long as the file is written.
    const surface::Progress whole = options.progress;
    surface::tell(whole, 0.0, 1.0);
    const conversion::PatchSet patches =
        conversion == "exact" ? conversion::exact_patches(surface, {.tolerance = tolerance})
                              : conversion::fit_per_cell(surface);
    options.progress = surface::part_of(whole, kConverted, 1.0);
    report = write_file(patches, path.string(), options);
  }
  return to_dict(report);
}

constexpr char kOptions[] =
    "\n\nunit: of the file's numbers, \"m\", \"cm\", \"mm\", \"ft\" or \"in\". mirrored: the image "
    "on y = 0 too, joined along the centre line. solid: close open borders with caps, plane ones "
    "where borders are plane, athwartships ruled ones elsewhere, and the centre plane of a half "
    "hull. regions: names of the patches' regions, which become layers, one a patch; None for "
    "\"shell\", \"flat side\", \"flat bottom\", \"transom\" and \"deck\" by their shape. colours: "
    "a dict from names of regions to (red, green, blue) from 0 to 1. curves: a list of (name, "
    "layer, spline) or (name, layer, knots, control_points). appendages: a list of Appendage, "
    "joined to "
    "the solid or cut out of it, whose faces have their names as regions; both sides must be "
    "there. progress: a callable that takes the "
    "share done; raising in it cancels.\n\nThe file is complete and was read back, or it is not "
    "there and one of the same name is untouched. Returns the report of read_cad_report. Raises "
    "ValueError if the patches make no valid shape, OSError if the file can't be written.";

// Both overloads of write_step() or write_iges().
void bind_writing(py::module_& module, const char* function, WriteFile write_file,
                  const std::string& what, const std::string& default_schema) {
  const std::string of_patches = what + kOptions;
  module.def(
      function,
      [write_file](const conversion::PatchSet& patches, const std::filesystem::path& path,
                   const std::string& schema, const std::string& name, const std::string& unit,
                   bool mirrored, bool solid, const py::object& regions, const py::object& colours,
                   const py::iterable& curves, const std::vector<analysis::Appendage>& appendages,
                   const py::object& progress) {
        return write(write_file, patches, path,
                     options_from({name, unit, mirrored, solid, regions, colours, curves,
                                   appendages, progress},
                                  schema));
      },
      py::arg("patches"), py::arg("path"), py::kw_only(), py::arg("schema") = default_schema,
      py::arg("name") = "hull", py::arg("unit") = "m", py::arg("mirrored") = false,
      py::arg("solid") = false, py::arg("regions") = py::none(), py::arg("colours") = py::none(),
      py::arg("curves") = py::tuple(), py::arg("appendages") = py::tuple(),
      py::arg("progress") = py::none(), of_patches.c_str());
  module.def(
      function,
      [write_file](const surface::LimitSurface& surface, const std::filesystem::path& path,
                   const std::string& conversion, double tolerance, const std::string& schema,
                   const std::string& name, const std::string& unit, bool mirrored, bool solid,
                   const py::object& regions, const py::object& colours, const py::iterable& curves,
                   const std::vector<analysis::Appendage>& appendages, const py::object& progress) {
        return convert_and_write(write_file, surface, path, conversion, tolerance,
                                 options_from({name, unit, mirrored, solid, regions, colours,
                                               curves, appendages, progress},
                                              schema));
      },
      py::arg("surface"), py::arg("path"), py::kw_only(), py::arg("conversion") = "exact",
      py::arg("tolerance") = 1e-6, py::arg("schema") = default_schema, py::arg("name") = "hull",
      py::arg("unit") = "m", py::arg("mirrored") = false, py::arg("solid") = false,
      py::arg("regions") = py::none(), py::arg("colours") = py::none(),
      py::arg("curves") = py::tuple(), py::arg("appendages") = py::tuple(),
      py::arg("progress") = py::none(),
      "The same for a surface, which is converted first: \"exact\" as by exact_patches() with the "
      "tolerance, \"per_cell\" as by fit_per_cell().");
}

// PlaceError, with the attributes point, kind and elements.
void bind_place_error(py::module_& module) {
  PyObject* const type = PyErr_NewExceptionWithDoc(
      "hull_native.PlaceError",
      "What is wrong with patches at one place: a ValueError whose message says where and what to "
      "do about it. point: (3,), m; kind: \"face\" or \"vertex\", or \"mesh\" where no element is "
      "known; elements: the faces or points of the control mesh.",
      PyExc_ValueError, nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.add_object("PlaceError", type);
  // The module holds the class for good, so that the translator, which takes no state, finds it.
  static PyObject* const place_error = type;
  py::register_local_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const conversion::PlaceError& found) {
      // Made here and not by its message alone, for the attributes.
      const py::object raised = py::reinterpret_borrow<py::object>(place_error)(found.what());
      raised.attr("point") = to_array(std::vector{found.point()}).reshape({py::ssize_t{3}});
      if (!found.vertices().empty()) {
        raised.attr("kind") = "vertex";
        raised.attr("elements") = py::tuple(py::cast(found.vertices()));
      } else {
        const bool is_known = found.face() >= 0;
        raised.attr("kind") = is_known ? "face" : "mesh";
        raised.attr("elements") = is_known ? py::make_tuple(found.face()) : py::make_tuple();
      }
      PyErr_SetObject(place_error, raised.ptr());
    }
  });
}

}  // namespace
}  // namespace hull::bindings

PYBIND11_MODULE(_exchange, module) {
  using namespace hull::bindings;
  module.doc() = "Files of CAD systems, by way of Open CASCADE.";
  join_core(module);
  bind_place_error(module);
  bind_writing(module, "write_step", &hull::exchange::write_step,
               "Write patches as a STEP file: one shell whose faces share their edges, a solid "
               "where it is closed. schema: \"AP214\" or \"AP242\".",
               "AP214");
  bind_writing(module, "write_iges", &hull::exchange::write_iges,
               "Write patches as an IGES 5.3 file of B-rep entities: one shell whose faces share "
               "their edges, a solid where it is closed. schema does not matter.",
               "AP214");
  module.def(
      "read_cad_report",
      [](const std::filesystem::path& path) {
        hull::exchange::CadReport report;
        {
          const py::gil_scoped_release release;
          report = hull::exchange::read_cad_report(path.string());
        }
        return to_dict(report);
      },
      py::arg("path"),
      "What Open CASCADE finds in a STEP or IGES file, as a dict: format, unit (\"\" for one that "
      "write_step does not know), product (its name), valid (its own check), closed (no edge is "
      "free), numbers of solids, shells, faces, edges and free_edges (with one face), "
      "free_edge_length (m), area (m2), volume (m3, or None unless closed), box (2, 3; m), curves "
      "(of no face), regions (dicts of name, colour, faces and area), layers, bytes, and from "
      "writing cells_left_out (cells without area) and warnings (sentences, as of a gap in the "
      "centre line). Raises OSError if the file can't be read.");
  bind_cad_geometry(module);
  refuse_unmade_instances(module);
}
