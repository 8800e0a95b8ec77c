// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/rolled_plate.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <queue>

namespace hull::production {

namespace {

// A side of a triangle, from one corner.
struct Way {
  int from, to, middle;  // nodes
  CurveStep step;
};

// Each side once.
std::vector<Way> ways_of(const PlateMesh& mesh) {
  std::vector<Way> ways(mesh.middle_of_side.size(),
                        Way{-1, -1, -1, {-1, Vector2d::Zero(), Vector2d::Zero()}});
  const auto first = static_cast<int>(mesh.corners.size());
  for (const PlateMesh::Element& element : mesh.elements) {
    const ShellTriangle& t = mesh.triangle(element);
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      // Middles are numbered after the corners, by sides.
      Way& way = ways[element.nodes[3 + k] - first];
      if (way.from >= 0) continue;
      way = {element.nodes[k],
             element.nodes[next],
             element.nodes[3 + k],
             {t.cell, t.uv[k], t.uv[next]}};
    }
  }
  return ways;
}

CurveStep reversed(const CurveStep& step) { return {step.cell, step.to, step.from}; }
CurveStep half(const CurveStep& step) {
  return {step.cell, step.from, 0.5 * (step.from + step.to)};
}

int corner_near(const PlateMesh& mesh, const Vector3d& middle) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(mesh.corners.size()); ++i) {
    const double off = (mesh.shell->mesh.points[mesh.corners[i]] - middle).squaredNorm();
    if (off < least) {
      least = off;
      best = i;
    }
  }
  return best;
}

double angle_between(const PlaneFrame& a, const PlaneFrame& b, const Vector3d& normal) {
  // How far b's tangent is turned from a's on the surface, and so should be on the plane.
  const double seen = std::atan2(normal.dot(a.along.cross(b.along)), a.along.dot(b.along));
  return std::remainder(b.angle - a.angle - seen, 2.0 * M_PI);
}

}  // namespace

RolledPlate rolled_plate(const PlateMesh& mesh, const Vector3d& middle) {
  const surface::LimitSurface& surface = mesh.shell->surface;
  const std::vector<Way> ways = ways_of(mesh);
  std::vector<std::vector<int>> at(mesh.corners.size());
  for (int w = 0; w < static_cast<int>(ways.size()); ++w) {
    at[ways[w].from].push_back(w);
    at[ways[w].to].push_back(w);
  }
  RolledPlate plate;
  plate.frames.resize(mesh.corners.size());
  plate.nodes.resize(mesh.node_count, Vector2d::Zero());
  std::vector<char> reached(mesh.corners.size(), 0);
  std::vector<char> used(ways.size(), 0);
  // From the middle the ways are the shortest, and so is what adds up along them.
  const int root = corner_near(mesh, middle);
  const Way& first = ways[at[root].front()];
  plate.frames[root] = first_frame(surface, first.from == root ? first.step : reversed(first.step));
  reached[root] = 1;
  // Breadth first: few sides lead to each corner, and always the same ones.
  std::queue<int> open({root});
  while (!open.empty()) {
    const int corner = open.front();
    open.pop();
    for (const int w : at[corner]) {
      if (used[w]) continue;
      const Way& way = ways[w];
      const bool forward = way.from == corner;
      const int end = forward ? way.to : way.from;
      const CurveStep step = forward ? way.step : reversed(way.step);
      const PlaneFrame there = rolled(surface, step, plate.frames[corner]);
      used[w] = 1;
      plate.nodes[way.middle] = rolled(surface, half(step), plate.frames[corner]).at;
      if (!reached[end]) {
        reached[end] = 1;
        plate.frames[end] = there;
        open.push(end);
        continue;
      }
      // By a second way: only on a developable surface both end alike.
      const Vector3d normal = surface.normal(step.cell, step.to.x(), step.to.y());
      plate.gap = std::max(plate.gap, (there.at - plate.frames[end].at).norm());
      plate.turn = std::max(plate.turn, std::abs(angle_between(there, plate.frames[end], normal)));
    }
  }
  for (std::size_t i = 0; i < plate.frames.size(); ++i) plate.nodes[i] = plate.frames[i].at;
  return plate;
}

}  // namespace hull::production
