// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>

#include "bindings/arrays.h"
#include "bindings/morphing_classes.h"
#include "bindings/progress.h"
#include "morphing/features/layout_fit.h"
#include "morphing/features/renumbering.h"

namespace hull::bindings {
namespace {

using morphing::Feature;
using morphing::FeatureGraph;
using morphing::FeatureMatch;
using morphing::LayoutFit;

void bind_graph(py::module_& module) {
  py::class_<Feature>(module, "HullFeature",
                      "A line of creases or borders of a hull with its role to the ship.")
      .def_property_readonly("role", [](const Feature& f) { return morphing::name_of(f.role); })
      .def_readonly("body", &Feature::body, "The number of the body that it is of.")
      .def_property_readonly(
          "chains", [](const Feature& f) { return to_array(f.chains); },
          "(k,): numbers in crease_curves(), one after the other.")
      .def_property_readonly(
          "nodes", [](const Feature& f) { return to_array(f.nodes); },
          "(k + 1,): control points at the ends of chains.")
      .def_property_readonly(
          "lengths", [](const Feature& f) { return to_array(f.lengths); },
          "(k + 1,), m: along the curve at these.")
      .def_property_readonly(
          "curve", [](const Feature& f) { return f.curve; }, "The FieldCurve.");
  py::class_<FeatureGraph>(module, "FeatureGraph",
                           "All lines of creases and borders of a hull with their roles.")
      .def_readonly("features", &FeatureGraph::features, "HullFeatures, by role.")
      .def_readonly("body_count", &FeatureGraph::body_count)
      .def(
          "described",
          [](const FeatureGraph& graph, int feature) {
            if (feature < 0 || feature >= static_cast<int>(graph.features.size())) {
              throw std::invalid_argument("The hull has no feature " + std::to_string(feature) +
                                          ".");
            }
            return graph.described(feature);
          },
          py::arg("feature"), "A feature by its number, as a person says it.");
  module.def("feature_graph", &morphing::feature_graph, py::arg("surface"),
             py::call_guard<py::gil_scoped_release>(),
             "The FeatureGraph of a LimitSurface: its features are lines of creases and borders, "
             "joined while they go on in one way and have one role.");
}

void bind_match(py::module_& module) {
  py::class_<FeatureMatch>(module, "FeatureMatch", "Features of two hulls in pairs.")
      .def_property_readonly(
          "pairs",
          [](const FeatureMatch& m) {
            py::list pairs;
            for (const morphing::FeaturePair& pair : m.pairs) {
              pairs.append(py::make_tuple(pair.first, pair.second, pair.distance, pair.is_given));
            }
            return pairs;
          },
          "Tuples (feature of the first, of the second, distance in parts of the dimensions, "
          "whether it was given).")
      .def_readonly("alone_in_first", &FeatureMatch::alone_in_first)
      .def_readonly("alone_in_second", &FeatureMatch::alone_in_second)
      .def_readonly("remarks", &FeatureMatch::remarks,
                    "A sentence for each feature that is alone, with the remedy.");
  module.def("match_features", &morphing::match_features, py::arg("first"), py::arg("second"),
             py::arg("pairs") = std::vector<std::array<int, 2>>{},
             py::arg("apart") = std::vector<std::array<int, 2>>{},
             py::call_guard<py::gil_scoped_release>(),
             "The FeatureMatch of two FeatureGraphs: pairs (p, 2) as given, then by role, order "
             "and place, but for those held apart (q, 2). ValueError for pairs that are none or "
             "name a feature twice.");
}

void bind_layout(py::module_& module) {
  py::class_<LayoutFit>(module, "LayoutFit", "One hull's control mesh on another hull.")
      .def_property_readonly(
          "first",
          [](const LayoutFit& f) { return std::make_unique<surface::LimitSurface>(f.first); },
          "The first hull, subdivided as often as it took: the same surface.")
      .def_property_readonly(
          "second",
          [](const LayoutFit& f) { return std::make_unique<surface::LimitSurface>(f.second); },
          "The second hull with the faces, creases and corners of `first`.")
      .def_readonly("subdivisions", &LayoutFit::subdivisions)
      .def_property_readonly(
          "flats",
          [](const LayoutFit& f) {
            py::list flats;
            for (const morphing::CommonFlat& flat : f.flats) flats.append(to_array(flat.points));
            return flats;
          },
          "Arrays (k,): control points that are in one flat of each hull.")
      .def_readonly("rms", &LayoutFit::rms,
                    "m: root mean square, by area, of distances of the second hull from `second`.")
      .def_readonly("largest", &LayoutFit::largest, "m, and …")
      .def_property_readonly(
          "largest_place",
          [](const LayoutFit& f) { return py::array_t<double>(3, f.largest_place.data()); },
          "(3,), m: … where.")
      .def_readonly("rms_back", &LayoutFit::rms_back, "m: the same of `second` from the hull.")
      .def_readonly("largest_back", &LayoutFit::largest_back)
      .def_property_readonly(
          "largest_back_place",
          [](const LayoutFit& f) { return py::array_t<double>(3, f.largest_back_place.data()); })
      .def_property_readonly(
          "fold",
          [](const LayoutFit& f) -> py::object {
            if (!f.fold) return py::none();
            return py::array_t<double>(3, f.fold->data());
          },
          "(3,), m: a place on `first` where a member between the two is folded, or the layout is "
          "turned over on the hull; None: nowhere.")
      .def_property_readonly(
          "fold_ahead",
          [](const LayoutFit& f) -> py::object {
            if (!f.fold_ahead) return py::none();
            return py::array_t<double>(3, f.fold_ahead->data());
          },
          "(3,), m: a place on `first` where a member would be folded by a step of the fit, which "
          "was not taken for it; None: all were.")
      .def_readonly("match", &LayoutFit::match, "The FeatureMatch.")
      .def_readonly("shortfall", &LayoutFit::shortfall,
                    "Why the distances are larger than the tolerance, or why a member is folded, "
                    "and what to do, with the features to pair: a sentence; \"\" where neither is "
                    "so.");
  module.def(
      "fit_layout",
      [](const surface::LimitSurface& first, const surface::LimitSurface& second,
         const std::vector<std::array<int, 2>>& pairs, const std::vector<std::array<int, 2>>& apart,
         double tolerance, int most_subdivisions, const py::object& progress) {
        morphing::LayoutOptions options{pairs, apart, tolerance, most_subdivisions,
                                        progress_from(progress)};
        const py::gil_scoped_release release;
        return std::make_unique<LayoutFit>(morphing::fit_layout(first, second, options));
      },
      py::arg("first"), py::arg("second"), py::kw_only(),
      py::arg("pairs") = std::vector<std::array<int, 2>>{},
      py::arg("apart") = std::vector<std::array<int, 2>>{}, py::arg("tolerance") = 1e-4,
      py::arg("most_subdivisions") = 1, py::arg("progress") = py::none(),
      "The LayoutFit that makes two hulls parents of one family: the first hull's control mesh "
      "laid onto the second hull's exact surface, creases and borders along their counterparts. "
      "Hulls of one topology, however they are numbered, are renumbered and not fitted. pairs "
      "(p, 2) of features, given; apart (q, 2): not to be paired. tolerance: of the length; beyond "
      "it the layout is subdivided, "
      "exactly, most_subdivisions times. ValueError where bodies have no counterpart.");
}

}  // namespace

void bind_hull_features(py::module_& module) {
  bind_graph(module);
  bind_match(module);
  bind_layout(module);
  module.def(
      "renumbering",
      [](const mesh::ControlMesh& mesh, const mesh::ControlMesh& other) -> py::object {
        const auto found = morphing::renumbering(mesh, other);
        if (!found) return py::none();
        return to_array(*found);
      },
      py::arg("mesh"), py::arg("other"),
      "(n,): of each vertex of a ControlMesh the one of another that stands in its place, where "
      "the two differ by the numbers and order of vertices and faces only; else None. Of several "
      "such maps that with the nearest points.");
}

}  // namespace hull::bindings
