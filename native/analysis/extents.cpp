// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/extents.h"

#include <cmath>

#include "analysis/bezier_net.h"

namespace hull {
namespace {

constexpr double kTolerance = 1e-10;       // of the size
constexpr double kZeroHeight = 1e-13;      // of the size
constexpr double kSmallestCorner = 1e-11;  // of the size
constexpr int kDeepest = 100;              // halvings

using Part = ExtentSearch::Part;

// A rectangle of a piece: the coordinate looked for and the height above the water.
struct Rectangle {
  BezierNet g, h;
  double u, v, width_u, width_v;
};

bool has_part(double lowest_height, double highest_height, Part part) {
  return lowest_height < 0.0 && (part == Part::kImmersed || highest_height >= 0.0);
}

// Mean slopes over the rectangle.
Eigen::Vector2d mean_slope(const BezierNet& net) {
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  for (int k = 0; k < 4; ++k) {
    slope.x() += net[4 * k + 3] - net[4 * k];
    slope.y() += net[12 + k] - net[k];
  }
  return slope;
}

class PieceSearch {
 public:
  PieceSearch(const SurfacePiece& piece, Part part, double tolerance, FarthestPoint& best)
      : piece_(piece), part_(part), tolerance_(tolerance), best_(best) {}

  void search(const Rectangle& r, int depth) {
    if (!has_part(lowest(r.h), highest(r.h), part_)) return;
    const double top = bound(r);
    if (top < best_.value - tolerance_) return;
    take_candidates(r);
    if (top <= best_.value + tolerance_ || depth == kDeepest) return;
    Rectangle low = r, high = r;
    if (halves_u(r)) {
      halve_u(r.g, low.g, high.g);
      halve_u(r.h, low.h, high.h);
      low.width_u = high.width_u = 0.5 * r.width_u;
      high.u += low.width_u;
    } else {
      halve_v(r.g, low.g, high.g);
      halve_v(r.h, low.h, high.h);
      low.width_v = high.width_v = 0.5 * r.width_v;
      high.v += low.width_v;
    }
    search(low, depth + 1);
    search(high, depth + 1);
  }

 private:
  // Where h = 0, g is g - λ h for any λ; where h < 0, it is no more than that for λ >= 0. With the
  // λ for which the gradients cancel, the bound's error is quadratic in the rectangle's size.
  static double multiplier(const Rectangle& r) {
    const Eigen::Vector2d along_g = mean_slope(r.g), along_h = mean_slope(r.h);
    const double square = along_h.squaredNorm();
    return square > 0.0 ? along_g.dot(along_h) / square : 0.0;
  }

  double bound(const Rectangle& r) const {
    const double lambda = multiplier(r);
    const double plain = highest(r.g);
    if (part_ == Part::kImmersed && lambda <= 0.0) return plain;
    double top = r.g[0] - lambda * r.h[0];
    for (int k = 1; k < 16; ++k) top = std::max(top, r.g[k] - lambda * r.h[k]);
    return std::min(top, plain);
  }

  // Along the direction in which what the bound is made of varies more.
  static bool halves_u(const Rectangle& r) {
    const double lambda = multiplier(r);
    double along_u = 0.0, along_v = 0.0;
    const auto value = [&](int k) { return r.g[k] - lambda * r.h[k]; };
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 3; ++i) {
        along_u = std::max(along_u, std::abs(value(4 * j + i + 1) - value(4 * j + i)));
        along_v = std::max(along_v, std::abs(value(4 * i + 4 + j) - value(4 * i + j)));
      }
    }
    if (along_u == along_v) return r.width_u >= r.width_v;
    return along_u > along_v;
  }

  void take(const Rectangle& r, double value, double u, double v) {
    if (value < best_.value - tolerance_) return;
    const double s = r.u + r.width_u * u, t = r.v + r.width_v * v;
    const Vector3d point = evaluate_bicubic(piece_.points, s, t, 0).point;
    const bool is_tie = best_.found && value <= best_.value + tolerance_;
    if (is_tie && std::abs(point.y()) >= std::abs(best_.point.y())) {
      best_.value = std::max(best_.value, value);
      return;
    }
    best_.found = true;
    best_.value = std::max(best_.value, value);
    best_.point = point;
    best_.cell = piece_.cell;
    best_.uv = Eigen::Vector2d(piece_.u + piece_.size * s, piece_.v + piece_.size * t)
                   .cwiseMax(0.0)
                   .cwiseMin(1.0);
  }

  // The corners, and where the water crosses the sides.
  void take_candidates(const Rectangle& r) {
    if (part_ == Part::kImmersed) {
      for (int k : {0, 3, 12, 15}) {
        if (r.h[k] < 0.0) take(r, r.g[k], k & 3 ? 1.0 : 0.0, k & 12 ? 1.0 : 0.0);
      }
    }
    take_side(r, 0, 1, [](double t) { return Eigen::Vector2d(t, 0.0); });
    take_side(r, 12, 1, [](double t) { return Eigen::Vector2d(t, 1.0); });
    take_side(r, 0, 4, [](double t) { return Eigen::Vector2d(0.0, t); });
    take_side(r, 3, 4, [](double t) { return Eigen::Vector2d(1.0, t); });
  }

  template <class Place>
  void take_side(const Rectangle& r, int first, int stride, const Place& place) {
    const double from = r.h[first], to = r.h[first + 3 * stride];
    if ((from >= 0.0) == (to >= 0.0)) return;
    const BezierCubic h{from, r.h[first + stride], r.h[first + 2 * stride], to};
    const BezierCubic g{r.g[first], r.g[first + stride], r.g[first + 2 * stride],
                        r.g[first + 3 * stride]};
    if (*std::max_element(g.begin(), g.end()) < best_.value - tolerance_) return;
    for (double t : sign_changes(h)) {
      const Eigen::Vector2d at = place(t);
      take(r, evaluate(g, t), at.x(), at.y());
    }
  }

  const SurfacePiece& piece_;
  Part part_;
  double tolerance_;
  FarthestPoint& best_;
};

}  // namespace

ExtentSearch::ExtentSearch(const LimitSurface& surface, const CellBoxes& boxes, const Plane& water)
    : surface_(&surface), boxes_(&boxes), water_(water), size_(surface.mesh().size()) {}

bool ExtentSearch::may_have(int cell, Part part) const {
  return has_part(boxes_->least(cell, water_.normal) - water_.offset,
                  boxes_->most(cell, water_.normal) - water_.offset, part);
}

FarthestPoint ExtentSearch::farthest(const Vector3d& direction, Part part) const {
  const double tolerance = kTolerance * size_;
  FarthestPoint best;
  const auto search_cell = [&](int c) {
    const auto descend = [&](const CornerSquare& square) {
      if (square.extent() < kSmallestCorner * size_) return false;
      double low = std::numeric_limits<double>::infinity(), high = -low, top = -low;
      for (const Vector3d& p : square.points()) {
        low = std::min(low, water_.height(p));
        high = std::max(high, water_.height(p));
        top = std::max(top, direction.dot(p));
      }
      return has_part(low, high, part) && top > best.value + tolerance;
    };
    for_each_piece(*surface_, c, descend, [&](const SurfacePiece& piece) {
      Rectangle whole{bezier_net(piece.points, direction, 0.0),
                      bezier_net(piece.points, water_.normal, water_.offset),
                      0.0,
                      0.0,
                      1.0,
                      1.0};
      flush_to_zero(whole.h, kZeroHeight * size_);
      PieceSearch(piece, part, tolerance, best).search(whole, 0);
    });
  };
  // A cell that may hold the farthest point first, so that the others are soon excluded.
  int first = -1;
  double most = -std::numeric_limits<double>::infinity();
  for (int c = 0; c < surface_->cell_count(); ++c) {
    if (!may_have(c, part)) continue;
    const double bound = boxes_->most(c, direction);
    if (bound > most) {
      most = bound;
      first = c;
    }
  }
  if (first < 0) return best;
  search_cell(first);
  for (int c = 0; c < surface_->cell_count(); ++c) {
    if (c == first || !may_have(c, part)) continue;
    if (boxes_->most(c, direction) >= best.value - tolerance) search_cell(c);
  }
  return best;
}

const FarthestPoint& farther(const FarthestPoint& a, const FarthestPoint& b) {
  return b.value > a.value ? b : a;
}

}  // namespace hull
