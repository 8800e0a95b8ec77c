// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/ruled_warp.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace hull::production {
namespace {

constexpr int kMostParts = 4000;
constexpr double kNoWarp = 1e-10;    // rad, of a whole ruling: rounding
constexpr double kRounding = 1e-14;  // of a determinant, of the product of its columns

// What the warp of the rulings of a part [begin, begin + size] follows from.
struct Part {
  double begin, size;
  Bernstein twist, first, second, both, length;  // det, |n1|², |n2|², n1·n2, |q|²
  double slack;                                  // rounding of det
  double bound;
};

double magnitude(const Bernstein& p) { return std::max(std::abs(least(p)), std::abs(most(p))); }

// θ = asin(s), s = |det| |q| / (|n1| |n2|), where the normals are less than 90° apart; θ / |q| is
// |det| / (|n1| |n2|) times θ / s, which grows with s.
double bound_of(const Part& part) {
  const double shortest = least(part.length);
  const double product = least(part.first) * least(part.second);
  // An angle is no more than pi.
  const double anything = shortest > 0.0 ? std::numbers::pi / std::sqrt(shortest)
                                         : std::numeric_limits<double>::infinity();
  if (!(least(part.first) > 0.0 && least(part.second) > 0.0 && least(part.both) > 0.0)) {
    return anything;
  }
  const double rate = (magnitude(part.twist) + part.slack) / std::sqrt(product);
  const double sine = rate * std::sqrt(most(part.length));
  if (!(sine < 1.0)) return anything;
  const double stretch = sine > 0.0 ? std::asin(sine) / sine : 1.0;
  return std::min(anything, rate * stretch * (1.0 + 1e-9));
}

Part whole(const BezierSpan& a, const BezierSpan& b) {
  BezierSpan between;
  for (int i = 0; i < 4; ++i) between[i] = b[i] - a[i];
  const BernsteinVector da = derivative_of(a), db = derivative_of(b), q = polynomial_of(between);
  const BernsteinVector first = cross(da, q), second = cross(db, q);
  Part part{0.0,
            1.0,
            dot(cross(da, db), q),  // of degree 2 + 2 + 3
            dot(first, first),      // of degree 2 (2 + 3), as the two below
            dot(second, second),
            dot(first, second),
            dot(q, q),  // of degree 6
            0.0,
            0.0};
  part.slack = kRounding;
  for (const BernsteinVector* column : {&da, &db, &q}) {
    // The product of the columns' sums of moduli has all terms of the determinant in it.
    part.slack *= magnitude((*column)[0]) + magnitude((*column)[1]) + magnitude((*column)[2]);
  }
  part.bound = bound_of(part);
  return part;
}

std::array<Part, 2> halved(const Part& part) {
  std::array<Part, 2> result;
  const auto twist = halves(part.twist), first = halves(part.first), second = halves(part.second);
  const auto both = halves(part.both), length = halves(part.length);
  for (int i = 0; i < 2; ++i) {
    result[i] = {part.begin + 0.5 * i * part.size,
                 0.5 * part.size,
                 twist[i],
                 first[i],
                 second[i],
                 both[i],
                 length[i],
                 part.slack,
                 0.0};
    // A part has no more warp than the whole, whatever rounding makes of its coefficients.
    result[i].bound = std::min(part.bound, bound_of(result[i]));
  }
  return result;
}

}  // namespace

double warp_at(const BezierSpan& a, const BezierSpan& b, double t) {
  const surface::CurveJet one = BezierChain({a}).at(t), other = BezierChain({b}).at(t);
  const Vector3d q = other.point - one.point;
  const double length = q.norm();
  if (length == 0.0) return std::numeric_limits<double>::infinity();
  const double twist = std::abs(one.d1.cross(other.d1).dot(q));
  // |n1 x n2| = |q| |det|; against n1 · n2 this is right beyond 90°, too.
  const double along = one.d1.cross(q).dot(other.d1.cross(q));
  return std::atan2(twist * length, along) / length;
}

LargestWarp largest_warp(const BezierSpan& a, const BezierSpan& b, double tolerance) {
  LargestWarp result{0.0, 0.0, 0.0};
  const auto meet = [&](double t) {
    const double warp = warp_at(a, b, t);
    if (warp > result.found) {
      result.found = warp;
      result.at = t;
    }
  };
  const auto smaller = [](const Part& one, const Part& other) { return one.bound < other.bound; };
  std::priority_queue<Part, std::vector<Part>, decltype(smaller)> parts(smaller);
  parts.push(whole(a, b));
  // What was found rises with every sample, the queue's top falls: the largest warp is between
  // them.
  for (double t : {0.0, 0.5, 1.0}) meet(t);
  for (int count = 1; count < kMostParts; ++count) {
    const Part worst = parts.top();
    const double longest = std::sqrt(std::max(most(worst.length), 0.0));
    // Halving the part of the largest bound is all that can lower the bound of the whole.
    if (worst.bound <= (1.0 + tolerance) * result.found || worst.bound * longest <= kNoWarp) break;
    parts.pop();
    for (Part& part : halved(worst)) {
      meet(part.begin + 0.5 * part.size);
      parts.push(std::move(part));
    }
  }
  // Rounding of the warp itself, too.
  result.bound = std::max(parts.top().bound, result.found * (1.0 + 1e-12));
  return result;
}

}  // namespace hull::production
