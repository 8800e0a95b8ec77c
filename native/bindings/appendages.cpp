// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "analysis/appendages/appendage.h"
#include "analysis/appendages/joined_shells.h"
#include "bindings/arrays.h"
#include "bindings/classes.h"

namespace hull::bindings {
namespace {

using analysis::Appendage;
using analysis::SectionForm;

double on_chord(double x) {
  if (!(x >= 0.0 && x <= 1.0)) throw std::invalid_argument("x must be from 0 to 1.");
  return x;
}

// Points of a grid on each patch of the shell, and its quadrilaterals.
py::tuple grid_of(const Appendage& appendage, int divisions) {
  if (divisions < 1 || divisions > 64) {
    throw std::invalid_argument("divisions must be from 1 to 64.");
  }
  std::vector<Vector3d> points;
  std::vector<int> corners;
  const analysis::ClosedShell shell = analysis::shell_of(appendage.shape);
  const int side = divisions + 1;
  surface::SurfaceJet jet;
  for (const surface::BezierPatch& patch : shell.patches()) {
    const int first = static_cast<int>(points.size());
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        surface::evaluate_first(patch, static_cast<double>(i) / divisions,
                                static_cast<double>(j) / divisions, jet);
        points.push_back(jet.point);
      }
    }
    for (int j = 0; j < divisions; ++j) {
      for (int i = 0; i < divisions; ++i) {
        const int at = first + j * side + i;
        // Counter-clockwise in (u, v).
        corners.insert(corners.end(), {at, at + 1, at + side + 1, at + side});
      }
    }
  }
  const auto count = static_cast<py::ssize_t>(corners.size() / 4);
  return py::make_tuple(to_array(points), to_array(corners).reshape({count, py::ssize_t{4}}));
}

py::array_t<bool> inside_of(const Appendage& appendage, const DoubleArray& points) {
  const std::vector<Vector3d> all = points_from(points, "points");
  py::array_t<bool> inside(static_cast<py::ssize_t>(all.size()));
  const analysis::ClosedShell shell = analysis::shell_of(appendage.shape);
  for (std::size_t i = 0; i < all.size(); ++i) {
    inside.mutable_at(static_cast<py::ssize_t>(i)) = shell.is_inside(all[i]);
  }
  return inside;
}

analysis::ShellMoments moments_of(const Appendage& appendage) {
  return analysis::moments_of(analysis::shell_of(appendage.shape));
}

// What of each shape a script asks for by one name.
struct Form {
  const char* shape;
  std::array<Vector3d, 2> ends;
  Vector3d chord_direction;
  std::array<double, 2> chords, thicknesses;  // m; of the chord
};

Form form_of(const analysis::CylinderShape& c) {
  return {"cylinder",
          {c.start, c.end},
          (c.end - c.start).unitOrthogonal(),
          {2.0 * c.start_radius, 2.0 * c.end_radius},
          {1.0, 1.0}};
}

Form form_of(const analysis::FoilShape& f) {
  const double own = SectionForm(f.section).thickness();
  const auto or_own = [own](double given) { return given > 0.0 ? given : own; };
  return {"foil",
          {f.root, f.tip},
          f.chord_direction.normalized(),
          {f.root_chord, f.tip_chord},
          {or_own(f.root_thickness), or_own(f.tip_thickness)}};
}

Form form_of(const analysis::BulbShape& b) {
  const double length = (b.tail - b.nose).norm();
  return {"bulb",
          {b.nose, b.tail},
          (b.tail - b.nose) / length,
          {length, length},
          {b.diameter / length, b.diameter / length}};
}

Form form_of(const Appendage& appendage) {
  return std::visit([](const auto& shape) { return form_of(shape); }, appendage.shape);
}

void bind_form(py::class_<Appendage>& appendage) {
  appendage
      .def_property_readonly(
          "shape", [](const Appendage& a) { return form_of(a).shape; },
          "\"cylinder\", \"foil\" or \"bulb\".")
      .def_property_readonly(
          "ends",
          [](const Appendage& a) {
            const Form form = form_of(a);
            return to_array(std::vector<Vector3d>(form.ends.begin(), form.ends.end()));
          },
          "(2, 3), m: of a cylinder's axis, leading edges of root and tip, or nose and tail.")
      .def_property_readonly(
          "chord_direction", [](const Appendage& a) { return form_of(a).chord_direction; },
          "(3,), of length 1: to the trailing edge; of a cylinder any across it.")
      .def_property_readonly(
          "chords", [](const Appendage& a) { return form_of(a).chords; },
          "[at one end, at the other], m: of a bulb its length, of a cylinder its diameters.")
      .def_property_readonly(
          "thicknesses", [](const Appendage& a) { return form_of(a).thicknesses; },
          "Likewise, of the chord.");
}

void bind_shapes(py::module_& module) {
  module.def(
      "cylinder",
      [](const DoubleArray& start, const DoubleArray& end, double radius,
         const std::optional<double>& end_radius, const std::string& name, bool cut,
         bool mirrored) {
        const analysis::CylinderShape shape{point_from(start, "start"), point_from(end, "end"),
                                            radius, end_radius.value_or(radius)};
        // For what it refuses alone: so an Appendage that is made has a shell.
        analysis::shell_of(shape);
        return Appendage{name, shape, cut, mirrored};
      },
      py::arg("start"), py::arg("end"), py::arg("radius"), py::kw_only(),
      py::arg("end_radius") = py::none(), py::arg("name") = "cylinder", py::arg("cut") = false,
      py::arg("mirrored") = false,
      "An Appendage: a circular cylinder between two points (3,), m, or a cone with its tip cut "
      "off. cut: it is cut out of the hull, as a tunnel. mirrored: on the other side too. "
      "ValueError for lengths that are not positive.");
  module.def(
      "foil",
      [](const std::string& section, const DoubleArray& root, const DoubleArray& tip,
         double root_chord, const std::optional<double>& tip_chord,
         const DoubleArray& chord_direction, const DoubleArray& thickness_direction,
         double root_thickness, double tip_thickness, const std::string& name, bool cut,
         bool mirrored) {
        const analysis::FoilShape shape{section,
                                        point_from(root, "root"),
                                        point_from(tip, "tip"),
                                        point_from(chord_direction, "chord_direction"),
                                        point_from(thickness_direction, "thickness_direction"),
                                        root_chord,
                                        tip_chord.value_or(root_chord),
                                        root_thickness,
                                        tip_thickness};
        analysis::shell_of(shape);
        return Appendage{name, shape, cut, mirrored};
      },
      py::arg("section"), py::arg("root"), py::arg("tip"), py::arg("root_chord"), py::kw_only(),
      py::arg("tip_chord") = py::none(),
      py::arg("chord_direction") = py::make_tuple(-1.0, 0.0, 0.0),
      py::arg("thickness_direction") = py::make_tuple(0.0, 1.0, 0.0),
      py::arg("root_thickness") = 0.0, py::arg("tip_thickness") = 0.0, py::arg("name") = "foil",
      py::arg("cut") = false, py::arg("mirrored") = false,
      "An Appendage: straight lines between two sections whose leading edges are root and tip "
      "(3,), "
      "m. section: as of SectionForm. chord_direction (3,): to the trailing edge. "
      "root_thickness, tip_thickness: of the chord; 0: the section's own.");
  module.def(
      "bulb",
      [](const std::string& section, const DoubleArray& nose, const DoubleArray& tail,
         double diameter, const std::string& name, bool cut, bool mirrored) {
        const analysis::BulbShape shape{section, point_from(nose, "nose"), point_from(tail, "tail"),
                                        diameter};
        analysis::shell_of(shape);
        return Appendage{name, shape, cut, mirrored};
      },
      py::arg("section"), py::arg("nose"), py::arg("tail"), py::arg("diameter"), py::kw_only(),
      py::arg("name") = "bulb", py::arg("cut") = false, py::arg("mirrored") = false,
      "An Appendage: a body of revolution with a symmetric section's outline.");
}

}  // namespace

void bind_appendages(py::module_& module) {
  py::class_<SectionForm>(module, "SectionForm",
                          "A section of unit chord of NACA's families: four digits (\"0012\", "
                          "\"2412\"), five (\"23012\", mean lines 210 to 250, and reflexed ones, "
                          "\"23112\", 221 to 251), both with another nose and place of the largest "
                          "thickness (\"0012-64\"); series 63 to 65 and 63A to 65A (\"63-012\", "
                          "\"63-412\", \"64A010\", \"65-215 a=0.5\"). ValueError for other names.")
      .def(py::init<const std::string&>(), py::arg("name"))
      .def_property_readonly("name", &SectionForm::name)
      .def_property_readonly("thickness", &SectionForm::thickness, "Of the chord, by its name.")
      .def_property_readonly("symmetric", &SectionForm::is_symmetric)
      .def(
          "half_thickness",
          [](const SectionForm& form, double x) { return form.half_thickness(on_chord(x)); },
          py::arg("x"), "Perpendicular to the mean line at x of it, of the chord.")
      .def(
          "mean_line",
          [](const SectionForm& form, double x) { return form.mean_line(on_chord(x)); },
          py::arg("x"), "y at x, of the chord.")
      .def(
          "mean_slope",
          [](const SectionForm& form, double x) { return form.mean_slope(on_chord(x)); },
          py::arg("x"), "dy/dx of the mean line at x; where it is infinite, that 1e-15 beside it.")
      .def(
          "point",
          [](const SectionForm& form, double x, bool lower) {
            return form.outline(std::sqrt(on_chord(x)), lower ? -1 : 1, 1.0, true).place;
          },
          py::arg("x"), py::kw_only(), py::arg("lower") = false,
          "(2,): the outline's point at x of the mean line, of the chord.")
      .def(
          "spline",
          [](const SectionForm& form) {
            py::list parts;
            for (const auto& part : analysis::outline_of(form, form.thickness(), false)) {
              parts.append(to_array(std::vector<Eigen::Vector2d>(part.begin(), part.end())));
            }
            return parts;
          },
          "A list of arrays (4, 2): Bézier points of the cubics that bodies are made of, from the "
          "trailing edge along the upper side, and back along the lower one.");
  py::class_<Appendage> appendage(module, "Appendage",
                                  "A body that HullBody.join() joins to a hull or cuts out of it: "
                                  "of cylinder(), foil() or bulb().");
  appendage.def_readonly("name", &Appendage::name)
      .def_readonly("cut", &Appendage::is_cut)
      .def_readonly("mirrored", &Appendage::mirrored, "Its image is one, too.")
      .def_property_readonly(
          "volume", [](const Appendage& a) { return moments_of(a).first.trace() / 3.0; },
          "m³, of itself without its image.")
      .def_property_readonly(
          "area", [](const Appendage& a) { return moments_of(a).area; }, "m².")
      .def_property_readonly(
          "centre",
          [](const Appendage& a) -> Vector3d {
            const analysis::ShellMoments m = moments_of(a);
            return m.second.topRows<3>().diagonal() * 1.5 / m.first.trace();
          },
          "(3,), m, of the volume.")
      .def(
          "grid", &grid_of, py::arg("divisions") = 1,
          "(points (n, 3), quadrilaterals (m, 4)) on its surface, to be shown. Points at the sides "
          "of patches are there more than once.")
      .def("inside", &inside_of, py::arg("points"), "(n,) of bool: which points are within.");
  bind_form(appendage);
  bind_shapes(module);
}

}  // namespace hull::bindings
