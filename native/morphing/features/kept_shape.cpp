// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/kept_shape.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/fairness/flat_regions.h"
#include "mesh/tolerances.h"
#include "modelling/reshape/square_ties.h"
#include "morphing/limit_points.h"
#include "surface/queries/closest_point.h"

namespace hull::morphing {
namespace {

using analysis::FlatRegion;

// Of the normal's length: what a surface that is square to the centre plane may have across it.
constexpr double kSquareNormal = 1e-6;
// Of the size: how far a layout may still be from the flat that its points are put into.
constexpr double kNearFlat = 5e-3;
// Of the size: where the other hull has risen from its flat by no more than this, a point is put
// into the flat all the same, and slides towards it. It is what a layout may be off anyhow: else
// points of the rim that begin just beyond it stay millimetres out of the plane.
constexpr double kRisen = 1e-4;
// Of the size's square: smaller regions are not looked at.
constexpr double kSmallestFlat = 1e-6;

std::vector<FlatRegion> flats_of(const surface::LimitSurface& surface) {
  const double size = surface.mesh().size();
  return analysis::flat_regions(surface, std::nullopt, kInPlane * size,
                                kSmallestFlat * size * size);
}

// Whether a point of a hull is in a flat region or beside it, where it has hardly left the plane.
bool is_at(const surface::ClosestPoint& foot, const FlatRegion& flat, double risen) {
  return std::binary_search(flat.cells.begin(), flat.cells.end(), foot.cell) ||
         std::abs(flat.plane.height(foot.point)) <= risen;
}

// The control points in the plane of a region, of the faces that its cells are part of.
std::vector<int> points_of(const surface::LimitSurface& hull, const FlatRegion& region) {
  const mesh::Topology& t = hull.mesh().topology();
  std::set<int> found;
  for (int cell : region.cells) {
    for (int h = cell, k = 0; k < t.face_size(t.face(cell)); h = t.next(h), ++k) {
      // Of faces that are curved elsewhere some points are off the plane.
      const double height = region.plane.height(hull.mesh().points()[t.origin(h)]);
      if (std::abs(height) <= kInPlane * hull.mesh().size()) found.insert(t.origin(h));
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace

std::vector<modelling::TiedPoint> common_squares(const surface::LimitSurface& hull,
                                                 const surface::LimitSurface& layout,
                                                 const surface::LimitSurface& other) {
  const std::vector<Vector3d> limits = limit_points(layout);
  const surface::SurfaceTree tree(other);
  std::vector<modelling::TiedPoint> found;
  for (const modelling::TiedPoint& tie : modelling::square_ties(hull)) {
    // Where the other hull is not square a tie would hold the layout off it.
    const surface::ClosestPoint foot = surface::closest_point(tree, limits[tie.leader]);
    const Vector3d normal = other.normal(foot.cell, foot.u, foot.v);
    if (!normal.isZero(0.0) && std::abs(normal.y()) <= kSquareNormal) found.push_back(tie);
  }
  return found;
}

std::vector<CommonFlat> common_flats(const surface::LimitSurface& hull,
                                     const surface::LimitSurface& layout,
                                     const surface::LimitSurface& other) {
  const std::vector<Vector3d> limits = limit_points(layout);
  const surface::SurfaceTree tree(other);
  const double near = kNearFlat * other.mesh().size(), risen = kRisen * other.mesh().size();
  const std::vector<FlatRegion> others = flats_of(other);
  std::set<int> taken;
  std::vector<CommonFlat> found;
  for (const FlatRegion& region : flats_of(hull)) {
    for (const FlatRegion& counterpart : others) {
      // Normals point into the water on both: a deck is not taken for a bottom.
      if (region.plane.normal.dot(counterpart.plane.normal) < std::cos(kTurned)) continue;
      CommonFlat flat{{}, counterpart.plane};
      for (int v : points_of(hull, region)) {
        const surface::ClosestPoint foot = surface::closest_point(tree, limits[v]);
        const bool is_near = std::abs(counterpart.plane.height(limits[v])) <= near;
        // In one flat at most: two planes at an angle would leave it a line alone.
        if (is_near && is_at(foot, counterpart, risen) && !taken.count(v)) flat.points.push_back(v);
      }
      if (flat.points.size() < 3) continue;
      taken.insert(flat.points.begin(), flat.points.end());
      found.push_back(std::move(flat));
    }
  }
  return found;
}

}  // namespace hull::morphing
