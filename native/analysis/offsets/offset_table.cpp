// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/offsets/offset_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/offsets/feature_offsets.h"
#include "analysis/offsets/line_planes.h"
#include "analysis/sections/port_side.h"
#include "analysis/sections/sections.h"
#include "mesh/tolerances.h"

namespace hull::analysis {

namespace {

// All of the mesh's size.
constexpr double kSectionTolerance = 1e-7;
constexpr double kOnKnuckle = 5e-6;

void check_positions(const std::vector<double>& positions, const std::string& kind) {
  if (positions.size() > kMostOffsetPositions) {
    throw std::invalid_argument("A table of offsets has room for " +
                                std::to_string(kMostOffsetPositions) + " " + kind + "s, not " +
                                std::to_string(positions.size()) + ": space them wider");
  }
  for (const double position : positions) {
    if (!std::isfinite(position)) {
      throw std::invalid_argument("A " + kind + "'s position is not a finite number");
    }
  }
}

// The station's curves to port.
class Station {
 public:
  Station(const surface::LimitSurface& surface, double x)
      : same_(kSamePosition * surface.mesh().size()),
        flat_(kInSection * surface.mesh().size()),
        on_knuckle_(kOnKnuckle * surface.mesh().size()),
        curves_(section(surface, line_plane(surface, Axis::kX, x),
                        SectionOptions{kSectionTolerance * surface.mesh().size(),
                                       kInSection * surface.mesh().size()})) {}

  Offset half_breadth(double z) const {
    Vector3d best(0.0, -1.0, 0.0);
    for_each_crossing(2, z, [&best](const Vector3d& p) {
      if (p.y() > best.y()) best = p;
    });
    // Nothing at that height, or only to starboard.
    if (best.y() < -same_) return {};
    return {std::max(best.y(), 0.0), is_on_knuckle(best)};
  }

  Offset height(double y) const {
    bool found = false;
    Vector3d best = Vector3d::Zero();
    for_each_crossing(1, y, [&](const Vector3d& p) {
      if (!found || p.z() < best.z()) best = p;
      found = true;
    });
    if (!found) return {};
    return {best.z(), is_on_knuckle(best)};
  }

 private:
  // The points in which the curves meet the coordinate's value, or nearly touch it.
  template <class Visit>
  void for_each_crossing(int axis, double value, const Visit& visit) const {
    for (const SectionCurve& curve : curves_) {
      std::vector<double> above;
      for (const Vector3d& p : curve.points) above.push_back(p[axis] - value);
      for (std::size_t i = 0; i < above.size(); ++i) {
        // Points that are there as far as positions tell, then one that is not, or the end.
        const std::size_t first = i;
        while (i < above.size() && std::abs(above[i]) <= same_) ++i;
        if (!passes(above, first, i)) {
          // Touches and flats: each of the points is there, and the caller takes the outermost or
          // lowest.
          for (std::size_t k = first; k < i; ++k) visit(curve.points[k]);
        }
        // All legs from the point before the stretch to the point behind it.
        for (std::size_t k = std::max<std::size_t>(first, 1); k <= i && k < above.size(); ++k) {
          if ((above[k - 1] < 0.0) == (above[k] < 0.0)) continue;
          const Vector3d &a = curve.points[k - 1], &b = curve.points[k];
          // On the chord, which is as near to the curve as the section's tolerance.
          visit(Vector3d(a + above[k - 1] / (above[k - 1] - above[k]) * (b - a)));
        }
      }
    }
  }

  // Whether a curve goes from one side to the other between the points before `first` and at `end`,
  // and does not lie along the plane on its way, as a flat bottom or a step does. Then its crossing
  // is nearer than the points between, which where it runs all but flat are far from one another.
  bool passes(const std::vector<double>& above, std::size_t first, std::size_t end) const {
    if (first == 0 || end == above.size()) return false;
    for (std::size_t k = first + 1; k < end; ++k) {
      if (std::abs(above[k] - above[k - 1]) <= flat_) return false;
    }
    return (above[first - 1] < 0.0) != (above[end] < 0.0);
  }

  bool is_on_knuckle(const Vector3d& p) const {
    for (const SectionCurve& curve : curves_) {
      for (const int i : curve.knuckles) {
        if ((curve.points[i] - p).norm() <= on_knuckle_) return true;
      }
    }
    return false;
  }

  double same_, flat_, on_knuckle_;
  std::vector<SectionCurve> curves_;
};

}  // namespace

OffsetTable offset_table(const surface::LimitSurface& surface, const std::vector<double>& stations,
                         const std::vector<double>& waterlines, const std::vector<double>& buttocks,
                         bool mirrored) {
  check_positions(stations, "station");
  check_positions(waterlines, "waterline");
  check_positions(buttocks, "buttock");
  for (const double y : buttocks) {
    if (y < 0.0) {
      throw std::invalid_argument("A buttock at y = " + std::to_string(y) +
                                  " m has no offsets: they are of the port half, from 0 up");
    }
  }
  const std::string missing = missing_port_side(surface, mirrored);
  if (!missing.empty()) throw std::invalid_argument(missing);
  OffsetTable table{stations, waterlines, buttocks, {}, {}, {}};
  for (const double x : stations) {
    // Cut once for all lines of the table.
    const Station station(surface, x);
    for (const double z : waterlines) table.half_breadths.push_back(station.half_breadth(z));
    for (const double y : buttocks) table.heights.push_back(station.height(y));
  }
  table.features = feature_offsets(surface, stations);
  return table;
}

}  // namespace hull::analysis
