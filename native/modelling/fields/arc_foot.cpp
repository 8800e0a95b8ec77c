// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/arc_foot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hull::modelling {
namespace {

using Arc = std::array<Vector3d, 4>;
// Bézier coefficients of the squared distance from a point: of degree six.
using Sextic = std::array<double, 7>;

// Parts smaller than this part of an arc are no longer told apart.
constexpr double kLeastPart = 1e-10;
constexpr int kNewtonSteps = 60;

Sextic squared_distance(const Arc& arc, const Vector3d& p) {
  constexpr std::array<double, 4> kCubic{1.0, 3.0, 3.0, 1.0};
  constexpr std::array<double, 7> kSextic{1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0};
  std::array<Vector3d, 4> from;
  for (int i = 0; i < 4; ++i) from[i] = arc[i] - p;
  Sextic squares{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      // A product of Bernstein polynomials is one of degree six, by the binomials of all three.
      squares[i + j] += kCubic[i] * kCubic[j] / kSextic[i + j] * from[i].dot(from[j]);
    }
  }
  return squares;
}

// De Casteljau's halves.
std::array<Sextic, 2> halves(Sextic c) {
  Sextic low{}, high{};
  for (int n = 6; n >= 0; --n) {
    low[6 - n] = c[0];
    high[n] = c[n];
    for (int i = 0; i < n; ++i) c[i] = 0.5 * (c[i] + c[i + 1]);
  }
  return {low, high};
}

bool is_convex(const Sextic& c) {
  for (int i = 0; i + 2 < 7; ++i) {
    // The second differences are the Bézier coefficients of the second derivative, up to a factor.
    if (c[i] - 2.0 * c[i + 1] + c[i + 2] < 0.0) return false;
  }
  return true;
}

class Search {
 public:
  Search(const Arc& arc, const Vector3d& p, double most) : arc_(arc), p_(p), best_{0.0, most} {}

  ArcFoot run() {
    // Ends first: the nearer the best is known to be, the more is left out.
    try_at(0.0);
    try_at(1.0);
    look(squared_distance(arc_, p_), 0.0, 1.0);
    return best_;
  }

 private:
  void look(const Sextic& squares, double begin, double end) {
    // Rounding of the coefficients must not leave out the least.
    const double largest = std::abs(*std::ranges::max_element(squares));
    const double least = *std::ranges::min_element(squares) - 1e-15 * largest;
    if (least > 0.0 && least >= best_.distance * best_.distance) return;
    if (is_convex(squares)) {
      descend(begin, end);
      return;
    }
    const double middle = 0.5 * (begin + end);
    try_at(middle);
    if (end - begin < kLeastPart) return;
    const auto [low, high] = halves(squares);
    look(low, begin, middle);
    look(high, middle, end);
  }

  // Half the derivative of the squared distance.
  double slope(double t) const {
    const surface::CurveJet jet = arc_jet(arc_, t);
    return (jet.point - p_).dot(jet.d1);
  }

  // The one minimum of a convex stretch, by Newton's method in a bracket.
  void descend(double begin, double end) {
    // Where its slope keeps its sign a convex function has its least at an end.
    if (slope(begin) >= 0.0) return try_at(begin);
    if (slope(end) <= 0.0) return try_at(end);
    double low = begin, high = end, t = 0.5 * (begin + end);
    for (int step = 0; step < kNewtonSteps; ++step) {
      const surface::CurveJet jet = arc_jet(arc_, t);
      const double fall = (jet.point - p_).dot(jet.d1);
      (fall > 0.0 ? high : low) = t;
      const double rise = jet.d1.squaredNorm() + (jet.point - p_).dot(jet.d2);
      double next = rise > 0.0 ? t - fall / rise : 0.5 * (low + high);
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      const bool settled = std::abs(next - t) <= 1e-16 * std::max(1e-3, std::abs(t));
      t = next;
      if (settled) break;
    }
    try_at(t);
  }

  void try_at(double t) {
    const double distance = (arc_jet(arc_, t).point - p_).norm();
    if (distance < best_.distance) best_ = {t, distance};
  }

  const Arc& arc_;
  const Vector3d& p_;
  ArcFoot best_;
};

}  // namespace

surface::CurveJet arc_jet(const Arc& arc, double t) {
  const double s = 1.0 - t;
  surface::CurveJet jet;
  // De Casteljau: the points of the last round but one give the first derivative, those before the
  // second.
  const Vector3d a = s * arc[0] + t * arc[1], b = s * arc[1] + t * arc[2],
                 c = s * arc[2] + t * arc[3];
  const Vector3d ab = s * a + t * b, bc = s * b + t * c;
  jet.point = s * ab + t * bc;
  jet.d1 = 3.0 * (bc - ab);
  jet.d2 = 6.0 * (c - 2.0 * b + a);
  return jet;
}

double least_distance(const Arc& arc, const Vector3d& p) {
  Vector3d low = arc[0], high = arc[0];
  for (const Vector3d& point : arc) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).norm();
}

ArcFoot arc_foot(const Arc& arc, const Vector3d& p, double most) {
  return Search(arc, p, most).run();
}

}  // namespace hull::modelling
