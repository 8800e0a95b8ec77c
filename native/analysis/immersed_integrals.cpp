// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersed_integrals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "analysis/gauss.h"

namespace hull {
namespace {

// The highest polynomial integrand, a second moment, has degree 3 + 3 + 5 = 11 in u and in v.
constexpr int kExactNodes = 6;
constexpr int kAreaNodes = 8;
constexpr int kCutNodes = 12;  // along a cut, where the integrand is analytic but no polynomial
constexpr int kCutCheckNodes = 9;
constexpr double kSmallestCorner = 1e-8;  // of the mesh's size
constexpr double kAreaTolerance = 1e-12;  // of the size squared, per piece
constexpr int kDeepestArea = 5;

class Integrator {
 public:
  Integrator(const Plane& water, double size)
      : water_(water),
        size_(size),
        exact_(gauss_rule(kExactNodes)),
        area_(gauss_rule(kAreaNodes)),
        cut_(gauss_rule(kCutNodes)),
        cut_check_(gauss_rule(kCutCheckNodes)) {}

  void add(const SurfacePiece& piece) {
    const BezierBicubic height = heights(piece.points, water_, 1e-13 * size_);
    cut_piece(height, [&](const CutSquare& square) {
      if (square.side == CutSquare::Side::kBelow) add_whole(piece.points, square);
      if (square.side == CutSquare::Side::kCut) add_cut(piece.points, square);
    });
  }

  const ImmersedIntegrals& sum() const { return sum_; }

 private:
  // One node: position and normal times area element, from the piece's own parameters.
  void add_node(const SurfaceJet& jet, double weight, ImmersedIntegrals& sum) const {
    const Vector3d n = jet.du.cross(jet.dv) * weight;
    const double h = water_.height(jet.point), along = water_.normal.dot(n);
    const Vector3d foot = jet.point - h * water_.normal;
    sum.wetted_area += n.norm();
    sum.flux += h * along;
    sum.flux_moment += (jet.point - 0.5 * h * water_.normal) * (h * along);
    sum.projected_area -= along;
    sum.projected_moment -= foot * along;
    sum.projected_second -= foot * foot.transpose() * along;
    sum.flux_forms += jet.point.cwiseProduct(n);
  }

  double area(const BicubicPoints& points, double u, double v, double size,
              const GaussRule& rule) const {
    double total = 0.0;
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const SurfaceJet jet =
            evaluate_bicubic(points, u + size * rule.nodes[i], v + size * rule.nodes[j], 1);
        total += rule.weights[i] * rule.weights[j] * jet.du.cross(jet.dv).norm();
      }
    }
    return total * size * size;
  }

  // Refines where two rules disagree; returns the area and adds to the error estimate.
  double steady_area(const BicubicPoints& points, double u, double v, double size, double coarse,
                     int depth, double& error) const {
    const double fine = area(points, u, v, size, area_);
    const double difference = std::abs(fine - coarse);
    if (difference <= kAreaTolerance * size_ * size_ || depth == kDeepestArea) {
      error += difference;
      return fine;
    }
    double total = 0.0;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 2; ++i) {
        const double half = 0.5 * size, a = u + half * i, b = v + half * j;
        total +=
            steady_area(points, a, b, half, area(points, a, b, half, exact_), depth + 1, error);
      }
    }
    return total;
  }

  void add_whole(const BicubicPoints& points, const CutSquare& square) {
    ImmersedIntegrals whole;
    for (int j = 0; j < kExactNodes; ++j) {
      for (int i = 0; i < kExactNodes; ++i) {
        const SurfaceJet jet = evaluate_bicubic(points, square.u + square.size * exact_.nodes[i],
                                                square.v + square.size * exact_.nodes[j], 1);
        add_node(jet, exact_.weights[i] * exact_.weights[j] * square.size * square.size, whole);
      }
    }
    whole.wetted_area = steady_area(points, square.u, square.v, square.size, whole.wetted_area, 0,
                                    whole.wetted_area_error);
    sum_ += whole;
  }

  // Integrates over the immersed part of a cut square with `rule` along the cut.
  ImmersedIntegrals integrate_cut(const BicubicPoints& points, const CutSquare& square,
                                  const Breaks& breaks, const GaussRule& rule) const {
    ImmersedIntegrals sum;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const double begin = breaks[k], width = breaks[k + 1] - breaks[k];
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double u = begin + width * rule.nodes[i];
        const BezierCubic column = square.height.along_v(u);
        const bool low_wet = column[0] < 0.0, high_wet = column[3] < 0.0;
        if (!low_wet && !high_wet) continue;
        double from = 0.0, to = 1.0;
        if (low_wet != high_wet) (low_wet ? to : from) = crossing(square.height, u);
        for (int j = 0; j < kExactNodes; ++j) {
          const double v = from + (to - from) * exact_.nodes[j];
          const double s = square.u + square.size * (square.swapped ? v : u);
          const double t = square.v + square.size * (square.swapped ? u : v);
          const double weight = rule.weights[i] * width * exact_.weights[j] * (to - from);
          add_node(evaluate_bicubic(points, s, t, 1), weight * square.size * square.size, sum);
        }
      }
    }
    return sum;
  }

  void add_cut(const BicubicPoints& points, const CutSquare& square) {
    const Breaks breaks = crossing_breaks(square.height);
    ImmersedIntegrals part = integrate_cut(points, square, breaks, cut_);
    const ImmersedIntegrals check = integrate_cut(points, square, breaks, cut_check_);
    part.flux_error = std::abs(part.flux - check.flux);
    part.wetted_area_error = std::abs(part.wetted_area - check.wetted_area);
    sum_ += part;
  }

  Plane water_;
  double size_;
  GaussRule exact_, area_, cut_, cut_check_;
  ImmersedIntegrals sum_;
};

}  // namespace

ImmersedIntegrals& ImmersedIntegrals::operator+=(const ImmersedIntegrals& other) {
  wetted_area += other.wetted_area;
  flux += other.flux;
  flux_moment += other.flux_moment;
  projected_area += other.projected_area;
  projected_moment += other.projected_moment;
  projected_second += other.projected_second;
  flux_forms += other.flux_forms;
  wetted_area_error += other.wetted_area_error;
  flux_error += other.flux_error;
  return *this;
}

ImmersedIntegrals immersed_integrals(const LimitSurface& surface, const Plane& water) {
  const double size = surface.mesh().size();
  Integrator integrator(water, size);
  const auto descend = [&](const CornerSquare& square) {
    if (square.extent() < kSmallestCorner * size) return false;
    return height_range(square, water)[0] < 0.0;
  };
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for_each_piece(surface, cell, descend,
                   [&](const SurfacePiece& piece) { integrator.add(piece); });
  }
  return integrator.sum();
}

}  // namespace hull
