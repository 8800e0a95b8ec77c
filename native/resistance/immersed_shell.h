// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/derivatives/span_nodes.h"
#include "analysis/immersion/hull_body.h"
#include "resistance/wave_scales.h"

namespace hull::resistance {

// Upright water with the direction of the ship's way, horizontal.
struct WayFrame {
  analysis::Plane water;
  Vector3d ahead;
  double zero;  // m: heights closer to the water than this are none

  double x(const Vector3d& p) const { return ahead.dot(p); }
  double depth(const Vector3d& p) const { return std::max(0.0, -water.height(p)); }
};

// What is done at the nodes of a quadrature of waves over a shell.
class ShellVisitor {
 public:
  virtual ~ShellVisitor() = default;
  // On the shell: `weight` times S_u x S_v is the oriented area.
  virtual void at_node(const analysis::SpanNode& node, double weight) = 0;
  // On the waterline: `weight` times the rise of the height there is the strip of parameters, times
  // |S_u x S_v| the area, that comes under water when the shell sinks (analysis/derivatives).
  virtual void at_water(const analysis::SpanNode&, double) {}
};

// Visits nodes by which functions exp(i k x - K d) of the given scales, times the oriented area,
// are integrated over what is below the water of a span: between the exact crossings of the water,
// in rectangles that are halved until the phase turns little over them, and until depths no more
// than double or the shortest waves do not fall off. Each direction of a rectangle has as many of
// Gauss's nodes as its phase and decay ask for to be off by less than 1e-12.
void visit_span(const surface::BicubicPoints& points, const WayFrame& frame,
                const WaveScales& scales, ShellVisitor& visitor);

// Of all of a body's shell, the modelled side, without closings.
void visit_shell(const analysis::HullBody& body, const WayFrame& frame, const WaveScales& scales,
                 ShellVisitor& visitor);

// Whether a square with an irregular corner has, by its control points, something below the water
// that is not too small to count.
bool goes_on(const std::vector<Vector3d>& square, const WayFrame& frame, double size);

}  // namespace hull::resistance
