// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/models/closed_model.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include "mesh/tolerances.h"
#include "production/grid/hull_grid.h"
#include "production/models/slivers.h"

namespace hull::production {
namespace {

// Of triangles of closings, over their longest sides: less than single precision shows.
constexpr double kNoClosingHeight = 1e-6;

// How often a side is run through in either direction.
struct SideUse {
  int forward = 0, backward = 0;
};

// Cut along the shorter diagonal. Quadrilaterals that have a corner twice are triangles.
void add_quad(const HullGrid& grid, std::size_t quad, ClosedModel& model) {
  const std::array<int, 4>& q = grid.quads[quad];
  const auto add = [&](int a, int b, int c) {
    if (a == b || b == c || c == a) return;
    model.triangles.push_back({a, b, c});
    model.cells.push_back(grid.places[quad].cell);
  };
  const auto squared = [&](int a, int b) {
    return (grid.points[q[a]] - grid.points[q[b]]).squaredNorm();
  };
  if (squared(0, 2) <= squared(1, 3)) {
    add(q[0], q[1], q[2]);
    add(q[0], q[2], q[3]);
  } else {
    add(q[0], q[1], q[3]);
    add(q[1], q[2], q[3]);
  }
}

// A call of its own: where GCC 12 makes vectors of two such roundings it leaves them out.
[[gnu::noinline]] double in_single_precision(double x) { return static_cast<float>(x); }

// Sides no longer than `near` become points, triangles that have one are left out.
void weld(ClosedModel& model, double near) {
  // Union-find: the root of a group is its point of the lowest number.
  std::vector<int> one(model.points.size());
  std::iota(one.begin(), one.end(), 0);
  const auto root = [&one](int p) {
    while (one[p] != p) p = one[p] = one[one[p]];
    return p;
  };
  for (const std::array<int, 3>& triangle : model.triangles) {
    for (int k = 0; k < 3; ++k) {
      // Along sides alone: what is near without a side between is of another part of the body.
      const int a = root(triangle[k]), b = root(triangle[(k + 1) % 3]);
      if ((model.points[a] - model.points[b]).norm() <= near) one[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::array<int, 3>> kept;
  std::vector<int> cells;
  for (std::size_t k = 0; k < model.triangles.size(); ++k) {
    const auto& [a, b, c] = model.triangles[k];
    const std::array<int, 3> t{root(a), root(b), root(c)};
    // A side that is a point takes both of its triangles along, so that no other side is left open.
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    kept.push_back(t);
    if (!model.cells.empty()) cells.push_back(model.cells[k]);
  }
  model.triangles = std::move(kept);
  model.cells = std::move(cells);
  drop_unused_points(model);
}

void flip_slivers_of_closings(ClosedModel& model) {
  // The shell's triangles are within the chord tolerance as they are; others might not be.
  std::vector<std::array<int, 3>> closings;
  for (std::size_t k = 0; k < model.triangles.size(); ++k) {
    if (model.cells[k] < 0) closings.push_back(model.triangles[k]);
  }
  flip_slivers(model.points, closings, kNoClosingHeight);
  auto next = closings.begin();
  for (std::size_t k = 0; k < model.triangles.size(); ++k) {
    if (model.cells[k] < 0) model.triangles[k] = *next++;
  }
}

}  // namespace

double ClosedModel::volume() const {
  if (points.empty()) return 0.0;
  double sum = 0.0;
  // About a point of the model: far from the origin the terms would cancel.
  const Vector3d& origin = points[0];
  for (const auto& [a, b, c] : triangles) {
    sum += (points[a] - origin).dot((points[b] - origin).cross(points[c] - origin));
  }
  return sum / 6.0;
}

double ClosedModel::area() const {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) {
    sum += (points[b] - points[a]).cross(points[c] - points[a]).norm();
  }
  return 0.5 * sum;
}

ClosedModel closed_model(const analysis::HullBody& body, double chord_tolerance,
                         const surface::Progress& progress) {
  const surface::LimitSurface& surface = body.surface();
  const SidePoints sides(surface.cells(), surface::chord_divisions_for(surface, chord_tolerance));
  // Wholly in the water: says what is wrong with a body that has no inside.
  double top = surface.mesh().points()[0].z();
  for (const Vector3d& p : surface.mesh().points()) top = std::max(top, p.z());
  body.closed().immersion({Vector3d::UnitZ(), top + surface.mesh().size()});
  surface::tell(progress, 1.0, 3.0);
  GridOptions options;
  options.places = true;
  options.progress = surface::part_of(progress, 1.0 / 3.0, 0.9);
  HullGrid grid = hull_grid(body, sides, options);
  ClosedModel model;
  model.triangles.reserve(2 * grid.quads.size());
  for (std::size_t quad = 0; quad < grid.quads.size(); ++quad) add_quad(grid, quad, model);
  model.points = std::move(grid.points);
  weld(model, kNoLength * surface.mesh().size());
  flip_slivers_of_closings(model);
  return model;
}

ClosedModel scaled(const ClosedModel& model, double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor)) {
    std::ostringstream words;
    words << "A model's lengths are multiplied by a positive number, not " << factor << ".";
    throw std::invalid_argument(words.str());
  }
  ClosedModel result = model;
  for (Vector3d& p : result.points) {
    for (int k = 0; k < 3; ++k) p[k] = in_single_precision(factor * p[k]);
    if (!p.allFinite()) {
      throw std::invalid_argument(
          "At this scale the model is larger than single precision can tell; take a smaller one.");
    }
  }
  weld(result, 0.0);
  if (result.triangles.empty()) {
    throw std::invalid_argument("At this scale nothing is left of the model; take a larger one.");
  }
  return result;
}

void drop_unused_points(ClosedModel& model) {
  std::vector<int> number(model.points.size(), -1);
  std::vector<Vector3d> points;
  for (std::array<int, 3>& triangle : model.triangles) {
    for (int& corner : triangle) {
      if (number[corner] < 0) {
        number[corner] = static_cast<int>(points.size());
        points.push_back(model.points[corner]);
      }
      corner = number[corner];
    }
  }
  model.points = std::move(points);
}

int open_sides(const ClosedModel& model) {
  std::unordered_map<std::uint64_t, SideUse> uses;
  uses.reserve(2 * model.triangles.size());
  for (const std::array<int, 3>& triangle : model.triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto a = static_cast<std::uint64_t>(triangle[k]);
      const auto b = static_cast<std::uint64_t>(triangle[(k + 1) % 3]);
      if (a < b) {
        ++uses[a << 32 | b].forward;
      } else {
        ++uses[b << 32 | a].backward;
      }
    }
  }
  int open = 0;
  for (const auto& [side, use] : uses) open += use.forward != 1 || use.backward != 1;
  return open;
}

}  // namespace hull::production
