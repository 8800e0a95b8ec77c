// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_fit.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "morphing/features/layout_distances.h"
#include "morphing/features/layout_fitting.h"
#include "morphing/features/layout_shortfall.h"
#include "morphing/features/layout_start.h"
#include "morphing/features/layout_turns.h"
#include "morphing/features/renumbering.h"
#include "surface/refined_mesh.h"

namespace hull::morphing {
namespace {

// `turns`: against the second hull.
void measure(const LayoutTurns& turns, LayoutFit& fit) {
  // Both ways: each alone misses what the other surface has and this one is nowhere near.
  const LayoutDistances there = layout_distances(turns.hull(), fit.second);
  const modelling::SurfacePlaces places(fit.second);
  const std::vector<surface::ClosestPoint> feet = turns.feet(places);
  const LayoutDistances back = layout_distances(places, feet);
  fit.rms = there.rms;
  fit.largest = there.largest;
  fit.largest_place = there.place;
  fit.rms_back = back.rms;
  fit.largest_back = back.largest;
  fit.largest_back_place = back.place;
  fit.fold = fold_between(fit.first, fit.second);
  if (fit.fold) return;
  const std::vector<int> turned = turns.turned(places, feet);
  if (turned.empty()) return;
  // The same place of the first hull, on which folds of members are told, too.
  fit.fold = modelling::SurfacePlaces(fit.first, places.weights()).position(turned.front());
}

// The second hull with the numbers of the first, where both have one topology.
std::optional<surface::LimitSurface> renumbered_as(const surface::LimitSurface& first,
                                                   const surface::LimitSurface& second) {
  const std::optional<std::vector<int>> images = renumbering(first.mesh(), second.mesh());
  if (!images) return std::nullopt;
  std::vector<Vector3d> points;
  // Images are the second hull's vertices, by the first one's numbers.
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

std::string counted_bodies(const FeatureGraph& graph) {
  return std::to_string(graph.body_count) + (graph.body_count == 1 ? " body" : " bodies");
}

void check_bodies(const FeatureGraph& graph, const FeatureGraph& other) {
  if (graph.body_count == other.body_count) return;
  const bool is_first = graph.body_count > other.body_count;
  throw std::invalid_argument("The first hull has " + counted_bodies(graph) + " and the second " +
                              counted_bodies(other) + ": leave out of the " +
                              (is_first ? "first " : "second ") +
                              (is_first ? bodies_alone(graph, other) : bodies_alone(other, graph)) +
                              ", a keel, rudder or hull that has no counterpart, and bring it "
                              "along by itself.");
}

void check_halves(const FeatureGraph& graph, const FeatureGraph& other) {
  if (is_half(graph) == is_half(other)) {
    if (!is_half(graph) || side_of(graph.box) == side_of(other.box)) return;
    throw std::invalid_argument(
        std::string("One of the hulls is a half to port and the other one a half to starboard: "
                    "mirror the ") +
        (side_of(graph.box) < 0.0 ? "first." : "second."));
  }
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
  // Subdivision leaves a surface as it is: the coarser of two is brought to as many points as the
  // other one has, or more.
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

// From the hulls as they are, `start` being what is known of them.
LayoutFit fitted(const LayoutTurns& turns, const FeatureGraph& graph, const FeatureGraph& other,
                 const LayoutOptions& options, LayoutFit start, const LayoutWay& way) {
  const surface::LimitSurface& second = turns.hull();
  LayoutFit& found = start;
  found.second.set_points(
      points_near(found.first, graph, other, found.match, points_in_centre_plane(found.first)));
  found.fold_ahead = LayoutFitting(found.first, second, other, options, way)
                         .fit(found.second, graph, found.match, true, found.flats);
  measure(turns, found);
  const double allowed = options.tolerance * (other.box.high.x() - other.box.low.x());
  while (std::max(found.rms, found.rms_back) > allowed &&
         found.subdivisions < options.most_subdivisions) {
    ++found.subdivisions;
    subdivide(found.first);
    subdivide(found.second);
    // The same surface has the same features, in the same order.
    found.fold_ahead =
        LayoutFitting(found.first, second, other, options, way)
            .fit(found.second, feature_graph(found.first), found.match, false, found.flats);
    measure(turns, found);
  }
  found.shortfall = layout_shortfall(graph, other, found, options.tolerance);
  return found;
}

bool has_bar_alone(const FeatureGraph& graph, const FeatureMatch& match) {
  return std::any_of(match.alone_in_first.begin(), match.alone_in_first.end(),
                     [&](int k) { return graph.features[k].role == FeatureRole::kBarEdge; });
}

// Members without a fold first, then less distance.
bool is_better(const LayoutFit& a, const LayoutFit& b) {
  if (a.fold.has_value() != b.fold.has_value()) return !a.fold;
  return std::max(a.rms, a.rms_back) < std::max(b.rms, b.rms_back);
}

}  // namespace

LayoutFit fit_layout(const surface::LimitSurface& first, const surface::LimitSurface& second,
                     const LayoutOptions& options) {
  const FeatureGraph graph = feature_graph(first), other = feature_graph(second);
  check_hulls(first, second, graph, other, options);
  LayoutFit found{first, first};
  const LayoutTurns turns(second);
  found.match = match_features(graph, other, options.pairs, options.apart);
  if (are_alike(second, found)) {
    measure(turns, found);
    found.shortfall = layout_shortfall(graph, other, found, options.tolerance);
    return found;
  }
  // One way after the other, until one does: a fit takes seconds.
  std::vector<LayoutWay> ways{{.has_first_metric = true}, {}};
  if (has_bar_alone(graph, found.match)) ways.insert(ways.begin() + 1, {.holds_bar = true});
  std::optional<LayoutFit> best;
  for (const LayoutWay& way : ways) {
    LayoutFit fit = fitted(turns, graph, other, options, found, way);
    if (!best || is_better(fit, *best)) best = std::move(fit);
    if (best->shortfall.empty()) break;
  }
  return *best;
}

}  // namespace hull::morphing
