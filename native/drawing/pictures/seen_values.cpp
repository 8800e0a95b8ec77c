// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/pictures/seen_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hull::drawing {

using Eigen::Vector3d;

namespace {

// Shares below zero by rounding, at sides that two triangles have in common, count.
constexpr double kSide = -1e-9;

struct Range {
  int first, last;
};

// Of dots whose middles lie between.
Range dots_between(double low, double high, int count) {
  return {static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, double(count))),
          static_cast<int>(std::clamp(std::floor(high - 0.5), -1.0, count - 1.0))};
}

// Twice the area that is seen, with a sign: positive where the triangle turns clockwise on the
// page, whose y is down.
double across(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

struct Nearest {
  float depth = -std::numeric_limits<float>::infinity();
  int triangle = -1;
};

class Painter {
 public:
  Painter(const ValuedTriangles& given, int width, int height)
      : given_(given),
        width_(width),
        height_(height),
        nearest_(static_cast<std::size_t>(width) * height) {}

  void paint(int number) {
    const auto& [i, j, k] = given_.triangles[number];
    const Vector3d &a = given_.points[i], &b = given_.points[j], &c = given_.points[k];
    const double area = across(a, b, c);
    // Seen edge on it covers no dot.
    if (area == 0.0) return;
    const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
    const auto [top, bottom] = std::minmax({a.y(), b.y(), c.y()});
    const Range columns = dots_between(left, right, width_);
    const Range rows = dots_between(top, bottom, height_);
    const Vector3d depths(a.z(), b.z(), c.z());
    for (int row = rows.first; row <= rows.last; ++row) {
      for (int column = columns.first; column <= columns.last; ++column) {
        // Barycentric coordinates. Divided by the signed area they are positive inside whichever
        // way the triangle is turned.
        const Vector3d shares = shares_at({column + 0.5, row + 0.5, 0.0}, a, b, c) / area;
        if (shares.minCoeff() < kSide) continue;
        Nearest& there = nearest_[static_cast<std::size_t>(row) * width_ + column];
        const auto depth = static_cast<float>(shares.dot(depths));
        // Of those equally near the first in order stays.
        if (depth > there.depth) there = {depth, number};
      }
    }
  }

  SeenValues finish() const {
    SeenValues seen;
    // Values are made only now, once a dot, and not for all that was painted over.
    for (int dot = 0; dot < static_cast<int>(nearest_.size()); ++dot) {
      if (nearest_[dot].triangle < 0) continue;
      seen.dots.push_back(dot);
      add_values(given_.triangles[nearest_[dot].triangle],
                 {dot % width_ + 0.5, dot / width_ + 0.5, 0.0}, seen.values);
    }
    return seen;
  }

 private:
  static Vector3d shares_at(const Vector3d& dot, const Vector3d& a, const Vector3d& b,
                            const Vector3d& c) {
    return {across(dot, b, c), across(a, dot, c), across(a, b, dot)};
  }

  void add_values(const std::array<int, 3>& corners, const Vector3d& dot,
                  std::vector<float>& values) const {
    const auto& [i, j, k] = corners;
    const Vector3d &a = given_.points[i], &b = given_.points[j], &c = given_.points[k];
    const Vector3d shares = shares_at(dot, a, b, c) / across(a, b, c);
    const auto count = static_cast<std::size_t>(given_.count);
    for (std::size_t n = 0; n < count; ++n) {
      values.push_back(static_cast<float>(shares.x() * given_.values[i * count + n] +
                                          shares.y() * given_.values[j * count + n] +
                                          shares.z() * given_.values[k * count + n]));
    }
  }

  const ValuedTriangles& given_;
  int width_, height_;
  std::vector<Nearest> nearest_;
};

}  // namespace

SeenValues seen_values(const ValuedTriangles& given, int width, int height) {
  Painter painter(given, width, height);
  for (int t = 0; t < static_cast<int>(given.triangles.size()); ++t) painter.paint(t);
  return painter.finish();
}

}  // namespace hull::drawing
