// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/immersion/corner_moments.h"
#include "analysis/immersion/cut_moments.h"
#include "surface/limit_surface.h"

namespace hull::analysis {

// Errors relative to the whole body that its integrals may have: as small as they get (1e-13, the
// wetted surface 1e-9), and small enough for numbers that follow the mouse.
inline constexpr double kFinest = 1e-13;
inline constexpr double kLive = 1e-8;

// Of size times area: the volume that an open sheet has by rounding, of either sign. What is
// further below zero is turned inwards.
inline constexpr double kNoVolume = 1e-9;

// How the parts of a body are integrated.
struct BodyRules {
  Vector3d centre;   // what moments are counted from
  SpanRule span;     // of whole spans …
  double span_area;  // … and how much the area of one may be off, m²
  CornerRules corner;
  CutRules cut;
};

// For a surface in its present shape. Lengths that rules depend on are rounded to powers of two,
// and the centre to a coarse grid: rules, and what was computed by them, stay as they are while
// some points are dragged.
BodyRules body_rules(const surface::LimitSurface& surface, bool mirrored, double tolerance);

// How water cuts through spans as exactly as can be, for what has this size, m; a volume may be off
// by `looser` times as much.
CutRules exact_cuts(double size, double looser = 1.0);

// The same where areas do not matter: they may be off by any amount, and are not computed.
BodyRules without_areas(BodyRules rules);

bool operator==(const BodyRules& a, const BodyRules& b);

}  // namespace hull::analysis
