// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_turns.h"

#include <algorithm>

#include "morphing/features/layout_distances.h"
#include "surface/creases/crease_curves.h"

namespace hull::morphing {
namespace {

constexpr int kPiecesAnEdge = 16;
// How much farther than its foot a place's own face may be, beside a knuckle.
constexpr double kBesideFoot = 3.0;
// Of the size: what the straight pieces of a knuckle, and a foot on it, may be off.
constexpr double kPieceError = 1e-5;

Vector3d normal_at(const surface::LimitSurface& surface, const surface::CellPlace& place) {
  return place.cell < 0 ? Vector3d(Vector3d::Zero()) : surface.normal(place.cell, place.u, place.v);
}

double distance_from_piece(const Vector3d& p, const Vector3d& begin, const Vector3d& end) {
  const Vector3d along = end - begin;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp(along.dot(p - begin) / square, 0.0, 1.0) : 0.0;
  return (begin + t * along - p).norm();
}

}  // namespace

LayoutTurns::LayoutTurns(const surface::LimitSurface& hull) : hull_(hull), tree_(hull) {
  for (const surface::CreaseCurve& curve : surface::crease_curves(hull)) {
    for (int i = 0; i < kPiecesAnEdge * curve.edge_count(); ++i) {
      // At the middle of the piece: at its ends a corner may have no normal.
      const double middle = (i + 0.5) / kPiecesAnEdge;
      pieces_.push_back({curve.evaluate(static_cast<double>(i) / kPiecesAnEdge, 0).point,
                         curve.evaluate(static_cast<double>(i + 1) / kPiecesAnEdge, 0).point,
                         normal_at(hull, curve.left(middle)),
                         normal_at(hull, curve.right(middle))});
    }
  }
}

bool LayoutTurns::is_beside_its_face(const Vector3d& place, const Vector3d& normal,
                                     double distance) const {
  const double near = kBesideFoot * distance + kPieceError * tree_.size();
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
    return (normal.dot(piece.left) > 0.0 || normal.dot(piece.right) > 0.0) &&
           distance_from_piece(place, piece.begin, piece.end) <= near;
  });
}

std::vector<surface::ClosestPoint> LayoutTurns::feet(const modelling::SurfacePlaces& layout) const {
  return layout_feet(layout, tree_);
}

std::vector<int> LayoutTurns::turned(const modelling::SurfacePlaces& layout,
                                     const std::vector<surface::ClosestPoint>& feet) const {
  std::vector<int> found;
  for (int k = 0; k < layout.count(); ++k) {
    const Vector3d& normal = layout.normal(k);
    if (!(feet[k].distance <= kNearHull * tree_.size()) || normal.isZero(0.0)) continue;
    // At a foot on a knuckle this is the normal of the one face that the foot was found in.
    const Vector3d there = hull_.normal(feet[k].cell, feet[k].u, feet[k].v);
    // Few places are left, for which all pieces are gone through.
    if (there.isZero(0.0) || normal.dot(there) > 0.0) continue;
    if (!is_beside_its_face(layout.position(k), normal, feet[k].distance)) found.push_back(k);
  }
  return found;
}

}  // namespace hull::morphing
