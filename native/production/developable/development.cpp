// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "production/developable/developable_strip.h"

namespace hull::production {
namespace {

Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

double angle_of(const Vector2d& v) { return std::atan2(v.y(), v.x()); }

// The turn of the first curve in its tangent planes, per parameter: κ_g |a'| (do Carmo 1976, 4-4).
double turn(const surface::CurveJet& a, const Vector3d& q) {
  return a.d1.cross(q).normalized().dot(a.d1.cross(a.d2)) / a.d1.squaredNorm();
}

// From the first curve to the ruling.
double slant(const surface::CurveJet& a, const Vector3d& q) {
  return std::atan2(a.d1.cross(q).norm(), a.d1.dot(q));
}

// Of a part of a curve's span seen from a point: the angle of the cone of straight lines,
// ∫ |r x r'| / r².
double angle_of_part(const BezierChain& curve, double from, double to, const Vector3d& tip) {
  // Gauss and Legendre's rule on [0, 1].
  constexpr int kNodes = 8;
  static const double kAt[] = {0.0198550717512319, 0.1016667612931866, 0.2372337950418355,
                               0.4082826787521751, 0.5917173212478249, 0.7627662049581645,
                               0.8983332387068134, 0.9801449282487681};
  static const double kWeight[] = {0.0506142681451881, 0.1111905172266872, 0.1568533229389436,
                                   0.1813418916891810, 0.1813418916891810, 0.1568533229389436,
                                   0.1111905172266872, 0.0506142681451881};
  double sum = 0.0;
  for (int k = 0; k < kNodes; ++k) {
    const surface::CurveJet jet = curve.at(from + kAt[k] * (to - from));
    const Vector3d r = jet.point - tip;
    sum += kWeight[k] * r.cross(jet.d1).norm() / r.squaredNorm();
  }
  return std::abs(to - from) * sum;
}

// Of any part: the curve may bend at its joints, which Gauss's rule must not run over.
double cone_angle(const BezierChain& curve, double from, double to, const Vector3d& tip) {
  const double way = to < from ? -1.0 : 1.0;
  double angle = 0.0, begin = from;
  double joint = way > 0.0 ? std::floor(from) + 1.0 : std::ceil(from) - 1.0;
  for (; way * (to - joint) > 0.0; joint += way) {
    angle += angle_of_part(curve, begin, joint, tip);
    begin = joint;
  }
  return angle + angle_of_part(curve, begin, to, tip);
}

class Layout {
 public:
  Layout(const BezierChain& a, const BezierChain& b, const DevelopableStrip& strip)
      : a_(a), b_(b), strip_(strip) {
    result_.a.resize(strip.rulings.size());
    result_.b.resize(strip.rulings.size());
  }

  DevelopedStrip lay() {
    lay_core();
    // The cones hang on the core's first and last ruling, and are laid from there outwards.
    for (int i = strip_.first; i > 0; --i) lay_cone(i, i - 1);
    for (int i = strip_.last; i + 1 < static_cast<int>(strip_.rulings.size()); ++i) {
      lay_cone(i, i + 1);
    }
    return std::move(result_);
  }

 private:
  Vector3d ruling(double s, double t) const { return b_.at(t).point - a_.at(s).point; }

  // The ruling in the middle of two, by the root that lies between theirs.
  double middle(const Ruling& one, const Ruling& other) const {
    // Without a root nearby the mean stays. The 1e-9 lets t stand still from ruling to ruling.
    const double guess = 0.5 * (one.t + other.t);
    double best = guess, off = other.t - one.t + 1e-9;
    for (double t : touching(a_, 0.5 * (one.s + other.s), b_)) {
      if (std::abs(t - guess) > off) continue;
      best = t;
      off = std::abs(t - guess);
    }
    return best;
  }

  // φ' = κ_g |a'|, x' = |a'| (cos φ, sin φ) by Runge and Kutta's rule of fourth order; φ' does not
  // depend on φ.
  void lay_core() {
    double angle = 0.0;
    Vector2d at = Vector2d::Zero();
    for (int i = strip_.first; i <= strip_.last; ++i) {
      const Ruling& own = strip_.rulings[i];
      place(i, at, angle);
      if (i == strip_.last) break;
      const Ruling& next = strip_.rulings[i + 1];
      const double h = next.s - own.s, s = own.s + 0.5 * h;
      // The end belongs to this interval's span.
      const surface::CurveJet from = a_.at(own.s), half = a_.at(s), to = end_of(own.s, next.s);
      const double g0 = turn(from, ruling(own.s, own.t));
      const double gm = turn(half, ruling(s, middle(own, next)));
      const double g1 = turn(to, ruling(next.s, next.t));
      // Of the parabola through the three.
      const double angle_m = angle + h / 24.0 * (5.0 * g0 + 8.0 * gm - g1);
      const double angle_1 = angle + h / 6.0 * (g0 + 4.0 * gm + g1);
      at += h / 6.0 *
            (from.d1.norm() * direction(angle) + 4.0 * half.d1.norm() * direction(angle_m) +
             to.d1.norm() * direction(angle_1));
      angle = angle_1;
    }
  }

  // The first curve at an interval's end as the span that ends there has it: at a joint the next
  // span may have another second derivative.
  surface::CurveJet end_of(double from, double to) const {
    const int k = static_cast<int>(std::floor(from + 1e-12));
    return BezierChain({a_.span(std::min(k, a_.span_count() - 1))}).at(to - k);
  }

  void place(int i, const Vector2d& at, double angle) {
    const Ruling& own = strip_.rulings[i];
    // In the plane the ruling keeps its angle with the first curve, and its length.
    const Vector3d q = ruling(own.s, own.t);
    const surface::CurveJet jet =
        i > strip_.first ? end_of(strip_.rulings[i - 1].s, own.s) : a_.at(own.s);
    result_.a[i] = at;
    result_.b[i] = at + q.norm() * direction(angle + slant(jet, q));
  }

  // The next ruling around the tip that it has in common with a ruling that is laid. The first
  // curve runs to the right below the second.
  void lay_cone(int laid, int next) {
    const Ruling &own = strip_.rulings[laid], &other = strip_.rulings[next];
    const bool tip_on_a = own.s == other.s, forward = next > laid;
    const Vector2d tip = tip_on_a ? result_.a[laid] : result_.b[laid];
    const Vector2d ray = (tip_on_a ? result_.b[laid] : result_.a[laid]) - tip;
    const double cone = tip_on_a ? cone_angle(b_, own.t, other.t, a_.at(own.s).point)
                                 : cone_angle(a_, own.s, other.s, b_.at(own.t).point);
    // Around a tip on a, below, going on turns clockwise, around one on b, above,
    // counter-clockwise; going back it is the other way round.
    const double angle = angle_of(ray) + (tip_on_a == forward ? -cone : cone);
    const Vector2d end = tip + ruling(other.s, other.t).norm() * direction(angle);
    result_.a[next] = tip_on_a ? tip : end;
    result_.b[next] = tip_on_a ? end : tip;
  }

  const BezierChain &a_, &b_;
  const DevelopableStrip& strip_;
  DevelopedStrip result_;
};

}  // namespace

DevelopedStrip developed(const BezierChain& a, const BezierChain& b,
                         const DevelopableStrip& strip) {
  return Layout(a, b, strip).lay();
}

}  // namespace hull::production
