// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "analysis/derivatives/span_derivatives.h"
#include "analysis/derivatives/wet_columns.h"
#include "analysis/derivatives/whole_span.h"

namespace hull::analysis {
namespace {

using namespace immersed_number;
using RowVector = Eigen::RowVector3d;

// A row of columns: some of the numbers' derivatives, by one place's shift.
using NodeRow = Eigen::Matrix<double, 1, 3 * kCount>;

class SpanIntegrator {
 public:
  SpanIntegrator(const surface::BicubicPoints& points, const ImmersionFrame& frame,
                 PointColumns& sum)
      : points_(points), frame_(frame), sum_(sum) {}

  // All of a square of the span.
  void add_square(double u, double v, double size, SpanRule rule) {
    const GaussRule& gauss_nodes = gauss(rule);
    for (std::size_t j = 0; j < gauss_nodes.nodes.size(); ++j) {
      for (std::size_t i = 0; i < gauss_nodes.nodes.size(); ++i) {
        add_node({points_, u + size * gauss_nodes.nodes[i], v + size * gauss_nodes.nodes[j]},
                 size * size * gauss_nodes.weights[i] * gauss_nodes.weights[j]);
      }
    }
  }

  void add_cut(const CutSquare& square, SpanRule rule) {
    const auto add = [&](double begin, double width) { add_interval(square, rule, begin, width); };
    WetIntervals(points_, frame_.water, add).divide(square);
  }

 private:
  void add_interval(const CutSquare& square, SpanRule rule, double begin, double width) {
    const EstimatingRule& outer = EstimatingRule::of(kWetColumns);
    const GaussRule& inner = gauss(rule);
    for (int i = 0; i < outer.count(); ++i) {
      const double u = begin + width * outer.node(i);
      const double weight = outer.weight(i) * width * square.size;
      const WetColumn wet(square, u);
      if (!wet.any) continue;
      for (std::size_t j = 0; j < inner.nodes.size(); ++j) {
        // The wet part of the column alone, up to the exact crossing: within it all is smooth.
        const double v = wet.from + (wet.to - wet.from) * inner.nodes[j];
        add_node(node_of(points_, square, u, v),
                 weight * square.size * (wet.to - wet.from) * inner.weights[j]);
      }
      if (!wet.crosses) continue;
      const SpanNode at = node_of(points_, square, u, wet.at_water());
      const double slope = slope_across(square, at, frame_.water);
      if (slope > 0.0) add_line_node(at, weight / slope);
    }
  }

  void add_node(const SpanNode& at, double weight) {
    // Hadamard: the flux of f through what moves, for f = 1, x, y and z.
    const Vector3d n = weight * at.normal, arm = at.point - frame_.buoyancy;
    Eigen::Matrix<double, 1, 12> row;
    row << n.transpose(), arm.x() * n.transpose(), arm.y() * n.transpose(), arm.z() * n.transpose();
    sum_.leftCols<12>() += at.at * row;
    const double length = at.normal.norm();
    // Where the surface has no area, |N| has no derivative.
    if (!(length > 0.0)) return;
    const Vector3d unit = at.normal * (weight / length);
    // The variation of |N| is that of N times the unit normal: a triple product, in cyclic order.
    sum_.middleCols<3>(3 * kWettedSurface) +=
        at.du * at.along_v.cross(unit).transpose() + at.dv * unit.cross(at.along_u).transpose();
  }

  // On the waterline; `weight` over |h_v|.
  void add_line_node(const SpanNode& at, double weight) {
    const RowVector n = weight * at.normal.transpose();
    const Vector3d q = at.point - frame_.flotation;
    const double factors[] = {1.0,           q.x(),         q.y(),         q.z(),
                              q.x() * q.x(), q.y() * q.y(), q.z() * q.z(), q.x() * q.y(),
                              q.y() * q.z(), q.z() * q.x()};
    Eigen::Matrix<double, 1, 30> row;
    for (int k = 0; k < 10; ++k) row.segment<3>(3 * k) = factors[k] * n;
    sum_.rightCols<30>() += at.at * row;
    // Where the surface rises, a strip of it leaves the water.
    sum_.middleCols<3>(3 * kWettedSurface) -=
        at.at * (weight * at.normal.norm() * frame_.water.normal.transpose());
  }

  const surface::BicubicPoints& points_;
  const ImmersionFrame& frame_;
  PointColumns& sum_;
};

}  // namespace

void add_immersion_derivatives(const surface::BicubicPoints& points, const ImmersionFrame& frame,
                               SpanRule rule, PointColumns& sum) {
  double low = frame.water.height(points[0]), high = low;
  for (const Vector3d& p : points) {
    low = std::min(low, frame.water.height(p));
    high = std::max(high, frame.water.height(p));
  }
  if (low > -frame.zero) return;
  if (high < -frame.zero) return add_whole_span(points, frame, rule, sum);
  SpanIntegrator integrator(points, frame, sum);
  cut_piece(heights(points, frame.water, frame.zero), [&](const CutSquare& square) {
    if (square.side == CutSquare::Side::kBelow) {
      integrator.add_square(square.u, square.v, square.size, rule);
    } else if (square.side == CutSquare::Side::kCut) {
      integrator.add_cut(square, rule);
    }
  });
}

}  // namespace hull::analysis
