// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/cut_moments.h"

#include <Eigen/Geometry>
#include <cmath>

#include "analysis/arithmetic/estimating_rule.h"

namespace hull::analysis {
namespace {

constexpr int kMostHalvings = 6;

// A span as a cubic across, at one parameter along: its points, and their derivatives along.
struct Across {
  std::array<Vector3d, 4> points, slopes;

  Across(const surface::BicubicPoints& span, double along, bool swapped) {
    const surface::Basis value = surface::cubic_basis(along),
                         slope = surface::cubic_basis_d1(along);
    for (int b = 0; b < 4; ++b) {
      points[b].setZero();
      slopes[b].setZero();
      for (int a = 0; a < 4; ++a) {
        const Vector3d& p = span[swapped ? 4 * a + b : 4 * b + a];
        points[b] += value[a] * p;
        slopes[b] += slope[a] * p;
      }
    }
  }
};

class CutIntegrator {
 public:
  CutIntegrator(const surface::BicubicPoints& points, const Vector3d& origin, const Plane& water,
                const CutRules& rules)
      : points_(points), origin_(origin), water_(water), rules_(rules) {}

  void add(const CutSquare& square) {
    // Where the water leaves the square its limits have a corner: the rule is for what is smooth.
    const Breaks breaks = crossing_breaks(square.height);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      add_interval(square, breaks[k], breaks[k + 1] - breaks[k], 0);
    }
  }

  ShellMoments sum;

 private:
  // The part of the square whose parameter along the cut is within an interval, halved until the
  // estimated errors are small.
  void add_interval(const CutSquare& square, double begin, double width, int depth) {
    const EstimatingRule& outer = EstimatingRule::of(rules_.along);
    EstimatingRule::Values volumes{}, areas{};
    // Ten columns of six nodes at most, which its capacity holds.
    ShellNodes nodes;
    for (int i = 0; i < outer.count(); ++i) {
      const double u = begin + width * outer.node(i);
      const BezierCubic column = square.height.along_v(u);
      const bool low_wet = column[0] < 0.0, high_wet = column[3] < 0.0;
      if (!low_wet && !high_wet) continue;
      double from = 0.0, to = 1.0;
      // The height is monotonic along a column: two wet ends mean a wet column.
      if (low_wet != high_wet) (low_wet ? to : from) = crossing(column);
      const double weight = outer.weight(i) * width;
      const int first = nodes.count;
      add_column(square, u, from, to, weight, nodes);
      for (int k = first; k < nodes.count; ++k) {
        const Vector3d p(nodes.x[k], nodes.y[k], nodes.z[k]);
        const Vector3d n(nodes.nx[k], nodes.ny[k], nodes.nz[k]);
        // By u, without the node's weight: what the estimate asks for. The volume is the flux of
        // the height along the normal, which has none through the water's surface.
        volumes[i] += water_.height(p + origin_) * water_.normal.dot(n) / weight;
        areas[i] += n.norm() / weight;
      }
    }
    const double volume_error = width * outer.error(volumes),
                 area_error = width * outer.error(areas);
    if ((volume_error > rules_.volume || area_error > rules_.area) && depth < kMostHalvings) {
      add_interval(square, begin, 0.5 * width, depth + 1);
      add_interval(square, begin + 0.5 * width, 0.5 * width, depth + 1);
      return;
    }
    add_nodes(nodes, sum);
    sum.volume_error += volume_error;
    sum.area_error += area_error;
  }

  void add_column(const CutSquare& square, double u, double from, double to, double weight,
                  ShellNodes& nodes) const {
    const GaussRule& inner = gauss(rules_.span);  // exact for polynomials up to its degree
    // Columns run along v, or along u where the square is swapped.
    const double begin = square.swapped ? square.u : square.v;
    const Across across(points_, (square.swapped ? square.v : square.u) + square.size * u,
                        square.swapped);
    // The normal is d/du x d/dv, whichever of them is across.
    const double sign = square.swapped ? -1.0 : 1.0;
    // Derivatives are by the span's parameters: a size for each of the square's.
    const double scale = sign * weight * (to - from) * square.size * square.size;
    for (std::size_t j = 0; j < inner.nodes.size(); ++j) {
      const double t = begin + square.size * (from + (to - from) * inner.nodes[j]);
      const surface::Basis value = surface::cubic_basis(t), slope = surface::cubic_basis_d1(t);
      Vector3d p = -origin_, along = Vector3d::Zero(), over = Vector3d::Zero();
      for (int b = 0; b < 4; ++b) {
        p += value[b] * across.points[b];
        along += value[b] * across.slopes[b];
        over += slope[b] * across.points[b];
      }
      nodes.add(p, along.cross(over) * (scale * inner.weights[j]));
    }
  }

  const surface::BicubicPoints& points_;
  const Vector3d& origin_;
  const Plane& water_;
  const CutRules& rules_;
};

}  // namespace

ShellMoments wet_moments(const surface::BicubicPoints& points, const Vector3d& origin,
                         const Plane& water, const CutRules& rules) {
  CutIntegrator integrator(points, origin, water, rules);
  const BezierBicubic height = heights(points, water, rules.zero);
  cut_piece(height, [&](const CutSquare& square) {
    if (square.side == CutSquare::Side::kBelow) {
      integrator.sum +=
          span_moments({points, origin, square.u, square.v, square.size}, rules.span, rules.area);
    } else if (square.side == CutSquare::Side::kCut) {
      integrator.add(square);
    }
  });
  return integrator.sum;
}

}  // namespace hull::analysis
