// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "bindings/arrays.h"
#include "bindings/move_limits.h"
#include "bindings/progress.h"
#include "modelling/fairing/curve_smoothing.h"
#include "modelling/fairing/fair_region.h"

namespace hull::bindings {
namespace {

using modelling::Faired;
using modelling::FairEnergy;
using modelling::FairRegion;

FairEnergy energy_from(const std::string& name) {
  if (name == "lengthwise") return FairEnergy::kLengthwise;
  if (name == "blend") return FairEnergy::kBlend;
  if (name == "thin_plate") return FairEnergy::kThinPlate;
  if (name == "curvature") return FairEnergy::kCurvature;
  if (name == "variation") return FairEnergy::kVariation;
  throw std::invalid_argument(
      "energy must be 'lengthwise', 'blend', 'thin_plate', 'curvature' or 'variation', not '" +
      name + "'.");
}

const char* name_of(Faired::Bound bound) {
  switch (bound) {
    case Faired::Bound::kDeviation:
      return "deviation";
    case Faired::Bound::kLargest:
      return "largest";
    default:
      return "nothing";
  }
}

struct BoundFaired {
  Faired result;
  std::optional<Vector3d> largest_place, folded_place;
};

py::object as_place(const std::optional<Vector3d>& place) {
  if (!place) return py::none();
  return py::array_t<double>(3, place->data());
}

void bind_faired(py::module_& module) {
  py::class_<BoundFaired>(module, "Faired",
                          "How a faired surface comes to lie: FairRegion.solve().")
      .def_property_readonly(
          "moves", [](const BoundFaired& f) { return to_array(f.result.moves); },
          "(n, 3), m: of all control points.")
      .def_property_readonly(
          "rms", [](const BoundFaired& f) { return f.result.rms; },
          "Root of the mean, by area over the region, of the surface's squared shift, m.")
      .def_property_readonly(
          "largest", [](const BoundFaired& f) { return f.result.largest; }, "The largest shift, m.")
      .def_property_readonly(
          "largest_place", [](const BoundFaired& f) { return as_place(f.largest_place); },
          "(3,), m: where on the surface, as it was, that is; None where nothing moves.")
      .def_property_readonly(
          "bound", [](const BoundFaired& f) { return name_of(f.result.bound); },
          "What keeps the surface from being fairer: 'deviation', 'largest' or 'nothing'.")
      .def_property_readonly(
          "energy_before", [](const BoundFaired& f) { return f.result.energy_before; },
          "Of the region.")
      .def_property_readonly("energy_after",
                             [](const BoundFaired& f) { return f.result.energy_after; })
      .def_property_readonly("steps", [](const BoundFaired& f) { return f.result.steps; })
      .def_property_readonly(
          "settled", [](const BoundFaired& f) { return f.result.settled; },
          "Whether it ended by itself, not by most_steps.")
      .def_property_readonly(
          "folded_place", [](const BoundFaired& f) { return as_place(f.folded_place); },
          "(3,), m: where on the surface, as it was, it is turned over then; None: nowhere.");
}

BoundFaired solved(const FairRegion& region, double deviation, double largest,
                   const DoubleArray& values, const py::object& progress) {
  const std::vector<double> of_conditions = numbers_from(values, "values");
  const surface::Progress told = progress_from(progress);
  const py::gil_scoped_release release;
  BoundFaired bound{region.solve(deviation, largest, of_conditions, told), {}, {}};
  const auto place = [&](int k) {
    return k < 0 ? std::optional<Vector3d>() : region.places().position(k);
  };
  bound.largest_place = place(bound.result.largest_place);
  bound.folded_place = place(bound.result.folded_place);
  return bound;
}

Eigen::MatrixXd matrix_from(const DoubleArray& array, const char* name) {
  const DoubleArray::Values values = array.values(name);
  if (values.size() == 0) return {};
  if (values.ndim() != 2) {
    throw std::invalid_argument(std::string(name) + " must have the shape (n, d).");
  }
  // Copied on return, from rows to Eigen's columns.
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), values.shape(0), values.shape(1));
}

py::array_t<double> as_array(const Eigen::MatrixXd& matrix) {
  py::array_t<double> array({matrix.rows(), matrix.cols()});
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      array.mutable_data(), matrix.rows(), matrix.cols()) = matrix;
  return array;
}

void bind_smoothing(py::module_& module) {
  using modelling::SmoothCurve;
  py::class_<SmoothCurve>(module, "SmoothCurve", "A spline near points: smooth_curve().")
      .def_readonly("degree", &SmoothCurve::degree)
      .def_property_readonly(
          "knots", [](const SmoothCurve& c) { return to_array(c.knots); },
          "(k,) the first and last degree + 1 times.")
      .def_property_readonly(
          "coefficients", [](const SmoothCurve& c) { return as_array(c.coefficients); },
          "(k - degree - 1, d).")
      .def_readonly("error", &SmoothCurve::error, "The weighted sum of squared distances.")
      .def_readonly("p", &SmoothCurve::p,
                    "What weighs that against the jumps; infinite where none had to be weighed.")
      .def_readonly("is_short_of_knots", &SmoothCurve::is_short_of_knots,
                    "Whether the deviation could not be met for want of knots.")
      .def(
          "evaluate",
          [](const SmoothCurve& curve, const DoubleArray& parameters, int order) {
            return as_array(curve.evaluate(numbers_from(parameters, "parameters"), order));
          },
          py::arg("parameters"), py::arg("order") = 0,
          "(n, d) at parameters (n,): the curve's points, or a derivative of an order up to the "
          "degree.");
  module.def(
      "smooth_curve",
      [](const DoubleArray& points, double deviation, const DoubleArray& parameters,
         const DoubleArray& weights, const DoubleArray& start, const DoubleArray& end,
         bool straight_start, bool straight_end, int degree, bool knots_at_points) {
        const modelling::SmoothingOptions options{numbers_from(parameters, "parameters"),
                                                  numbers_from(weights, "weights"),
                                                  {matrix_from(start, "start"), straight_start},
                                                  {matrix_from(end, "end"), straight_end},
                                                  degree,
                                                  knots_at_points};
        return modelling::smooth_curve(matrix_from(points, "points"), deviation, options);
      },
      py::arg("points"), py::arg("deviation"), py::kw_only(), py::arg("parameters") = py::tuple(),
      py::arg("weights") = py::tuple(), py::arg("start") = py::tuple(),
      py::arg("end") = py::tuple(), py::arg("straight_start") = false,
      py::arg("straight_end") = false, py::arg("degree") = 3, py::arg("knots_at_points") = false,
      "The SmoothCurve through points (n, d) whose mean deviation from them is that given (Dierckx "
      "1993): the least sum of squared jumps of the highest derivative, with as few knots as will "
      "do. 0 interpolates. parameters (n,): rising; without them lengths of chords. weights (n,). "
      "start, end: up to three rows, the place, the first and the second derivative there; three "
      "need the degree 5. straight_start, straight_end: the second derivative is zero there. "
      "degree: 1 to 5. knots_at_points: all of them have a knot where any is needed; that is the "
      "fairest. Points and such conditions must be degree + 1 or more.\n\n"
      "ValueError for what is none of these.");
}

std::vector<modelling::WishedSum> wishes_from(const py::iterable& sums, const DoubleArray& values,
                                              const DoubleArray& weights) {
  std::vector<modelling::WishedSum> wishes;
  const std::vector<double> wanted = numbers_from(values, "wished_values");
  const std::vector<double> costs = numbers_from(weights, "wished_weights");
  for (modelling::MoveCondition& sum : conditions_from(sums, "wished")) {
    wishes.push_back({std::move(sum), 0.0, 0.0});
  }
  if (wanted.size() != wishes.size() || costs.size() != wishes.size()) {
    throw std::invalid_argument("Each sum wished for must have a value and a weight.");
  }
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    wishes[i].value = wanted[i];
    wishes[i].weight = costs[i];
  }
  return wishes;
}

void bind_region(py::module_& module) {
  py::class_<FairRegion>(
      module, "FairRegion",
      "Chosen control points move so that the exact surface is as fair as can be within a "
      "deviation from what it was. Prepared once, so that solve() may follow a slider with the "
      "energies 'lengthwise', 'blend' and 'thin_plate'. It keeps to the surface as it is when "
      "made.")
      .def(py::init([](const surface::LimitSurface& surface, const py::object& points,
                       const std::string& energy, const py::object& locked,
                       const py::object& held_points, const DoubleArray& held_normals,
                       const py::object& tied, const DoubleArray& tied_directions,
                       const py::iterable& kept, bool keep_creases, bool keep_stations,
                       bool along_normals, const py::iterable& conditions, int most_steps,
                       const DoubleArray& before, double least_bend, const DoubleArray& emphasised,
                       const DoubleArray& factors, double reach, const py::iterable& wished,
                       const DoubleArray& wished_values, const DoubleArray& wished_weights) {
             modelling::FairOptions options;
             options.points = integers_from(points, "points");
             options.energy = energy_from(energy);
             options.limits =
                 limits_from(locked, held_points, held_normals, tied, tied_directions, kept);
             options.keep_creases = keep_creases;
             options.keep_stations = keep_stations;
             options.along_normals = along_normals;
             options.conditions = conditions_from(conditions, "conditions");
             options.most_steps = most_steps;
             options.wishes = wishes_from(wished, wished_values, wished_weights);
             const std::vector<Vector3d> points_before = points_from(before, "before");
             if (!points_before.empty()) {
               options.before = {points_before, least_bend, points_from(emphasised, "emphasised"),
                                 numbers_from(factors, "factors"), reach};
             }
             const py::gil_scoped_release release;
             return std::make_unique<FairRegion>(surface, options);
           }),
           py::arg("surface"), py::arg("points"), py::kw_only(), py::arg("energy") = "lengthwise",
           py::arg("locked") = py::tuple(), py::arg("held_points") = py::tuple(),
           py::arg("held_normals") = py::tuple(), py::arg("tied") = py::tuple(),
           py::arg("tied_directions") = py::tuple(), py::arg("kept") = py::tuple(),
           py::arg("keep_creases") = true, py::arg("keep_stations") = true,
           py::arg("along_normals") = true, py::arg("conditions") = py::tuple(),
           py::arg("most_steps") = modelling::FairOptions().most_steps,
           py::arg("before") = py::tuple(), py::arg("least_bend") = 0.0,
           py::arg("emphasised") = py::tuple(), py::arg("factors") = py::tuple(),
           py::arg("reach") = 0.0, py::arg("wished") = py::tuple(),
           py::arg("wished_values") = py::tuple(), py::arg("wished_weights") = py::tuple(),
           "points (k,): control points that may move. energy: 'thin_plate' (squared second "
           "derivatives to the metric of the surface as it was), 'lengthwise' (of these what bends "
           "along the ship: sections keep their own bend), 'blend' (what is not blended from rows "
           "along "
           "and across: the squared derivatives by u³ v³ of single cells), 'curvature' (the "
           "integral "
           "of the squared principal curvatures) or 'variation' (of the squared changes of "
           "curvature). "
           "locked, held_points, held_normals, tied, tied_directions, kept, conditions: as of "
           "Reshape. "
           "keep_creases: points of creases, borders and corners stay. keep_stations: x stays, bit "
           "by bit. along_normals: points move along the surface's normal (with keep_stations its "
           "part "
           "across the ship), not along the surface. most_steps: of 'curvature' and 'variation'. "
           "before (n, 3): control points of the surface before a change; the energy is then how "
           "much each place bends otherwise than there, in proportion to how much it did, where "
           "bends below least_bend, 1/m, count as that one. emphasised (k, 3): places on that "
           "surface within whose reach, m, it counts so many times as factors (k,) tell, the "
           "largest of several. wished: sums, as conditions are, of which each is to come to its "
           "value of wished_values (w,): weight · (sum - value)², of wished_weights (w,), is added "
           "to "
           "the energy, which must be none of these two.\n\n"
           "The surface is read here and not kept. ValueError for what is none of these, and where "
           "no point may move.")
      .def_property_readonly("area", &FairRegion::area,
                             "m²: of the region, where the moving points have any weight.")
      .def("solve", &solved, py::arg("deviation"), py::kw_only(),
           py::arg("largest") = std::numeric_limits<double>::infinity(),
           py::arg("values") = py::tuple(), py::arg("progress") = py::none(),
           "The Faired for a root mean square shift by area over the region, deviation, m; it is "
           "met unless the surface is as fair as it can be with less, or the largest shift, m, "
           "binds. values: of the conditions; ValueError where they need longer moves than both "
           "let. progress: a callable that takes the share done, 0 to 1; what it raises ends it.");
}

}  // namespace

void bind_fairing(py::module_& module) {
  bind_faired(module);
  bind_region(module);
  bind_smoothing(module);
  module.def(
      "fair_energy",
      [](const surface::LimitSurface& surface, const std::string& energy) {
        return modelling::fair_energy(surface, energy_from(energy));
      },
      py::arg("surface"), py::arg("energy"),
      "The energy of a whole surface: 'thin_plate' and 'curvature' are numbers, 8 π of a sphere, "
      "and 'lengthwise' is one; 'blend' is m², 'variation' 1/m².");
}

}  // namespace hull::bindings
