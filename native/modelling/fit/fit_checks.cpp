// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit_checks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "surface/creases/crease_curves.h"

namespace hull::modelling::fit_internal {
namespace {

void check_points(const std::vector<Vector3d>& points, const char* what) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite() && points[i].cwiseAbs().maxCoeff() <= mesh::kMaxCoordinate) continue;
    throw std::invalid_argument(std::string(what) + " " + std::to_string(i) +
                                " is no place within 1e9 m.");
  }
}

void check_target(const FitTarget& target) {
  check_points(target.points, "Target");
  const auto check_length = [&](std::size_t length, const char* what) {
    if (length == 0 || length == target.points.size()) return;
    throw std::invalid_argument(std::string("There must be as many ") + what + " as targets, " +
                                std::to_string(target.points.size()) + ", not " +
                                std::to_string(length) + ".");
  };
  check_length(target.normals.size(), "normals");
  check_length(target.weights.size(), "weights");
  for (std::size_t i = 0; i < target.normals.size(); ++i) {
    if (target.normals[i].allFinite()) continue;
    throw std::invalid_argument("Normal " + std::to_string(i) +
                                " is no number: leave out its target, or give no normals.");
  }
  for (double weight : target.weights) {
    if (!(weight >= 0.0 && std::isfinite(weight))) {
      throw std::invalid_argument("A target's weight is " + std::to_string(weight) +
                                  "; it must not be negative.");
    }
  }
}

void check_curves(const std::vector<FitCurve>& curves, int chain_count) {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const FitCurve& curve = curves[i];
    const std::string name = "Curve " + std::to_string(i);
    if (curve.points.size() < 2) throw std::invalid_argument(name + " needs two points or more.");
    check_points(curve.points, (name + ": point").c_str());
    if (curve.chain >= FitCurve::kNearest && curve.chain < chain_count) continue;
    throw std::invalid_argument(name + " is for crease curve " + std::to_string(curve.chain) +
                                ", but they are 0 to " + std::to_string(chain_count - 1) + ".");
  }
}

void check_options(const FitOptions& options) {
  const auto check = [](double value, const char* what) {
    if (value >= 0.0 && std::isfinite(value)) return;
    throw std::invalid_argument(std::string(what) + " must not be negative, nor infinite.");
  };
  check(options.fairness, "fairness");
  check(options.stiffness, "stiffness");
  check(options.curve_weight, "curve_weight");
  check(options.least_move, "least_move");
  if (!(options.reach > 0.0)) throw std::invalid_argument("reach must be positive.");
  if (options.most_steps < 0 || options.most_steps > kMostFitSteps) {
    throw std::invalid_argument("most_steps is " + std::to_string(options.most_steps) +
                                ": it must be from 0 to " + std::to_string(kMostFitSteps) + ".");
  }
}

void check_sums(const std::vector<FitSum>& sums, int point_count) {
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const FitSum& sum = sums[i];
    const std::string name = "Sum " + std::to_string(i);
    if (sum.points.size() != sum.weights.size()) {
      throw std::invalid_argument(name + " must have as many weights as points, " +
                                  std::to_string(sum.points.size()) + ", not " +
                                  std::to_string(sum.weights.size()) + ".");
    }
    for (int point : sum.points) check_point(point, point_count, (name + "'s point").c_str());
    const auto is_finite = [](double weight) { return std::isfinite(weight); };
    if (!sum.rest.allFinite() || !std::ranges::all_of(sum.weights, is_finite)) {
      throw std::invalid_argument(name + " has a weight or a rest that is no number.");
    }
  }
}

void check_bounds(const std::vector<FitBound>& bounds, int point_count) {
  for (const FitBound& bound : bounds) {
    check_point(bound.point, point_count, "bounded");
    if (bound.direction.allFinite() && !bound.direction.isZero(0.0) && std::isfinite(bound.least)) {
      continue;
    }
    throw std::invalid_argument("The bound of point " + std::to_string(bound.point) +
                                " has no direction or no place.");
  }
}

bool has_same_faces(const mesh::Topology& a, const mesh::Topology& b) {
  if (a.vertex_count() != b.vertex_count() || a.half_edge_count() != b.half_edge_count()) {
    return false;
  }
  for (int h = 0; h < a.half_edge_count(); ++h) {
    // Pieces are those of the surface that is fitted; the metric lends them its points alone.
    if (a.origin(h) != b.origin(h) || a.next(h) != b.next(h) || a.is_crease(h) != b.is_crease(h)) {
      return false;
    }
  }
  return true;
}

void check_metric(const surface::LimitSurface* metric, const surface::LimitSurface& surface) {
  if (!metric || has_same_faces(metric->mesh().topology(), surface.mesh().topology())) return;
  throw std::invalid_argument("The metric is that of a surface with other faces or creases.");
}

}  // namespace

void check_fit(const surface::LimitSurface& surface, const FitTarget& target,
               const std::vector<FitCurve>& curves, const FitOptions& options) {
  const int point_count = surface.mesh().topology().vertex_count();
  check_target(target);
  check_options(options);
  check_curves(curves, static_cast<int>(surface::crease_curves(surface).size()));
  check_sums(options.sums, point_count);
  check_bounds(options.bounds, point_count);
  check_metric(options.metric, surface);
}

}  // namespace hull::modelling::fit_internal
