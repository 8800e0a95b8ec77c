// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/feature_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/immersion/bodies.h"
#include "mesh/place_text.h"
#include "mesh/tolerances.h"
#include "morphing/features/line_order.h"

namespace hull::morphing {
namespace {

using modelling::FieldCurve;
using surface::CreaseCurve;
using surface::CreaseKind;

// Of the length: how far from its after end a hull's transom may reach, as it is raked.
constexpr double kTransomReach = 0.06;
// A transom leans by less: length of its edge along the ship over that across or upwards.
constexpr double kTransomLean = 0.5;

constexpr std::array<const char*, 12> kRoleNames{"centre line",
                                                 "middle of the transom",
                                                 "transom's edge",
                                                 "rim of the transom",
                                                 "middle of the bow's flat end",
                                                 "edge of the bow's flat end",
                                                 "rim of the bow's flat end",
                                                 "deck edge",
                                                 "edge of the bar keel",
                                                 "rim of the flat bottom",
                                                 "knuckle",
                                                 "opening"};

// Of the depth: how far off the bottom a flat's rim is, on average.
constexpr double kRimShare = 0.05;

enum class EndPart { kMiddle, kEdge, kRim };

FeatureRole at_end(bool is_aft, EndPart part) {
  switch (part) {
    case EndPart::kMiddle:
      return is_aft ? FeatureRole::kTransomMiddle : FeatureRole::kBowMiddle;
    case EndPart::kEdge:
      return is_aft ? FeatureRole::kTransomEdge : FeatureRole::kBowEdge;
    default:
      return is_aft ? FeatureRole::kTransomRim : FeatureRole::kBowRim;
  }
}

// What a crease is that runs off the centre plane: the rim of a flat bottom is, on average of its
// control points, as low as the hull is.
FeatureRole knuckle_role(const CreaseCurve& curve, const HullBox& hull) {
  const std::vector<Vector3d>& points = curve.spline().points();
  double height = 0.0;
  for (const Vector3d& p : points) height += hull.relative(p).z();
  const bool is_low = height < kRimShare * static_cast<double>(points.size());
  return is_low ? FeatureRole::kBottomRim : FeatureRole::kKnuckle;
}

// By the box of its control points against the hull's: where a line is tells what it is.
FeatureRole role_of(const CreaseCurve& curve, const HullBox& hull, double size) {
  const HullBox box = box_of(curve.spline().points());
  const Vector3d extent = box.high - box.low;
  const double across = std::max(extent.y(), extent.z());
  const bool is_border = curve.kind() == CreaseKind::kBorder;
  const bool is_central =
      std::max(std::abs(box.low.y()), std::abs(box.high.y())) <= kAtCentreLine * size;
  const bool is_aft =
      box.high.x() <= hull.low.x() + kTransomReach * (hull.high.x() - hull.low.x()) &&
      extent.x() <= kTransomLean * across;
  const bool is_forward = box.low.x() >= hull.high.x() - kAtCentreLine * size;
  // A crease beside the centre plane that runs along it, and not across, is a bar's at the ends,
  // too.
  const bool is_bar = is_central && extent.y() < 0.5 * std::max(extent.x(), extent.z());
  // Ends of the ship first: the middle and the edges of a transom would be centre line and
  // knuckles.
  if (is_aft || is_forward) {
    if (!is_border && !is_bar) return at_end(is_aft, EndPart::kEdge);
    if (is_border) return at_end(is_aft, is_central ? EndPart::kMiddle : EndPart::kRim);
  }
  if (is_central) return is_border ? FeatureRole::kCentreLine : FeatureRole::kBarEdge;
  if (!is_border) return knuckle_role(curve, hull);
  return extent.x() >= extent.z() && extent.x() > kNoLength * size ? FeatureRole::kDeckEdge
                                                                   : FeatureRole::kOpening;
}

class Grouping {
 public:
  Grouping(const std::vector<CreaseCurve>& curves, const std::vector<FeatureRole>& roles,
           const std::vector<int>& bodies)
      : curves_(curves), roles_(roles), bodies_(bodies), is_used_(curves.size(), 0) {
    for (int c = 0; c < static_cast<int>(curves.size()); ++c) {
      // Closed chains are lines by themselves.
      if (curves[c].closed()) continue;
      for (bool is_backward : {false, true}) leaving_[key(c, first(c, is_backward))].push_back(c);
    }
  }

  // The lines, each as far as it goes on in one way only.
  std::vector<std::vector<Link>> lines() {
    std::vector<std::vector<Link>> all;
    for (int c = 0; c < static_cast<int>(curves_.size()); ++c) {
      if (is_used_[c]) continue;
      is_used_[c] = 1;
      std::vector<Link> line{{c, false}};
      if (!curves_[c].closed()) {
        // To one end; then, turned round, to the other.
        extend(line);
        for (Link& link : line) link.is_backward = !link.is_backward;
        std::reverse(line.begin(), line.end());
        extend(line);
      }
      all.push_back(std::move(line));
    }
    return all;
  }

 private:
  int first(int chain, bool is_backward) const {
    const std::vector<int>& v = curves_[chain].vertices();
    return is_backward ? v.back() : v.front();
  }
  std::tuple<int, int, int> key(int chain, int vertex) const {
    return {bodies_[chain], static_cast<int>(roles_[chain]), vertex};
  }
  void extend(std::vector<Link>& line) {
    for (;;) {
      const Link last = line.back();
      const int end = first(last.chain, !last.is_backward);
      const std::vector<int>& there = leaving_[key(last.chain, end)];
      // Both chains that leave the place, in the line's own role: with more of them it does not go
      // on.
      if (there.size() != 2) return;
      const int next = there[0] == last.chain ? there[1] : there[0];
      if (is_used_[next]) return;
      is_used_[next] = 1;
      line.push_back({next, curves_[next].vertices().front() != end});
    }
  }

  const std::vector<CreaseCurve>& curves_;
  const std::vector<FeatureRole>& roles_;
  const std::vector<int>& bodies_;
  std::vector<char> is_used_;
  std::map<std::tuple<int, int, int>, std::vector<int>> leaving_;
};

// `vertex`: with which a closed curve begins.
std::vector<FieldCurve::Arc> arcs_of(const CreaseCurve& curve, bool is_backward, int vertex) {
  // As cubics by their control points: backwards these, and the order of the cubics.
  std::vector<FieldCurve::Arc> arcs = FieldCurve::of_spline(curve.spline()).arcs();
  if (is_backward) {
    std::reverse(arcs.begin(), arcs.end());
    for (FieldCurve::Arc& arc : arcs) std::reverse(arc.begin(), arc.end());
  }
  if (vertex == 0) return arcs;
  // Both ends are one to rounding, and come to be within.
  arcs.front()[0] = arcs.back()[3];
  const Vector3d begin = curve.evaluate(vertex, 0).point;
  std::ranges::rotate(arcs, std::ranges::min_element(arcs, {}, [&](const FieldCurve::Arc& arc) {
                        return (arc[0] - begin).squaredNorm();
                      }));
  return arcs;
}

Feature feature_of(const std::vector<CreaseCurve>& curves, std::vector<Link> line, FeatureRole role,
                   int body, const HullBox& hull) {
  const int vertex = set_order(curves, hull, line);
  std::vector<FieldCurve::Arc> arcs;
  std::vector<double> lengths{0.0};
  std::vector<int> chains, nodes;
  std::vector<char> is_backward;
  for (const Link& link : line) {
    const std::vector<FieldCurve::Arc> own = arcs_of(curves[link.chain], link.is_backward, vertex);
    lengths.push_back(lengths.back() + FieldCurve(own).length());
    arcs.insert(arcs.end(), own.begin(), own.end());
    // Chains meet in a control point that the surface goes through, to rounding of each.
    if (arcs.size() > own.size())
      arcs[arcs.size() - own.size()][0] = arcs[arcs.size() - own.size() - 1][3];
    const std::vector<int>& v = curves[link.chain].vertices();
    chains.push_back(link.chain);
    is_backward.push_back(link.is_backward);
    const bool is_closed = curves[link.chain].closed();
    if (nodes.empty())
      nodes.push_back(is_closed ? v[vertex] : link.is_backward ? v.back() : v.front());
    nodes.push_back(is_closed ? nodes.front() : link.is_backward ? v.front() : v.back());
  }
  return {role,
          body,
          std::move(chains),
          std::move(is_backward),
          std::move(lengths),
          std::move(nodes),
          FieldCurve(std::move(arcs))};
}

int body_of(const CreaseCurve& curve, const analysis::Bodies& bodies) {
  // A border has a face on one side alone.
  const surface::CellPlace left = curve.left(0.0), right = curve.right(0.0);
  return bodies.of_cell[left.cell >= 0 ? left.cell : right.cell];
}

}  // namespace

const char* name_of(FeatureRole role) { return kRoleNames[static_cast<std::size_t>(role)]; }

std::string FeatureGraph::described(int feature) const {
  const Feature& f = features[feature];
  return std::string("the ") + name_of(f.role) + " from " +
         mesh::place_text(f.curve.point_at(0.0), 2) + " to " +
         mesh::place_text(f.curve.point_at(f.curve.length()), 2);
}

std::string FeatureGraph::described_body(int body) const {
  std::vector<Vector3d> points;
  for (const Feature& f : features) {
    if (f.body != body) continue;
    for (int chain : f.chains) {
      for (int i = 0; i <= curves[chain].edge_count(); ++i) {
        points.push_back(curves[chain].evaluate(i, 0).point);
      }
    }
  }
  if (points.empty()) return "the closed body without a crease";
  const HullBox extent = box_of(points);
  return "the body between " + mesh::place_text(extent.low, 2) + " and " +
         mesh::place_text(extent.high, 2);
}

FeatureGraph feature_graph(const surface::LimitSurface& surface) {
  const analysis::Bodies bodies = analysis::bodies_of(surface);
  FeatureGraph graph{surface::crease_curves(surface),
                     {},
                     box_of(surface.mesh().points()),
                     static_cast<int>(bodies.first_cell.size())};
  std::vector<FeatureRole> roles;
  std::vector<int> body_of_chain;
  for (const CreaseCurve& curve : graph.curves) {
    roles.push_back(role_of(curve, graph.box, surface.mesh().size()));
    body_of_chain.push_back(body_of(curve, bodies));
  }
  for (std::vector<Link>& line : Grouping(graph.curves, roles, body_of_chain).lines()) {
    const int chain = line.front().chain;
    graph.features.push_back(
        feature_of(graph.curves, std::move(line), roles[chain], body_of_chain[chain], graph.box));
  }
  // By places, so that numbers of features do not follow those of points.
  const auto order = [](const Feature& f) {
    const Vector3d begin = f.curve.point_at(0.0);
    return std::tuple(f.body, static_cast<int>(f.role), begin.x(), begin.z(), begin.y());
  };
  std::stable_sort(graph.features.begin(), graph.features.end(),
                   [&](const Feature& a, const Feature& b) { return order(a) < order(b); });
  // From the centre plane, so that what is in it in one hull is so in another.
  if (is_half(graph)) (side_of(graph.box) > 0.0 ? graph.box.low : graph.box.high).y() = 0.0;
  return graph;
}

bool is_half(const FeatureGraph& graph) {
  return std::any_of(graph.features.begin(), graph.features.end(),
                     [](const Feature& f) { return f.role == FeatureRole::kCentreLine; });
}

}  // namespace hull::morphing
