// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/body_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

// Of the mesh's size, or of its powers.
constexpr double kCornerFirst = 1e-15;  // per irregular corner
constexpr double kCutVolume = 1e-15;    // per part of a cut
constexpr double kSpanArea = 1e-12;     // per span
constexpr double kCornerArea = 1e-11;   // per irregular corner

constexpr double kCoarse = 1e-9;       // tolerance from which on rules that are not exact will do
constexpr double kLeastVolume = 1e-6;  // of size³: flat meshes

constexpr double kCentreGrid = 0.125;  // of the size, for the centre

double power_of_two(double x) { return std::exp2(std::round(std::log2(x))); }

}  // namespace

CutRules exact_cuts(double size, double looser) {
  return {kZeroHeight * size, looser * kCutVolume * size * size * size, kSpanArea * size * size,
          SpanRule::kExact, 10};
}

BodyRules body_rules(const surface::LimitSurface& surface, bool mirrored, double tolerance) {
  const Eigen::AlignedBox3d& box = surface.mesh().box();
  const Vector3d middle = 0.5 * (box.min() + box.max());
  const double size = power_of_two(surface.mesh().size());
  BodyRules rules;
  rules.centre = kCentreGrid * size * (middle / (kCentreGrid * size)).array().round().matrix();
  // In the centre plane, so that the mirror image of moments is about the same point.
  if (mirrored) rules.centre.y() = 0.0;
  if (tolerance < kCoarse) {
    // The rules stay exact; where they are not, at corners and cuts, they end earlier.
    const double looser = std::max(1.0, tolerance / kFinest);
    rules.span = SpanRule::kExact;
    rules.span_area = kSpanArea * size * size;
    rules.corner = {looser * kCornerFirst * size * size * size, kCornerArea * size * size,
                    SpanRule::kExact, SpanRule::kVolume};
    rules.cut = exact_cuts(size, looser);
    return rules;
  }
  // The parts share in what the volume and the surface of the box around the mesh may be off, of
  // which a hull has a third or more. Few spans, and few of those that the water cuts, come near to
  // their share; at corners a volume's error is some part of that of the nine moments together.
  const Vector3d sides = box.sizes();
  const double volume =
      tolerance * power_of_two(std::max(sides.prod(), kLeastVolume * size * size * size));
  const double area = tolerance * power_of_two(sides.x() * sides.y() + sides.y() * sides.z() +
                                               sides.z() * sides.x() + kLeastVolume * size * size);
  const double corners = 1.0 + 0.25 * surface.layout().corner_count();
  const double spans = 1.0 + 0.125 * surface.layout().leaf_count();
  rules.span = SpanRule::kSmall;
  rules.span_area = area / spans;
  rules.corner = {volume / corners, area / corners, SpanRule::kSmall, SpanRule::kSmall};
  rules.cut = {kZeroHeight * size, volume / spans, area / spans, SpanRule::kSmall, 6};
  return rules;
}

BodyRules without_areas(BodyRules rules) {
  rules.span_area = rules.corner.area = rules.cut.area = std::numeric_limits<double>::infinity();
  return rules;
}

bool operator==(const BodyRules& a, const BodyRules& b) {
  // What is not compared here would change without parts being computed anew.
  return a.centre == b.centre && a.span == b.span && a.span_area == b.span_area &&
         a.corner.first == b.corner.first && a.corner.area == b.corner.area &&
         a.corner.outer == b.corner.outer && a.corner.inner == b.corner.inner &&
         a.cut.zero == b.cut.zero && a.cut.volume == b.cut.volume && a.cut.area == b.cut.area &&
         a.cut.span == b.cut.span && a.cut.along == b.cut.along;
}

}  // namespace hull::analysis
