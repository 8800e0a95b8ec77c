// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit_curves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hull::modelling::fit_internal {
namespace {

constexpr int kSamplesAnEdge = 8;
// Cosine of the largest angle between a line and the chain it is taken for.
constexpr double kSameCourse = 0.8;
// What an end of a whole curve counts for, of all its points.
constexpr double kEndShare = 0.1;

struct OnChain {
  double t = 0.0, distance = std::numeric_limits<double>::infinity();
};

// A chain with points on it, from which searches start.
class Chain {
 public:
  explicit Chain(const surface::CreaseCurve& curve) : curve_(curve) {
    const int count = kSamplesAnEdge * curve.edge_count();
    for (int i = 0; i <= count; ++i) {
      samples_.push_back(curve.evaluate(static_cast<double>(i) / kSamplesAnEdge, 0).point);
    }
  }

  const surface::CreaseCurve& curve() const { return curve_; }
  double end() const { return curve_.edge_count(); }
  Vector3d tangent(double t) const { return curve_.evaluate(t, 1).d1.normalized(); }

  OnChain nearest(const Vector3d& p) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      if ((samples_[i] - p).squaredNorm() < (samples_[best] - p).squaredNorm()) best = i;
    }
    // The foot is looked for on both sides of the nearest sample.
    const double at = static_cast<double>(best) / kSamplesAnEdge, step = 1.0 / kSamplesAnEdge;
    // A closed chain goes on beyond its seam.
    OnChain found = within(p, std::max(0.0, at - step), std::min(end(), at + step));
    if (curve_.closed() && (best == 0 || best + 1 == samples_.size())) {
      const OnChain other = best == 0 ? within(p, end() - step, end()) : within(p, 0.0, step);
      if (other.distance < found.distance) found = other;
    }
    return found;
  }

 private:
  // Newton's method for the foot, kept in the interval by halving it.
  OnChain within(const Vector3d& p, double low, double high) const {
    double t = 0.5 * (low + high);
    for (int i = 0; i < 60 && high - low > 1e-15 * end(); ++i) {
      const surface::CurveJet jet = curve_.evaluate(t, 2);
      const double slope = (jet.point - p).dot(jet.d1);
      const double change = jet.d1.squaredNorm() + (jet.point - p).dot(jet.d2);
      (slope > 0.0 ? high : low) = t;
      double next = change > 0.0 ? t - slope / change : 0.5 * (low + high);
      // Beyond the interval's end there may be no foot: then the end is nearest.
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (std::abs(next - t) < 1e-15 * end()) break;
      t = next;
    }
    OnChain best{t, (curve_.evaluate(t, 0).point - p).norm()};
    for (double side : {low, high}) {
      const double distance = (curve_.evaluate(side, 0).point - p).norm();
      if (distance < best.distance) best = {side, distance};
    }
    return best;
  }

  const surface::CreaseCurve& curve_;
  std::vector<Vector3d> samples_;
};

surface::CellPlace place_at(const surface::CreaseCurve& curve, double t) {
  const surface::CellPlace left = curve.left(t);
  // Beside a border is a face on one side alone.
  return left.cell >= 0 ? left : curve.right(t);
}

// The line's direction at one of its points; zero where it has none.
Vector3d course(const std::vector<Vector3d>& line, std::size_t i) {
  const Vector3d along = line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0];
  return along.normalized();
}

class Collector {
 public:
  Collector(const std::vector<Chain>& chains, double reach) : chains_(chains), reach_(reach) {}

  void add(const FitCurve& curve) {
    for (std::size_t i = 0; i < curve.points.size(); ++i) add_point(curve, i);
    // The ends are pulled along the line too, or the chain could be shorter or longer than it.
    if (curve.whole && curve.chain >= 0) add_ends(curve);
  }

  CurvePulls finish() {
    double sum = 0.0;
    for (FitRow& row : pulls_.rows) {
      // Where anything counts the weights sum to 1 or more: the 1 is for nothing at all.
      row.weight /= std::max(weight_, 1.0);
      sum += row.weight * row.distance * row.distance;
    }
    pulls_.mean_square = sum;
    return std::move(pulls_);
  }

 private:
  void add_point(const FitCurve& curve, std::size_t i) {
    const Vector3d& p = curve.points[i];
    const Vector3d along = course(curve.points, i);
    const Chain* chain = nullptr;
    OnChain at;
    for (std::size_t k = 0; k < chains_.size(); ++k) {
      if (curve.chain >= 0 && static_cast<int>(k) != curve.chain) continue;
      const OnChain here = chains_[k].nearest(p);
      if (here.distance >= at.distance || here.distance > reach_) continue;
      // Either way round: chains have no direction that a line could know.
      if (curve.chain < 0 && std::abs(chains_[k].tangent(here.t).dot(along)) < kSameCourse) {
        continue;
      }
      chain = &chains_[k];
      at = here;
    }
    pulls_.distances.push_back(chain ? at.distance : std::nan(""));
    if (!chain) return;
    const Vector3d off = p - chain->curve().evaluate(at.t, 0).point;
    const Vector3d tangent = chain->tangent(at.t);
    if (is_beyond_end(*chain, at.t, off, tangent)) {
      pulls_.distances.back() = std::nan("");
      return;
    }
    weight_ += 1.0;
    Vector3d axis = Vector3d::Zero();
    Eigen::Index least;
    tangent.cwiseAbs().minCoeff(&least);
    axis[least] = 1.0;
    // Two rows square to the tangent: their squares sum to that of the distance from the tangent
    // line, along which the chain may slide. The axis is the one most across it.
    const Vector3d across = tangent.cross(axis).normalized();
    add_row(chain->curve(), at.t, across, off, 1.0);
    add_row(chain->curve(), at.t, tangent.cross(across), off, 1.0);
  }

  // Where the line goes on after the chain's end, which the end's own point tells of.
  bool is_beyond_end(const Chain& chain, double t, const Vector3d& off, const Vector3d& tangent) {
    const bool is_end = !chain.curve().closed() && (t == 0.0 || t == chain.end());
    return is_end && std::abs(off.dot(tangent)) > 0.5 * off.norm() && off.norm() > 0.0;
  }

  void add_ends(const FitCurve& curve) {
    const Chain& chain = chains_[static_cast<std::size_t>(curve.chain)];
    if (chain.curve().closed()) return;
    const Vector3d begin = chain.curve().evaluate(0.0, 0).point;
    const Vector3d end = chain.curve().evaluate(chain.end(), 0).point;
    const Vector3d &first = curve.points.front(), &last = curve.points.back();
    // The line may run against the chain.
    const bool is_along = (begin - first).squaredNorm() + (end - last).squaredNorm() <=
                          (begin - last).squaredNorm() + (end - first).squaredNorm();
    const double weight = std::max(1.0, kEndShare * static_cast<double>(curve.points.size()));
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d direction = Vector3d::Unit(axis);
      add_row(chain.curve(), 0.0, direction, (is_along ? first : last) - begin, weight);
      add_row(chain.curve(), chain.end(), direction, (is_along ? last : first) - end, weight);
    }
    weight_ += 2.0 * weight;
  }

  void add_row(const surface::CreaseCurve& curve, double t, const Vector3d& direction,
               const Vector3d& off, double weight) {
    const surface::CellPlace place = place_at(curve, t);
    pulls_.rows.push_back({place.cell, place.u, place.v, direction, off.dot(direction), weight});
  }

  const std::vector<Chain>& chains_;
  double reach_;
  double weight_ = 0.0;
  CurvePulls pulls_;
};

}  // namespace

CurvePulls find_curve_pulls(const surface::LimitSurface& surface,
                            const std::vector<FitCurve>& curves, const FitOptions& options) {
  if (curves.empty()) return {};
  const std::vector<surface::CreaseCurve> creases = surface::crease_curves(surface);
  const std::vector<Chain> chains(creases.begin(), creases.end());
  Collector collector(chains, options.reach);
  for (const FitCurve& curve : curves) collector.add(curve);
  return collector.finish();
}

}  // namespace hull::modelling::fit_internal
