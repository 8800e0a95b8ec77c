// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "analysis/arithmetic/bracketed_root.h"
#include "analysis/arithmetic/estimating_rule.h"
#include "analysis/derivatives/span_derivatives.h"
#include "analysis/derivatives/span_nodes.h"
#include "analysis/sections/arc_square.h"
#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

constexpr int kNodes = 10;
constexpr int kDeepestClip = 12;
constexpr int kDeepestArc = 8;
constexpr double kSettledOfSize = 1e-12;  // of the size: of what a shift adds to the area, m

// A part [begin, end] of the square's u, over which the nets are restricted: b is the height above
// the water, and a is not used.
struct Strip {
  ArcSquare square;
  double begin, end;

  double at(double u) const { return begin + (end - begin) * u; }
};

class ArcIntegrator {
 public:
  ArcIntegrator(const surface::BicubicPoints& points, const Plane& station, double size,
                PointColumns& sum)
      : points_(points), station_(station), size_(size), sum_(sum) {}

  void add(const CutSquare& cut, const BezierNet& h, const BezierNet& b) {
    Strip strip{
        {restricted(h, cut.u, cut.v, cut.size), {}, restricted(b, cut.u, cut.v, cut.size), 1.0},
        0.0,
        1.0};
    // Nets are turned as the square is, so that arcs are functions of u again.
    if (cut.swapped) {
      strip.square.h = transposed(strip.square.h);
      strip.square.b = transposed(strip.square.b);
    }
    // Any net will do: of an arc's points only b and v are asked for.
    strip.square.a = strip.square.b;
    clip(cut, strip, 0);
  }

 private:
  // The stretches below the water: all of the strip, or up to the one crossing of an arc along
  // which the height rises or falls.
  void clip(const CutSquare& cut, const Strip& strip, int depth) {
    const ArcSquare& square = strip.square;
    if (lowest(square.b) >= 0.0) return;
    if (highest(square.b) < 0.0) {
      return for_each_stretch(
          square, [&](double begin, double end) { integrate(cut, strip, begin, end, 0); });
    }
    // One crossing of the water at most, or a strip so narrow that it is taken for that.
    if (depth == kDeepestClip || is_monotonic(square)) {
      return for_each_stretch(square, [&](double begin, double end) {
        const auto height = [&](double u) { return arc_point(square, u).b; };
        const double at_begin = height(begin), at_end = height(end);
        if (at_begin >= 0.0 && at_end >= 0.0) return;
        if (at_begin < 0.0 && at_end < 0.0) return integrate(cut, strip, begin, end, 0);
        const double at = bracketed_root(height, begin, at_begin, end, at_end, 1e-15);
        integrate(cut, strip, at_begin < 0.0 ? begin : at, at_begin < 0.0 ? at : end, 0);
      });
    }
    Strip low = strip, high = strip;
    halve_u(square.h, low.square.h, high.square.h);
    halve_u(square.b, low.square.b, high.square.b);
    low.square.a = low.square.b;
    high.square.a = high.square.b;
    low.end = high.begin = strip.at(0.5);
    for (const Strip& half : {low, high}) {
      // In a half on one side of the station, zero counting as above, there is no arc.
      if (lowest(half.square.h) < 0.0 && highest(half.square.h) >= 0.0) clip(cut, half, depth + 1);
    }
  }

  void integrate(const CutSquare& cut, const Strip& strip, double begin, double end, int depth) {
    const EstimatingRule& rule = EstimatingRule::of(kNodes);
    // From the arc's parameter to the strip's, the square's and the span's.
    const double width = end - begin, scale = width * (strip.end - strip.begin) * cut.size;
    Eigen::Matrix<double, 16, 3> part = Eigen::Matrix<double, 16, 3>::Zero();
    EstimatingRule::Values shares{};
    for (int k = 0; k < rule.count(); ++k) {
      const double u = begin + width * rule.node(k);
      const double a = cut.size * strip.at(u), b = cut.size * arc_point(strip.square, u).v;
      const SpanNode at(points_, cut.u + (cut.swapped ? b : a), cut.v + (cut.swapped ? a : b));
      const double slope = std::abs(station_.normal.dot(cut.swapped ? at.along_u : at.along_v));
      if (!(slope > 0.0)) continue;
      part += at.at * ((rule.weight(k) * scale / slope) * at.normal.transpose());
      // The weights of points are polynomials below 1: how smooth the integrand is, this factor
      // tells.
      shares[k] = at.normal.norm() / slope;
    }
    if (depth < kDeepestArc && std::abs(scale) * rule.error(shares) > kSettledOfSize * size_) {
      integrate(cut, strip, begin, 0.5 * (begin + end), depth + 1);
      integrate(cut, strip, 0.5 * (begin + end), end, depth + 1);
      return;
    }
    sum_ += part;
  }

  const surface::BicubicPoints& points_;
  const Plane& station_;
  double size_;
  PointColumns& sum_;
};

}  // namespace

void add_section_derivatives(const surface::BicubicPoints& points, const Plane& station,
                             const Plane& water, double size, PointColumns& sum) {
  BezierNet h = bezier_net(points, station.normal, station.offset);
  flush_to_zero(h, kZeroHeight * size);
  if (lowest(h) >= 0.0 || highest(h) < 0.0) return;
  const BezierNet b = bezier_net(points, water.normal, water.offset);
  if (lowest(b) >= 0.0) return;
  ArcIntegrator integrator(points, station, size, sum);
  cut_piece(BezierBicubic(h), [&](const CutSquare& cut) {
    if (cut.side == CutSquare::Side::kCut) integrator.add(cut, h, b);
  });
}

}  // namespace hull::analysis
