// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include "analysis/arithmetic/estimating_rule.h"
#include "analysis/derivatives/span_derivatives.h"
#include "analysis/derivatives/span_nodes.h"
#include "analysis/derivatives/whole_span.h"

namespace hull::analysis {
namespace {

using namespace immersed_number;
using RowVector = Eigen::RowVector3d;

constexpr int kAlong = 10;          // nodes along the water's surface
constexpr int kMostHalvings = 5;    // of an interval there
constexpr double kSettled = 1e-12;  // of a span's own area: what an interval may be off

// A row of columns: some of the numbers' derivatives, by one place's shift.
using NodeRow = Eigen::Matrix<double, 1, 3 * kCount>;

double span_size(const surface::BicubicPoints& points) {
  return (points[10] - points[5]).squaredNorm() + (points[9] - points[6]).squaredNorm();
}

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
    const Breaks breaks = crossing_breaks(square.height);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      add_interval(square, rule, breaks[k], breaks[k + 1] - breaks[k], 0);
    }
  }

 private:
  struct Wet {
    double from = 0.0, to = 1.0;
    bool any = true, crosses = false;
  };

  static Wet wet_part(const CutSquare& square, double u) {
    const BezierCubic column = square.height.along_v(u);
    const bool low = column[0] < 0.0, high = column[3] < 0.0;
    Wet wet;
    wet.any = low || high;
    wet.crosses = low != high;
    if (wet.crosses) (low ? wet.to : wet.from) = crossing(column);
    return wet;
  }

  // Where the square's parameters (along the cut, across it) are in the span.
  SpanNode node(const CutSquare& square, double along, double across) const {
    const double a = square.size * along, b = square.size * across;
    return {points_, square.u + (square.swapped ? b : a), square.v + (square.swapped ? a : b)};
  }

  static double slope_across(const CutSquare& square, const SpanNode& at, const Plane& water) {
    return std::abs(water.normal.dot(square.swapped ? at.along_u : at.along_v));
  }

  void add_interval(const CutSquare& square, SpanRule rule, double begin, double width, int depth) {
    const EstimatingRule& outer = EstimatingRule::of(kAlong);
    if (depth < kMostHalvings && !is_settled(square, outer, begin, width)) {
      add_interval(square, rule, begin, 0.5 * width, depth + 1);
      add_interval(square, rule, begin + 0.5 * width, 0.5 * width, depth + 1);
      return;
    }
    const GaussRule& inner = gauss(rule);
    for (int i = 0; i < outer.count(); ++i) {
      const double u = begin + width * outer.node(i);
      const double weight = outer.weight(i) * width * square.size;
      const Wet wet = wet_part(square, u);
      if (!wet.any) continue;
      for (std::size_t j = 0; j < inner.nodes.size(); ++j) {
        const double v = wet.from + (wet.to - wet.from) * inner.nodes[j];
        add_node(node(square, u, v), weight * square.size * (wet.to - wet.from) * inner.weights[j]);
      }
      if (!wet.crosses) continue;
      const SpanNode at = node(square, u, wet.from > 0.0 ? wet.from : wet.to);
      const double slope = slope_across(square, at, frame_.water);
      if (slope > 0.0) add_line_node(at, weight / slope);
    }
  }

  // By the area of what is wet, and by the waterplane's share of it.
  bool is_settled(const CutSquare& square, const EstimatingRule& outer, double begin,
                  double width) const {
    EstimatingRule::Values widths{}, shares{};
    for (int i = 0; i < outer.count(); ++i) {
      const double u = begin + width * outer.node(i);
      const Wet wet = wet_part(square, u);
      if (!wet.crosses) continue;
      widths[i] = wet.to - wet.from;
      const SpanNode at = node(square, u, wet.from > 0.0 ? wet.from : wet.to);
      const double slope = slope_across(square, at, frame_.water);
      shares[i] = slope > 0.0 ? at.normal.norm() * std::sqrt(span_size(points_)) / slope : 0.0;
    }
    const double size = span_size(points_);
    return width * outer.error(widths) <= kSettled &&
           width * outer.error(shares) <= kSettled * size;
  }

  void add_node(const SpanNode& at, double weight) {
    const Vector3d n = weight * at.normal, arm = at.point - frame_.buoyancy;
    Eigen::Matrix<double, 1, 12> row;
    row << n.transpose(), arm.x() * n.transpose(), arm.y() * n.transpose(), arm.z() * n.transpose();
    sum_.leftCols<12>() += at.at * row;
    const double length = at.normal.norm();
    if (!(length > 0.0)) return;
    const Vector3d unit = at.normal * (weight / length);
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
