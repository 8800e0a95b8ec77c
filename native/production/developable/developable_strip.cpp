// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/developable_strip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hull::production {
namespace {

constexpr double kNoValue = 1e-13;   // of the coefficients: rounding
constexpr double kSameRoot = 1e-11;  // of parameters, on both sides of a joint

// Both curves run on the same side of the line, so that the surface does not turn over on it.
bool is_regular(const surface::CurveJet& a, const surface::CurveJet& b) {
  const Vector3d q = b.point - a.point;
  return a.d1.cross(q).dot(b.d1.cross(q)) > 0.0;
}

// What leads up to a ruling by the most others: the longest chain in which t does not fall.
struct Candidate {
  double s, t;
  int row;
  int length = 1, before = -1;
  double steps = 0.0;  // of t, squared: the smaller of two chains of one length is taken
};

std::vector<Ruling> longest_chain(std::vector<Candidate>& all) {
  std::size_t best = 0;
  // Dynamic programming: candidates are in order of their rows, so that all that may lead up to one
  // come before it.
  for (std::size_t i = 0; i < all.size(); ++i) {
    Candidate& own = all[i];
    for (std::size_t k = 0; k < i; ++k) {
      const Candidate& other = all[k];
      // A row has one ruling of the chain at most.
      if (other.row == own.row || other.t > own.t) continue;
      const double steps = other.steps + (own.t - other.t) * (own.t - other.t);
      const bool is_longer = other.length + 1 > own.length;
      if (!is_longer && !(other.length + 1 == own.length && steps < own.steps)) continue;
      own.length = other.length + 1;
      own.before = static_cast<int>(k);
      own.steps = steps;
    }
    if (own.length > all[best].length) best = i;
  }
  std::vector<Ruling> chain;
  for (int i = static_cast<int>(best); i >= 0; i = all[i].before) {
    chain.push_back({all[i].s, all[i].t});
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

// Parameters from `from` to `to` in steps of at most `step`, without both.
std::vector<double> between(double from, double to, double step) {
  const int parts = static_cast<int>(std::ceil((to - from) / step - 1e-9));
  std::vector<double> values;
  for (int i = 1; i < parts; ++i) values.push_back(from + i * (to - from) / parts);
  return values;
}

}  // namespace

std::vector<double> touching(const BezierChain& a, double s, const BezierChain& b) {
  const surface::CurveJet jet = a.at(s);
  // A constant is a polynomial of degree 0; f is of degree 3 + 0 + 2, with five roots at most.
  const BernsteinVector tangent{Bernstein{jet.d1.x()}, Bernstein{jet.d1.y()},
                                Bernstein{jet.d1.z()}};
  std::vector<double> all;
  for (int k = 0; k < b.span_count(); ++k) {
    BezierSpan between = b.span(k);
    for (Vector3d& p : between) p = jet.point - p;
    const Bernstein f = dot(cross(polynomial_of(between), tangent), derivative_of(b.span(k)));
    std::vector<double> roots;
    // A root at an end may have no change of sign, or be beyond it by rounding.
    const double none = kNoValue * std::max(std::abs(least(f)), std::abs(most(f)));
    if (std::abs(f.front()) <= none) roots.push_back(0.0);
    for (double t : sign_changes(f)) roots.push_back(t);
    if (std::abs(f.back()) <= none) roots.push_back(1.0);
    for (double t : roots) {
      if (all.empty() || k + t > all.back() + kSameRoot) all.push_back(k + t);
    }
  }
  return all;
}

void check_interval_count(int count) {
  if (count < 1 || count > kMostRulings) {
    throw std::invalid_argument("A strip has 1 to " + std::to_string(kMostRulings) +
                                " intervals, not " + std::to_string(count) + ".");
  }
}

DevelopableStrip developable_strip(const BezierChain& a, const BezierChain& b, int count) {
  check_interval_count(count);
  // A whole number for each span, so that joints of the curve are among the rulings' ends.
  const int spans = a.span_count(), per_span = (count + spans - 1) / spans;
  std::vector<Candidate> candidates;
  for (int i = 0; i <= spans * per_span; ++i) {
    const double s = static_cast<double>(i) / per_span;
    const surface::CurveJet jet = a.at(s);
    for (double t : touching(a, s, b)) {
      if (is_regular(jet, b.at(t))) candidates.push_back({s, t, i});
    }
  }
  if (candidates.empty()) {
    throw std::invalid_argument(
        "No straight line between the curves lies in one tangent plane of both: no developable "
        "surface joins them. Let them run more alike.");
  }
  const std::vector<Ruling> chain = longest_chain(candidates);
  const double s_end = spans, t_end = b.span_count(), step = 1.0 / per_span;
  const Ruling head = chain.front(), tail = chain.back();
  DevelopableStrip strip;
  // From (0, 0) on around the end of b, then around the first ruling's end on a.
  std::vector<Ruling>& rulings = strip.rulings;
  if (head.s > 0.0) {
    rulings.push_back({0.0, 0.0});
    for (double s : between(0.0, head.s, step)) rulings.push_back({s, 0.0});
  }
  if (head.t > 0.0) {
    rulings.push_back({head.s, 0.0});
    for (double t : between(0.0, head.t, step)) rulings.push_back({head.s, t});
  }
  strip.first = static_cast<int>(rulings.size());
  rulings.insert(rulings.end(), chain.begin(), chain.end());
  strip.last = static_cast<int>(rulings.size()) - 1;
  for (double t : between(tail.t, t_end, step)) rulings.push_back({tail.s, t});
  if (tail.t < t_end) rulings.push_back({tail.s, t_end});
  for (double s : between(tail.s, s_end, step)) rulings.push_back({s, t_end});
  if (tail.s < s_end) rulings.push_back({s_end, t_end});
  return strip;
}

}  // namespace hull::production
