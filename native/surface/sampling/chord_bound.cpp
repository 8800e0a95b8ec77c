// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/chord_bound.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hull::surface {
namespace {

// Directions that turn by more than asin of this are not told apart from any.
constexpr double kMostTurning = 0.5;
// Diagonals that are nearer to parallel than this have no plane.
constexpr double kParallel = 1e-9;

// Weights of four uniform B-spline points in the blossom's value at (x, y, z): de Boor's algorithm
// for the span [0, 1], with another argument in each round.
Basis blossom_weights(double x, double y, double z) {
  Basis weights{};
  for (int k = 0; k < 4; ++k) {
    double c[4] = {};
    c[k] = 1.0;
    const double arguments[] = {x, y, z};
    for (int round = 1; round <= 3; ++round) {
      for (int i = 3; i >= round; --i) {
        // From knot i - 3 to i - round + 1.
        const double s = (arguments[round - 1] - (i - 3)) / (4 - round);
        c[i] = (1.0 - s) * c[i - 1] + s * c[i];
      }
    }
    weights[k] = c[3];
  }
  return weights;
}

// Bezier points over [a, b] are values of the blossom (Ramshaw 1989).
std::array<Basis, 4> bezier_weights(double a, double b) {
  return {blossom_weights(a, a, a), blossom_weights(a, a, b), blossom_weights(a, b, b),
          blossom_weights(b, b, b)};
}

// Largest and mean vectors of a derivative's control points.
struct Net {
  // First derivatives have the most, 3 x 4.
  std::array<Vector3d, 12> at;
  int count = 0;

  void add(const Vector3d& v) { at[count++] = v; }
  Vector3d mean() const {
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < count; ++i) sum += at[i];
    return sum / count;
  }
  template <class Measure>
  double largest(const Measure& measure) const {
    double most = 0.0;
    for (int i = 0; i < count; ++i) most = std::max(most, measure(at[i]));
    return most;
  }
  double longest() const {
    return largest([](const Vector3d& v) { return v.norm(); });
  }
};

// First derivatives, as steps along one part's side, and how far their direction turns.
struct Direction {
  Vector3d mean;
  double length, turning;

  explicit Direction(const Net& net) : mean(net.mean()), length(mean.norm()) {
    turning = length > 0.0
                  ? net.largest([this](const Vector3d& v) { return (v - mean).norm(); }) / length
                  : 1.0;
  }
  // Bound on the part of v across any chord in this direction.
  double across(const Vector3d& v) const {
    // Turning the direction by asin(turning) takes that share of the part along it across at most.
    const double along = v.dot(mean) / length;
    return std::sqrt(std::max(0.0, v.squaredNorm() - along * along)) + std::abs(along) * turning;
  }
};

template <class Point>
double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double square = along.squaredNorm();
  const double s = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - s * along).norm();
}

}  // namespace

BicubicPoints bezier_points(const BicubicPoints& span, double u0, double u1, double v0, double v1) {
  const std::array<Basis, 4> wu = bezier_weights(u0, u1), wv = bezier_weights(v0, v1);
  BicubicPoints rows, result;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      rows[4 * j + i] = wu[i][0] * span[4 * j] + wu[i][1] * span[4 * j + 1] +
                        wu[i][2] * span[4 * j + 2] + wu[i][3] * span[4 * j + 3];
    }
  }
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      result[4 * j + i] = wv[j][0] * rows[i] + wv[j][1] * rows[4 + i] + wv[j][2] * rows[8 + i] +
                          wv[j][3] * rows[12 + i];
    }
  }
  return result;
}

double smooth_bound(const BicubicPoints& bezier, int nu, int nv) {
  // Derivatives are taken by the parameters of a part, so that its sides have the length 1.
  const double h = 1.0 / nu, k = 1.0 / nv;
  Net u, v, uu, vv, uv;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const Vector3d* p = &bezier[4 * j + i];
      if (i < 3) u.add(3.0 * h * (p[1] - p[0]));
      if (j < 3) v.add(3.0 * k * (p[4] - p[0]));
      if (i < 2) uu.add(6.0 * h * h * (p[2] - 2.0 * p[1] + p[0]));
      if (j < 2) vv.add(6.0 * k * k * (p[8] - 2.0 * p[4] + p[0]));
      if (i < 3 && j < 3) uv.add(9.0 * h * k * (p[5] - p[4] - p[1] + p[0]));
    }
  }
  // Nothing slides: this holds whatever the directions.
  const double all = (uu.longest() + vv.longest()) / 8.0 + uv.longest() / 4.0;
  const Direction a(u), b(v);
  if (!(a.turning < kMostTurning && b.turning < kMostTurning)) return all;
  const Vector3d normal = a.mean.cross(b.mean);
  const double area = normal.norm();
  // How far a normal can turn within the patch.
  const double turning =
      a.length * b.length * (a.turning + b.turning + a.turning * b.turning) / area;
  // Not a number where u and v run the same way in the mean.
  if (!(turning < kMostTurning)) return all;
  const double sag = uu.largest([&](const Vector3d& d) { return a.across(d); }) +
                     vv.largest([&](const Vector3d& d) { return b.across(d); });
  const double bend = uv.largest(
      [&](const Vector3d& d) { return std::abs(d.dot(normal)) / area + d.norm() * turning; });
  // The ends of a chord across slide by different amounts along sides that differ by the twist.
  const double slide = vv.longest() * uv.longest() / (16.0 * b.length * (1.0 - b.turning));
  return std::min(all, sag / 8.0 + bend / 4.0 + slide);
}

QuadGauge::QuadGauge(const std::array<Vector3d, 4>& corners) : corners_(corners) {
  // A plane along both diagonals and halfway between them, from which all corners are equally far.
  const Vector3d d1 = corners[2] - corners[0], d2 = corners[3] - corners[1];
  normal_ = d1.cross(d2);
  const double length = normal_.norm();
  if (!(length > kParallel * d1.norm() * d2.norm())) return;
  normal_ /= length;
  e1_ = d1.normalized();
  e2_ = normal_.cross(e1_);
  centre_ = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  std::array<Vector2d, 4> q;
  for (int i = 0; i < 4; ++i) {
    const Vector3d d = corners[i] - centre_;
    q[i] = {d.dot(e1_), d.dot(e2_)};
    half_height_ = std::max(half_height_, std::abs(d.dot(normal_)));
  }
  int dents = 0, dented = 0;
  for (int i = 0; i < 4; ++i) {
    const Vector2d &before = q[(i + 3) % 4], &after = q[(i + 1) % 4];
    if (cross(q[i] - before, after - q[i]) >= 0.0) continue;
    ++dents;
    dented = i;
    dent_ = distance_to_segment(q[i], before, after);
  }
  // An outline that crosses itself.
  if (dents > 1) return;
  for (int i = 0; i < 4; ++i) {
    // Without the dented corner it is convex, and so is the distance from it. It is too large then
    // by the dent, which bound() adds.
    if (dents == 0 || i != dented) outline_.push_back(q[i]);
  }
  flat_enough_ = true;
}

double QuadGauge::distance_in_plane(const Vector2d& q) const {
  bool inside = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const Vector2d &a = outline_[i], &b = outline_[(i + 1) % outline_.size()];
    inside = inside && cross(b - a, q - a) >= 0.0;
    nearest = std::min(nearest, distance_to_segment(q, a, b));
  }
  return inside ? 0.0 : nearest;
}

double QuadGauge::bound(const Vector3d& p) const {
  if (!flat_enough_) {
    // Either way of cutting has one of the diagonals.
    return std::max(distance_to_segment(p, corners_[0], corners_[2]),
                    distance_to_segment(p, corners_[1], corners_[3]));
  }
  const Vector3d d = p - centre_;
  return std::hypot(distance_in_plane({d.dot(e1_), d.dot(e2_)}) + dent_,
                    std::abs(d.dot(normal_)) + half_height_);
}

}  // namespace hull::surface
