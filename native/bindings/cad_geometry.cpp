// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/reading/cad_geometry.h"

#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/cad_geometry.h"
#include "bindings/progress.h"

namespace hull::bindings {
namespace {

py::dict to_dict(const exchange::CadSpline& curve) {
  py::dict dict;
  dict["name"] = curve.name;
  dict["layer"] = curve.layer;
  dict["faces"] = curve.faces;
  dict["degree"] = curve.degree;
  dict["knots"] = to_array(curve.knots);
  dict["weights"] = to_array(curve.weights);
  dict["points"] = to_array(curve.points);
  return dict;
}

py::dict to_dict(const exchange::CadFace& face) {
  py::array_t<int> triangles({static_cast<py::ssize_t>(face.triangles.size()), py::ssize_t{3}});
  int* out = triangles.mutable_data();
  for (const auto& triangle : face.triangles)
    out = std::copy(triangle.begin(), triangle.end(), out);
  py::dict dict;
  dict["name"] = face.name;
  dict["layer"] = face.layer;
  dict["points"] = to_array(face.points);
  dict["triangles"] = triangles;
  return dict;
}

template <class Value>
py::list to_list(const std::vector<Value>& values) {
  py::list list;
  for (const Value& value : values) list.append(to_dict(value));
  return list;
}

py::dict to_dict(const exchange::CadGeometry& geometry) {
  py::dict dict;
  dict["format"] = geometry.format;
  dict["unit"] = geometry.unit;
  dict["product"] = geometry.product;
  dict["curves"] = to_list(geometry.curves);
  dict["faces"] = to_list(geometry.faces);
  dict["points"] = to_array(geometry.points);
  dict["curves_left_out"] = geometry.curves_left_out;
  dict["faces_left_out"] = geometry.faces_left_out;
  return dict;
}

}  // namespace

void bind_cad_geometry(py::module_& module) {
  module.def(
      "read_cad_geometry",
      [](const std::filesystem::path& path, double chord_share, const py::object& progress) {
        if (!(chord_share >= 1e-7 && chord_share <= 0.1)) {
          throw std::invalid_argument("chord_share must be from 1e-7 to 0.1, not " +
                                      std::to_string(chord_share) + ".");
        }
        const surface::Progress told = progress_from(progress);
        exchange::CadGeometry geometry;
        {
          const py::gil_scoped_release release;
          geometry = exchange::read_cad_geometry(path.string(), chord_share, told);
        }
        return to_dict(geometry);
      },
      py::arg("path"), py::kw_only(), py::arg("chord_share") = 2e-5,
      py::arg("progress") = py::none(),
      "What a STEP or IGES file holds, in metres, as a dict: format, unit (of the file; \"\" for "
      "one that write_step does not know), product, curves (dicts of name, layer, faces (how many "
      "have it as an edge), degree, knots, weights (none where all are 1) and points (n, 3)), "
      "faces (dicts of name, layer, points and triangles (m, 3), at their middles within "
      "chord_share of the size from the face), points (n, 3), curves_left_out and faces_left_out "
      "(numbers of those of "
      "which nothing could be made). Files that may be damaged can end the process: read them by "
      "hull_io.read_geometry. Raises OSError if the file can't be read.");
}

}  // namespace hull::bindings
