// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "modelling/fields/field_base.h"
#include "surface/limit_surface.h"
#include "surface/queries/surface_tree.h"

namespace hull::modelling {

// Distances along a surface as it is now: what is near through thin parts, or across the gap
// between two hulls, is far along the surface.
//
// Fronts march over a net of some 50,000 points of the surface (Kimmel and Sethian 1998), by the
// triangles of both ways to cut each of its quadrilaterals: distances are within about two per
// cent.
//
// `mirrored`: the surface is a half, and ways lead over its image, too. Immutable; thread-safe.
class GeodesicNet {
 public:
  GeodesicNet(const surface::LimitSurface& surface, bool mirrored);

  // Of each point of the net from a base; kUnreached where no way leads. Throws
  // std::invalid_argument for a base that is nowhere on the surface.
  std::vector<double> from(const FieldBase& base) const;

  struct Reading {
    double distance;  // m
    Vector3d slope;   // by the point, within the surface
    double spacing;   // m: of the net there
  };
  // At the point of the surface, or of its image, that is nearest to p.
  Reading at(const std::vector<double>& distances, const Vector3d& p) const;

  static constexpr double kUnreached = 1e30;

 private:
  using Quad = std::array<int, 4>;
  void relax(const Quad& quad, std::vector<double>& distances, std::vector<int>& changed) const;

  surface::SurfaceTree tree_;
  int per_side_;
  bool mirrored_;
  double near_, side_;  // m: in the centre plane; +1 where the half is to port, -1
  std::vector<Vector3d> points_;
  std::vector<int> images_;  // of each point of the surface itself
  std::vector<Quad> quads_;  // of the surface, cell by cell; then those of its image
  std::vector<std::vector<int>> quads_at_;
  std::vector<double> longest_;  // m, per point: side or diagonal of a quadrilateral
  std::size_t own_quads_;
};

// The base of a field, distances from which are measured along a surface. Beside the base, where
// the net is too coarse, straight distances take their place.
std::shared_ptr<const FieldBase> along_surface(std::shared_ptr<const FieldBase> base,
                                               std::shared_ptr<const GeodesicNet> distances);

}  // namespace hull::modelling
