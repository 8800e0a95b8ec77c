// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/fairness/curve_fairness.h"
#include "bindings/arrays.h"
#include "bindings/casts.h"

namespace hull::bindings {
namespace {

// A curve of which only what is to one side of the centre plane may be wanted, or which may stand
// for its mirror image.
struct SeenCurve {
  const analysis::CurveFairness* curve;
  int side;  // 1 to port, -1 to starboard, 0 all of it
  bool flipped;

  bool wants(const Vector3d& p) const { return p.y() * side >= 0.0; }
  Vector3d seen(const Vector3d& v) const { return flipped ? Vector3d(v.x(), -v.y(), v.z()) : v; }
};

std::vector<SeenCurve> seen_curves(const py::list& curves, const std::vector<int>& sides,
                                   const std::vector<bool>& flips) {
  if (sides.size() != curves.size() || flips.size() != curves.size()) {
    throw std::invalid_argument("Give a side and a flip for each of " +
                                std::to_string(curves.size()) + " curves.");
  }
  std::vector<SeenCurve> seen;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    seen.push_back({&cast_or_refuse<const analysis::CurveFairness&>(
                        curves[i], "curves must be a list of CurveFairness."),
                    sides[i], flips[i]});
  }
  return seen;
}

py::tuple comb_arrays(const py::list& curves, const std::vector<int>& sides,
                      const std::vector<bool>& flips) {
  std::vector<Vector3d> points, bends;
  std::vector<std::array<int, 2>> pairs;
  for (const SeenCurve& seen : seen_curves(curves, sides, flips)) {
    const analysis::CurveFairness& curve = *seen.curve;
    for (std::size_t stretch = 0; stretch + 1 < curve.starts.size(); ++stretch) {
      bool follows = false;  // knuckles break the line, and so does what is not wanted
      for (int i = curve.starts[stretch]; i < curve.starts[stretch + 1]; ++i) {
        const analysis::CurveSample& at = curve.samples[i];
        const bool wanted = seen.wants(at.point);
        if (wanted) {
          const int number = static_cast<int>(points.size());
          if (follows) pairs.push_back({number - 1, number});
          points.push_back(seen.seen(at.point));
          bends.push_back(seen.seen(at.curvature));
        }
        follows = wanted;
      }
    }
  }
  return py::make_tuple(to_array(points), to_array(bends), to_array(pairs));
}

py::tuple comb_marks(const py::list& curves, const std::vector<int>& sides,
                     const std::vector<bool>& flips, double straight) {
  std::array<std::vector<Vector3d>, 3> found;  // inflections, peaks, and where it bends least
  for (const SeenCurve& seen : seen_curves(curves, sides, flips)) {
    for (const analysis::CurveMark& mark : seen.curve->marks) {
      if (!seen.wants(mark.point)) continue;
      const bool is_inflection = mark.kind == analysis::CurveMark::Kind::kInflection;
      // What is straight to rounding bends to neither side.
      const bool is_peak = mark.peak && std::abs(mark.curvature) > straight;
      found[is_inflection ? 0 : (is_peak ? 1 : 2)].push_back(seen.seen(mark.point));
    }
  }
  return py::make_tuple(to_array(found[0]), to_array(found[1]), to_array(found[2]));
}

}  // namespace

void bind_comb_arrays(py::module_& module) {
  module.def("comb_arrays", &comb_arrays, py::arg("curves"), py::kw_only(), py::arg("sides"),
             py::arg("flips"),
             "What combs of many curves are drawn of, in one go: points (n, 3) in m, curvature "
             "vectors (n, 3) in 1/m, and pairs (m, 2) of points that follow one another, not "
             "across knuckles. curves: list of CurveFairness; sides: of each 1 or -1 where only "
             "points to port or starboard of the centre plane are wanted, else 0; flips: whether "
             "it stands for its mirror image. ValueError where their numbers differ.");
  module.def("comb_marks", &comb_marks, py::arg("curves"), py::kw_only(), py::arg("sides"),
             py::arg("flips"), py::arg("straight"),
             "Points (n, 3), m, of the marks of such curves: inflections, where they bend most, "
             "and where they bend least, or no more than straight, 1/m. The other arguments as "
             "comb_arrays() takes them.");
}

}  // namespace hull::bindings
