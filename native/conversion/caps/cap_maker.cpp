// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/caps/cap_maker.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "mesh/tolerances.h"

namespace hull::conversion {
namespace {

BSplineCurve straight_line(const Vector3d& from, const Vector3d& to) {
  return {1, {0.0, 0.0, 1.0, 1.0}, {from, to}};
}

EdgePath backwards(const EdgePath& path) {
  EdgePath result;
  for (auto edge = path.rbegin(); edge != path.rend(); ++edge) result.push_back(-*edge);
  return result;
}

void append(EdgePath& path, const EdgePath& more) {
  path.insert(path.end(), more.begin(), more.end());
}

// Mirrored, it runs the other way along its border; so an image goes the way of what it is of.
EdgePath image_of(const EdgePath& path, const FarSide& far) {
  EdgePath result;
  if (far.is_plane) return result;
  for (const DirectedEdge& edge : path) result.push_back({far.edges.at(edge.edge), !edge.reversed});
  return result;
}

// Whether points lie on a line athwartships see as a point: equal x and z.
bool is_line_athwart(const std::vector<Vector3d>& points, double tolerance) {
  return std::ranges::all_of(points, [&](const Vector3d& p) {
    return std::hypot(p.x() - points[0].x(), p.z() - points[0].z()) <= tolerance;
  });
}

// Whether points lie in a plane that contains the direction athwartships.
bool is_plane_athwart(const std::vector<Vector3d>& points, double tolerance) {
  const auto furthest = [&](const Vector3d& from) {
    const auto distance = [&](const Vector3d& p) {
      return std::hypot(p.x() - from.x(), p.z() - from.z());
    };
    return *std::ranges::max_element(points, {}, distance);
  };
  // Seen athwart the points have to lie on a line: through two that are far apart, or it would turn
  // by rounding.
  const Vector3d one = furthest(points[0]), two = furthest(one);
  const double dx = two.x() - one.x(), dz = two.z() - one.z(), length = std::hypot(dx, dz);
  return length <= tolerance || std::ranges::all_of(points, [&](const Vector3d& p) {
           return std::abs((p.x() - one.x()) * dz - (p.z() - one.z()) * dx) <= tolerance * length;
         });
}

// Twice the area within the control polygons of a loop, as a vector.
Vector3d area_vector(const std::vector<BSplineCurve>& loop) {
  Vector3d sum = Vector3d::Zero();
  const Vector3d origin = loop.front().points.front();
  for (const BSplineCurve& curve : loop) {
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const Vector3d a = curve.points[i - 1] - origin, b = curve.points[i] - origin;
      sum += a.cross(b);
    }
  }
  return sum;
}

Cap::Kind kind_of(const Vector3d& normal) {
  if (normal.z() >= 0.7 * normal.norm()) return Cap::Kind::kDeck;
  return std::abs(normal.x()) >= 0.7 * normal.norm() ? Cap::Kind::kTransom : Cap::Kind::kOpening;
}

}  // namespace

CapMaker::CapMaker(const PatchSet& set, const EdgeUses& uses)
    : set_(set), uses_(uses), size_(set.size()) {}

BorderStep CapMaker::step(const EdgeUse& use) const {
  const SideEdge& part = uses_.part(use);
  return {part.edge, uses_.curve(use), uses_.vertex(part.from), uses_.vertex(part.to)};
}

int CapMaker::from(const DirectedEdge& edge) const {
  if (edge.edge >= set_.edge_count) {
    const CapEdge& own = result_.edges[edge.edge - set_.edge_count];
    return edge.reversed ? own.to : own.from;
  }
  const SideEdge& part = uses_.part(uses_.of(edge.edge)[0]);
  return uses_.vertex(edge.reversed ? part.to : part.from);
}

BSplineCurve CapMaker::curve(const DirectedEdge& edge) const {
  const BSplineCurve found = edge.edge >= set_.edge_count
                                 ? result_.edges[edge.edge - set_.edge_count].curve
                                 : uses_.curve(uses_.of(edge.edge)[0]);
  return edge.reversed ? found.reversed() : found;
}

void CapMaker::add_plane(Cap::Kind kind, std::vector<EdgePath> loops) {
  std::vector<BSplineCurve> outer;
  for (const DirectedEdge& edge : loops.front()) outer.push_back(curve(edge));
  Cap cap;
  cap.kind = kind;
  const Vector3d area = area_vector(outer);
  if (!(area.norm() > kNoLength * size_ * size_)) {
    throw PlaceError("the border at " + place_text(outer[0].points[0]) +
                         " encloses no area to close; move its sides apart, or merge their points",
                     outer[0].points[0]);
  }
  cap.normal = area.normalized();
  // The middle of what the plane has to come close to.
  Eigen::AlignedBox3d box;
  double low = 0.0, high = 0.0;
  const Vector3d start = outer[0].points[0];
  for (const BSplineCurve& part : outer) {
    for (const Vector3d& point : part.points) {
      box.extend(point);
      const double height = cap.normal.dot(point - start);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  cap.origin = box.center();
  cap.origin += (0.5 * (low + high) - cap.normal.dot(cap.origin - start)) * cap.normal;
  cap.loops = std::move(loops);
  result_.caps.push_back(std::move(cap));
}

void CapMaker::add_plane(EdgePath loop) {
  add_plane(Cap::Kind::kOpening, {std::move(loop)});
  Cap& cap = result_.caps.back();
  cap.kind = kind_of(cap.normal);
}

bool CapMaker::is_athwart(const BorderStep& step) const {
  return is_line_athwart(step.curve.points, tolerance());
}

std::vector<CapMaker::Run> CapMaker::runs_of(const BorderChain& chain) const {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (is_athwart(chain[i])) continue;
    Run run{i, i + 1, false, {}, {}};
    std::vector<Vector3d> points = chain[i].curve.points;
    run.is_plane = is_plane_athwart(points, tolerance());
    for (std::size_t j = i + 1; run.is_plane && j < chain.size(); ++j) {
      const auto& more = chain[j].curve.points;
      points.insert(points.end(), more.begin(), more.end());
      if (!is_plane_athwart(points, tolerance())) break;
      // Edges athwart count for the plane, but none ends a run.
      if (!is_athwart(chain[j])) run.end = j + 1;
    }
    i = run.end - 1;
    runs.push_back(run);
  }
  return runs;
}

DirectedEdge CapMaker::add_edge(BSplineCurve curve, int from, int to) {
  result_.edges.push_back({std::move(curve), from, to});
  return {set_.edge_count + static_cast<int>(result_.edges.size()) - 1, false};
}

int CapMaker::far_vertex(int vertex, const Vector3d& position, FarSide& far) {
  if (!far.is_plane) return far.vertices.at(vertex);
  // On the plane a vertex is across from itself.
  if (std::abs(position.y() - far.y) <= tolerance()) return vertex;
  const auto [found, fresh] = far.vertices.try_emplace(vertex, -1);
  if (fresh) {
    found->second = set_.vertex_count + static_cast<int>(result_.vertices.size());
    result_.vertices.emplace_back(position.x(), far.y, position.z());
  }
  return found->second;
}

EdgePath CapMaker::straight(int vertex, const Vector3d& position, FarSide& far) {
  const int across = far_vertex(vertex, position, far);
  const auto [found, fresh] = straight_.try_emplace(vertex);
  if (fresh && across != vertex) {
    const double y = far.is_plane ? far.y : 2.0 * far.y - position.y();
    const Vector3d target(position.x(), y, position.z());
    found->second = {add_edge(straight_line(position, target), vertex, across)};
  }
  return found->second;
}

// Between two runs there may be edges athwart. From the end of them that is nearer to the plane the
// line goes straight on, and from the other one along them first.
void CapMaker::find_ends(const BorderChain& chain, std::vector<Run>& runs, FarSide& far) {
  for (std::size_t r = 0; r <= runs.size(); ++r) {
    const std::size_t begin = r > 0 ? runs[r - 1].end : 0;
    const std::size_t end = r < runs.size() ? runs[r].begin : chain.size();
    const bool after_all = begin == chain.size();
    const int v = after_all ? chain.back().to : chain[begin].from;
    const Vector3d from =
        after_all ? chain.back().curve.points.back() : chain[begin].curve.points.front();
    const int w = end > 0 ? chain[end - 1].to : chain[0].from;
    const Vector3d to = end > 0 ? chain[end - 1].curve.points.back() : from;
    EdgePath along;
    for (std::size_t i = begin; i < end; ++i) along.push_back({chain[i].edge, false});
    // At the chain's ends it is the first or last vertex that lies across.
    const bool from_is_near =
        r == 0 || (r < runs.size() && std::abs(from.y() - far.y) <= std::abs(to.y() - far.y));
    EdgePath near = from_is_near ? straight(v, from, far) : straight(w, to, far);
    EdgePath away = from_is_near ? backwards(along) : along;
    if (far.is_plane && v != w) {
      far.vertices[from_is_near ? w : v] =
          from_is_near ? far_vertex(v, from, far) : far_vertex(w, to, far);
    }
    append(away, near);
    append(away, image_of(from_is_near ? along : backwards(along), far));
    if (r > 0) runs[r - 1].finish = from_is_near ? near : away;
    if (r < runs.size()) runs[r].start = from_is_near ? away : near;
  }
}

// The far side of a run, in the direction of the chain.
EdgePath CapMaker::far_path(const BorderChain& chain, const Run& run, FarSide& far) {
  const BorderStep &first = chain[run.begin], &last = chain[run.end - 1];
  if (!far.is_plane) {
    EdgePath path;
    for (std::size_t i = run.begin; i < run.end; ++i) path.push_back({chain[i].edge, false});
    return image_of(path, far);
  }
  const auto on_plane = [&](Vector3d point) {
    point.y() = far.y;
    return point;
  };
  const int from = far_vertex(first.from, first.curve.points.front(), far);
  const int to = far_vertex(last.to, last.curve.points.back(), far);
  BSplineCurve curve =
      straight_line(on_plane(first.curve.points.front()), on_plane(last.curve.points.back()));
  if (!run.is_plane) {
    curve = first.curve;
    for (Vector3d& point : curve.points) point = on_plane(point);
  } else if (from == to || curve.polygon_length() <= kNoLength * size_) {
    return {};
  }
  const DirectedEdge made = add_edge(std::move(curve), from, to);
  in_plane_.push_back(made);
  return {made};
}

void CapMaker::add_patch(const BorderStep& step, const Run& run, const EdgePath& far_edge,
                         const FarSide& far) {
  BSplinePatch patch;
  patch.degree_u = step.curve.degree;
  patch.degree_v = 1;
  patch.knots_u = step.curve.knots;
  patch.knots_v = {0.0, 0.0, 1.0, 1.0};
  patch.count_u = static_cast<int>(step.curve.points.size());
  patch.count_v = 2;
  for (const Vector3d& point : step.curve.points) {
    const double y = far.is_plane ? far.y : 2.0 * far.y - point.y();
    patch.control_points.emplace_back(point.x(), y, point.z());
    patch.control_points.push_back(point);
  }
  const surface::SurfaceJet middle = patch.evaluate(0.5, 0.5);
  Cap cap;
  cap.kind = kind_of(middle.du.cross(middle.dv));
  // v runs from the far side to the border, which becomes side 1 by turning.
  cap.loops = {backwards(run.finish), {{step.edge, true}}, run.start, far_edge};
  cap.patch = patch.turned();
  result_.caps.push_back(std::move(cap));
}

void CapMaker::close_run(const BorderChain& chain, const Run& run, FarSide& far) {
  const EdgePath opposite = far_path(chain, run, far);
  if (!run.is_plane) return add_patch(chain[run.begin], run, opposite, far);
  EdgePath loop;
  for (std::size_t i = run.end; i-- > run.begin;) loop.push_back({chain[i].edge, true});
  append(loop, run.start);
  append(loop, opposite);
  append(loop, backwards(run.finish));
  add_plane(std::move(loop));
}

void CapMaker::close(const BorderChain& chain, FarSide& far, const EdgePath& start,
                     const EdgePath& end) {
  if (!start.empty()) straight_[chain.front().from] = start;
  if (!end.empty()) straight_[chain.back().to] = end;
  std::vector<Run> runs = runs_of(chain);
  if (runs.empty()) {
    throw PlaceError("the border at " + place_text(chain[0].curve.points[0]) +
                         " runs athwartships and back along itself; merge its points",
                     chain[0].curve.points[0]);
  }
  find_ends(chain, runs, far);
  for (const Run& run : runs) close_run(chain, run, far);
}

}  // namespace hull::conversion
