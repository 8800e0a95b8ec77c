// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/edge_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hull::production {

using surface::on_square_side;

namespace {

constexpr std::int64_t kParts = CellTriangulation::kParts;
// Places so near to one another are one: rounding of two ways to the same point.
constexpr std::int64_t kSame = 12;

}  // namespace

CellTriangulation::Grid on_grid(const Vector2d& uv) {
  const auto whole = [](double x) { return std::llround(x * static_cast<double>(kParts)); };
  return {whole(uv.x()), whole(uv.y())};
}

// By five points: what turns within the first and the last chord is taken for half of what turns
// between chords.
EdgePoints::Shape EdgePoints::shape_of(const surface::LimitSurface& surface, int h) {
  Shape shape{0.0, 0.0};
  Vector3d last = Vector3d::Zero(), chord = Vector3d::Zero();
  for (int i = 0; i <= 4; ++i) {
    const Vector2d uv = on_square_side(h % 4, 0.25 * i);
    const Vector3d next = surface.position(h / 4, uv.x(), uv.y());
    if (i > 0) {
      const Vector3d step = next - last;
      shape.length += step.norm();
      if (i > 1) shape.turn += std::atan2(chord.cross(step).norm(), chord.dot(step)) * 4.0 / 3.0;
      chord = step;
    }
    last = next;
  }
  return shape;
}

EdgePoints::EdgePoints(const surface::LimitSurface& surface, ShellMesh& mesh)
    : surface_(surface),
      cells_(surface.cells()),
      mesh_(mesh),
      on_edge_(cells_.edge_count()),
      front_(cells_.edge_count(), -1),
      shapes_(cells_.edge_count()) {
  mesh_.points.resize(cells_.vertex_count());
  for (int h = 0; h < cells_.half_edge_count(); ++h) {
    const Vector2d uv = on_square_side(h % 4, 0.0);
    mesh_.points[cells_.origin(h)] = surface.position(h / 4, uv.x(), uv.y());
    if (cells_.is_edge_front(h)) front_[cells_.edge(h)] = h;
  }
  for (int e = 0; e < cells_.edge_count(); ++e) shapes_[e] = shape_of(surface, front_[e]);
}

EdgePlace EdgePoints::on_side(int cell, int side, const CellTriangulation::Grid& at) const {
  // By side, in the direction of its half-edge.
  const std::int64_t t[] = {at[0], at[1], kParts - at[0], kParts - at[1]};
  const bool on[] = {at[1] == 0, at[0] == kParts, at[1] == kParts, at[0] == 0};
  if (!on[side]) return {};
  const int h = 4 * cell + side;
  return {cells_.edge(h), cells_.is_edge_front(h) ? t[side] : kParts - t[side]};
}

int EdgePoints::point(const EdgePlace& place) {
  const int h = front_[place.edge];
  if (place.at == 0) return cells_.origin(h);
  if (place.at == kParts) return cells_.origin(cells_.next(h));
  const auto [found, is_new] =
      on_edge_[place.edge].try_emplace(place.at, static_cast<int>(mesh_.points.size()));
  if (is_new) {
    const Vector2d uv = on_half_edge(h, place.at);
    mesh_.points.push_back(surface_.position(h / 4, uv.x(), uv.y()));
  }
  return found->second;
}

EdgePlace EdgePoints::merged(EdgePlace place) const {
  const auto near = [&place](std::int64_t at) { return std::abs(at - place.at) <= kSame; };
  if (near(0)) return {place.edge, 0};
  if (near(kParts)) return {place.edge, kParts};
  const auto& taken = on_edge_[place.edge];
  // Places are further apart than kSame: the first one is the only one.
  const auto after = taken.lower_bound(place.at - kSame);
  if (after != taken.end() && near(after->first)) place.at = after->first;
  return place;
}

Vector2d EdgePoints::put_on_sides(int cell, Vector2d uv) {
  for (int side = 0; side < 4; ++side) {
    // A corner is on two sides: the second sees what the first made of it.
    EdgePlace place = on_side(cell, side, on_grid(uv));
    if (place.edge < 0) continue;
    place = merged(place);
    point(place);
    const int h = 4 * cell + side;
    uv = on_half_edge(h, cells_.is_edge_front(h) ? place.at : kParts - place.at);
  }
  return uv;
}

void EdgePoints::divide(int edge, int parts, double clear) {
  // A point of a curve stands for one of the division that would be next to it.
  const auto room = static_cast<std::int64_t>(clear * static_cast<double>(kParts) / parts);
  std::vector<std::int64_t> taken;
  for (const auto& [at, number] : on_edge_[edge]) taken.push_back(at);
  for (int i = 1; i < parts; ++i) {
    // In whole numbers: the last part has what the division leaves.
    const std::int64_t at = kParts / parts * i;
    const bool free = std::none_of(taken.begin(), taken.end(),
                                   [&](std::int64_t other) { return std::abs(at - other) < room; });
    if (free) point({edge, at});
  }
}

std::vector<EdgePoints::Part> EdgePoints::parts(int edge) {
  std::vector<Part> parts;
  Part part{0, point({edge, 0}), 0, -1};
  const auto end_at = [&](std::int64_t at, int number) {
    part.to = at;
    part.last = number;
    parts.push_back(part);
    part = {at, number, 0, -1};
  };
  for (const auto& [at, number] : on_edge_[edge]) end_at(at, number);
  end_at(kParts, point({edge, kParts}));
  return parts;
}

}  // namespace hull::production
