// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/section_areas.h"

#include <pybind11/stl.h>

#include "analysis/stations/bonjean.h"
#include "analysis/stations/kept_stations.h"
#include "bindings/arrays.h"

namespace hull::bindings {
namespace {

// A number of each section as an array of the given shape.
py::array_t<double> numbers(const std::vector<analysis::SectionArea>& sections,
                            const std::vector<py::ssize_t>& shape,
                            double analysis::SectionArea::*member) {
  py::array_t<double> array(shape);
  double* out = array.mutable_data();
  for (const analysis::SectionArea& section : sections) *out++ = section.*member;
  return array;
}

py::array_t<double> centroids(const std::vector<analysis::SectionArea>& sections,
                              std::vector<py::ssize_t> shape) {
  shape.push_back(3);
  py::array_t<double> array(shape);
  double* out = array.mutable_data();
  for (const analysis::SectionArea& section : sections) {
    for (int k = 0; k < 3; ++k) *out++ = section.centroid[k];
  }
  return array;
}

// The sectional area curve's values.
struct SectionAreas {
  std::vector<analysis::SectionArea> sections;
  std::vector<py::ssize_t> shape() const { return {static_cast<py::ssize_t>(sections.size())}; }
};

std::vector<py::ssize_t> shape_of(const analysis::BonjeanCurves& c) {
  return {static_cast<py::ssize_t>(c.stations.size()), static_cast<py::ssize_t>(c.drafts.size())};
}

}  // namespace

void bind_section_areas(py::module_& module) {
  using S = SectionAreas;
  py::class_<S>(module, "SectionAreas",
                "Immersed stations of a body, of both sides: the sectional area curve. Arrays have "
                "one entry per station.")
      .def_property_readonly(
          "positions",
          [](const S& s) {
            return numbers(s.sections, s.shape(), &analysis::SectionArea::position);
          },
          "(n,) x of the stations, m.")
      .def_property_readonly(
          "areas",
          [](const S& s) { return numbers(s.sections, s.shape(), &analysis::SectionArea::area); },
          "(n,) m².")
      .def_property_readonly(
          "centroids", [](const S& s) { return centroids(s.sections, s.shape()); },
          "(n, 3) of the areas, m; 0 where nothing is immersed.")
      .def_property_readonly(
          "girths",
          [](const S& s) { return numbers(s.sections, s.shape(), &analysis::SectionArea::girth); },
          "(n,) wetted lengths of the shell's outline, m.")
      .def_property_readonly(
          "breadths",
          [](const S& s) {
            return numbers(s.sections, s.shape(), &analysis::SectionArea::breadth);
          },
          "(n,) lengths of the stations' waterlines, m.")
      .def_property_readonly(
          "area_errors",
          [](const S& s) {
            return numbers(s.sections, s.shape(), &analysis::SectionArea::area_error);
          },
          "(n,) estimated errors of integration, m².");
  module.def(
      "section_areas",
      [](const analysis::HullBody& body, const std::vector<double>& positions, double draft,
         double trim, double heel, double draft_at) {
        return S{analysis::section_areas(body, positions,
                                         analysis::FloatingPosition{draft, trim, heel, draft_at})};
      },
      py::arg("body"), py::arg("positions"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
      py::arg("heel") = 0.0, py::arg("draft_at") = 0.0, py::call_guard<py::gil_scoped_release>(),
      "SectionAreas at the given x (m), exact but for a quadrature along the outline; their "
      "integral is the displaced volume.\n\ndraft in m where the ship's vertical through "
      "(draft_at, "
      "0) meets the water, trim (by the stern) and heel (to starboard) in rad. Where the area "
      "jumps, at a transom, it is the larger one.");

  py::class_<analysis::KeptStations>(
      module, "KeptStations",
      "Immersed stations of a body whose surface's points are moved: of each that was asked for "
      "the "
      "integrals over its cells are kept, and only those over cells that have moved are taken "
      "again.")
      .def(py::init<const analysis::HullBody&>(), py::arg("body"), py::keep_alive<1, 2>())
      .def(
          "section_areas",
          [](analysis::KeptStations& kept, const std::vector<double>& positions, double draft,
             double trim, double heel, double draft_at) {
            // The lock is kept: what is kept is changed.
            return S{kept.section_areas(positions,
                                        analysis::water_plane({draft, trim, heel, draft_at}))};
          },
          py::arg("positions"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
          py::arg("heel") = 0.0, py::arg("draft_at") = 0.0,
          "What the function section_areas() gives of the body as it is, to the last bit.");

  module.def(
      "volume_abaft",
      [](const analysis::HullBody& body, double x, double draft, double trim, double draft_at) {
        return body.volume_abaft(
            analysis::water_plane(analysis::FloatingPosition{draft, trim, 0.0, draft_at}), x);
      },
      py::arg("body"), py::arg("x"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
      py::arg("draft_at") = 0.0, py::call_guard<py::gil_scoped_release>(),
      "Displaced volume abaft the station x (m), m³, both sides, upright; as exact as that of the "
      "whole. draft, trim and draft_at as section_areas() takes them. ValueError after join().");

  using B = analysis::BonjeanCurves;
  py::class_<B>(module, "BonjeanCurves",
                "Immersed stations over a range of upright drafts. Arrays have one row per station "
                "and one column per draft.")
      .def_property_readonly(
          "stations", [](const B& b) { return to_array(b.stations); }, "(s,) x, m.")
      .def_property_readonly(
          "drafts", [](const B& b) { return to_array(b.drafts); }, "(d,) m.")
      .def_property_readonly(
          "areas",
          [](const B& b) { return numbers(b.sections, shape_of(b), &analysis::SectionArea::area); },
          "(s, d) m².")
      .def_property_readonly(
          "centroids", [](const B& b) { return centroids(b.sections, shape_of(b)); },
          "(s, d, 3) of the areas, m; 0 where nothing is immersed.")
      .def_property_readonly(
          "girths",
          [](const B& b) {
            return numbers(b.sections, shape_of(b), &analysis::SectionArea::girth);
          },
          "(s, d) wetted lengths of the shell's outline, m.")
      .def_property_readonly(
          "breadths",
          [](const B& b) {
            return numbers(b.sections, shape_of(b), &analysis::SectionArea::breadth);
          },
          "(s, d) lengths of the stations' waterlines, m: derivatives of the areas with draft.");
  module.def("bonjean", &analysis::bonjean, py::arg("body"), py::kw_only(), py::arg("stations"),
             py::arg("drafts"), py::call_guard<py::gil_scoped_release>(),
             "BonjeanCurves at the given stations (x, m) and upright drafts (m). Each station is "
             "cut once for all drafts.");
}

}  // namespace hull::bindings
