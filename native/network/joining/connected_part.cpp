// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/joining/connected_part.h"

#include <algorithm>
#include <set>

#include "network/joining/edge_shape.h"

namespace hull::network {
namespace {

// Edges are struck off first; what is left is numbered anew at the end.
class Pruning {
 public:
  Pruning(JoinedCurves& joined, const std::vector<CurveShape>& shapes,
          const std::vector<std::string>& names)
      : joined_(joined), shapes_(shapes), names_(names), stays_(joined.edges.size(), true) {}

  void run() {
    // First what is apart: a curve that meets nothing would else be told as dangling.
    cut_apart();
    cut_dangling();
    renumber();
  }

 private:
  const std::string& name(int curve) const { return names_[static_cast<std::size_t>(curve)]; }
  const Vector3d& node(int number) const { return joined_.nodes[static_cast<std::size_t>(number)]; }

  std::vector<int> edge_counts() const {
    // An edge from a node to itself counts twice there: a closed curve does not dangle.
    std::vector<int> counts(joined_.nodes.size(), 0);
    for (std::size_t e = 0; e < stays_.size(); ++e) {
      if (!stays_[e]) continue;
      ++counts[static_cast<std::size_t>(joined_.edges[e].from)];
      ++counts[static_cast<std::size_t>(joined_.edges[e].to)];
    }
    return counts;
  }

  // What dangles is told once for each end, over all edges to where the rest begins.
  struct Dangling {
    Vector3d free_end, root;
    double length;
  };

  void cut_dangling() {
    std::vector<std::pair<int, Dangling>> told;
    // By nodes: the sentence that what dangles next there belongs to.
    std::vector<int> told_at(joined_.nodes.size(), -1);
    // An edge that is cut may leave the one before it dangling.
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      // Of the round's beginning: which edges go does not depend on their order.
      const std::vector<int> counts = edge_counts();
      for (std::size_t e = 0; e < stays_.size(); ++e) {
        if (!stays_[e]) continue;
        const CurveEdge& edge = joined_.edges[e];
        const bool is_from = counts[static_cast<std::size_t>(edge.from)] == 1;
        if (!is_from && counts[static_cast<std::size_t>(edge.to)] != 1) continue;
        stays_[e] = false;
        is_changed = true;
        const int free = is_from ? edge.from : edge.to, root = is_from ? edge.to : edge.from;
        int& at = told_at[static_cast<std::size_t>(free)];
        // Where another curve goes on from a root, that one dangles by itself.
        if (at < 0 || told[static_cast<std::size_t>(at)].first != edge.curve) {
          at = static_cast<int>(told.size());
          told.push_back({edge.curve, {node(free), node(root), 0.0}});
        }
        // Handed on to the root: the edge that is to dangle there goes on with it.
        Dangling& dangling = told[static_cast<std::size_t>(at)].second;
        dangling.root = node(root);
        dangling.length += length_of(edge);
        told_at[static_cast<std::size_t>(root)] = at;
      }
    }
    for (const auto& [curve, dangling] : told) name_dangling(curve, dangling);
  }

  double length_of(const CurveEdge& edge) const {
    const auto& pieces = shapes_[static_cast<std::size_t>(edge.curve)].pieces;
    return EdgeShape(edge, pieces[static_cast<std::size_t>(edge.piece)], node(edge.from),
                     node(edge.to))
        .length();
  }

  void name_dangling(int curve, const Dangling& dangling) {
    joined_.problems.push_back(
        {NetworkProblem::Kind::kDanglingEnd,
         "Curve " + name(curve) + " ends at " + place_text(dangling.free_end) + ", " +
             length_text(dangling.length) + " beyond the last curve that it meets, at " +
             place_text(dangling.root) + ": lengthen it to a curve, or cut it off there.",
         {curve},
         {dangling.free_end, dangling.root}});
  }

  void cut_apart() {
    std::vector<int> part_of_node(joined_.nodes.size(), -1);
    std::vector<int> sizes;
    for (std::size_t e = 0; e < stays_.size(); ++e) {
      if (!stays_[e] || part_of_node[static_cast<std::size_t>(joined_.edges[e].from)] >= 0)
        continue;
      sizes.push_back(spread(joined_.edges[e].from, static_cast<int>(sizes.size()), part_of_node));
    }
    if (sizes.size() < 2) return;
    // Of parts with as many edges the first stays.
    const int largest = static_cast<int>(std::ranges::max_element(sizes) - sizes.begin());
    std::vector<std::set<int>> curves(sizes.size());
    std::vector<Vector3d> places(sizes.size());
    for (std::size_t e = 0; e < stays_.size(); ++e) {
      if (!stays_[e]) continue;
      const int part = part_of_node[static_cast<std::size_t>(joined_.edges[e].from)];
      if (part == largest) continue;
      stays_[e] = false;
      curves[static_cast<std::size_t>(part)].insert(joined_.edges[e].curve);
      places[static_cast<std::size_t>(part)] = node(joined_.edges[e].from);
    }
    for (std::size_t part = 0; part < sizes.size(); ++part) {
      // One sentence a part; the largest has none.
      if (!curves[part].empty()) name_apart(curves[part], places[part]);
    }
  }

  void name_apart(const std::set<int>& curves, const Vector3d& place) {
    std::string all;
    for (int curve : curves) all += (all.empty() ? "" : ", ") + name(curve);
    joined_.problems.push_back({NetworkProblem::Kind::kApart,
                                "Nothing connects " + all + ", at " + place_text(place) +
                                    ", with the rest of the network: add a curve that meets both.",
                                {curves.begin(), curves.end()},
                                {place}});
  }

  // The ends of edges that hang together with a node; an edge from a node to itself counts as one.
  int spread(int first, int part, std::vector<int>& part_of_node) const {
    std::vector<int> reached{first};
    part_of_node[static_cast<std::size_t>(first)] = part;
    int ends = 0;
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (std::size_t e = 0; e < stays_.size(); ++e) {
        const CurveEdge& edge = joined_.edges[e];
        if (!stays_[e] || (edge.from != reached[i] && edge.to != reached[i])) continue;
        ++ends;
        for (int next : {edge.from, edge.to}) {
          int& its_part = part_of_node[static_cast<std::size_t>(next)];
          if (its_part >= 0) continue;
          its_part = part;
          reached.push_back(next);
        }
      }
    }
    return ends;
  }

  void renumber() {
    const std::vector<int> counts = edge_counts();
    std::vector<int> number(counts.size(), -1);
    std::vector<Vector3d> nodes;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] == 0) continue;
      number[i] = static_cast<int>(nodes.size());
      nodes.push_back(joined_.nodes[i]);
    }
    std::vector<CurveEdge> edges;
    for (std::size_t e = 0; e < stays_.size(); ++e) {
      if (!stays_[e]) continue;
      edges.push_back(joined_.edges[e]);
      // Both ends of an edge that stays have an edge, and so a number.
      for (int* end : {&edges.back().from, &edges.back().to}) {
        *end = number[static_cast<std::size_t>(*end)];
      }
    }
    std::vector<NodeVisit> visits;
    for (NodeVisit visit : joined_.visits) {
      visit.node = number[static_cast<std::size_t>(visit.node)];
      if (visit.node >= 0) visits.push_back(visit);
    }
    joined_.nodes = std::move(nodes);
    joined_.edges = std::move(edges);
    joined_.visits = std::move(visits);
  }

  JoinedCurves& joined_;
  const std::vector<CurveShape>& shapes_;
  const std::vector<std::string>& names_;
  std::vector<bool> stays_;
};

}  // namespace

void keep_connected(JoinedCurves& joined, const std::vector<CurveShape>& shapes,
                    const std::vector<std::string>& names) {
  Pruning(joined, shapes, names).run();
}

}  // namespace hull::network
