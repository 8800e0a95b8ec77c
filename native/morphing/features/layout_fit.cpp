// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/tolerances.h"
#include "modelling/fit.h"
#include "modelling/reshape/move_space.h"
#include "modelling/reshape/surface_places.h"
#include "morphing/families/hull_family.h"
#include "morphing/features/layout_start.h"
#include "morphing/features/renumbering.h"
#include "surface/queries/closest_point.h"
#include "surface/refined_mesh.h"

namespace hull::morphing {
namespace {

using modelling::SurfacePlaces;

// Stiffness of the moves, step by step: rows of points stay laid out as they are while they are
// far away, and go where the surface is at last.
constexpr std::array<double, 2> kFarStiffness{3e-3, 1e-4};
constexpr std::array<double, 2> kNearStiffness{3e-5, 1e-5};
constexpr int kStepsEach = 15;
constexpr double kCurveSpacing = 1.0 / 500.0;  // of the length

std::vector<int> points_in_centre_plane(const surface::LimitSurface& surface) {
  std::vector<int> found;
  const std::vector<Vector3d>& points = surface.mesh().points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(points[i].y()) <= kOnCentrePlane * surface.mesh().size()) {
      found.push_back(static_cast<int>(i));
    }
  }
  return found;
}

modelling::FitTarget target_of(const surface::LimitSurface& surface) {
  const SurfacePlaces places(surface);
  modelling::FitTarget target;
  target.shape = &surface;
  for (int k = 0; k < places.count(); ++k) {
    if (places.normal(k).isZero(0.0)) continue;
    target.points.push_back(places.position(k));
    target.normals.push_back(places.normal(k));
    target.weights.push_back(places.area(k));
  }
  return target;
}

struct Distances {
  double rms = 0.0, largest = 0.0;
  Vector3d place = Vector3d::Zero();
};

// Of places all over a surface from another one, by area.
Distances distances(const surface::LimitSurface& from, const surface::LimitSurface& to) {
  const SurfacePlaces places(from);
  std::vector<Vector3d> points;
  for (int k = 0; k < places.count(); ++k) points.push_back(places.position(k));
  const std::vector<surface::ClosestPoint> feet =
      surface::closest_points(surface::SurfaceTree(to), points);
  Distances found;
  double sum = 0.0;
  for (int k = 0; k < places.count(); ++k) {
    const double distance = feet[k].distance;
    sum += places.area(k) * distance * distance;
    if (distance <= found.largest) continue;
    found.largest = distance;
    found.place = points[k];
  }
  found.rms = std::sqrt(sum / places.total_area());
  return found;
}

// Where a member between the two is folded; none: nowhere.
std::optional<Vector3d> fold_between(const surface::LimitSurface& first,
                                     const surface::LimitSurface& second) {
  const HullFamily family({first, second});
  for (int i = 1; i <= kFoldTrials; ++i) {
    const double t = i / (kFoldTrials + 1.0);
    const auto place = family.first_fold(family.points(std::vector<double>{1.0 - t, t}));
    if (place) return place;
  }
  return std::nullopt;
}

void measure(const surface::LimitSurface& target, LayoutFit& fit) {
  const Distances there = distances(target, fit.second), back = distances(fit.second, target);
  fit.rms = there.rms;
  fit.largest = there.largest;
  fit.largest_place = there.place;
  fit.rms_back = back.rms;
  fit.largest_back = back.largest;
  fit.largest_back_place = back.place;
  fit.fold = fold_between(fit.first, fit.second);
}

// The second hull with the numbers of the first, where both have one topology.
std::optional<surface::LimitSurface> renumbered_as(const surface::LimitSurface& first,
                                                   const surface::LimitSurface& second) {
  const std::optional<std::vector<int>> images = renumbering(first.mesh(), second.mesh());
  if (!images) return std::nullopt;
  std::vector<Vector3d> points;
  for (int image : *images) points.push_back(second.mesh().points()[image]);
  surface::LimitSurface surface = first;
  surface.set_points(std::move(points));
  return surface;
}

// Bodies of the first of two hulls that have none in the second, for a person.
std::string bodies_alone(const FeatureGraph& graph, const FeatureGraph& other) {
  const std::vector<int> paired = paired_bodies(graph, other);
  std::string text;
  for (int body = 0; body < graph.body_count; ++body) {
    if (paired[body] >= 0) continue;
    text += (text.empty() ? "" : " and ") + graph.described_body(body);
  }
  return text;
}

void check_bodies(const FeatureGraph& graph, const FeatureGraph& other) {
  if (graph.body_count == other.body_count) return;
  const bool is_first = graph.body_count > other.body_count;
  throw std::invalid_argument("The first hull has " + std::to_string(graph.body_count) +
                              " bodies and the second " + std::to_string(other.body_count) +
                              ": leave out of the " + (is_first ? "first " : "second ") +
                              (is_first ? bodies_alone(graph, other) : bodies_alone(other, graph)) +
                              ", a keel, rudder or hull that has no counterpart, and bring it "
                              "along by itself.");
}

bool is_half(const FeatureGraph& graph) {
  return std::any_of(graph.features.begin(), graph.features.end(),
                     [](const Feature& f) { return f.role == FeatureRole::kCentreLine; });
}

void check_halves(const FeatureGraph& graph, const FeatureGraph& other) {
  if (is_half(graph) == is_half(other)) return;
  throw std::invalid_argument(
      std::string("The ") + (is_half(graph) ? "first" : "second") +
      " hull is a half with its border in the centre plane, and the other one has both sides, as a "
      "demihull has: mirror the half and take the whole of it, or cut the other one in half.");
}

int size_of(const surface::LimitSurface& surface) {
  return surface.mesh().topology().vertex_count();
}

void subdivide(surface::LimitSurface& surface) {
  surface = surface::LimitSurface(surface::refined_mesh(surface), surface.scheme());
}

// Whether the second hull, or one of the two subdivided, has the first one's topology: then they
// are parents as they are.
bool are_alike(const surface::LimitSurface& second, LayoutFit& fit) {
  surface::LimitSurface first = fit.first, other = second;
  int subdivisions = 0;
  const bool is_coarser = size_of(first) < size_of(other);
  for (; is_coarser && size_of(first) < size_of(other); ++subdivisions) subdivide(first);
  while (!is_coarser && size_of(other) < size_of(first)) subdivide(other);
  std::optional<surface::LimitSurface> same = renumbered_as(first, other);
  if (!same) return false;
  fit.first = std::move(first);
  fit.second = std::move(*same);
  fit.subdivisions = subdivisions;
  return true;
}

void check_hulls(const surface::LimitSurface& first, const surface::LimitSurface& second,
                 const FeatureGraph& graph, const FeatureGraph& other,
                 const LayoutOptions& options) {
  if (first.scheme() != second.scheme()) {
    throw std::invalid_argument("The hulls have different schemes: give both the same.");
  }
  if (!(options.tolerance > 0.0) || options.most_subdivisions < 0) {
    throw std::invalid_argument(
        "The tolerance of a layout must be positive, and subdivisions 0 or more.");
  }
  check_bodies(graph, other);
  check_halves(graph, other);
}

// A layout on its way to the second hull.
class LayoutFitting {
 public:
  LayoutFitting(const surface::LimitSurface& first, const surface::LimitSurface& second,
                const FeatureGraph& other, const LayoutOptions& options)
      : first_(first),
        second_(second),
        other_(other),
        options_(options),
        target_(target_of(second)) {}

  // Fits the layout from where its points are now: near enough to tell what is square and flat in
  // both hulls, and then with that.
  void fit(surface::LimitSurface& layout, const FeatureGraph& graph, const FeatureMatch& match,
           bool is_far, std::vector<CommonFlat>& flats) const {
    const double length = other_.box.high.x() - other_.box.low.x();
    const std::vector<modelling::FitCurve> curves =
        counterpart_curves(graph, other_, match, kCurveSpacing * length);
    modelling::ReshapeLimits limits;
    for (int v : points_in_centre_plane(first_)) {
      limits.limits.held.push_back({v, Vector3d::UnitY()});
    }
    if (is_far) approach(layout, curves, limits, kFarStiffness);
    std::vector<Vector3d> points = layout.mesh().points();
    limits.tied = common_squares(first_, layout, second_);
    for (const modelling::TiedPoint& tie : limits.tied) {
      points[tie.point] +=
          tie.direction.dot(points[tie.leader] - points[tie.point]) * tie.direction;
    }
    flats = common_flats(first_, layout, second_);
    for (const CommonFlat& flat : flats) {
      for (int v : flat.points) {
        limits.limits.held.push_back({v, flat.plane.normal});
        points[v] -= flat.plane.height(points[v]) * flat.plane.normal;
      }
    }
    layout.set_points(std::move(points));
    approach(layout, curves, limits, kNearStiffness);
  }

 private:
  void approach(surface::LimitSurface& layout, const std::vector<modelling::FitCurve>& curves,
                const modelling::ReshapeLimits& limits,
                const std::array<double, 2>& stiffness) const {
    modelling::FitOptions options;
    options.limits = limits;
    options.fairness = 0.0;
    options.draw_border = true;
    options.most_steps = kStepsEach;
    options.progress = options_.progress;
    bool was_folded = fold_between(first_, layout).has_value();
    for (double each : stiffness) {
      options.stiffness = each;
      surface::LimitSurface next = layout;
      next.set_points(modelling::fit(layout, target_, curves, options).points);
      const bool is_folded = fold_between(first_, next).has_value();
      if (is_folded && !was_folded) return;
      was_folded = is_folded;
      layout = std::move(next);
    }
  }

  const surface::LimitSurface& first_;
  const surface::LimitSurface& second_;
  const FeatureGraph& other_;
  const LayoutOptions& options_;
  modelling::FitTarget target_;
};

}  // namespace

LayoutFit fit_layout(const surface::LimitSurface& first, const surface::LimitSurface& second,
                     const LayoutOptions& options) {
  const FeatureGraph graph = feature_graph(first), other = feature_graph(second);
  check_hulls(first, second, graph, other, options);
  LayoutFit found{first, first};
  found.match = match_features(graph, other, options.pairs, options.apart);
  if (are_alike(second, found)) {
    measure(second, found);
    return found;
  }
  found.second.set_points(
      points_near(first, graph, other, found.match, points_in_centre_plane(first)));
  LayoutFitting(first, second, other, options)
      .fit(found.second, graph, found.match, true, found.flats);
  measure(second, found);
  const double allowed = options.tolerance * (other.box.high.x() - other.box.low.x());
  while (found.rms > allowed && found.subdivisions < options.most_subdivisions) {
    ++found.subdivisions;
    subdivide(found.first);
    subdivide(found.second);
    // The same surface has the same features, in the same order.
    LayoutFitting(found.first, second, other, options)
        .fit(found.second, feature_graph(found.first), found.match, false, found.flats);
    measure(second, found);
  }
  return found;
}

}  // namespace hull::morphing
