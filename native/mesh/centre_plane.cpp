// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/centre_plane.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "mesh/tolerances.h"

namespace hull::mesh {
namespace {

// Borders that leave the plane on purpose, as a deck's edge at the stem, do so more steeply.
constexpr double kAlong = 0.01;

template <class Visit>
void for_each_border_edge(const Topology& topology, const Visit& visit) {
  for (int h = 0; h < topology.half_edge_count(); ++h) {
    if (topology.twin(h) < 0) visit(topology.origin(h), topology.origin(topology.next(h)));
  }
}

// The borders' vertices, loop by loop.
std::vector<std::vector<int>> border_loops(const Topology& topology, std::size_t vertex_count) {
  std::vector<int> next(vertex_count, -1);
  // A manifold's border leaves each of its vertices once, so that it falls into loops.
  for_each_border_edge(topology, [&](int a, int b) { next[a] = b; });
  std::vector<std::vector<int>> loops;
  for (std::size_t first = 0; first < vertex_count; ++first) {
    std::vector<int> loop;
    for (int v = static_cast<int>(first); next[v] >= 0;) {
      loop.push_back(v);
      // Taken out as it is followed: each loop is found once.
      v = std::exchange(next[v], -1);
    }
    if (!loop.empty()) loops.push_back(std::move(loop));
  }
  return loops;
}

// Gaps of a chain of vertices that follow one another near the plane.
void add_gaps(const std::vector<int>& chain, const std::vector<bool>& is_on,
              std::vector<int>& found) {
  const auto on = [&](int v) { return is_on[v]; };
  // What comes before the first point on the plane, or after the last, is no gap: the border leaves
  // the plane there.
  const auto begin = std::ranges::find_if(chain, on);
  const auto end = std::find_if(chain.rbegin(), chain.rend(), on).base();
  if (begin >= end) return;
  std::vector<int> off;
  std::copy_if(begin, end, std::back_inserter(off), [&](int v) { return !is_on[v]; });
  if (2 * off.size() < chain.size()) found.insert(found.end(), off.begin(), off.end());
}

}  // namespace

std::vector<Eigen::Vector3d> points_with_centre_line(const ControlMesh& mesh) {
  const std::vector<Eigen::Vector3d>& points = mesh.points();
  const double on = kOnCentrePlane * mesh.size();
  std::vector<Eigen::Vector3d> result = points;
  for_each_border_edge(mesh.topology(), [&](int a, int b) {
    // By the points as they were given, so that the order of edges does not count.
    if (std::abs(points[a].y()) <= on && std::abs(points[b].y()) <= on) {
      result[a].y() = result[b].y() = 0.0;
    }
  });
  return result;
}

std::vector<int> vertices_near_centre_line(const ControlMesh& mesh) {
  std::vector<Eigen::Vector3d> points = mesh.points();
  const double on = kOnCentrePlane * mesh.size(), near = kNearCentrePlane * mesh.size();
  std::vector<int> found;
  std::size_t known = 0;
  // Some edges run along the plane only when one of their ends has been put there.
  do {
    known = found.size();
    for_each_border_edge(mesh.topology(), [&](int a, int b) {
      const double farther = std::max(std::abs(points[a].y()), std::abs(points[b].y()));
      if (farther > near || farther > kAlong * (points[b] - points[a]).norm()) return;
      for (int v : {a, b}) {
        if (std::abs(points[v].y()) <= on) continue;
        found.push_back(v);
        points[v].y() = 0.0;
      }
    });
  } while (found.size() > known);
  std::ranges::sort(found);
  return found;
}

std::vector<int> gaps_in_centre_line(const ControlMesh& mesh) {
  const std::vector<Eigen::Vector3d>& points = mesh.points();
  const double on = kOnCentrePlane * mesh.size(), at = kAtCentreLine * mesh.size();
  std::vector<bool> is_on(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) is_on[v] = std::abs(points[v].y()) <= on;
  const auto is_far = [&](int v) { return std::abs(points[v].y()) > at; };
  std::vector<int> found;
  for (std::vector<int>& loop : border_loops(mesh.topology(), points.size())) {
    // From a point that is in no chain on, or else on the plane, so that none is cut in two.
    auto first = std::ranges::find_if(loop, is_far);
    if (first == loop.end()) first = std::ranges::find_if(loop, [&](int v) { return is_on[v]; });
    if (first != loop.end()) std::rotate(loop.begin(), first, loop.end());
    std::vector<int> chain;
    for (int v : loop) {
      if (!is_far(v)) {
        chain.push_back(v);
        continue;
      }
      add_gaps(chain, is_on, found);
      chain.clear();
    }
    // A loop that is near the plane all around is closed again where it began.
    if (!chain.empty() && chain.size() == loop.size()) chain.push_back(loop.front());
    add_gaps(chain, is_on, found);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace hull::mesh
