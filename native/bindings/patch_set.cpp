// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/patch_set.h"

#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/progress.h"
#include "conversion/exact/exact_conversion.h"
#include "conversion/per_cell/per_cell.h"

namespace hull::bindings {
namespace {

py::array_t<int> fours(const std::vector<std::array<int, 4>>& rows) {
  py::array_t<int> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{4}});
  for (size_t i = 0; i < rows.size(); ++i) {
    for (int k = 0; k < 4; ++k) array.mutable_at(i, k) = rows[i][k];
  }
  return array;
}

py::list sides(const conversion::PatchSet& set) {
  py::list result;
  for (const auto& four : set.sides) {
    py::list of_patch;
    for (const conversion::PatchSide& side : four) {
      py::list edges;
      for (const conversion::SideEdge& part : side) {
        edges.append(py::make_tuple(part.edge, part.begin, part.end));
      }
      of_patch.append(edges);
    }
    result.append(of_patch);
  }
  return result;
}

// The patch with a number from Python, which may count from the end.
const conversion::BSplinePatch& patch_at(const conversion::PatchSet& set, py::ssize_t index) {
  const auto count = static_cast<py::ssize_t>(set.patches.size());
  if (index < -count || index >= count) {
    throw py::index_error("there is no patch " + std::to_string(index) + "; there are " +
                          std::to_string(count));
  }
  return set.patches[index < 0 ? index + count : index];
}

py::array_t<double> control_points(const conversion::PatchSet& set, py::ssize_t index) {
  const conversion::BSplinePatch& patch = patch_at(set, index);
  py::array_t<double> array = to_array(patch.control_points);
  return array.reshape({py::ssize_t{patch.count_u}, py::ssize_t{patch.count_v}, py::ssize_t{3}});
}

py::tuple knots(const conversion::PatchSet& set, py::ssize_t index) {
  const conversion::BSplinePatch& patch = patch_at(set, index);
  const auto array = [](const std::vector<double>& values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
  };
  return py::make_tuple(array(patch.knots_u), array(patch.knots_v));
}

// Calls visit(patch, u, v) for places given by Python.
template <class Visit>
void for_each_place(const conversion::PatchSet& set, const py::object& patches,
                    const DoubleArray& uv, const Visit& visit) {
  const std::vector<int> indices = integers_from(patches, "patches");
  const std::vector<Eigen::Vector2d> parameters = parameters_from(uv, "uv");
  if (indices.size() != parameters.size()) {
    throw std::invalid_argument("patches and uv must be of equal length, not " +
                                std::to_string(indices.size()) + " and " +
                                std::to_string(parameters.size()) + ".");
  }
  const int count = static_cast<int>(set.patches.size());
  for (size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] < 0 || indices[i] >= count) {
      throw std::invalid_argument("patches[" + std::to_string(i) + "] is " +
                                  std::to_string(indices[i]) + ", but the patches are 0 to " +
                                  std::to_string(count - 1) + ".");
    }
    visit(set.patches[indices[i]], parameters[i].x(), parameters[i].y());
  }
}

py::array_t<double> positions(const conversion::PatchSet& set, const py::object& patches,
                              const DoubleArray& uv) {
  std::vector<Vector3d> points;
  for_each_place(set, patches, uv, [&](const conversion::BSplinePatch& patch, double u, double v) {
    points.push_back(patch.position(u, v));
  });
  return to_array(points);
}

py::tuple evaluate_patches(const conversion::PatchSet& set, const py::object& patches,
                           const DoubleArray& uv) {
  std::array<std::vector<Vector3d>, 6> values;
  for_each_place(set, patches, uv, [&](const conversion::BSplinePatch& patch, double u, double v) {
    const surface::SurfaceJet jet = patch.evaluate(u, v);
    const Vector3d* parts[] = {&jet.point, &jet.du, &jet.dv, &jet.duu, &jet.duv, &jet.dvv};
    for (std::size_t k = 0; k < values.size(); ++k) values[k].push_back(*parts[k]);
  });
  py::tuple result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) result[k] = to_array(values[k]);
  return result;
}

// The half-edges of a patch's cells, (0, 0) where it stands for none.
py::array_t<int> half_edges(const conversion::PatchSet& set, py::ssize_t index) {
  // The number that patch_at() made of one that counts from the end.
  const auto at = static_cast<size_t>(&patch_at(set, index) - set.patches.data());
  const conversion::Block block = set.blocks.empty() ? conversion::Block{} : set.blocks[at];
  return to_array(block.sides).reshape({py::ssize_t{block.count_u}, py::ssize_t{block.count_v}});
}

}  // namespace

void bind_patch_set(py::module_& module) {
  py::class_<conversion::PatchSet>(
      module, "PatchSet",
      "Bicubic B-spline patches over [0, 1]^2 that stand for a surface and share their border "
      "curves.")
      .def_property_readonly(
          "patch_count", [](const conversion::PatchSet& s) { return s.patches.size(); },
          "Number of patches.")
      .def_readonly("vertex_count", &conversion::PatchSet::vertex_count)
      .def_readonly("edge_count", &conversion::PatchSet::edge_count)
      .def_property_readonly(
          "corners", [](const conversion::PatchSet& s) { return fours(s.corners); },
          "(p, 4) vertex numbers of (0, 0), (1, 0), (1, 1), (0, 1).")
      .def_property_readonly(
          "sides", &sides,
          "Of every patch four lists, one for each side from corner to corner, of its edges: "
          "(number, begin, end), where on the side from 0 to 1 they are.")
      .def_property_readonly("largest_gap", &conversion::PatchSet::largest_gap,
                             "m: the largest distance of the curves of two patches at their edge.")
      .def("control_points", &control_points, py::arg("index"),
           "(nu, nv, 3), m: the control points of one patch, the first index along u.")
      .def("knots", &knots, py::arg("index"), "The knots of one patch along u and along v.")
      .def("positions", &positions, py::arg("patches"), py::arg("uv"),
           "Points (k, 3) of the patches (k,) at uv (k, 2).")
      .def("evaluate", &evaluate_patches, py::arg("patches"), py::arg("uv"),
           "The same with derivatives with respect to the patch's (u, v): point, du, dv, duu, duv, "
           "dvv, each (k, 3).")
      .def(
          "half_edges", &half_edges, py::arg("index"),
          "(nu, nv): of each cell that a patch stands for 4 times its number plus the side that is "
          "its v = 0 in the patch: 0: (0,0)->(1,0), 1: (1,0)->(1,1), 2: (1,1)->(0,1), 3: "
          "(0,1)->(0,0). (0, 0) where it stands for none.");

  module.def(
      "fit_per_cell",
      [](const surface::LimitSurface& surface, int number) {
        const py::gil_scoped_release release;
        return conversion::fit_per_cell(surface, number);
      },
      py::arg("surface"), py::arg("control_points") = 5,
      "One bicubic B-spline patch of control_points x control_points per cell: corners on the "
      "surface, borders and interiors by least squares, borders shared exactly. Returns a "
      "PatchSet.");

  module.def(
      "exact_patches",
      [](const surface::LimitSurface& surface, double tolerance, double seam_angle, int grading,
         bool matched_knots, int most_control_points, bool bezier, const py::object& progress) {
        const surface::Progress told = progress_from(progress);
        const py::gil_scoped_release release;
        return conversion::exact_patches(
            surface, {tolerance, seam_angle, grading, matched_knots, most_control_points, bezier},
            told);
      },
      py::arg("surface"), py::kw_only(), py::arg("tolerance") = 1e-6, py::arg("seam_angle") = 0.0,
      py::arg("grading") = 0, py::arg("matched_knots") = false, py::arg("most_control_points") = 0,
      py::arg("bezier") = false, py::arg("progress") = py::none(),
      "Few large bicubic B-spline patches with knots graded towards irregular points, which equal "
      "the surface but for small squares there. tolerance: how far they may be from the surface, "
      "of the mesh's largest extent; seam_angle (rad): how much normals of neighbours may differ, "
      "0 for what goes with the tolerance; grading: how often knots are halved, 0 for as often as "
      "these need; matched_knots: insert knots until neighbours have the same ones; "
      "most_control_points: cut patches with more, 0 for none; bezier: cut at all knots; progress: "
      "called now and then with the share done, what it raises ends the "
      "conversion. Returns a PatchSet.");
}

}  // namespace hull::bindings
