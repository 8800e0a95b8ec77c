// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/quality/quality_report.h"

#include <pybind11/stl.h>

#include <optional>

#include "bindings/arrays.h"
#include "bindings/progress.h"
#include "conversion/quality/measure_quality.h"

namespace hull::bindings {
namespace {

py::array_t<double> point_array(const Vector3d& point) {
  return py::array_t<double>(py::ssize_t{3}, point.data());
}

py::object place_of(const conversion::Worst& worst) {
  if (worst.place.cell < 0) return py::none();
  return py::make_tuple(worst.place.cell, worst.place.u, worst.place.v);
}

void add_worst(py::dict& dict, const char* name, const char* point,
               const conversion::Worst& worst) {
  dict[name] = worst.value;
  dict[point] = point_array(worst.point);
}

py::dict to_dict(const conversion::PatchQuality& patch) {
  py::dict dict;
  add_worst(dict, "largest_distance", "worst_point", patch.distance);
  dict["worst_place"] = place_of(patch.distance);
  dict["rms_distance"] = patch.rms_distance;
  dict["area"] = patch.area;
  dict["exact_area"] = patch.exact_area;
  dict["cell_count"] = patch.cells;
  dict["knot_count"] = patch.knot_count;
  dict["control_point_count"] = patch.control_point_count;
  return dict;
}

py::dict to_dict(const conversion::SeamQuality& seam) {
  py::dict dict;
  dict["edge"] = seam.edge;
  dict["patches"] = py::make_tuple(seam.patches[0], seam.patches[1]);
  dict["is_smooth"] = seam.is_smooth;
  add_worst(dict, "largest_gap", "worst_gap_point", seam.gap);
  add_worst(dict, "largest_seam_angle", "worst_seam_point", seam.angle);
  dict["largest_seam_angle_at_points"] = seam.angle_at_points.value;
  add_worst(dict, "largest_curvature_jump", "worst_curvature_point", seam.curvature_jump);
  dict["largest_curvature_jump_at_points"] = seam.curvature_jump_at_points.value;
  return dict;
}

template <class Part>
py::list list_of(const std::vector<Part>& parts) {
  py::list list;
  for (const Part& part : parts) list.append(to_dict(part));
  return list;
}

using ReportClass = py::class_<conversion::QualityReport>;

// A value of all seams, and where it is.
void bind_seam_value(ReportClass& report, const char* name, const char* point_name,
                     conversion::Worst conversion::SeamQuality::*value, const char* doc) {
  report.def_property_readonly(
      name, [value](const conversion::QualityReport& r) { return (r.worst_seams.*value).value; },
      doc);
  report.def_property_readonly(
      point_name,
      [value](const conversion::QualityReport& r) {
        return point_array((r.worst_seams.*value).point);
      },
      "(3,), m: where that is; NaN where nothing was measured.");
}

void bind_distances(ReportClass& report) {
  report
      .def_readonly("length", &conversion::QualityReport::length,
                    "m: largest extent of the control mesh.")
      .def_readonly("normal_reach", &conversion::QualityReport::normal_reach,
                    "m, around irregular points: there angles and jumps count as at_points.")
      .def_property_readonly(
          "largest_distance", [](const conversion::QualityReport& r) { return r.distance.value; },
          "m, of a sampled point of a patch from the surface.")
      .def_property_readonly("largest_distance_per_length",
                             &conversion::QualityReport::distance_per_length)
      .def_property_readonly(
          "worst_point",
          [](const conversion::QualityReport& r) { return point_array(r.distance.point); },
          "(3,), m: where the largest distance is; NaN where nothing was measured.")
      .def_property_readonly(
          "worst_place", [](const conversion::QualityReport& r) { return place_of(r.distance); },
          "(cell, u, v) of the surface near the worst point, or None.")
      .def_readonly("rms_distance", &conversion::QualityReport::rms_distance,
                    "m: root of the mean square over the area.")
      .def_readonly("area", &conversion::QualityReport::area,
                    "m2, of the patches that stand for cells.")
      .def_readonly("exact_share", &conversion::QualityReport::exact_share,
                    "Of the area, 0 to 1: where no distance above 1e-12 of the length was met.");
}

void bind_seams(ReportClass& report) {
  bind_seam_value(report, "largest_gap", "worst_gap_point", &conversion::SeamQuality::gap,
                  "m, between the curves of two patches at their seam.");
  bind_seam_value(report, "largest_seam_angle", "worst_seam_point", &conversion::SeamQuality::angle,
                  "rad, between normals of two patches at a seam that is no crease, farther than "
                  "normal_reach from irregular points.");
  bind_seam_value(report, "largest_seam_angle_at_points", "worst_seam_point_at_points",
                  &conversion::SeamQuality::angle_at_points,
                  "rad: the same within normal_reach of irregular points.");
  bind_seam_value(report, "largest_curvature_jump", "worst_curvature_point",
                  &conversion::SeamQuality::curvature_jump,
                  "1/m: of the normal curvature in the direction across a seam that is no crease, "
                  "farther than normal_reach from irregular points.");
  bind_seam_value(report, "largest_curvature_jump_at_points", "worst_curvature_point_at_points",
                  &conversion::SeamQuality::curvature_jump_at_points,
                  "1/m: the same within normal_reach of irregular points.");
}

void bind_counts(ReportClass& report) {
  report
      .def_property_readonly("patch_count",
                             [](const conversion::QualityReport& r) { return r.patches.size(); })
      .def_readonly("theoretical_patch_count", &conversion::QualityReport::theoretical_patch_count,
                    "The fewest rectangles that creases and irregular points allow, as counted.")
      .def_readonly("knot_count", &conversion::QualityReport::knot_count,
                    "Distinct knots of all patches.")
      .def_readonly("control_point_count", &conversion::QualityReport::control_point_count)
      .def_property_readonly(
          "patches", [](const conversion::QualityReport& r) { return list_of(r.patches); },
          "A dict for each patch: largest_distance, worst_point, worst_place, rms_distance, area, "
          "exact_area, cell_count (0: it stands for none, and has no distance), knot_count, "
          "control_point_count.")
      .def_property_readonly(
          "seams", [](const conversion::QualityReport& r) { return list_of(r.seams); },
          "A dict for each edge of two patches: edge, patches, is_smooth (no crease), and the "
          "values of the report. Seams that are not smooth have gaps only.");
}

}  // namespace

void bind_quality_report(py::module_& module) {
  ReportClass report(module, "QualityReport",
                     "How far patches are from the surface that they stand for.");
  bind_distances(report);
  bind_seams(report);
  bind_counts(report);
  report
      .def("text", &conversion::QualityReport::text,
           "A table: millimetres, degrees, places in metres.")
      .def("json", &conversion::QualityReport::json, "All of it as JSON, units in the names.");

  module.def(
      "measure_quality",
      [](const surface::LimitSurface& surface, const conversion::PatchSet& patches, int samples,
         std::optional<double> normal_reach, const py::object& progress) {
        const surface::Progress tell = progress_from(progress);
        const py::gil_scoped_release release;
        return conversion::measure_quality(surface, patches, {samples, normal_reach}, tell);
      },
      py::arg("surface"), py::arg("patches"), py::kw_only(), py::arg("samples") = 3,
      py::arg("normal_reach") = py::none(), py::arg("progress") = py::none(),
      "Measures a PatchSet against the LimitSurface it was made from, at samples of its own: "
      "`samples` (1 to 16) in each interval of knots and direction, crowding towards irregular "
      "points. normal_reach (m; 1e-6 of the length unless given): within it of irregular points, "
      "angles are told apart. progress takes the share done; what it raises ends the measurement. "
      "Returns a QualityReport.");
}

}  // namespace hull::bindings
