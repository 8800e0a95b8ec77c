// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hydrostatics/hydrostatics.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "analysis/hydrostatics/hydrostatics_check.h"
#include "analysis/stations/lateral_profile.h"

namespace hull::bindings {

namespace py = pybind11;

namespace {

void bind_coefficients(py::module_& module) {
  using C = analysis::FormCoefficients;
  py::class_<C>(module, "FormCoefficients",
                "Coefficients of form on a length L, beam B, draft T and section area A; 0 where "
                "undefined.")
      .def_readonly("block", &C::block, "Cb, displaced volume / (L B T).")
      .def_readonly("prismatic", &C::prismatic, "Cp, displaced volume / (A L).")
      .def_readonly("midship", &C::midship, "Cm, A / (B T).")
      .def_readonly("waterplane", &C::waterplane, "Cwp, waterplane area / (L B).")
      .def_readonly("vertical_prismatic", &C::vertical_prismatic,
                    "Cvp, displaced volume / (waterplane area T).");
}

void bind_section_area(py::module_& module) {
  using S = analysis::SectionArea;
  py::class_<S>(module, "SectionArea", "What of a station is under water, of both sides.")
      .def_readonly("position", &S::position, "x of the station, m.")
      .def_readonly("area", &S::area, "m².")
      .def_property_readonly(
          "centroid",
          [](const S& s) { return py::make_tuple(s.centroid.x(), s.centroid.y(), s.centroid.z()); },
          "(x, y, z) of the area's centroid, m.")
      .def_readonly("girth", &S::girth, "Wetted length of the shell's outline, m.")
      .def_readonly("breadth", &S::breadth, "Length of the station's waterline, m.")
      .def_readonly("area_error", &S::area_error, "Estimated error of integration, m².");
}

using HydrostaticsClass = py::class_<analysis::Hydrostatics>;

void add_volume_and_waterplane(HydrostaticsClass& c) {
  using P = analysis::Hydrostatics;
  c.def_readonly("draft", &P::draft, "m: z of the water where the draft is measured.")
      .def_property_readonly(
          "trim", [](const P& p) { return p.position.trim; }, "rad, positive by the stern.")
      .def_property_readonly(
          "heel", [](const P& p) { return p.position.heel; }, "rad, positive to starboard.")
      .def_property_readonly(
          "draft_at", [](const P& p) { return p.position.draft_at; },
          "x where the draft is measured, m.")
      .def_readonly("displaced_volume", &P::displaced_volume, "m³, moulded.")
      .def_readonly("displacement_t", &P::displacement_t, "t, displaced volume times density.")
      .def_readonly("lcb", &P::lcb, "x of the centre of buoyancy, m.")
      .def_readonly("tcb", &P::tcb, "y of the centre of buoyancy, m.")
      .def_readonly("kb", &P::kb, "z of the centre of buoyancy, m.")
      .def_readonly("wetted_surface", &P::wetted_surface, "m², of the shell alone.")
      .def_readonly("waterplane_area", &P::waterplane_area, "m².")
      .def_readonly("lcf", &P::lcf, "x of the centre of flotation, m.")
      .def_readonly("tcf", &P::tcf, "y of the centre of flotation, m.")
      .def_readonly("waterplane_inertia_transverse", &P::waterplane_inertia_transverse,
                    "m⁴, about the fore-and-aft axis through the centre of flotation.")
      .def_readonly("waterplane_inertia_longitudinal", &P::waterplane_inertia_longitudinal,
                    "m⁴, about the transverse axis through the centre of flotation.")
      .def_readonly("waterplane_inertia_product", &P::waterplane_inertia_product,
                    "m⁴, of distances forward and to port of the centre of flotation.")
      .def_readonly("bm_transverse", &P::bm_transverse, "Metacentric radius, m.")
      .def_readonly("bm_longitudinal", &P::bm_longitudinal, "Metacentric radius, m.")
      .def_readonly("km_transverse", &P::km_transverse, "Metacentre above base, m.")
      .def_readonly("km_longitudinal", &P::km_longitudinal, "Metacentre above base, m.")
      .def_readonly("lcb_percent", &P::lcb_percent,
                    "Centre of buoyancy forward of midship, % of length_pp.")
      .def_readonly("lcf_percent", &P::lcf_percent,
                    "Centre of flotation forward of midship, % of length_pp.")
      .def_readonly("tpc", &P::tpc, "t/cm, displacement for 1 cm of sinkage.")
      .def_readonly("mtc", &P::mtc,
                    "t·m/cm, moment to change trim by 1 cm over length_pp; BMl stands for GMl.")
      .def_readonly("volume_error", &P::volume_error, "Estimated error of integration, m³.")
      .def_readonly("wetted_surface_error", &P::wetted_surface_error,
                    "Estimated error of integration, m².")
      .def_readonly("volume_from_breadths", &P::volume_from_breadths,
                    "m³, the volume from breadths instead of depths; upright, it differs where the "
                    "shell is open below the water.");
}

void add_form(HydrostaticsClass& c) {
  using P = analysis::Hydrostatics;
  c.def_readonly("waterline_length", &P::waterline_length,
                 "Lwl, m: extent of the shell's waterline, level along the ship.")
      .def_readonly("waterline_beam", &P::waterline_beam,
                    "Bwl, m: extent of the shell's waterline, level across the ship.")
      .def_readonly("waterline_aft", &P::waterline_aft, "x of the waterline's after end, m.")
      .def_readonly("waterline_forward", &P::waterline_forward,
                    "x of the waterline's forward end, m.")
      .def_readonly("immersed_length", &P::immersed_length,
                    "m: extent of the immersed shell, level along the ship.")
      .def_readonly("immersed_beam", &P::immersed_beam,
                    "m: extent of the immersed shell, level across the ship.")
      .def_readonly("immersed_draft", &P::immersed_draft,
                    "m: depth of the shell's lowest point below the water.")
      .def_readonly("midship_section", &P::midship_section,
                    "SectionArea at length_pp / 2; all 0 if that is not given.")
      .def_readonly("largest_section", &P::largest_section, "SectionArea of the largest area.")
      .def_readonly("project", &P::project,
                    "FormCoefficients on length_pp, beam, design_draft and the midship section.")
      .def_readonly("immersed", &P::immersed,
                    "FormCoefficients on immersed length, beam and draft and the largest section.")
      .def_readonly("half_angle_of_entrance", &P::half_angle_of_entrance,
                    "rad, between the centre plane and the waterline's tangent at its forward end; "
                    "pi / 2 where it is round or flat there.")
      .def_readonly("entrance_chord_angle", &P::entrance_chord_angle,
                    "rad, between the centre plane and the chord from the waterline's forward end "
                    "to the half breadth 5 % of Lwl abaft it.")
      .def_readonly("lateral_area", &P::lateral_area,
                    "m², of the underwater profile: the centre plane inside the immersed body, "
                    "with what is joined to it.")
      .def_readonly("lateral_x", &P::lateral_x, "x of the lateral area's centre, m.")
      .def_readonly("lateral_z", &P::lateral_z, "z of the lateral area's centre, m.")
      .def_readonly("wind_area", &P::wind_area, "m², of the profile above the water.")
      .def_readonly("wind_x", &P::wind_x, "x of the wind area's centre, m.")
      .def_readonly("wind_z", &P::wind_z, "z of the wind area's centre, m.");
}

void bind_lateral_profile(py::module_& module) {
  using P = analysis::ProfileArea;
  py::class_<P>(module, "ProfileArea", "A part of a ship's profile.")
      .def_readonly("area", &P::area, "m².")
      .def_property_readonly(
          "centre", [](const P& p) { return py::make_tuple(p.centre.x(), 0.0, p.centre.z()); },
          "(x, 0, z), m; zeros without an area.");
  using L = analysis::LateralProfile;
  py::class_<L>(module, "LateralProfile", "A ship's profile on the centre plane in some water.")
      .def_readonly("above", &L::above, "ProfileArea above the water: what the wind meets.")
      .def_readonly("below", &L::below, "ProfileArea below the water.");
  module.def(
      "lateral_profile",
      [](const analysis::HullBody& body, double draft, double trim, double heel, double draft_at) {
        const analysis::FloatingPosition position{draft, trim, heel, draft_at};
        analysis::check_hydrostatics(position, {}, analysis::kSeaWaterDensity);
        return analysis::lateral_profile(body, analysis::water_plane(position));
      },
      py::arg("body"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
      py::arg("heel") = 0.0, py::arg("draft_at") = 0.0, py::call_guard<py::gil_scoped_release>(),
      "The LateralProfile of a HullBody in water, as in hydrostatics(); there may be nothing "
      "immersed.\n\nOf each body it is the centre plane inside it (of one beside the plane the "
      "plane amidst it), openings closed athwartships. With join() bodies that overlap and "
      "appendages, as they are seen athwartships, count once, and light falls through tunnels "
      "across the ship. Raises ValueError for numbers that are not finite.");
}

analysis::ProjectDimensions dimensions(std::optional<double> length_pp, std::optional<double> beam,
                                       std::optional<double> design_draft) {
  return {length_pp.value_or(0.0), beam.value_or(0.0), design_draft.value_or(0.0)};
}

constexpr const char* kDimensionsDoc =
    "length_pp, beam, design_draft: the project's dimensions in m, for midship, percentages and "
    "coefficients, which are 0 where one is not given; design_draft is then the draft. "
    "water_density in t/m³.";

}  // namespace

void bind_hydrostatics(py::module_& module) {
  module.attr("SEA_WATER_DENSITY") = analysis::kSeaWaterDensity;
  bind_coefficients(module);
  bind_section_area(module);
  HydrostaticsClass hydrostatics_class(
      module, "Hydrostatics",
      "Hydrostatics of a body in water, of both sides; positions in m from x = 0, y = 0 and z = 0. "
      "What is undefined (nothing immersed, no waterplane, a dimension not given) is 0.");
  add_volume_and_waterplane(hydrostatics_class);
  add_form(hydrostatics_class);
  module.def(
      "hydrostatics",
      [](const analysis::HullBody& body, double draft, double trim, double heel,
         std::optional<double> draft_at, std::optional<double> length_pp,
         std::optional<double> beam, std::optional<double> design_draft, double water_density,
         analysis::KeptStations* kept_stations) {
        const analysis::ProjectDimensions project = dimensions(length_pp, beam, design_draft);
        const double at = draft_at.value_or(0.5 * project.length_pp);
        // With the lock no other thread changes what is kept.
        std::optional<py::gil_scoped_release> released;
        if (!kept_stations) released.emplace();
        return analysis::hydrostatics(body, {draft, trim, heel, at}, project, water_density,
                                      kept_stations);
      },
      py::arg("body"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
      py::arg("heel") = 0.0, py::arg("draft_at") = py::none(), py::arg("length_pp") = py::none(),
      py::arg("beam") = py::none(), py::arg("design_draft") = py::none(),
      py::arg("water_density") = analysis::kSeaWaterDensity, py::arg("kept_stations") = py::none(),
      (std::string("Hydrostatics of a HullBody in water, integrated over the exact surface.\n\n"
                   "draft in m where the ship's vertical through (draft_at, 0) meets the water; "
                   "draft_at is midship, or 0 without length_pp. trim (by the stern) and heel (to "
                   "starboard) in rad. ") +
       kDimensionsDoc +
       " kept_stations: KeptStations of the body, whose points are moved, from which the largest "
       "section is taken as far as it has not moved, to the same bits. Raises ValueError if the "
       "faces are turned inwards.")
          .c_str());
  bind_lateral_profile(module);
  module.def(
      "hydrostatic_table",
      [](const analysis::HullBody& body, const std::vector<double>& drafts,
         const std::vector<double>& trims, std::optional<double> length_pp,
         std::optional<double> beam, std::optional<double> design_draft, double water_density) {
        return analysis::hydrostatic_table(
            body, drafts, trims, dimensions(length_pp, beam, design_draft), water_density);
      },
      py::arg("body"), py::kw_only(), py::arg("drafts"),
      py::arg("trims") = std::vector<double>{0.0}, py::arg("length_pp") = py::none(),
      py::arg("beam") = py::none(), py::arg("design_draft") = py::none(),
      py::arg("water_density") = analysis::kSeaWaterDensity,
      py::call_guard<py::gil_scoped_release>(),
      (std::string("A list of Hydrostatics, one for each draft (m, at midship) and trim (rad, by "
                   "the stern): all drafts for the first trim, then for the next. ") +
       kDimensionsDoc)
          .c_str());
  module.def("upright_hydrostatics", &analysis::upright_hydrostatics, py::arg("surface"),
             py::kw_only(), py::arg("draft"), py::arg("mirrored"),
             py::call_guard<py::gil_scoped_release>(),
             "Hydrostatics of a LimitSurface floating upright at a draft (m above z = 0), without "
             "project dimensions: hydrostatics() for a single draft.\n\nmirrored: the mesh is the "
             "port half (y >= 0) and counts twice. Openings below the water are closed by vertical "
             "planes. Raises ValueError if the faces are turned inwards.");
}

}  // namespace hull::bindings
