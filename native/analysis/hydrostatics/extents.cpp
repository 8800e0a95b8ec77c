// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hydrostatics/extents.h"

#include <cmath>

#include "analysis/sections/arc_square.h"
#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

constexpr double kTolerance = 1e-10;      // of the size
constexpr double kSmallestPiece = 1e-11;  // of the size: an extent is off by no more
constexpr int kDeepest = 100;             // halvings
constexpr int kSamples = 8;               // of the slope along a stretch of the waterline

using Part = ExtentSearch::Part;

// A rectangle of a piece: the coordinate looked for and the height above the water.
struct Rectangle {
  BezierNet g, h;
  double u, v, width_u, width_v;
};

// Zero is above: what lies in the water's surface is not immersed, and has no waterline.
bool has_part(double lowest_height, double highest_height, Part part) {
  return lowest_height < 0.0 && (part == Part::kImmersed || highest_height >= 0.0);
}

bool excludes_zero(const SlopeRange& range) { return range.low > 0.0 || range.high < 0.0; }

// Bounds the coordinate g on the water's surface: where h = 0, it is g - λ h for any λ. With the λ
// for which the mean gradients cancel, the bound's error is quadratic in the square's size.
// The same with λ >= 0 bounds g where h <= 0.
double waterline_bound(const BezierNet& g, const BezierNet& h, bool below_too = false) {
  double product = 0.0, square = 0.0, g_u = 0.0, g_v = 0.0, h_u = 0.0, h_v = 0.0;
  for (int k = 0; k < 4; ++k) {
    g_u += g[4 * k + 3] - g[4 * k];
    g_v += g[12 + k] - g[k];
    h_u += h[4 * k + 3] - h[4 * k];
    h_v += h[12 + k] - h[k];
  }
  product = g_u * h_u + g_v * h_v;
  square = h_u * h_u + h_v * h_v;
  // Least squares: what the gradient of g has along that of h.
  const double lambda = square > 0.0 ? product / square : 0.0;
  if (below_too && lambda <= 0.0) return highest(g);
  double top = g[0] - lambda * h[0];
  for (int k = 1; k < 16; ++k) top = std::max(top, g[k] - lambda * h[k]);
  // Either bound holds; far from the water's surface that of g alone may be the lower one.
  return std::min(top, highest(g));
}

// Calls visit(t) where the cubic's derivative is zero within (0, 1).
template <class Visit>
void for_each_critical(const BezierCubic& c, const Visit& visit) {
  const double a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2];
  const double p = a - 2.0 * b + d, q = b - a;  // p t² + 2 q t + a
  const double root = q * q - p * a;
  if (root < 0.0) return;
  const double s = -(q + std::copysign(std::sqrt(root), q));
  // Both roots without a difference of nearly equal numbers, and the one where the cubic term is
  // zero.
  for (double t : {p != 0.0 ? s / p : -1.0, s != 0.0 ? a / s : -1.0}) {
    if (t > 0.0 && t < 1.0) visit(t);
  }
}

class PieceSearch {
 public:
  PieceSearch(const surface::SurfacePiece& piece, const Vector3d& direction, const Plane& water,
              double size, FarthestPoint& best)
      : piece_(piece),
        direction_(direction),
        tolerance_(kTolerance * size),
        best_(best),
        whole_{bezier_net(piece.points, direction, 0.0),
               bezier_net(piece.points, water.normal, water.offset),
               0.0,
               0.0,
               1.0,
               1.0} {
    flush_to_zero(whole_.h, kZeroHeight * size);
  }

  void search(Part part) {
    // Here and below ties are looked at: of places equally far the one nearest the centre plane
    // counts.
    if (highest(whole_.g) < best_.value - tolerance_) return;
    if (!has_part(lowest(whole_.h), highest(whole_.h), part)) return;
    // The waterline bounds the immersed part: its extremes are there, on sides, or within, where
    // both slopes vanish.
    if (highest(whole_.h) >= 0.0) search_waterline();
    if (part == Part::kImmersed) {
      for (const auto& side : kSides) search_side(side);
      search_inside(whole_, 0);
    }
  }

 private:
  static constexpr int kSides[4][4] = {
      {0, 1, 2, 3}, {0, 4, 8, 12}, {3, 7, 11, 15}, {12, 13, 14, 15}};

  void take(double u, double v) {
    const Vector3d point = surface::evaluate_bicubic(piece_.points, u, v, 0).point;
    const double value = direction_.dot(point);
    if (value < best_.value - tolerance_) return;
    const bool is_tie = best_.found && value <= best_.value + tolerance_;
    // A tie may be lower by the tolerance: the value kept must not creep down with such.
    best_.value = std::max(best_.value, value);
    if (is_tie && std::abs(point.y()) >= std::abs(best_.point.y())) return;
    best_.found = true;
    best_.point = point;
    best_.cell = piece_.cell;
    best_.uv = Eigen::Vector2d(piece_.u + piece_.size * u, piece_.v + piece_.size * v)
                   .cwiseMax(0.0)
                   .cwiseMin(1.0);
  }

  void search_waterline() {
    if (waterline_bound(whole_.g, whole_.h) < best_.value - tolerance_) return;
    cut_piece(BezierBicubic(whole_.h), [&](const CutSquare& cut) {
      if (cut.side != CutSquare::Side::kCut) return;
      const BezierNet g = restricted(whole_.g, cut.u, cut.v, cut.size);
      const BezierNet h = restricted(whole_.h, cut.u, cut.v, cut.size);
      // The square's own bound is far closer, and spares the search along its waterline.
      if (waterline_bound(g, h) < best_.value - tolerance_) return;
      ArcSquare square{h, g, g, 1.0};
      if (cut.swapped) square.h = transposed(h), square.a = square.b = transposed(g);
      const auto take_at = [&](double u) {
        const double v = arc_point(square, u).v;
        take(cut.u + cut.size * (cut.swapped ? v : u), cut.v + cut.size * (cut.swapped ? u : v));
      };
      // Then an end of the stretch is the farthest.
      const bool monotonic = is_monotonic(square);
      for_each_stretch(square, [&](double begin, double end) {
        take_at(begin);
        take_at(end);
        if (!monotonic) search_stretch(square, begin, end, take_at);
      });
    });
  }

  // Where g, on the way along the water, stops to rise.
  template <class Take>
  void search_stretch(const ArcSquare& square, double begin, double end, const Take& take_at) {
    double before = arc_point(square, begin).db;
    for (int k = 1; k <= kSamples; ++k) {
      const double u = begin + (end - begin) * k / kSamples;
      const double slope = arc_point(square, u).db;
      if (before > 0.0 && slope <= 0.0) {
        double low = begin + (end - begin) * (k - 1) / kSamples, high = u;
        double f_low = before, f_high = slope;
        for (int i = 0; i < 60 && high - low > 1e-9; ++i) {
          // Secants, and a bisection every third time, so that both ends close in.
          double t =
              i % 3 == 2 ? 0.5 * (low + high) : low + (high - low) * f_low / (f_low - f_high);
          if (!(t > low && t < high)) t = 0.5 * (low + high);
          const double f = arc_point(square, t).db;
          (f > 0.0 ? low : high) = t;
          (f > 0.0 ? f_low : f_high) = f;
          if (f == 0.0) break;
        }
        take_at(std::abs(f_low) < std::abs(f_high) ? low : high);
      }
      before = slope;
    }
  }

  // Ends of the piece's sides and extremes along them, which may be creases or borders.
  void search_side(const int (&side)[4]) {
    BezierCubic g, h;
    for (int i = 0; i < 4; ++i) {
      g[i] = whole_.g[side[i]];
      h[i] = whole_.h[side[i]];
    }
    if (*std::max_element(g.begin(), g.end()) < best_.value - tolerance_) return;
    const int step = side[1] - side[0];
    const auto try_at = [&](double t) {
      if (evaluate(h, t) >= 0.0) return;
      if (step == 1) {
        take(t, side[0] == 0 ? 0.0 : 1.0);
      } else {
        take(side[0] == 0 ? 0.0 : 1.0, t);
      }
    };
    try_at(0.0);
    try_at(1.0);
    for_each_critical(g, try_at);
  }

  // Immersed places where g is stationary.
  void search_inside(const Rectangle& r, int depth) {
    // Here a tie is of no use: flat faces would be halved to the bottom.
    if (lowest(r.h) >= 0.0 || highest(r.g) <= best_.value + tolerance_) return;
    if (waterline_bound(r.g, r.h, true) <= best_.value + tolerance_) return;
    // An extreme where one slope does not vanish is on a side or on the waterline, and was looked
    // for.
    if (excludes_zero(slope_range_u(r.g)) || excludes_zero(slope_range_v(r.g))) return;
    if (r.h[0] < 0.0) take(r.u, r.v);
    if (depth == kDeepest) return;
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
    search_inside(low, depth + 1);
    search_inside(high, depth + 1);
  }

  // Along the direction in which g varies more.
  static bool halves_u(const Rectangle& r) {
    const SlopeRange u = slope_range_u(r.g), v = slope_range_v(r.g);
    const double along_u = std::max(u.high, -u.low), along_v = std::max(v.high, -v.low);
    return along_u == along_v ? r.width_u >= r.width_v : along_u > along_v;
  }

  const surface::SurfacePiece& piece_;
  const Vector3d& direction_;
  double tolerance_;
  FarthestPoint& best_;
  Rectangle whole_;
};

}  // namespace

ExtentSearch::ExtentSearch(const surface::LimitSurface& surface, const CellBoxes& boxes,
                           const Plane& water)
    : surface_(&surface), boxes_(&boxes), water_(water), size_(surface.mesh().size()) {
  for (int c = 0; c < surface.cell_count(); ++c) {
    const double low = boxes.least(c, water.normal) - water.offset;
    const double high = boxes.most(c, water.normal) - water.offset;
    if (has_part(low, high, Part::kImmersed)) immersed_.push_back(c);
    if (has_part(low, high, Part::kWaterline)) waterline_.push_back(c);
  }
}

FarthestPoint ExtentSearch::farthest(const Vector3d& direction, Part part) const {
  const double tolerance = kTolerance * size_;
  FarthestPoint best;
  const auto search_cell = [&](int c) {
    const auto descend = [&](const surface::CornerSquare& square) {
      if (square.extent() < kSmallestPiece * size_) return false;
      double low = std::numeric_limits<double>::infinity(), high = -low, top = -low;
      for (const Vector3d& p : square.points()) {
        low = std::min(low, water_.height(p));
        high = std::max(high, water_.height(p));
        top = std::max(top, direction.dot(p));
      }
      return has_part(low, high, part) && top > best.value + tolerance;
    };
    surface::for_each_piece(*surface_, c, descend, [&](const surface::SurfacePiece& piece) {
      PieceSearch(piece, direction, water_, size_, best).search(part);
    });
  };
  // A cell that may hold the farthest point first, so that the others are soon excluded.
  int first = -1;
  double most = -std::numeric_limits<double>::infinity();
  for (int c : cells(part)) {
    const double bound = boxes_->most(c, direction);
    if (bound > most) {
      most = bound;
      first = c;
    }
  }
  if (first < 0) return best;
  search_cell(first);
  for (int c : cells(part)) {
    if (c != first && boxes_->most(c, direction) >= best.value - tolerance) search_cell(c);
  }
  return best;
}

}  // namespace hull::analysis
