// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/closings.h"

#include <algorithm>
#include <cmath>

#include "analysis/immersion/border_centroid.h"
#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

// Of the square of a loop's extent: a projection without area.
constexpr double kNoArea = 1e-9;

using Cubic = std::array<Vector3d, 4>;  // Bézier points

struct BezierLoop {
  std::vector<Cubic> spans;  // in the surface's direction
  std::vector<int> cells;    // of each
};

std::vector<BezierLoop> border_loops(const std::vector<BorderEdge>& border) {
  std::vector<BezierLoop> loops;
  for (const BorderEdge& edge : border) {
    // Loops come one after the other, numbered from 0, and their edges in order.
    if (edge.loop == static_cast<int>(loops.size())) loops.emplace_back();
    loops.back().spans.push_back(edge.points);
    loops.back().cells.push_back(edge.half_edge / 4);
  }
  return loops;
}

// ∮ (z dx - x dz) / 2 of the Bézier cubics; exact (Farin 2002, area under a Bézier curve).
double area_on_centre_plane(const BezierLoop& loop) {
  const auto cross = [](const Vector3d& a, const Vector3d& b) {
    return a.z() * b.x() - a.x() * b.z();
  };
  double area = 0.0;
  for (const Cubic& c : loop.spans) {
    area += (6.0 * cross(c[0], c[1]) + 3.0 * cross(c[0], c[2]) + cross(c[0], c[3]) +
             3.0 * cross(c[1], c[2]) + 3.0 * cross(c[1], c[3]) + 6.0 * cross(c[2], c[3])) /
            20.0;
  }
  return area;
}

struct Box {
  Vector3d low, high;
};

template <class Spans>
Box extent_of(const Spans& spans) {
  Box extent{spans[0][0], spans[0][0]};
  for (const Cubic& cubic : spans) {
    for (const Vector3d& p : cubic) {
      extent.low = extent.low.cwiseMin(p);
      extent.high = extent.high.cwiseMax(p);
    }
  }
  return extent;
}

// The control points of a uniform span, the inverse of (p0 + 4 p1 + p2) / 6, (2 p1 + p2) / 3 and so
// on, so that closings are spans like all others.
Cubic bspline_from_bezier(const Cubic& b) {
  return {6.0 * b[0] - 7.0 * b[1] + 2.0 * b[2], 2.0 * b[1] - b[2], 2.0 * b[2] - b[1],
          2.0 * b[1] - 7.0 * b[2] + 6.0 * b[3]};
}

// The ruled surface from the border, run through against the surface's direction, to `target`.
surface::BicubicPoints ruled(const Cubic& border, const Cubic& target) {
  const Cubic near = bspline_from_bezier({border[3], border[2], border[1], border[0]});
  const Cubic far = bspline_from_bezier({target[3], target[2], target[1], target[0]});
  surface::BicubicPoints points;
  for (int b = 0; b < 4; ++b) {
    // Coefficients -1, 0, 1, 2 make the straight line from 0 to 1.
    for (int a = 0; a < 4; ++a) points[4 * b + a] = near[a] + (b - 1) * (far[a] - near[a]);
  }
  return points;
}

Cubic athwartships(const Cubic& border, double y) {
  Cubic target = border;
  for (Vector3d& p : target) p.y() = y;
  return target;
}

bool is_transverse(const Box& extent, double size) {
  return extent.high.x() - extent.low.x() <= kInPlane * size;
}

}  // namespace

Vector3d border_centroid(const std::vector<std::array<Vector3d, 4>>& spans) {
  Vector3d moment = Vector3d::Zero();
  double length = 0.0;
  for (const Cubic& c : spans) {
    for (int i = 0; i < 3; ++i) {
      const double l = (c[i + 1] - c[i]).norm();
      moment += 0.5 * l * (c[i] + c[i + 1]);
      length += l;
    }
  }
  return length > 0.0 ? Vector3d(moment / length) : spans[0][0];
}

std::vector<ClosingPatch> closing_patches(const surface::LimitSurface& surface,
                                          const std::vector<BorderEdge>& edges, bool mirrored) {
  const double size = surface.mesh().size();
  std::vector<ClosingPatch> result;
  for (const BezierLoop& loop : border_loops(edges)) {
    const Box extent = extent_of(loop.spans);
    const double diagonal = (extent.high - extent.low).norm();
    // A half that ends short of the centre plane, as that of a catamaran, is closed by itself.
    const bool at_centre = mirrored && extent.low.y() <= kOnCentrePlane * size;
    const bool across =
        at_centre || std::abs(area_on_centre_plane(loop)) <= kNoArea * diagonal * diagonal;
    const Vector3d apex = border_centroid(loop.spans);
    // A border that is symmetric about a plane has its centroid there, where its two sides meet.
    const double y = at_centre ? 0.0 : apex.y();
    for (std::size_t i = 0; i < loop.spans.size(); ++i) {
      const Cubic& border = loop.spans[i];
      const Box own = extent_of(std::array<Cubic, 1>{border});
      // There the other half goes on: no water comes in.
      const bool in_centre_plane =
          at_centre && std::max(-own.low.y(), own.high.y()) <= kOnCentrePlane * size;
      const Cubic target = across ? athwartships(border, y) : Cubic{apex, apex, apex, apex};
      // Lines athwartships from a curve at one x stay at that x; a fan is plane only with the whole
      // loop.
      const bool transverse = is_transverse(across ? own : extent, size);
      result.push_back(
          {loop.cells[i], ruled(border, target), border, !transverse && !in_centre_plane});
    }
  }
  return result;
}

// An end, or where the height has no slope.
DownfloodingPoint lowest_point(const std::array<Vector3d, 4>& c, const Vector3d& up) {
  const double h[] = {up.dot(c[0]), up.dot(c[1]), up.dot(c[2]), up.dot(c[3])};
  // A third of the derivative: a + b t + d t².
  const double a = h[1] - h[0], b = 2.0 * (h[2] - 2.0 * h[1] + h[0]);
  const double d = h[3] - 3.0 * h[2] + 3.0 * h[1] - h[0];
  const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * d));
  DownfloodingPoint lowest{h[0], c[0]};
  // The last is for d = 0. Quotients by zero are infinite or no numbers, and in no interval; places
  // that are no minima do no harm.
  for (double t : {1.0, (-b + root) / (2.0 * d), (-b - root) / (2.0 * d), -a / b}) {
    if (!(t > 0.0 && t <= 1.0)) continue;
    const double s = 1.0 - t;
    const Vector3d p = s * s * (s * c[0] + 3.0 * t * c[1]) + t * t * (3.0 * s * c[2] + t * c[3]);
    if (up.dot(p) < lowest.height) lowest = {up.dot(p), p};
  }
  return lowest;
}

}  // namespace hull::analysis
