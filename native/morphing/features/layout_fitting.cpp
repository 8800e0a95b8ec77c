// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_fitting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesh/tolerances.h"
#include "modelling/reshape/surface_places.h"
#include "morphing/families/hull_family.h"
#include "morphing/features/layout_distances.h"
#include "morphing/features/layout_start.h"

namespace hull::morphing {
namespace {

using modelling::SurfacePlaces;

// Stiffness of the moves, step by step: rows of points stay laid out as they are while they are
// far away, and go where the surface is at last.
constexpr std::array<FitStage, 2> kFarStages{{{3e-3, 15}, {1e-4, 15}}};
// Short stages end where members are folded that are not when the stage has settled.
constexpr std::array<FitStage, 2> kNearStages{{{3e-5, 25}, {1e-5, 25}}};
// Where that is not near enough: a layout that need not be subdivided has fewer marks.
constexpr std::array<FitStage, 1> kLastStage{{{3e-6, 25}}};
constexpr double kCurveSpacing = 1.0 / 500.0;  // of the length
// Of the second hull's size: so far from the centre plane at least are points of a half hull that
// are not in it, 1 mm on 100 m. More than kOnCentrePlane, so that none is taken for one in it.
constexpr double kOffCentrePlane = 1e-5;
static_assert(kOffCentrePlane > kOnCentrePlane);

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

void hold_bar(const FeatureGraph& graph, const FeatureMatch& match,
              modelling::ReshapeLimits& limits) {
  for (int k : match.alone_in_first) {
    // Held across alone: along the ship and up the bar goes with the hull.
    if (graph.features[k].role != FeatureRole::kBarEdge) continue;
    for (int chain : graph.features[k].chains) {
      for (int v : graph.curves[chain].vertices()) {
        limits.limits.held.push_back({v, Vector3d::UnitY()});
      }
    }
  }
}

// The shortest way into a plane; of points of the centre plane within that, as a transom that is
// square to it but for its last digits would draw them out.
void put_into(const analysis::Plane& plane, bool is_central, Vector3d& point) {
  Vector3d way = plane.normal;
  if (is_central) way.y() = 0.0;
  // By as much of the way as takes the whole height off.
  if (!way.isZero(0.0)) point -= plane.height(point) / way.dot(plane.normal) * way;
}

// What keeps a half hull on its side: its surface is there where its control points are. Points
// of the first hull that are in the plane, or beyond it, have no bound.
std::vector<modelling::FitBound> bounds_of_half(const surface::LimitSurface& first,
                                                const FeatureGraph& other, double size) {
  const double side = side_of(other.box);
  std::vector<modelling::FitBound> bounds;
  const std::vector<Vector3d>& points = first.mesh().points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Towards the side on which the second hull is, which is the first one's, too.
    const double own = side * points[i].y();
    if (own <= kOnCentrePlane * first.mesh().size()) continue;
    bounds.push_back(
        {static_cast<int>(i), side * Vector3d::UnitY(), std::min(own, kOffCentrePlane * size)});
  }
  return bounds;
}

}  // namespace

std::optional<Vector3d> fold_between(const surface::LimitSurface& first,
                                     const surface::LimitSurface& second) {
  const HullFamily family({first, second});
  for (int i = 1; i <= kFoldTrials; ++i) {
    // Between both, none of which is folded against itself.
    const double t = i / (kFoldTrials + 1.0);
    const auto place = family.first_fold(family.points(std::vector<double>{1.0 - t, t}));
    if (place) return place;
  }
  return std::nullopt;
}

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

LayoutFitting::LayoutFitting(const surface::LimitSurface& first,
                             const surface::LimitSurface& second, const FeatureGraph& other,
                             const LayoutOptions& options, const LayoutWay& way)
    : first_(first),
      second_(second),
      other_(other),
      progress_(options.progress),
      tolerance_(options.tolerance * (other.box.high.x() - other.box.low.x())),
      way_(way),
      target_(target_of(second)) {}

std::optional<Vector3d> LayoutFitting::fit(surface::LimitSurface& layout, const FeatureGraph& graph,
                                           const FeatureMatch& match, bool is_far,
                                           std::vector<CommonFlat>& flats) const {
  const double length = other_.box.high.x() - other_.box.low.x();
  const std::vector<modelling::FitCurve> curves =
      counterpart_curves(graph, other_, match, kCurveSpacing * length);
  modelling::ReshapeLimits limits;
  for (int v : points_in_centre_plane(first_)) {
    limits.limits.held.push_back({v, Vector3d::UnitY()});
  }
  if (way_.holds_bar) hold_bar(graph, match, limits);
  // A whole hull may be on either side of the centre plane.
  const std::vector<modelling::FitBound> bounds =
      is_half(graph) ? bounds_of_half(first_, other_, second_.mesh().size())
                     : std::vector<modelling::FitBound>();
  std::optional<surface::LimitSurface> boxed;
  if (way_.has_first_metric) {
    boxed = first_;
    boxed->set_points(in_box(first_.mesh().points(), graph.box, other_.box));
  }
  const surface::LimitSurface* const metric = boxed ? &*boxed : nullptr;
  // A step from afar that would fold a member is left out, and the near ones begin before it.
  if (is_far) approach(layout, curves, limits, bounds, metric, kFarStages);
  std::vector<Vector3d> points = layout.mesh().points();
  limits.tied = common_squares(first_, layout, second_);
  for (const modelling::TiedPoint& tie : limits.tied) {
    // Ties are of moves: what they keep square must be so to begin with.
    points[tie.point] += tie.direction.dot(points[tie.leader] - points[tie.point]) * tie.direction;
  }
  flats = common_flats(first_, layout, second_);
  const std::vector<int> central = points_in_centre_plane(first_);
  for (const CommonFlat& flat : flats) {
    for (int v : flat.points) {
      limits.limits.held.push_back({v, flat.plane.normal});
      const bool is_central = std::binary_search(central.begin(), central.end(), v);
      put_into(flat.plane, is_central, points[v]);
    }
  }
  layout.set_points(std::move(points));
  const auto fold = approach(layout, curves, limits, bounds, metric, kNearStages);
  if (fold || is_met(layout)) return fold;
  return approach(layout, curves, limits, bounds, metric, kLastStage);
}

bool LayoutFitting::is_met(const surface::LimitSurface& layout) const {
  return layout_distances(second_, layout).rms <= tolerance_ &&
         layout_distances(layout, second_).rms <= tolerance_;
}

std::optional<Vector3d> LayoutFitting::approach(surface::LimitSurface& layout,
                                                const std::vector<modelling::FitCurve>& curves,
                                                const modelling::ReshapeLimits& limits,
                                                const std::vector<modelling::FitBound>& bounds,
                                                const surface::LimitSurface* metric,
                                                std::span<const FitStage> stages) const {
  modelling::FitOptions options;
  options.limits = limits;
  options.bounds = bounds;
  options.metric = metric;
  options.fairness = 0.0;
  options.draw_border = true;
  options.progress = progress_;
  // A layout that is folded already may come out of it: only a fold that is new ends the way.
  bool was_folded = fold_between(first_, layout).has_value();
  for (const FitStage& stage : stages) {
    options.stiffness = stage.stiffness;
    options.most_steps = stage.most_steps;
    surface::LimitSurface next = layout;
    next.set_points(modelling::fit(layout, target_, curves, options).points);
    const std::optional<Vector3d> fold = fold_between(first_, next);
    if (fold && !was_folded) return fold;
    was_folded = fold.has_value();
    layout = std::move(next);
  }
  return std::nullopt;
}

}  // namespace hull::morphing
