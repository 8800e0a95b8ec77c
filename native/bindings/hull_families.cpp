// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bindings/arrays.h"
#include "bindings/morphing_classes.h"
#include "bindings/openings.h"
#include "bindings/progress.h"
#include "morphing/families/agreement.h"
#include "morphing/families/family_way.h"
#include "morphing/families/local_weights.h"
#include "morphing/families/wanted_weights.h"

namespace hull::bindings {
namespace {

using morphing::FamilyFlat;
using morphing::FamilyWay;
using morphing::HullFamily;
using morphing::WholeVolume;

using Parents = std::vector<surface::LimitSurface>;
using Flats = std::vector<std::pair<std::string, py::object>>;
using Local = std::vector<std::pair<modelling::ShapeField, py::object>>;

std::vector<FamilyFlat> flats_from(const Flats& flats) {
  std::vector<FamilyFlat> found;
  for (const auto& [name, points] : flats) {
    found.push_back({name, integers_from(points, "flats")});
  }
  return found;
}

std::vector<morphing::LocalWeights> local_from(const Local& local) {
  std::vector<morphing::LocalWeights> found;
  for (const auto& [field, weights] : local) {
    std::vector<double> numbers;
    if (!weights.is_none()) numbers = numbers_from(DoubleArray(weights), "local weights");
    found.push_back({field, std::move(numbers)});
  }
  return found;
}

py::array_t<double> member(const HullFamily& family, const std::vector<double>& weights,
                           const Local& local, bool mirrored) {
  const std::vector<morphing::LocalWeights> fields = local_from(local);
  if (fields.empty()) return to_array(family.points(weights));
  return to_array(family.points(morphing::local_weights(family, weights, fields, mirrored)));
}

void bind_whole_volume(py::module_& module) {
  py::class_<WholeVolume>(
      module, "WholeVolume",
      "Volume and first moments of the whole hull, its openings closed, along a way through a "
      "family: a cubic and quartics in t, exactly, where no closing changes its kind.")
      .def_property_readonly(
          "volume", [](const WholeVolume& w) { return py::array_t<double>(4, w.volume().data()); },
          "(4,), m³: coefficients of 1, t, t², t³.")
      .def_property_readonly(
          "moments",
          [](const WholeVolume& w) {
            py::array_t<double> moments({3, 5});
            for (int i = 0; i < 3; ++i) {
              for (int j = 0; j < 5; ++j) moments.mutable_at(i, j) = w.moments()(i, j);
            }
            return moments;
          },
          "(3, 5), m⁴: of ∫ (x, y, z) dV, coefficients of 1 to t⁴.")
      .def_property_readonly("departure", &WholeVolume::departure,
                             "By how much members between are off, as a part of volume: rounding "
                             "where the volume is a cubic.")
      .def("volume_at", &WholeVolume::volume_at, py::arg("t"), "m³.")
      .def(
          "centre_at",
          [](const WholeVolume& w, double t) {
            return py::array_t<double>(3, w.centre_at(t).data());
          },
          py::arg("t"), "(3,), m: the centre of the whole volume.")
      .def("at_volume", &WholeVolume::at_volume, py::arg("wanted"), py::arg("low") = 0.0,
           py::arg("high") = 1.0,
           "All t from low to high, rising, at which the volume is as wanted, m³.");
}

modelling::TargetOptions options_from(bool mirrored, double draft, const std::string& openings,
                                      double trim, std::optional<double> draft_at,
                                      const std::array<double, 3>& project, double density) {
  modelling::TargetOptions options;
  options.water.mirrored = mirrored;
  options.water.openings = openings_from(openings);
  options.water.project = {project[0], project[1], project[2]};
  options.water.position = {draft, trim, 0.0, draft_at.value_or(0.5 * project[0])};
  options.water.density = density;
  return options;
}

void bind_wanted(py::class_<HullFamily>& family) {
  family
      .def(
          "t_of_displacement",
          [](const HullFamily& f, const std::vector<double>& from, const std::vector<double>& to,
             double wanted, bool mirrored, const std::array<double, 2>& drafts,
             const std::string& openings, double trim, double draft_at, double low, double high) {
            const morphing::WayWater water{mirrored, openings_from(openings), drafts, trim,
                                           draft_at};
            const py::gil_scoped_release release;
            return morphing::t_of_displacement(f, {from, to}, water, wanted, low, high);
          },
          py::arg("from_weights"), py::arg("to_weights"), py::arg("wanted"), py::kw_only(),
          py::arg("mirrored"), py::arg("drafts"), py::arg("openings") = "closed",
          py::arg("trim") = 0.0, py::arg("draft_at") = 0.0, py::arg("low") = 0.0,
          py::arg("high") = 1.0,
          "A t from low to high at which the member between two displaces as wanted, m³, at the "
          "draft between the drafts (2,), m; None where none does. The water cuts members along "
          "other curves, so it is looked for step by step.")
      .def(
          "wanted_weights",
          [](const HullFamily& f, const std::vector<double>& start,
             const std::vector<modelling::FormTarget>& targets, bool mirrored, double draft,
             const std::string& openings, double trim, std::optional<double> draft_at,
             double length_pp, double beam, double design_draft, double water_density,
             double stiffness, const std::array<double, 2>& length_scale,
             const std::array<double, 2>& beam_scale, const std::array<double, 2>& draft_scale,
             double scale_cost, const modelling::SurfacePlaces* places,
             const py::object& progress) {
            modelling::TargetOptions options =
                options_from(mirrored, draft, openings, trim, draft_at,
                             {length_pp, beam, design_draft}, water_density);
            options.stiffness = stiffness;
            options.scales = {modelling::ScaleBounds{length_scale[0], length_scale[1]},
                              modelling::ScaleBounds{beam_scale[0], beam_scale[1]},
                              modelling::ScaleBounds{draft_scale[0], draft_scale[1]}};
            options.scale_cost = scale_cost;
            if (places) options.weights = places->weights();
            const surface::Progress told = progress_from(progress);
            morphing::WantedWeights found;
            {
              const py::gil_scoped_release release;
              found = morphing::wanted_weights(f, start, targets, std::move(options), told);
            }
            return py::make_tuple(to_array(found.weights), found.reached);
          },
          py::arg("start"), py::arg("targets"), py::kw_only(), py::arg("mirrored"),
          py::arg("draft"), py::arg("openings") = "closed", py::arg("trim") = 0.0,
          py::arg("draft_at") = py::none(), py::arg("length_pp") = 0.0, py::arg("beam") = 0.0,
          py::arg("design_draft") = 0.0, py::arg("water_density") = analysis::kSeaWaterDensity,
          py::arg("stiffness") = 0.05, py::arg("length_scale") = std::array<double, 2>{1.0, 1.0},
          py::arg("beam_scale") = std::array<double, 2>{1.0, 1.0},
          py::arg("draft_scale") = std::array<double, 2>{1.0, 1.0}, py::arg("scale_cost") = 0.01,
          py::arg("places") = py::none(), py::arg("progress") = py::none(),
          "The weights (p,) of parents with which a member meets FormTargets at the least change "
          "from the one of the weights `start`, and the TargetsReached, whose moves are those from "
          "that member's points, scaling included. Water, dimensions, scales and places as "
          "reach_targets() has them; weights may leave 0 to 1.");
}

void bind_members(py::class_<HullFamily>& family) {
  family
      .def("points", &member, py::arg("weights"), py::kw_only(), py::arg("local") = Local(),
           py::arg("mirrored") = false,
           "(n, 3), m: control points of the member with weights (p,) of the parents that sum to "
           "1; below 0 or above 1 they extrapolate. local: tuples (ShapeField, weights (p,)) that "
           "hold around the field's base, in the space of the first parent, and fade into those of "
           "the whole hull; None for a field that protects. mirrored: fields work on both sides of "
           "the centre plane. ValueError for weights that do not sum to 1.")
      .def(
          "first_fold",
          [](const HullFamily& f, const DoubleArray& points) -> py::object {
            const std::optional<Vector3d> place = f.first_fold(points_from(points, "points"));
            if (!place) return py::none();
            return py::array_t<double>(3, place->data());
          },
          py::arg("points"),
          "(3,), m: a place on the first parent where the surface of control points (n, 3) is "
          "turned over, by a right angle or more against each parent; None where it is nowhere.")
      .def(
          "whole_volume",
          [](const HullFamily& f, const std::vector<double>& from, const std::vector<double>& to,
             bool mirrored) {
            const py::gil_scoped_release release;
            return std::make_unique<WholeVolume>(f, FamilyWay{from, to}, mirrored);
          },
          py::arg("from_weights"), py::arg("to_weights"), py::kw_only(), py::arg("mirrored"),
          "The WholeVolume of members with the weights (1 - t) from_weights + t to_weights.");
}

}  // namespace

void bind_hull_families(py::module_& module) {
  bind_whole_volume(module);
  py::class_<HullFamily> family(
      module, "HullFamily",
      "Hulls of one topology as parents of a family, whose members have the control points "
      "Σ weight · points. A weight of 1 beside zeros gives a parent bit by bit. It keeps to the "
      "parents as they are when made.");
  family.def(py::init<Parents>(), py::arg("parents"), py::call_guard<py::gil_scoped_release>(),
             "LimitSurfaces, two or more, as they are now. ValueError, naming what differs, unless "
             "they have the same faces, creases, corners and scheme.");
  family.def_property_readonly("parent_count", &HullFamily::parent_count)
      .def_property_readonly("point_count", &HullFamily::point_count);
  bind_members(family);
  bind_wanted(family);
  module.def(
      "family_differences",
      [](const Parents& parents, const Flats& flats) {
        std::vector<std::string> found = morphing::differences(parents);
        if (!found.empty()) return found;
        return morphing::flat_differences(parents, flats_from(flats));
      },
      py::arg("parents"), py::kw_only(), py::arg("flats") = Flats(),
      "What keeps LimitSurfaces from being parents of one family, a sentence each: faces, creases "
      "and corners that differ from the first. Where there is none, flats, tuples (name, points "
      "(k,)), that are not flat or are turned against one another.");
}

}  // namespace hull::bindings
