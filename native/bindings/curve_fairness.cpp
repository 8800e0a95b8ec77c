// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/curve_fairness.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "analysis/fairness/kept_fairness.h"
#include "bindings/arrays.h"
#include "bindings/casts.h"
#include "bindings/planes.h"

namespace hull::bindings {
namespace {

struct CurveMarks {
  std::vector<analysis::CurveMark> all;
};

template <class Item, class Value>
auto column(const std::vector<Item>& items, Value Item::*member) {
  std::vector<Value> values;
  values.reserve(items.size());
  for (const Item& item : items) values.push_back(item.*member);
  return to_array(values);
}

auto of_samples(Vector3d analysis::CurveSample::*member) {
  return [member](const analysis::CurveFairness& c) { return column(c.samples, member); };
}

const char* name_of(analysis::CurveFairness::Kind kind) {
  switch (kind) {
    case analysis::CurveFairness::Kind::kCrease:
      return "crease";
    case analysis::CurveFairness::Kind::kBorder:
      return "border";
    case analysis::CurveFairness::Kind::kSection:
      break;
  }
  return "section";
}

const char* name_of(analysis::CurveMark::Kind kind) {
  switch (kind) {
    case analysis::CurveMark::Kind::kMaximum:
      return "maximum";
    case analysis::CurveMark::Kind::kMinimum:
      return "minimum";
    case analysis::CurveMark::Kind::kInflection:
      break;
  }
  return "inflection";
}

std::vector<const char*> kinds_of(const CurveMarks& marks) {
  std::vector<const char*> kinds;
  for (const analysis::CurveMark& mark : marks.all) kinds.push_back(name_of(mark.kind));
  return kinds;
}

py::array_t<bool> peaks_of(const CurveMarks& marks) {
  py::array_t<bool> flags(static_cast<py::ssize_t>(marks.all.size()));
  std::transform(marks.all.begin(), marks.all.end(), flags.mutable_data(),
                 [](const analysis::CurveMark& mark) { return mark.peak; });
  return flags;
}

py::array_t<double> comb_of(const analysis::CurveFairness& curve, double scale) {
  if (!std::isfinite(scale)) {
    throw std::invalid_argument("The scale of a comb, m a tooth for 1/m, must be finite.");
  }
  const std::vector<analysis::Segment3> segments = analysis::comb(curve, scale);
  py::array_t<double> array(
      {static_cast<py::ssize_t>(segments.size()), py::ssize_t{2}, py::ssize_t{3}});
  double* out = array.mutable_data();
  for (const analysis::Segment3& segment : segments) {
    for (const Vector3d& p : segment) out = std::copy_n(p.data(), 3, out);
  }
  return array;
}

struct GivenSections {
  std::vector<std::vector<const analysis::SectionCurve*>> curves;
  std::vector<py::object> kept;  // whose they are
};

// Iterables of SectionCurve, one for each plane. The curves are kept: an iterator has no other
// holder of them, and lists may change while the lock is released.
GivenSections curves_from(const py::list& sections, std::size_t planes) {
  if (sections.size() != planes) {
    throw std::invalid_argument("Give as many sections as planes, " + std::to_string(planes) +
                                ", not " + std::to_string(sections.size()) + ".");
  }
  GivenSections given{std::vector<std::vector<const analysis::SectionCurve*>>(planes), {}};
  for (std::size_t i = 0; i < planes; ++i) {
    for (const py::handle curve : sections[i]) {
      given.curves[i].push_back(&cast_or_refuse<const analysis::SectionCurve&>(
          curve, "sections[" + std::to_string(i) + "] must be SectionCurves."));
      given.kept.push_back(py::reinterpret_borrow<py::object>(curve));
    }
  }
  return given;
}

void bind_marks(py::module_& module) {
  py::class_<CurveMarks>(module, "CurveMarks",
                         "Inflections and curvature extrema of a curve, in its order.")
      .def("__len__", [](const CurveMarks& m) { return m.all.size(); })
      .def_property_readonly(
          "points", [](const CurveMarks& m) { return column(m.all, &analysis::CurveMark::point); },
          "(n, 3), m.")
      .def_property_readonly(
          "arc_lengths",
          [](const CurveMarks& m) { return column(m.all, &analysis::CurveMark::arc_length); },
          "(n,), m from the curve's start.")
      .def_property_readonly(
          "values",
          [](const CurveMarks& m) { return column(m.all, &analysis::CurveMark::curvature); },
          "(n,) signed curvature, 1/m; 0 at inflections.")
      .def_property_readonly("kinds", &kinds_of,
                             "List of n: \"inflection\", or \"maximum\" or \"minimum\" of the "
                             "signed curvature.")
      .def_property_readonly("peaks", &peaks_of,
                             "(n,) whether the curve bends more there than to both sides: maxima "
                             "above and minima below zero.");
}

void bind_comb_curve(py::module_& module) {
  py::class_<analysis::CurveFairness>(
      module, "CurveFairness",
      "A curve as its fairness is judged: samples at even arc lengths between knuckles, exact on "
      "the surface, and marks.")
      .def_property_readonly(
          "kind", [](const analysis::CurveFairness& c) { return name_of(c.kind); },
          "\"section\", \"crease\" or \"border\".")
      .def_property_readonly(
          "vertices", [](const analysis::CurveFairness& c) { return to_array(c.vertices); },
          "(n,) control vertices of a crease or border; empty for sections.")
      .def_readonly("closed", &analysis::CurveFairness::closed)
      .def_readonly("length", &analysis::CurveFairness::length, "m.")
      .def_property_readonly("points", of_samples(&analysis::CurveSample::point),
                             "(k, 3), m; knuckles are there twice, at the end of a stretch and at "
                             "the start of the next.")
      .def_property_readonly("tangents", of_samples(&analysis::CurveSample::tangent),
                             "(k, 3), of unit length.")
      .def_property_readonly("curvature_vectors", of_samples(&analysis::CurveSample::curvature),
                             "(k, 3), 1/m, towards the centre of curvature.")
      .def_property_readonly(
          "curvatures",
          [](const analysis::CurveFairness& c) {
            return column(c.samples, &analysis::CurveSample::signed_curvature);
          },
          "(k,) signed, 1/m: positive where the curve turns left, seen against the plane's normal. "
          "Of space curves the length of the curvature vector.")
      .def_property_readonly(
          "arc_lengths", [](const analysis::CurveFairness& c) { return to_array(c.arc_lengths); },
          "(k,), m from the curve's start.")
      .def_property_readonly(
          "starts", [](const analysis::CurveFairness& c) { return to_array(c.starts); },
          "(n + 1,): stretch i, between knuckles, is starts[i]:starts[i + 1].")
      .def_property_readonly(
          "marks", [](const analysis::CurveFairness& c) { return CurveMarks{c.marks}; },
          "CurveMarks, by arc length from the curve's start.")
      .def_property_readonly("inflection_count", &analysis::CurveFairness::inflection_count)
      .def_property_readonly("extremum_count", &analysis::CurveFairness::extremum_count)
      .def("comb", &comb_of, py::kw_only(), py::arg("scale"),
           "The curvature comb as line segments (m, 2, 3), in m, ready to draw: the k teeth, from "
           "each point to point - scale * curvature vector, away from the centre of curvature; "
           "then the line through their ends, broken at knuckles. scale: length of a tooth in m "
           "for a curvature of 1/m; ValueError unless it is finite.");
}

void bind_kept_fairness(py::module_& module) {
  py::class_<analysis::KeptFairness>(
      module, "KeptFairness",
      "The fairness of sections of a surface whose points are moved: of each plane that was asked "
      "for is kept what was found between the points of its sections, and only in cells that have "
      "moved since it is found anew.")
      .def(py::init<const surface::LimitSurface&>(), py::arg("surface"), py::keep_alive<1, 2>())
      .def(
          "section_fairness",
          [](analysis::KeptFairness& kept, const DoubleArray& planes, const py::list& sections,
             std::optional<double> step, std::optional<double> noise, double relative_noise) {
            const std::vector<analysis::Plane> wanted = planes_from(planes);
            const GivenSections given = curves_from(sections, wanted.size());
            // The lock is kept: what is kept is changed.
            return kept.section_fairness(wanted, given.curves,
                                         {step, std::nullopt, noise, relative_noise, true});
          },
          py::arg("planes"), py::arg("sections"), py::kw_only(), py::arg("step") = py::none(),
          py::arg("noise") = py::none(), py::arg("relative_noise") = 1e-3,
          "What the function section_fairness() gives of sections that are there, of the surface "
          "as it is, to the last bit. ValueError as for that function.");
}

}  // namespace

void bind_curve_fairness(py::module_& module) {
  bind_marks(module);
  bind_comb_curve(module);
  bind_kept_fairness(module);
  module.def(
      "section_fairness",
      [](const surface::LimitSurface& surface, const DoubleArray& planes,
         std::optional<double> step, std::optional<int> count,
         std::optional<double> chord_tolerance, std::optional<double> flat_tolerance,
         std::optional<double> noise, double relative_noise, bool marks,
         const std::optional<py::list>& sections) {
        const std::vector<analysis::Plane> wanted = planes_from(planes);
        if (sections) {
          const GivenSections given = curves_from(*sections, wanted.size());
          const py::gil_scoped_release release;
          return analysis::section_fairness(surface, wanted, given.curves,
                                            {step, count, noise, relative_noise, marks});
        }
        const analysis::SectionOptions sampling{
            chord_tolerance.value_or(kChordTolerance * surface.mesh().size()), flat_tolerance};
        const py::gil_scoped_release release;
        return analysis::section_fairness(surface, wanted, sampling,
                                          {step, count, noise, relative_noise, marks});
      },
      py::arg("surface"), py::arg("planes"), py::kw_only(), py::arg("step") = py::none(),
      py::arg("count") = py::none(), py::arg("chord_tolerance") = py::none(),
      py::arg("flat_tolerance") = py::none(), py::arg("noise") = py::none(),
      py::arg("relative_noise") = 1e-3, py::arg("marks") = true, py::arg("sections") = py::none(),
      "Sections by planes (n, 4), as for sections(), with what is needed to judge them: a list of "
      "n lists of CurveFairness.\n\n"
      "step: largest distance of samples along the curve, m (default 1/200 of the mesh's size); or "
      "count: how many each stretch between knuckles has, 2 or more. Samples are exact on surface "
      "and plane; arc lengths to about 1e-6, with a chord_tolerance (m) below the default, 1e-5 of "
      "the mesh's size, more so.\n\n"
      "Inflections count between places that bend to different sides by more than the noise, "
      "extrema where curvature falls by more than that on either side: noise (1/m; default 1e-3 "
      "over the mesh's size), or relative_noise times the curvature that 95 % of the curve stay "
      "below, whichever is more. With marks=False none are looked for, which takes half the "
      "time.\n\n"
      "sections: what sections() gave for these planes, of the surface as it is, to a "
      "chord_tolerance no coarser than the default; nothing is cut then. "
      "ValueError for planes, tolerances and options out of range, and for sections that are not "
      "on the surface as it is.");
  module.def(
      "feature_fairness",
      [](const surface::LimitSurface& surface, std::optional<double> step, std::optional<int> count,
         const std::optional<DoubleArray>& direction, std::optional<double> noise,
         double relative_noise, bool marks) {
        std::optional<Vector3d> view;
        if (direction) view = point_from(*direction, "direction");
        const py::gil_scoped_release release;
        return analysis::feature_fairness(surface, view,
                                          {step, count, noise, relative_noise, marks});
      },
      py::arg("surface"), py::kw_only(), py::arg("step") = py::none(),
      py::arg("count") = py::none(), py::arg("direction") = py::none(),
      py::arg("noise") = py::none(), py::arg("relative_noise") = 1e-3, py::arg("marks") = true,
      "The same for creases and borders, in the order of crease_curves(): a list of CurveFairness. "
      "direction (3,), of any length: curves are judged as seen along it, (0, 0, 1) in plan, "
      "(0, 1, 0) in profile. Without it plane curves are judged in their plane, whose normal has a "
      "positive largest component; space curves by the length of their curvature vector: they have "
      "extrema but no inflections.");
  module.def("suggested_comb_scale", &analysis::suggested_comb_scale, py::arg("curves"),
             py::kw_only(), py::arg("height"),
             "Scale for CurveFairness.comb() at which 98 % of the curves' length have teeth no "
             "longer than height (m). curves: list of CurveFairness. ValueError unless height is "
             "above zero.");
}

}  // namespace hull::bindings
