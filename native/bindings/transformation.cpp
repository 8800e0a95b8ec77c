// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/hydrostatics/hydrostatics.h"
#include "bindings/arrays.h"
#include "bindings/move_limits.h"
#include "bindings/transform_limits.h"
#include "modelling/transformation/area_matching.h"
#include "modelling/transformation/lengthening.h"
#include "modelling/transformation/section_shift.h"

namespace hull::bindings {
namespace {

using modelling::AreasMatched;
using modelling::HullRange;
using modelling::Inflated;
using modelling::Lengthened;
using modelling::SectionShift;
using modelling::SectionsShifted;
using Ranges = std::vector<std::array<double, 3>>;
using Range = std::optional<std::pair<double, double>>;

analysis::FloatingPosition afloat(double draft, double trim, double draft_at) {
  return {draft, trim, 0.0, draft_at};
}

std::optional<HullRange> range_from(const Range& range) {
  if (!range) return std::nullopt;
  return HullRange{range->first, range->second};
}

modelling::ShiftedPart part_from(const std::string& name) {
  if (name == "whole") return modelling::ShiftedPart::kWhole;
  if (name == "apart") return modelling::ShiftedPart::kApart;
  if (name == "fore") return modelling::ShiftedPart::kFore;
  if (name == "aft") return modelling::ShiftedPart::kAft;
  if (name == "fair") return modelling::ShiftedPart::kFair;
  throw std::invalid_argument(
      "part is \"whole\", \"apart\", \"fore\", \"aft\" or \"fair\", not \"" + name + "\".");
}

modelling::FormTargets targets_from(std::optional<double> volume, std::optional<double> mass_t,
                                    std::optional<double> block, std::optional<double> prismatic,
                                    std::optional<double> lcb) {
  using Measure = modelling::VolumeMeasure;
  modelling::FormTargets targets;
  int count = 0;
  const auto take = [&](std::optional<double> value, Measure measure) {
    if (!value) return;
    targets.volume = {measure, *value};
    ++count;
  };
  take(volume, Measure::kVolume);
  take(mass_t, Measure::kDisplacement);
  take(block, Measure::kBlock);
  take(prismatic, Measure::kPrismatic);
  if (count > 1) {
    throw std::invalid_argument(
        "volume, displacement_t, block and prismatic say the same: give one of them.");
  }
  targets.lcb = lcb;
  return targets;
}

constexpr const char* kMoves = "(n, 3), m: of all control points.";
constexpr const char* kRms =
    "Root of the mean, by area, of the squared residual: of the wanted shifts less what the "
    "surface does, m.";
constexpr const char* kLargest = "The largest residual, m.";
constexpr const char* kLargestPlace = "(3,), m: where on the surface, as it was, that is.";

void bind_transformed(py::module_& module) {
  py::class_<SectionsShifted>(module, "SectionsShifted",
                              "A hull whose sections were shifted: SectionShift.")
      .def_property_readonly(
          "moves", [](const SectionsShifted& r) { return to_array(r.moves); }, kMoves)
      .def_property_readonly(
          "coefficients", [](const SectionsShifted& r) { return to_array(r.coefficients); },
          "(A, B), or those of fore and aft body.")
      .def_readonly("rms", &SectionsShifted::rms, kRms)
      .def_readonly("largest", &SectionsShifted::largest, kLargest)
      .def_readonly("largest_place", &SectionsShifted::largest_place, kLargestPlace)
      .def_readonly("volume", &SectionsShifted::volume, "m³, of the resulting surface.")
      .def_readonly("lcb", &SectionsShifted::lcb, "m, of the resulting surface.")
      .def_readonly("iterations", &SectionsShifted::iterations)
      .def_readonly("converged", &SectionsShifted::converged,
                    "Whether the targets are met to 1e-10.");
  py::class_<Lengthened>(module, "Lengthened", "A hull that became longer or shorter: lengthen().")
      .def_property_readonly(
          "moves", [](const Lengthened& r) { return to_array(r.moves); }, kMoves)
      .def_property_readonly(
          "range", [](const Lengthened& r) { return std::pair(r.range.aft, r.range.forward); },
          "(aft, forward), m: between these it was stretched.")
      .def_readonly("is_parallel", &Lengthened::is_parallel,
                    "Whether the immersed body is parallel there.")
      .def_readonly("area", &Lengthened::area, "m², of the immersed section at the place.")
      .def_readonly("volume_change", &Lengthened::volume_change, "m³, of the resulting surface.")
      .def_readonly("rms", &Lengthened::rms, kRms)
      .def_readonly("largest", &Lengthened::largest, kLargest);
  py::class_<Inflated>(module, "Inflated", "A section that was brought to an area: inflate().")
      .def_property_readonly(
          "moves", [](const Inflated& r) { return to_array(r.moves); }, kMoves)
      .def_readonly("amount", &Inflated::amount, "m, outwards.")
      .def_readonly("area", &Inflated::area, "m², of the resulting surface's section.")
      .def_readonly("rms", &Inflated::rms, kRms)
      .def_readonly("largest", &Inflated::largest, kLargest)
      .def_readonly("largest_place", &Inflated::largest_place, kLargestPlace)
      .def_readonly("iterations", &Inflated::iterations)
      .def_readonly("converged", &Inflated::converged);
  py::class_<AreasMatched>(module, "AreasMatched",
                           "A hull with another sectional area curve: match_areas().")
      .def_property_readonly(
          "moves", [](const AreasMatched& r) { return to_array(r.moves); }, kMoves)
      .def_readonly("difference_before", &AreasMatched::difference_before,
                    "The largest difference of areas, in parts of the largest one wanted, as the "
                    "hull was.")
      .def_readonly("difference", &AreasMatched::difference, "The same as it is now.")
      .def_readonly("difference_at", &AreasMatched::difference_at, "m: its x.")
      .def_readonly("rms", &AreasMatched::rms, kRms)
      .def_readonly("largest", &AreasMatched::largest, kLargest)
      .def_readonly("largest_place", &AreasMatched::largest_place, kLargestPlace)
      .def_readonly("volume", &AreasMatched::volume, "m³, of the resulting surface.")
      .def_readonly("lcb", &AreasMatched::lcb, "m, of the resulting surface.")
      .def_readonly("iterations", &AreasMatched::iterations)
      .def_readonly("converged", &AreasMatched::converged,
                    "Whether the difference is below the tolerance.");
}

void bind_section_shift(py::module_& module) {
  py::class_<SectionShift>(
      module, "SectionShift",
      "Sections shifted along the ship until displacement and centre of buoyancy of the exact "
      "surface are as wanted: shift(x) = A x sin(π|x|) + B a(x), x from -1 at the after "
      "perpendicular to 1 at the forward one, a the sectional area divided by the largest. "
      "It keeps to the body as it is when made.")
      .def(py::init([](const analysis::HullBody& body, double draft, double trim, double length_pp,
                       double beam, double design_draft, double water_density,
                       const std::string& part, const Range& parallel, const Range& parallel_wanted,
                       const Ranges& kept_ranges, const LimitArguments& limits) {
             modelling::ShiftSettings settings;
             settings.part = part_from(part);
             settings.parallel = range_from(parallel);
             settings.parallel_wanted = range_from(parallel_wanted);
             for (const auto& [aft, forward, fade] : kept_ranges) {
               settings.held.push_back({aft, forward, fade});
             }
             const modelling::TransformLimits found = limits.limits();
             const py::gil_scoped_release release;
             return std::make_unique<SectionShift>(
                 body, afloat(draft, trim, 0.5 * length_pp),
                 analysis::ProjectDimensions{length_pp, beam, design_draft}, water_density,
                 settings, found);
           }),
           py::arg("body"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
           py::arg("length_pp"), py::arg("beam") = 0.0, py::arg("design_draft") = 0.0,
           py::arg("water_density") = analysis::kSeaWaterDensity, py::arg("part") = "whole",
           py::arg("parallel") = py::none(), py::arg("parallel_wanted") = py::none(),
           py::arg("kept_ranges") = Ranges{}, py::arg("limits") = LimitArguments{},
           "draft, trim, length_pp, beam, design_draft, water_density: as for hydrostatics(), "
           "which needs no heel. part: \"whole\": A and B; \"apart\": an A for the fore and one "
           "for the aft body; \"fore\" or \"aft\": for one of them alone; \"fair\": A and B by the "
           "two functions that bend the hull's lines the least. parallel (aft, forward), m: the "
           "parallel middle body, which keeps its sections' distances; parallel_wanted: what it is "
           "to become. kept_ranges: tuples (aft, forward, fade), m, of sections that "
           "stay; the shift fades within a length. limits: TransformLimits.\n\nThe body is read "
           "here and not kept. ValueError for what is none of these.")
      .def(
          "solve",
          [](SectionShift& shift, std::optional<double> volume, std::optional<double> mass_t,
             std::optional<double> block, std::optional<double> prismatic,
             std::optional<double> lcb) {
            const modelling::FormTargets targets =
                targets_from(volume, mass_t, block, prismatic, lcb);
            const py::gil_scoped_release release;
            return shift.solve(targets);
          },
          py::kw_only(), py::arg("volume") = py::none(), py::arg("displacement_t") = py::none(),
          py::arg("block") = py::none(), py::arg("prismatic") = py::none(),
          py::arg("lcb") = py::none(),
          "SectionsShifted for one of volume (m³), displacement_t, block (Cb) and prismatic (Cp on "
          "the station amidships), for lcb (x, m), or for both. ValueError where that is out of "
          "reach, with what can be reached.")
      .def(
          "shifted",
          [](SectionShift& shift, const DoubleArray& coefficients) {
            const std::vector<double> values = numbers_from(coefficients, "coefficients");
            const py::gil_scoped_release release;
            return shift.shifted(values);
          },
          py::arg("coefficients"),
          "SectionsShifted for coefficients as given. ValueError where sections would overtake one "
          "another.")
      .def(
          "shift",
          [](const SectionShift& shift, int coefficient, double x) {
            if (coefficient < 0 || coefficient >= shift.functions().count()) {
              throw std::invalid_argument("There is no coefficient " + std::to_string(coefficient) +
                                          ".");
            }
            return shift.functions().value(coefficient, x);
          },
          py::arg("coefficient"), py::arg("x"),
          "m: by how much a section at x (m) is shifted where this coefficient is 1.")
      .def(
          "least_stretch",
          [](const SectionShift& shift, const DoubleArray& coefficients, double aft,
             double forward) {
            const std::vector<double> values = numbers_from(coefficients, "coefficients");
            if (static_cast<int>(values.size()) != shift.functions().count()) {
              throw std::invalid_argument("coefficients must be as many as the shift has.");
            }
            const auto& functions = shift.functions();
            return functions.least_stretch(functions.slopes(aft, forward), values);
          },
          py::arg("coefficients"), py::arg("aft"), py::arg("forward"),
          "The least of 1 + shift' between two x: below 0 sections overtake one another.");
}

void bind_functions(py::module_& module) {
  module.def(
      "lengthen",
      [](const analysis::HullBody& body, double place, double length, double draft, double trim,
         double draft_at, const Range& stretched, const LimitArguments& limits) {
        const modelling::TransformLimits found = limits.limits();
        const py::gil_scoped_release release;
        return modelling::lengthen(body, afloat(draft, trim, draft_at), place, length,
                                   range_from(stretched), found);
      },
      py::arg("body"), py::arg("place"), py::arg("length"), py::kw_only(), py::arg("draft"),
      py::arg("trim") = 0.0, py::arg("draft_at") = 0.0, py::arg("stretched") = py::none(),
      py::arg("limits") = LimitArguments{},
      "Lengthened by so much parallel middle body at x = place, m; below zero it is taken out. "
      "stretched (aft, forward), m: the shift goes smoothly from zero to the length between these, "
      "whatever the body there. ValueError where the body is not parallel and nothing is "
      "stretched.");
  module.def(
      "inflate",
      [](const analysis::HullBody& body, double place, double area, double draft, double trim,
         double draft_at, std::optional<double> extent, const LimitArguments& limits) {
        const modelling::TransformLimits found = limits.limits();
        const py::gil_scoped_release release;
        return modelling::inflate(body, afloat(draft, trim, draft_at), place, area,
                                  extent.value_or(std::numeric_limits<double>::infinity()), found);
      },
      py::arg("body"), py::arg("place"), py::arg("area"), py::kw_only(), py::arg("draft"),
      py::arg("trim") = 0.0, py::arg("draft_at") = 0.0, py::arg("extent") = py::none(),
      py::arg("limits") = LimitArguments{},
      "Inflated: the immersed section at x = place, m, brought to an area, m², along the sections' "
      "normals; less and less up to extent, m, on either side, or all sections by as much. "
      "ValueError where that cannot be.");
  module.def(
      "match_areas",
      [](const analysis::HullBody& body, const DoubleArray& positions, const DoubleArray& areas,
         double draft, double trim, double draft_at, const std::string& by, double tolerance,
         const LimitArguments& limits) {
        if (by != "shift" && by != "inflate") {
          throw std::invalid_argument("by is \"shift\" or \"inflate\", not \"" + by + "\".");
        }
        const modelling::TargetCurve target(numbers_from(positions, "positions"),
                                            numbers_from(areas, "areas"));
        const modelling::TransformLimits found = limits.limits();
        const py::gil_scoped_release release;
        return modelling::match_areas(
            body, afloat(draft, trim, draft_at), target,
            by == "shift" ? modelling::AreaMatching::kShift : modelling::AreaMatching::kInflate,
            tolerance, found);
      },
      py::arg("body"), py::arg("positions"), py::arg("areas"), py::kw_only(), py::arg("draft"),
      py::arg("trim") = 0.0, py::arg("draft_at") = 0.0, py::arg("by") = "shift",
      py::arg("tolerance") = 1e-3, py::arg("limits") = LimitArguments{},
      "AreasMatched: the sectional area curve brought to the one through points positions (n,), m, "
      "rising, and areas (n,), m². by: \"shift\": each section goes along the ship to where its "
      "area is wanted; \"inflate\": it is inflated where it is. tolerance: in parts of the largest "
      "area wanted. ValueError where nothing of it can be done.");
  module.def(
      "target_area_curve",
      [](const DoubleArray& positions, const DoubleArray& areas, const DoubleArray& at) {
        const modelling::TargetCurve target(numbers_from(positions, "positions"),
                                            numbers_from(areas, "areas"));
        std::vector<double> values = numbers_from(at, "at");
        for (double& value : values) value = target.at(value);
        return to_array(values);
      },
      py::arg("positions"), py::arg("areas"), py::arg("at"),
      "(k,), m²: the curve that match_areas() takes positions (n,) and areas (n,) for, at x (k,), "
      "m. It rises and falls only where its points do; 0 beyond them.");
  module.def(
      "parallel_body",
      [](const analysis::HullBody& body, double draft, double trim, double draft_at) {
        const py::gil_scoped_release release;
        const HullRange found =
            modelling::parallel_body(modelling::WorkingHull(body, afloat(draft, trim, draft_at)));
        return std::pair(found.aft, found.forward);
      },
      py::arg("body"), py::kw_only(), py::arg("draft"), py::arg("trim") = 0.0,
      py::arg("draft_at") = 0.0,
      "(aft, forward), m: between these all immersed sections have the largest area. Both are the "
      "same where there is no parallel middle body.");
}

}  // namespace

void bind_transformation(py::module_& module) {
  bind_transform_limits(module);
  bind_transformed(module);
  bind_section_shift(module);
  bind_functions(module);
}

}  // namespace hull::bindings
