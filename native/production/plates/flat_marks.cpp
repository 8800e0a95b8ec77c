// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "production/plates/across_centre.h"
#include "production/plates/flat_plate.h"

namespace hull::production {

namespace {

constexpr double kInTriangle = 1e-9;  // of barycentric coordinates

// A developed plate rolls each place from the nearest corner of its triangle; a stretched one has a
// map of all places.
Vector2d laid(const FlatPlate& flat, const PlateMesh::Element& element, const Vector2d& uv) {
  const ShellTriangle& t = flat.mesh.triangle(element);
  const Eigen::Vector3d b = barycentric(t, uv);
  if (flat.expansion == Expansion::kDeveloped) {
    int nearest = 0;
    b.maxCoeff(&nearest);
    const PlaneFrame& frame = flat.frames[element.nodes[nearest]];
    if ((uv - t.uv[nearest]).norm() <= 1e-14) return frame.at;
    return rolled(flat.mesh.shell->surface, {t.cell, t.uv[nearest], uv}, frame).at;
  }
  const Vector3d p = flat.mesh.shell->surface.position(t.cell, uv.x(), uv.y());
  return flat.turn * flat.map->place(p) + flat.shift;
}

// The part [begin, end] of a step within a triangle.
struct Inside {
  double begin, end;
  int element;
};

std::optional<Inside> inside(const FlatPlate& flat, int element, const CurveStep& step) {
  const ShellTriangle& t = flat.mesh.triangle(flat.mesh.elements[element]);
  const Eigen::Vector3d a = barycentric(t, step.from), b = barycentric(t, step.to);
  Inside part{0.0, 1.0, element};
  for (int k = 0; k < 3; ++k) {
    const double from = a[k] + kInTriangle, to = b[k] + kInTriangle;
    if (from < 0.0 && to < 0.0) return std::nullopt;
    // Linear along the step, and so zero where this enters or leaves.
    const double crossing = from / (from - to);
    if (from < 0.0) part.begin = std::max(part.begin, crossing);
    if (to < 0.0) part.end = std::min(part.end, crossing);
  }
  if (part.begin >= part.end) return std::nullopt;
  return part;
}

// What of a step lies in the plate, in order. Where it runs along triangles' sides one of them
// counts.
std::vector<Inside> parts_inside(const FlatPlate& flat, const CurveStep& step) {
  std::vector<Inside> parts;
  const auto found = flat.mesh.in_cell.find(step.cell);
  if (found == flat.mesh.in_cell.end()) return parts;
  for (const int element : found->second) {
    if (const auto part = inside(flat, element, step)) parts.push_back(*part);
  }
  // Elements come in the mesh's order, not in that of the step.
  std::sort(parts.begin(), parts.end(),
            [](const Inside& a, const Inside& b) { return a.begin < b.begin; });
  std::vector<Inside> kept;
  double reached = 0.0;
  for (Inside part : parts) {
    // Neighbours overlap by the tolerance, and along a common side wholly: what was reached is not
    // taken twice.
    part.begin = std::max(part.begin, kept.empty() ? part.begin : reached);
    if (part.end - part.begin <= 1e-9) continue;
    reached = part.end;
    kept.push_back(part);
  }
  return kept;
}

void append(const FlatPlate& flat, const CurveStep& step, const Inside& part, double near,
            std::vector<FlatMark>& marks) {
  const auto at = [&](double t) { return Vector2d(step.from + t * (step.to - step.from)); };
  const surface::LimitSurface& surface = flat.mesh.shell->surface;
  const PlateMesh::Element& element = flat.mesh.elements[part.element];
  const Vector2d begin = at(part.begin), end = at(part.end);
  const Vector2d from = laid(flat, element, begin);
  // A gap that is no rounding begins another mark: the curve was off the plate.
  if (marks.empty() || (marks.back().points.back() - from).norm() > near) {
    marks.push_back({{from}, {surface.position(step.cell, begin.x(), begin.y())}});
  }
  marks.back().points.push_back(laid(flat, element, end));
  marks.back().on_hull.push_back(surface.position(step.cell, end.x(), end.y()));
}

// Marks with their mirror images; where one ends in the centre plane both are one mark.
std::vector<FlatMark> with_mirror_images(const FlatPlate& flat,
                                         const std::vector<FlatMark>& marks) {
  const surface::LimitSurface& surface = flat.mesh.shell->surface;
  std::vector<FlatMark> all;
  for (FlatMark mark : marks) {
    const auto turn_round = [](FlatMark& m) {
      std::reverse(m.points.begin(), m.points.end());
      std::reverse(m.on_hull.begin(), m.on_hull.end());
    };
    const auto is_on = [&surface](const Vector3d& p) { return is_central(surface, p); };
    const bool ends = is_on(mark.on_hull.back()), begins = is_on(mark.on_hull.front());
    // Along the centre plane; one that only begins and ends in it goes on in its mirror image.
    if (std::all_of(mark.on_hull.begin(), mark.on_hull.end(), is_on)) {
      all.push_back(std::move(mark));
      continue;
    }
    // So that the mirror image goes on where the mark ends.
    if (begins) turn_round(mark);
    FlatMark other = mark;
    for (Vector2d& p : other.points) p = flat.axis->mirrored(p);
    for (Vector3d& p : other.on_hull) p.y() *= -1.0;
    turn_round(other);
    if (!begins && !ends) {
      all.push_back(std::move(mark));
      all.push_back(std::move(other));
      continue;
    }
    mark.points.insert(mark.points.end(), other.points.begin() + 1, other.points.end());
    mark.on_hull.insert(mark.on_hull.end(), other.on_hull.begin() + 1, other.on_hull.end());
    all.push_back(std::move(mark));
  }
  return all;
}

}  // namespace

std::vector<std::vector<std::vector<Vector2d>>> flat_sides(const FlatPlate& flat,
                                                           const Plate& plate) {
  std::vector<std::vector<std::vector<Vector2d>>> loops;
  for (const auto& loop : plate.loops) {
    auto& sides = loops.emplace_back();
    for (const PlateSide& side : loop) {
      auto& points = sides.emplace_back();
      // Nodes of the mirror image follow all of the mesh's own.
      const int before = side.mirrored ? flat.mesh.node_count : 0;
      for (std::size_t i = 0; i < side.points.size(); ++i) {
        if (i > 0) {
          const auto key = ShellMesh::pair_key(side.points[i - 1], side.points[i]);
          points.push_back(flat.nodes[before + flat.mesh.middle_of_side.at(key)]);
        }
        points.push_back(flat.nodes[before + flat.mesh.node_of_point.at(side.points[i])]);
      }
    }
  }
  return loops;
}

std::vector<FlatMark> flat_marks(const FlatPlate& flat, const SurfaceCurve& curve) {
  const double near = 1e-6 * std::sqrt(std::abs(flat.area));
  std::vector<FlatMark> marks;
  for (const CurveStep& step : curve.steps) {
    // A step along a side is in two cells: the first of which the plate has a part counts.
    for (const CurveStep& seen : in_all_cells(flat.mesh.shell->surface.cells(), step)) {
      const std::vector<Inside> parts = parts_inside(flat, seen);
      for (const Inside& part : parts) append(flat, seen, part, near, marks);
      if (!parts.empty()) break;
    }
  }
  return flat.axis ? with_mirror_images(flat, marks) : marks;
}

std::optional<Vector2d> flat_place(const FlatPlate& flat, const CellPlace& place) {
  for (const CellPlace& seen : places_of(flat.mesh.shell->surface.cells(), place)) {
    const auto found = flat.mesh.in_cell.find(seen.cell);
    if (found == flat.mesh.in_cell.end()) continue;
    const Vector2d uv(seen.u, seen.v);
    for (const int e : found->second) {
      const PlateMesh::Element& element = flat.mesh.elements[e];
      if (barycentric(flat.mesh.triangle(element), uv).minCoeff() >= -kInTriangle) {
        return laid(flat, element, uv);
      }
    }
  }
  return std::nullopt;
}

}  // namespace hull::production
