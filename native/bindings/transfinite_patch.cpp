// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/patches/transfinite_patch.h"

#include <string>

#include "bindings/arrays.h"
#include "bindings/network_classes.h"
#include "network/patches/patch_grid.h"

namespace hull::bindings {
namespace {

using network::TransfinitePatch;
using network::Vector2d;

constexpr double kBeyondDomain = 1e-9;

std::vector<Vector2d> domain_places_from(const TransfinitePatch& patch, const DoubleArray& given) {
  const DoubleArray::Values values = given.values("places");
  if (values.ndim() != 2 || values.shape(1) != 2) {
    throw std::invalid_argument("places has to be of shape (n, 2).");
  }
  const auto& domain = patch.domain();
  std::vector<Vector2d> places;
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    const Vector2d place(values.at(i, 0), values.at(i, 1));
    for (std::size_t k = 0; k < domain.size(); ++k) {
      const Vector2d way = domain[(k + 1) % domain.size()] - domain[k], from = place - domain[k];
      // To the left of every side; not a number is to the left of none.
      if (way[0] * from[1] - way[1] * from[0] >= -kBeyondDomain) continue;
      throw std::invalid_argument("places[" + std::to_string(i) +
                                  "] is not within the patch's domain.");
    }
    places.push_back(place);
  }
  return places;
}

py::tuple evaluated_patch(const TransfinitePatch& patch, const std::vector<Vector2d>& places) {
  std::vector<Vector3d> points, normals;
  {
    const py::gil_scoped_release release;
    for (const network::PatchPoint& at : patch.at_all(places)) {
      points.push_back(at.point);
      normals.push_back(at.normal());
    }
  }
  return py::make_tuple(to_array(points), to_array(normals));
}

}  // namespace

void bind_transfinite_patch(py::module_& module) {
  py::class_<TransfinitePatch>(module, "TransfinitePatch",
                               "The surface within a region of a CurveNetwork: it passes through "
                               "its sides exactly, with the "
                               "tangent planes that they have in the network (Koelman 1999).")
      .def_property_readonly("side_count", &TransfinitePatch::side_count,
                             "Of two sides one is halved: 3.")
      .def_property_readonly(
          "domain", [](const TransfinitePatch& patch) { return to_array(patch.domain()); },
          "(n, 2) corners of what it is over, counter-clockwise: the unit square, or a regular "
          "polygon in the unit circle. Side i goes from corner i to the next one.")
      .def(
          "evaluate",
          [](const TransfinitePatch& patch, const DoubleArray& places) {
            return evaluated_patch(patch, domain_places_from(patch, places));
          },
          py::arg("places"),
          "(points (n, 3), m, normals (n, 3), unit, outwards) at places (n, 2) of the domain. "
          "ValueError for a place beyond it.")
      .def(
          "grid",
          [](const TransfinitePatch& patch, int count) {
            const network::PatchGrid grid = network::patch_grid(patch.domain(), count);
            py::array_t<int> triangles(
                {static_cast<py::ssize_t>(grid.triangles.size()), py::ssize_t{3}});
            auto rows = triangles.mutable_unchecked<2>();
            for (std::size_t i = 0; i < grid.triangles.size(); ++i) {
              for (std::size_t k = 0; k < 3; ++k) {
                rows(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) =
                    grid.triangles[i][k];
              }
            }
            return py::make_tuple(to_array(grid.places), triangles);
          },
          py::arg("count"),
          "(places (n, 2), triangles (m, 3)): a grid of the domain with count parts on each side.");
}

}  // namespace hull::bindings
