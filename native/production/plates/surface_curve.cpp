// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/surface_curve.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "analysis/arithmetic/bracketed_maximum.h"
#include "surface/place_in_cell.h"
#include "surface/queries/closest_point.h"

namespace hull::production {

using mesh::Topology;
using surface::on_square_side;

namespace {

// Of the mesh's size: points of a curve are at its places on the surface, which are put onto sides
// and corners within kOnCellSide.
constexpr double kOnOwnSurface = 1e-7;
// Of a cell's side: as near as a shortest way tells its place on it.
constexpr double kNearestOnSide = 1e-8;

double snapped(double x) {
  if (std::abs(x) <= kOnCellSide) return 0.0;
  return std::abs(x - 1.0) <= kOnCellSide ? 1.0 : x;
}

// Number of the side of the square on which (u, v) lies, or -1.
int side_at(const Vector2d& uv) {
  if (uv.y() == 0.0) return 0;
  if (uv.x() == 1.0) return 1;
  if (uv.y() == 1.0) return 2;
  return uv.x() == 0.0 ? 3 : -1;
}

double along_side(int side, const Vector2d& uv) {
  const double t[] = {uv.x(), uv.y(), 1.0 - uv.x(), 1.0 - uv.y()};
  return t[side];
}

void add_at_corner(std::vector<CellPlace>& places, int h) {
  const Vector2d uv = on_square_side(h % 4, 0.0);
  places.push_back({h / 4, uv.x(), uv.y()});
}

void add_around(const Topology& cells, int h, std::vector<CellPlace>& places) {
  add_at_corner(places, h);
  // Around the corner one way, and from the start the other way, if a border ended the first.
  int g = cells.twin(cells.prev(h));
  for (; g >= 0 && g != h; g = cells.twin(cells.prev(g))) add_at_corner(places, g);
  if (g == h) return;
  for (g = cells.twin(h); g >= 0; g = cells.twin(g)) {
    g = cells.next(g);
    add_at_corner(places, g);
  }
}

struct Spot {
  std::vector<CellPlace> places;
  Vector3d point;
};

Spot spot_at(const surface::LimitSurface& surface, const CellPlace& place) {
  Spot spot{places_of(surface.cells(), place), {}};
  const CellPlace& first = spot.places.front();
  spot.point = surface.position(first.cell, first.u, first.v);
  return spot;
}

std::optional<CurveStep> common_step(const Spot& a, const Spot& b) {
  for (const CellPlace& from : a.places) {
    for (const CellPlace& to : b.places) {
      if (from.cell == to.cell) return CurveStep{from.cell, {from.u, from.v}, {to.u, to.v}};
    }
  }
  return std::nullopt;
}

class Joiner {
 public:
  Joiner(const surface::LimitSurface& surface, const surface::SurfaceTree& tree,
         SurfaceCurve& curve)
      : surface_(surface), tree_(tree), curve_(curve) {}

  // Where two spots have no cell in common the point nearest to the middle of their chord comes
  // between, until it lies on the side that is passed.
  void join(const Spot& a, const Spot& b, int depth = 0) {
    if ((a.point - b.point).norm() <= 1e-12 * tree_.error_size()) return;
    if (const auto step = common_step(a, b)) {
      curve_.steps.push_back(*step);
      curve_.points.push_back(b.point);
      return;
    }
    if (const auto between = over_crease(a, b)) {
      join(a, *between, depth + 1);
      join(*between, b, depth + 1);
      return;
    }
    if (depth > 60) throw std::invalid_argument(lost(a.point));
    const auto middle = surface::closest_point(tree_, 0.5 * (a.point + b.point));
    const Spot m = spot_at(surface_, {middle.cell, middle.u, middle.v});
    join(a, m, depth + 1);
    join(m, b, depth + 1);
  }

 private:
  // Over a crease between two cells the way is the shortest one, since at a sharp one, as a stem,
  // the chord is far from it.
  std::optional<Spot> over_crease(const Spot& a, const Spot& b) const {
    const Topology& cells = surface_.cells();
    for (const CellPlace& from : a.places) {
      for (const CellPlace& to : b.places) {
        for (int h = 4 * from.cell; h < 4 * from.cell + 4; ++h) {
          const int twin = cells.twin(h);
          if (twin >= 0 && twin / 4 == to.cell && cells.is_crease(h)) {
            return nearest_to_both(h, a.point, b.point);
          }
        }
      }
    }
    return std::nullopt;
  }

  // The point of a cell's side from which the way to a and b is the shortest.
  Spot nearest_to_both(int h, const Vector3d& a, const Vector3d& b) const {
    const auto place = [h](double t) {
      const Vector2d uv = on_square_side(h % 4, t);
      return CellPlace{h / 4, uv.x(), uv.y()};
    };
    // The sum of two distances is convex along a straight side, and nearly so along others.
    const auto shortness = [&](double t) {
      const CellPlace at = place(t);
      const Vector3d p = surface_.position(at.cell, at.u, at.v);
      return -(p - a).norm() - (p - b).norm();
    };
    const auto best = analysis::bracketed_maximum(shortness, 0.0, 1.0, kNearestOnSide);
    return spot_at(surface_, place(best.place));
  }

  std::string lost(const Vector3d& p) const {
    return "The curve \"" + curve_.name + "\" can't be followed over the surface at (" +
           std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) +
           ") m: parts of the hull lie on one another there.";
  }
  const surface::LimitSurface& surface_;
  const surface::SurfaceTree& tree_;
  SurfaceCurve& curve_;
};

}  // namespace

std::vector<CellPlace> places_of(const Topology& cells, const CellPlace& place) {
  const Vector2d uv(snapped(place.u), snapped(place.v));
  const int side = side_at(uv);
  // A corner belongs to two sides: all cells around it have it.
  std::vector<CellPlace> places;
  if (side < 0) return {{place.cell, uv.x(), uv.y()}};
  const double t = along_side(side, uv);
  const int h = 4 * place.cell + side;
  if (t == 0.0 || t == 1.0) {
    add_around(cells, t == 0.0 ? h : cells.next(h), places);
    return places;
  }
  places.push_back({place.cell, uv.x(), uv.y()});
  if (const int twin = cells.twin(h); twin >= 0) {
    const Vector2d beyond = on_square_side(twin % 4, 1.0 - t);
    places.push_back({twin / 4, beyond.x(), beyond.y()});
  }
  return places;
}

std::vector<CurveStep> in_all_cells(const Topology& cells, const CurveStep& step) {
  std::vector<CurveStep> steps{step};
  for (int side = 0; side < 4; ++side) {
    const Vector2d begin = on_square_side(side, 0.0), along = on_square_side(side, 1.0) - begin;
    // Exactly: what is near a side places_of() has put there.
    if (cross(step.from - begin, along) != 0.0 || cross(step.to - begin, along) != 0.0) continue;
    const int twin = cells.twin(4 * step.cell + side);
    if (twin < 0) continue;
    steps.push_back({twin / 4, on_square_side(twin % 4, 1.0 - along_side(side, step.from)),
                     on_square_side(twin % 4, 1.0 - along_side(side, step.to))});
  }
  return steps;
}

SurfaceCurve joined(const surface::LimitSurface& surface, const surface::SurfaceTree& tree,
                    const std::vector<CellPlace>& places, std::string name) {
  SurfaceCurve curve;
  curve.name = std::move(name);
  if (places.empty()) return curve;
  Joiner joiner(surface, tree, curve);
  Spot last = spot_at(surface, places.front());
  curve.points.push_back(last.point);
  for (std::size_t i = 1; i < places.size(); ++i) {
    Spot next = spot_at(surface, places[i]);
    joiner.join(last, next);
    last = std::move(next);
  }
  return curve;
}

bool is_on(const surface::LimitSurface& surface, const SurfaceCurve& curve) {
  const double near = kOnOwnSurface * surface.mesh().size();
  const auto is_at = [&](int cell, const Vector2d& uv, const Vector3d& point) {
    return cell < surface.cell_count() &&
           (surface.position(cell, uv.x(), uv.y()) - point).norm() <= near;
  };
  for (std::size_t k = 0; k < curve.steps.size(); ++k) {
    const CurveStep& step = curve.steps[k];
    if (!is_at(step.cell, step.from, curve.points[k])) return false;
    if (!is_at(step.cell, step.to, curve.points[k + 1])) return false;
  }
  return true;
}

void require_on(const surface::LimitSurface& surface, const SurfaceCurve& curve) {
  if (is_on(surface, curve)) return;
  throw std::invalid_argument("The curve \"" + curve.name +
                              "\" is not on the surface as it is: the surface's points were set "
                              "since the curve was made, or it is another's. Make it anew.");
}

}  // namespace hull::production
