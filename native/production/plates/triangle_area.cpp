// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/triangle_area.h"

#include <Eigen/Geometry>
#include <vector>

#include "analysis/arithmetic/gauss.h"

namespace hull::production {

namespace {

using Corners = std::array<Vector2d, 3>;
constexpr int kOrder = 6;
constexpr int kDeepest = 6;
// Of halvings towards an irregular corner: areas fall by about four each time.
constexpr int kRings = 22;

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
        // The square's side s = 1 shrinks to a point, and the weights have 1 - s, the map's
        // determinant.
        at.emplace_back(s, (1.0 - s) * rule.nodes[j]);
        weights.push_back(rule.weights[i] * rule.weights[j] * (1.0 - s));
      }
    }
  }
};

using Polygon = std::vector<Vector2d>;

// The part of a convex polygon with sign (p[axis] - at) >= 0.
Polygon cut_off(const Polygon& polygon, int axis, double at, double sign) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double here = sign * (p[axis] - at), there = sign * (q[axis] - at);
    // Corners on the line are of both parts; sides along it cross nothing.
    if (here >= 0.0) part.push_back(p);
    if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) {
      Vector2d between = p + here / (here - there) * (q - p);
      between[axis] = at;  // exactly, so that both parts share it
      part.push_back(between);
    }
  }
  return part;
}

// A cell's square, or what is left of it towards an irregular corner.
struct Square {
  double u, v, size;
};

class Integrator {
 public:
  Integrator(const surface::LimitSurface& surface, int cell, double tolerance)
      : surface_(surface), cell_(cell), tolerance_(tolerance) {}

  // Piece by piece of the surface: within each it is smooth, and the rule is quick.
  AreaMoments over(const Polygon& polygon, const surface::SurfaceNode& node,
                   const Square& square) const {
    using Kind = surface::SurfaceNode::Kind;
    if (polygon.size() < 3) return {};
    // A triangle may go over several pieces: its parts in each are convex polygons.
    if (node.kind == Kind::kSplit) {
      const auto& children = surface_.layout().split(node.index);
      return by_quarters(polygon, square, [&](const Polygon& part, int i, const Square& quarter) {
        return over(part, children[i], quarter);
      });
    }
    return node.kind == Kind::kCorner ? around_corner(polygon, square, 0) : smooth(polygon);
  }

 private:
  template <class Visit>
  AreaMoments by_quarters(const Polygon& polygon, const Square& square, const Visit& visit) const {
    const double half = 0.5 * square.size;
    AreaMoments sum;
    for (int j = 0; j < 2; ++j) {
      const Polygon row = cut_off(polygon, 1, square.v + half, j ? 1.0 : -1.0);
      for (int i = 0; i < 2; ++i) {
        const Polygon part = cut_off(row, 0, square.u + half, i ? 1.0 : -1.0);
        if (part.size() < 3) continue;
        sum += visit(part, 2 * j + i, {square.u + half * i, square.v + half * j, half});
      }
    }
    return sum;
  }

  // Rings of pieces that shrink towards an irregular corner.
  AreaMoments around_corner(const Polygon& polygon, const Square& square, int ring) const {
    // 4^-22 of the square's area is left.
    if (ring == kRings) return fan(polygon, [this](const Corners& c) { return by_rule(c); });
    return by_quarters(polygon, square, [&](const Polygon& part, int i, const Square& quarter) {
      // The quarter's corner that is one of the whole square's.
      const double u = quarter.u + (i % 2) * quarter.size, v = quarter.v + (i / 2) * quarter.size;
      return surface_.is_irregular_knot(cell_, u, v) ? around_corner(part, quarter, ring + 1)
                                                     : smooth(part);
    });
  }

  template <class Integrate>
  static AreaMoments fan(const Polygon& polygon, const Integrate& integrate) {
    AreaMoments sum;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      sum += integrate(Corners{polygon[0], polygon[k - 1], polygon[k]});
    }
    return sum;
  }

  AreaMoments smooth(const Polygon& polygon) const {
    return fan(polygon, [this](const Corners& c) { return refined(c, by_rule(c), tolerance_, 0); });
  }

  AreaMoments refined(const Corners& c, const AreaMoments& whole, double tolerance,
                      int depth) const {
    const Vector2d ab = 0.5 * (c[0] + c[1]), bc = 0.5 * (c[1] + c[2]), ca = 0.5 * (c[2] + c[0]);
    const std::array<Corners, 4> quarters{
        Corners{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {ab, bc, ca}};
    std::array<AreaMoments, 4> parts;
    AreaMoments sum;
    for (int k = 0; k < 4; ++k) sum += parts[k] = by_rule(quarters[k]);
    // The finer sum is taken; a quarter of the triangle gets a quarter of the tolerance.
    if (std::abs(sum.area - whole.area) <= tolerance || depth == kDeepest) return sum;
    sum = {};
    for (int k = 0; k < 4; ++k) {
      sum += refined(quarters[k], parts[k], 0.25 * tolerance, depth + 1);
    }
    return sum;
  }

  AreaMoments by_rule(const Corners& c) const {
    static const TriangleRule rule;
    const Vector2d along = c[1] - c[0], across = c[2] - c[0];
    const double twice = cross(along, across);
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

  const surface::LimitSurface& surface_;
  int cell_;
  double tolerance_;
};

}  // namespace

AreaMoments area_moments(const surface::LimitSurface& surface, const ShellTriangle& triangle,
                         double tolerance) {
  return Integrator(surface, triangle.cell, tolerance)
      .over({triangle.uv.begin(), triangle.uv.end()}, surface.layout().root(triangle.cell),
            {0.0, 0.0, 1.0});
}

}  // namespace hull::production
