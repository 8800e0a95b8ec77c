// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/blocks/ringed_surface.h"

#include <algorithm>
#include <cmath>

#include "surface/pieces/bicubic.h"
#include "surface/place_in_cell.h"

namespace hull::conversion {
namespace {

// LimitSurface keeps the spans of these rings.
constexpr int kKeptThere = surface::kPlainRings;
constexpr int kMostRings = 64;

}  // namespace

const surface::BicubicPoints& RingedSurface::span(int corner, int ring, int segment) const {
  const surface::CornerBasis& basis = surface_.layout().basis(corner);
  auto found = rings_.find(corner);
  if (found == rings_.end()) {
    Rings rings{surface::CornerRing(basis, surface_.corner(corner)), {}};
    for (int k = 0; k < kKeptThere; ++k) rings.walk.advance();
    found = rings_.emplace(corner, std::move(rings)).first;
  }
  Rings& rings = found->second;
  const std::size_t number =
      static_cast<std::size_t>((ring - kKeptThere) * basis.segment_count() + segment);
  // All rings up to the one asked for: the walk only goes inwards.
  while (rings.spans.size() <= number) {
    for (int s = 0; s < basis.segment_count(); ++s) {
      rings.spans.push_back(rings.walk.segment_points(s));
    }
    rings.walk.advance();
  }
  return rings.spans[number];
}

Vector3d RingedSurface::position(int cell, double u, double v) const {
  return evaluate(cell, u, v, 0).point;
}

surface::SurfaceJet RingedSurface::evaluate(int cell, double u, double v, int order) const {
  const surface::PlaceInCell place = surface::find_place(surface_.layout(), cell, u, v);
  if (place.node.kind != surface::SurfaceNode::Kind::kCorner) {
    return surface_.evaluate(cell, u, v, order);
  }
  const Eigen::Vector2d seen = surface::turned(place.node.turn, place.u, place.v);
  // As in CornerBasis: the power of two tells the ring, and scaling by it the place in that.
  int exponent = 0;
  std::frexp(seen.maxCoeff(), &exponent);
  const int ring = -exponent;  // 0: beyond 1/2
  if (seen.maxCoeff() == 0.0 || ring < kKeptThere || ring > kMostRings) {
    return surface_.evaluate(cell, u, v, order);
  }
  const Eigen::Vector2d at = std::ldexp(1.0, ring) * seen;
  const std::vector<surface::RingSegment>& segments =
      surface_.layout().basis(place.node.index).segments();
  // On the side between two segments either does: they agree there.
  const auto segment = std::ranges::find_if(segments, [&](const surface::RingSegment& s) {
    return at.x() >= s.u && at.x() <= s.u + s.size && at.y() >= s.v && at.y() <= s.v + s.size;
  });
  surface::SurfaceJet jet;
  surface::evaluate_bicubic(
      span(place.node.index, ring, static_cast<int>(segment - segments.begin())),
      (at.x() - segment->u) / segment->size, (at.y() - segment->v) / segment->size, order, jet);
  surface::scale_derivatives(jet, std::ldexp(1.0, ring) / segment->size, order);
  if (place.node.turn != 0) surface::turn_back(place.node.turn, jet);
  surface::scale_derivatives(jet, place.scale, order);
  return jet;
}

}  // namespace hull::conversion
