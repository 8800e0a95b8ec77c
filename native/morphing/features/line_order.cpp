// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/line_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hull::morphing {
namespace {

using surface::CreaseCurve;

// Along no edge, and across no area, that ships usually have: of equals rounding would choose.
const Vector3d kSlanting(1.0, 0.37, 0.61);

Vector3d end_of(const CreaseCurve& curve, bool at_begin) {
  return curve.evaluate(at_begin ? 0.0 : curve.edge_count(), 0).point;
}

// Whether a line from one point to the other runs forward, upwards or outwards, whichever is most.
bool is_in_order(const Vector3d& from, const Vector3d& to) {
  const Vector3d way = to - from;
  if (std::abs(way.x()) >= std::max(std::abs(way.y()), std::abs(way.z()))) return way.x() >= 0.0;
  if (std::abs(way.z()) >= std::abs(way.y())) return way.z() >= 0.0;
  // Lines of a whole hull go over the centre plane, from starboard to port as on one side of it.
  if (from.y() * to.y() < 0.0) return way.y() >= 0.0;
  return std::abs(to.y()) >= std::abs(from.y());
}

void turn_round(std::vector<Link>& line) {
  std::reverse(line.begin(), line.end());
  for (Link& link : line) link.is_backward = !link.is_backward;
}

bool is_closed(const std::vector<CreaseCurve>& curves, const std::vector<Link>& line) {
  const CreaseCurve &first = curves[line.front().chain], &last = curves[line.back().chain];
  if (first.closed()) return true;
  const std::vector<int>&v = first.vertices(), &w = last.vertices();
  return (line.front().is_backward ? v.back() : v.front()) ==
         (line.back().is_backward ? w.front() : w.back());
}

// A place at which a closed line passes a control point, in the hull's box.
struct Pass {
  Vector3d at;
  std::size_t link;
  int vertex;
};

std::vector<Pass> passes_of(const std::vector<CreaseCurve>& curves, const HullBox& hull,
                            const std::vector<Link>& line) {
  std::vector<Pass> passes;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const CreaseCurve& curve = curves[line[k].chain];
    const int count = curve.edge_count();
    // Without the last one, with which the next chain begins.
    for (int i = 0; i < count; ++i) {
      const int vertex = line[k].is_backward ? count - i : i;
      passes.push_back({hull.relative(curve.evaluate(vertex, 0).point), k, vertex % count});
    }
  }
  return passes;
}

int set_closed_order(const std::vector<CreaseCurve>& curves, const HullBox& hull,
                     std::vector<Link>& line) {
  const std::vector<Pass> passes = passes_of(curves, hull, line);
  Vector3d area = Vector3d::Zero();
  const Vector3d& origin = passes.front().at;
  for (std::size_t i = 1; i + 1 < passes.size(); ++i) {
    area += (passes[i].at - origin).cross(passes[i + 1].at - origin);
  }
  const bool is_whole = curves[line.front().chain].closed();
  const Pass* first = nullptr;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    // Chains are whole: a line of several begins with one of them.
    if (!is_whole && i > 0 && passes[i].link == passes[i - 1].link) continue;
    if (!first || passes[i].at.dot(kSlanting) < first->at.dot(kSlanting)) first = &passes[i];
  }
  std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(first->link), line.end());
  if (area.dot(kSlanting) < 0.0) turn_round(line);
  return is_whole ? first->vertex : 0;
}

}  // namespace

int set_order(const std::vector<CreaseCurve>& curves, const HullBox& hull,
              std::vector<Link>& line) {
  if (is_closed(curves, line)) return set_closed_order(curves, hull, line);
  const Vector3d from = end_of(curves[line.front().chain], !line.front().is_backward);
  const Vector3d to = end_of(curves[line.back().chain], line.back().is_backward);
  if (!is_in_order(from, to)) turn_round(line);
  return 0;
}

}  // namespace hull::morphing
