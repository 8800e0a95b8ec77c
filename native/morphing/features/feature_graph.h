// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "modelling/fields/field_curve.h"
#include "morphing/features/hull_box.h"
#include "surface/creases/crease_curves.h"
#include "surface/limit_surface.h"

namespace hull::morphing {

// What a line of creases or borders is to the ship.
enum class FeatureRole {
  kCentreLine,     // border in the centre plane: keel, stem, stern
  kTransomMiddle,  // border in the centre plane within a transom
  kTransomEdge,    // crease around a transom
  kTransomRim,     // border along the top of a transom
  kBowMiddle,      // the same three at a flat end forward, as of a barge
  kBowEdge,
  kBowRim,
  kDeckEdge,   // border along the ship, off the centre plane
  kBarEdge,    // crease along the centre plane, as beside a bar keel
  kBottomRim,  // crease along the flat bottom
  kKnuckle,    // any other crease: chine, knuckle, rim of a flat side
  kOpening     // any other border, as the end of an appendage
};
// As a person says it: "the deck edge".
const char* name_of(FeatureRole role);

// A line of one role, from end to end: chains of crease_curves(), one after the other.
struct Feature {
  FeatureRole role;
  int body;
  std::vector<int> chains;        // in order …
  std::vector<char> is_backward;  // … and whether each is run through against its own direction
  std::vector<double> lengths;    // along the curve, m: at the chains' ends, from 0 on
  std::vector<int> nodes;         // control points at these; the first again of a closed one
  // From aft to forward, from below upwards, or outwards; of a closed one set_order() tells.
  modelling::FieldCurve curve;
  bool closed() const { return nodes.front() == nodes.back(); }
};

// All lines of creases and borders of a hull with what they are to it.
struct FeatureGraph {
  std::vector<surface::CreaseCurve> curves;  // crease_curves() of the surface
  std::vector<Feature> features;             // by role, then from aft to forward
  HullBox box;  // of control points; of a half hull from the centre plane on
  int body_count;

  // "the knuckle from (12.0, 3.5, 4.0) to (80.0, 3.0, 4.5)".
  std::string described(int feature) const;
  // "the body between (5.0, 0.0, 0.4) and (6.4, 0.2, 1.8)", by its creases and borders.
  std::string described_body(int body) const;
};

FeatureGraph feature_graph(const surface::LimitSurface& surface);

// Whether the hull has a centre line: it is one side of a ship.
bool is_half(const FeatureGraph& graph);

}  // namespace hull::morphing
