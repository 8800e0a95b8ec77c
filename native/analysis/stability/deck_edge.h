// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/immersion/hull_body.h"
#include "surface/creases/crease_curves.h"

namespace hull::analysis {

// The edge where the deck meets the sides, of both sides of a mirrored hull.
class DeckEdge {
 public:
  // The borders of the surface that run along the ship: those that are longer than high, and not in
  // the centre plane. None for a body whose deck is modelled and closes it.
  explicit DeckEdge(const HullBody& body);
  // The crease and border chains all of whose control points are among `vertices`. Throws
  // std::invalid_argument for a vertex the mesh has not, and if there is no such chain.
  DeckEdge(const HullBody& body, const std::vector<int>& vertices);

  bool empty() const { return curves_.empty(); }
  // Height of its lowest point along a direction, exactly; infinite if there is no edge.
  double lowest(const Vector3d& up) const;

 private:
  std::vector<surface::CreaseCurve> curves_;
  bool mirrored_;
};

}  // namespace hull::analysis
