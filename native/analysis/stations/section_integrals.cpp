// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/section_integrals.h"

#include <Eigen/Geometry>
#include <cmath>

#include "analysis/arithmetic/estimating_rule.h"

namespace hull::analysis {
namespace {

constexpr int kDeepestClip = 12;
constexpr int kDeepestArc = 12;
constexpr double kCoarse = 1e-9;  // tolerance from which on fewer nodes will do

void integrate(const ArcSquare& square, double begin, double end, const ArcRule& rule, int depth,
               SectionIntegrals& sum) {
  const EstimatingRule& along = EstimatingRule::of(rule.nodes);
  EstimatingRule::Values areas, lengths;
  SectionIntegrals part;
  for (int k = 0; k < along.count(); ++k) {
    // By Green's theorem areas and moments, too, are integrals along the outline.
    const ArcPoint p = arc_point(square, begin + (end - begin) * along.node(k));
    const double weight = along.weight(k);
    areas[k] = p.a * p.db;
    lengths[k] = std::sqrt(p.da * p.da + p.db * p.db);
    part.area += weight * areas[k];
    part.moment_a += weight * 0.5 * p.a * areas[k];
    part.moment_b += weight * p.b * areas[k];
    part.girth += weight * lengths[k];
    part.breadth += weight * p.da;
  }
  const double width = end - begin;
  part.error = width * along.error(areas);
  if (depth < kDeepestArc &&
      (part.error > rule.area || width * along.error(lengths) > rule.length)) {
    const double middle = 0.5 * (begin + end);
    integrate(square, begin, middle, rule, depth + 1, sum);
    integrate(square, middle, end, rule, depth + 1, sum);
    return;
  }
  part.area *= width * square.sign;
  part.moment_a *= width * square.sign;
  part.moment_b *= width * square.sign;
  part.girth *= width;
  part.breadth *= width * square.sign;
  sum += part;
}

// The u between begin and end where b passes level; one of them is below it, the other not.
double level_crossing(const ArcSquare& square, double begin, double end, double level) {
  double f_begin = arc_point(square, begin).b - level;
  double f_end = arc_point(square, end).b - level;
  int side = 0;
  for (int i = 0; i < 100 && end - begin > 1e-15; ++i) {
    double t = begin + (end - begin) * (f_begin / (f_begin - f_end));
    if (!(t > begin && t < end)) t = 0.5 * (begin + end);
    const double f = arc_point(square, t).b - level;
    if (f == 0.0) return t;
    // Halving the value at the end that stays (Illinois) keeps the secant from creeping.
    if ((f < 0.0) == (f_begin < 0.0)) {  // an end at the very level is not below
      if (t - begin < 1e-15) return t;
      begin = t;
      f_begin = f;
      if (side == -1) f_end *= 0.5;
      side = -1;
    } else {
      if (end - t < 1e-15) return t;
      end = t;
      f_end = f;
      if (side == 1) f_begin *= 0.5;
      side = 1;
    }
  }
  return 0.5 * (begin + end);
}

void clip(const ArcSquare& square, double level, const ArcRule& rule, int depth,
          SectionIntegrals& sum) {
  if (lowest(square.b) >= level) return;
  if (highest(square.b) < level) {
    for_each_stretch(
        square, [&](double begin, double end) { integrate(square, begin, end, rule, 0, sum); });
    return;
  }
  // On a monotonic arc each end tells its half: one crossing, or none.
  if (depth == kDeepestClip || is_monotonic(square)) {
    for_each_stretch(square, [&](double begin, double end) {
      const bool begin_wet = arc_point(square, begin).b < level;
      const bool end_wet = arc_point(square, end).b < level;
      if (begin_wet && end_wet) return integrate(square, begin, end, rule, 0, sum);
      if (!begin_wet && !end_wet) return;
      const double at = level_crossing(square, begin, end, level);
      integrate(square, begin_wet ? begin : at, begin_wet ? at : end, rule, 0, sum);
    });
    return;
  }
  std::array<ArcSquare, 2> sides;
  halve_u(square.h, sides[0].h, sides[1].h);
  halve_u(square.a, sides[0].a, sides[1].a);
  halve_u(square.b, sides[0].b, sides[1].b);
  for (const ArcSquare& side : sides) {
    std::array<ArcSquare, 2> quarters;
    halve_v(side.h, quarters[0].h, quarters[1].h);
    halve_v(side.a, quarters[0].a, quarters[1].a);
    halve_v(side.b, quarters[0].b, quarters[1].b);
    for (ArcSquare& quarter : quarters) {
      // Zero counts as above everywhere, so that an arc along the side of two quarters is in one.
      if (lowest(quarter.h) >= 0.0 || highest(quarter.h) < 0.0) continue;
      quarter.sign = square.sign;
      clip(quarter, level, rule, depth + 1, sum);
    }
  }
}

}  // namespace

SectionFrame SectionFrame::above_water(const Plane& plane, const Plane& water) {
  const Vector3d& normal = plane.normal;
  // Areas are in the station's plane, whatever the trim; only the level is the water's.
  const Vector3d up = (water.normal - water.normal.dot(normal) * normal).normalized();
  const Vector3d foot = plane.offset * normal;
  const Vector3d origin =
      foot + up * ((water.offset - water.normal.dot(foot)) / water.normal.dot(up));
  return {plane, origin, up.cross(normal), up};
}

SectionFrame SectionFrame::mirrored() const {
  const Vector3d mirror(1.0, -1.0, 1.0);
  // A mirrored pair of axes turns the other way round; reversing one makes up for it.
  return {plane, origin.cwiseProduct(mirror), -across.cwiseProduct(mirror),
          up.cwiseProduct(mirror)};
}

SectionIntegrals& SectionIntegrals::operator+=(const SectionIntegrals& other) {
  area += other.area;
  moment_a += other.moment_a;
  moment_b += other.moment_b;
  girth += other.girth;
  breadth += other.breadth;
  error += other.error;
  return *this;
}

ArcRule arc_rule(double size, double tolerance) {
  if (tolerance < kCoarse) return {8, 1e-12 * size * size, 1e-11 * size};
  return {5, 1e-2 * tolerance * size * size, tolerance * size};
}

void add_arcs(const ArcSquare& square, double level, const ArcRule& rule, SectionIntegrals& sum) {
  clip(square, level, rule, 0, sum);
}

void add_line(double a0, double b0, double a1, double b1, double level, SectionIntegrals& sum) {
  if (b0 >= level && b1 >= level) return;
  if (b0 >= level) {
    a0 += (a1 - a0) * (level - b0) / (b1 - b0);
    b0 = level;
  } else if (b1 >= level) {
    a1 += (a0 - a1) * (level - b1) / (b0 - b1);
    b1 = level;
  }
  const double da = a1 - a0, db = b1 - b0;
  // The same integrals along a0 + t da, b0 + t db, in closed form.
  sum.area += 0.5 * (a0 + a1) * db;
  sum.moment_a += (a0 * a0 + a0 * a1 + a1 * a1) / 6.0 * db;
  sum.moment_b += (a0 * b0 + 0.5 * (a0 * db + b0 * da) + da * db / 3.0) * db;
  sum.breadth += da;
}

}  // namespace hull::analysis
