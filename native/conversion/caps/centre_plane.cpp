// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/caps/centre_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace hull::conversion {
namespace {

struct PlaneLoop {
  EdgePath path;
  std::vector<Vector2d> polygon;  // as seen from outside
  double area = 0.0;              // negative: a hole
};

class Loops {
 public:
  Loops(CapMaker& maker, const EdgePath& edges, bool is_port_half)
      : maker_(maker), is_port_half_(is_port_half) {
    for (const DirectedEdge& edge : edges) from_[maker.from(edge)].push_back(edge);
  }

  std::vector<PlaneLoop> make() {
    std::vector<PlaneLoop> loops;
    for (auto& [vertex, leaving] : from_) {
      while (!leaving.empty()) loops.push_back(loop_from(vertex));
    }
    return loops;
  }

 private:
  // x to the right for who looks at the face from outside, z up.
  Vector2d seen(const Vector3d& point) const {
    return {is_port_half_ ? point.x() : -point.x(), point.z()};
  }

  PlaneLoop loop_from(int vertex) {
    PlaneLoop loop;
    DirectedEdge edge = from_[vertex].back();
    from_[vertex].pop_back();
    for (;;) {
      loop.path.push_back(edge);
      add_points(edge, loop.polygon);
      const int at = maker_.to(edge);
      // Back where it began, even if others go on from there.
      if (at == vertex) break;
      edge = take_next(edge, at);
    }
    for (std::size_t i = 0; i < loop.polygon.size(); ++i) {
      const Vector2d &a = loop.polygon[i], &b = loop.polygon[(i + 1) % loop.polygon.size()];
      loop.area += 0.5 * cross(a, b);
    }
    return loop;
  }

  void add_points(const DirectedEdge& edge, std::vector<Vector2d>& polygon) const {
    const BSplineCurve curve = maker_.curve(edge);
    // Chords enough to tell which way a loop runs, and what lies in it.
    constexpr int kSteps = 4;
    for (std::size_t k = 0; k + 1 < curve.knots.size(); ++k) {
      const double begin = curve.knots[k], step = (curve.knots[k + 1] - begin) / kSteps;
      for (int i = 0; i < kSteps && step > 0.0; ++i) {
        polygon.push_back(seen(curve.position(begin + i * step)));
      }
    }
  }

  // Where loops touch in a vertex, the one furthest to the left: so none crosses itself.
  DirectedEdge take_next(const DirectedEdge& last, int vertex) {
    auto& leaving = from_[vertex];
    if (leaving.empty()) {
      const Vector3d end = maker_.curve(last).points.back();
      throw PlaceError("the border in the centre plane is not closed at " + place_text(end) +
                           "; set y to 0 for all points that are meant to be on the centre line",
                       end);
    }
    const Vector2d back = -direction(-last);
    const auto turn = [&](const DirectedEdge& edge) {
      const Vector2d ahead = direction(edge);
      return std::atan2(cross(back, ahead), back.dot(ahead));
    };
    // Angles from the way straight on: the largest is the sharpest turn to the left.
    const auto best = std::ranges::max_element(leaving, {}, turn);
    const DirectedEdge next = *best;
    leaving.erase(best);
    return next;
  }

  // Of an edge where it begins.
  Vector2d direction(const DirectedEdge& edge) const {
    const BSplineCurve curve = maker_.curve(edge);
    // The first control points may coincide, or nearly.
    const double reach = 1e-6 * curve.polygon_length();
    for (const Vector3d& point : curve.points) {
      const Vector2d way = seen(point) - seen(curve.points[0]);
      if (way.norm() > reach) return way.normalized();
    }
    return Vector2d::UnitX();
  }

  CapMaker& maker_;
  bool is_port_half_;
  std::map<int, std::vector<DirectedEdge>> from_;
};

bool is_within(const Vector2d& point, const std::vector<Vector2d>& polygon) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    // Half-open, so that a ray through a corner counts once.
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

}  // namespace

void close_centre_plane(CapMaker& maker, const EdgePath& edges, bool is_port_half) {
  const std::vector<PlaneLoop> loops = Loops(maker, edges, is_port_half).make();
  std::vector<std::vector<EdgePath>> faces(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].area > 0.0) faces[i].push_back(loops[i].path);
  }
  for (const PlaneLoop& hole : loops) {
    if (hole.area > 0.0) continue;
    std::size_t around = loops.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loops.size(); ++i) {
      // The smallest loop around a hole is its face: there may be islands in holes.
      if (loops[i].area <= 0.0 || loops[i].area >= least) continue;
      if (!is_within(hole.polygon[0], loops[i].polygon)) continue;
      around = i;
      least = loops[i].area;
    }
    if (around == loops.size()) {
      const Vector3d begin = maker.curve(hole.path[0]).points[0];
      throw PlaceError("the border in the centre plane at " + place_text(begin) +
                           " crosses itself or runs the wrong way; make all normals point "
                           "outwards and check the points there",
                       begin);
    }
    faces[around].push_back(hole.path);
  }
  for (auto& face : faces) {
    if (!face.empty()) maker.add_plane(Cap::Kind::kCentrePlane, std::move(face));
  }
}

}  // namespace hull::conversion
