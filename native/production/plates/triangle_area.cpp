// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/triangle_area.h"

#include <Eigen/Geometry>

#include "analysis/arithmetic/gauss.h"

namespace hull::production {

using Eigen::Vector2d;

namespace {

using Corners = std::array<Vector2d, 3>;
constexpr int kOrder = 6;
constexpr int kDeepest = 24;

// Points and weights of the triangle (0, 0), (1, 0), (0, 1), from those of the square that
// collapses onto it.
struct TriangleRule {
  std::vector<Vector2d> at;
  std::vector<double> weights;
  TriangleRule() {
    const analysis::GaussRule rule = analysis::gauss_rule(kOrder);
    for (int i = 0; i < kOrder; ++i) {
      for (int j = 0; j < kOrder; ++j) {
        const double s = rule.nodes[i];
        at.emplace_back(s, (1.0 - s) * rule.nodes[j]);
        weights.push_back(rule.weights[i] * rule.weights[j] * (1.0 - s));
      }
    }
  }
};

class Integrator {
 public:
  Integrator(const surface::LimitSurface& surface, int cell) : surface_(surface), cell_(cell) {}

  AreaMoments integrate(const Corners& c, const AreaMoments& whole, double tolerance,
                        int depth) const {
    const Vector2d ab = 0.5 * (c[0] + c[1]), bc = 0.5 * (c[1] + c[2]), ca = 0.5 * (c[2] + c[0]);
    const std::array<Corners, 4> quarters{
        Corners{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {ab, bc, ca}};
    std::array<AreaMoments, 4> parts;
    AreaMoments sum;
    for (int k = 0; k < 4; ++k) sum += parts[k] = by_rule(quarters[k]);
    if (std::abs(sum.area - whole.area) <= tolerance || depth == kDeepest) return sum;
    sum = {};
    for (int k = 0; k < 4; ++k) {
      sum += integrate(quarters[k], parts[k], 0.25 * tolerance, depth + 1);
    }
    return sum;
  }

  AreaMoments by_rule(const Corners& c) const {
    static const TriangleRule rule;
    const Vector2d along = c[1] - c[0], across = c[2] - c[0];
    const double twice = along.x() * across.y() - along.y() * across.x();
    AreaMoments sum;
    surface::SurfaceJet jet;
    for (std::size_t k = 0; k < rule.at.size(); ++k) {
      const Vector2d uv = c[0] + rule.at[k].x() * along + rule.at[k].y() * across;
      surface_.evaluate(cell_, uv.x(), uv.y(), 1, jet);
      const double area = twice * rule.weights[k] * jet.du.cross(jet.dv).norm();
      sum += {area, area * jet.point};
    }
    return sum;
  }

 private:
  const surface::LimitSurface& surface_;
  int cell_;
};

}  // namespace

AreaMoments area_moments(const surface::LimitSurface& surface, const ShellTriangle& triangle,
                         double tolerance) {
  const Integrator integrator(surface, triangle.cell);
  return integrator.integrate(triangle.uv, integrator.by_rule(triangle.uv), tolerance, 0);
}

}  // namespace hull::production
