// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/topology/regions.h"

#include <algorithm>

namespace hull::network {
namespace {

std::size_t end_number(const EdgeEnd& end) {
  return 2 * static_cast<std::size_t>(end.edge) + (end.is_start ? 0 : 1);
}

// Puts edges into a shell that has one vertex at the beginning.
class Drawing {
 public:
  Drawing(int node_count, const std::vector<NetworkEdge>& edges,
          const std::vector<std::vector<EdgeEnd>>& around);
  Regions run();

 private:
  void check_ends() const;
  void draw(int edge);
  // The half-edge that is to come after an end's, clockwise: that of the next end there is; the
  // bare one of a vertex without edges.
  int corner_of(int node, EdgeEnd end) const;
  // Whether, clockwise, one end of an edge from a node to itself comes before the other, and that
  // before a corner.
  bool comes_first(int node, EdgeEnd end, EdgeEnd other, int corner) const;
  void keep(int edge, const Shells::NewEdge& drawn, bool is_along);
  void check_connected() const;

  const std::vector<NetworkEdge>& edges_;
  const std::vector<std::vector<EdgeEnd>>& around_;
  std::vector<int> half_of_end_;  // by end_number(); -1: not drawn
  Regions regions_;
};

Drawing::Drawing(int node_count, const std::vector<NetworkEdge>& edges,
                 const std::vector<std::vector<EdgeEnd>>& around)
    : edges_(edges), around_(around), half_of_end_(2 * edges.size(), -1) {
  regions_.vertex_of_node.assign(static_cast<std::size_t>(node_count), -1);
  regions_.half_of_edge.assign(edges.size(), -1);
  check_ends();
}

void Drawing::check_ends() const {
  const int nodes = static_cast<int>(regions_.vertex_of_node.size());
  if (edges_.empty()) throw std::invalid_argument("A network needs an edge.");
  if (around_.size() != regions_.vertex_of_node.size()) {
    throw std::invalid_argument("Each node needs the ends of edges around it.");
  }
  // All of this is seen to before anything is drawn: draw() looks ends up without asking.
  std::vector<int> node_of_end(half_of_end_.size(), -1);
  for (int node = 0; node < nodes; ++node) {
    for (const EdgeEnd& end : around_[static_cast<std::size_t>(node)]) {
      const bool is_there = end.edge >= 0 && end.edge < static_cast<int>(edges_.size());
      if (!is_there || node_of_end[end_number(end)] >= 0) {
        throw std::invalid_argument("Edge " + std::to_string(end.edge) + " at node " +
                                    std::to_string(node) + " is not there, or twice.");
      }
      node_of_end[end_number(end)] = node;
    }
  }
  for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
    if (node_of_end[2 * edge] != edges_[edge].from ||
        node_of_end[2 * edge + 1] != edges_[edge].to || edges_[edge].from < 0 ||
        edges_[edge].to < 0) {
      throw std::invalid_argument("Edge " + std::to_string(edge) +
                                  " is not around the nodes where it begins and ends.");
    }
  }
}

int Drawing::corner_of(int node, EdgeEnd end) const {
  const auto& ends = around_[static_cast<std::size_t>(node)];
  const auto is_it = [&](const EdgeEnd& other) { return end_number(other) == end_number(end); };
  // Clockwise is backwards in `around`; what is not drawn yet is passed over.
  const auto at = static_cast<std::size_t>(std::ranges::find_if(ends, is_it) - ends.begin());
  for (std::size_t step = 1; step < ends.size(); ++step) {
    const EdgeEnd& clockwise = ends[(at + ends.size() - step) % ends.size()];
    const int half = half_of_end_[end_number(clockwise)];
    if (half >= 0) return half;
  }
  const int vertex = regions_.vertex_of_node[static_cast<std::size_t>(node)];
  return regions_.shells.vertices()[vertex].half_edge;
}

bool Drawing::comes_first(int node, EdgeEnd end, EdgeEnd other, int corner) const {
  const auto& ends = around_[static_cast<std::size_t>(node)];
  const auto is_it = [&](const EdgeEnd& one) { return end_number(one) == end_number(end); };
  auto at = static_cast<std::size_t>(std::ranges::find_if(ends, is_it) - ends.begin());
  for (std::size_t step = 1; step < ends.size(); ++step) {
    const std::size_t number = end_number(ends[(at + ends.size() - step) % ends.size()]);
    // Clockwise, which of both is met first.
    if (number == end_number(other)) return true;
    if (half_of_end_[number] == corner) return false;
  }
  return true;
}

void Drawing::keep(int edge, const Shells::NewEdge& drawn, bool is_along) {
  // `half` leaves the node that it was drawn from: the edge's start, if it was drawn along.
  const auto start = 2 * static_cast<std::size_t>(edge);
  half_of_end_[start] = is_along ? drawn.half : drawn.mate;
  half_of_end_[start + 1] = is_along ? drawn.mate : drawn.half;
  regions_.half_of_edge[static_cast<std::size_t>(edge)] = half_of_end_[start];
}

void Drawing::draw(int edge) {
  const NetworkEdge& e = edges_[static_cast<std::size_t>(edge)];
  auto& vertices = regions_.vertex_of_node;
  const auto from = static_cast<std::size_t>(e.from), to = static_cast<std::size_t>(e.to);
  const EdgeEnd start{edge, true}, end{edge, false};
  if (vertices[from] < 0 || vertices[to] < 0) {
    // One of both nodes is new: an edge with it, into the face at the other one's corner (MEV).
    const bool is_along = vertices[from] >= 0;
    const int corner = is_along ? corner_of(e.from, start) : corner_of(e.to, end);
    const Shells::NewEdge drawn = regions_.shells.make_edge_vertex(corner, corner, e.curve);
    vertices[is_along ? to : from] = drawn.vertex;
    keep(edge, drawn, is_along);
    return;
  }
  // Both are there: the edge divides the face in which both corners are (MEF).
  const int first = corner_of(e.from, start), last = corner_of(e.to, end);
  const auto& half_edges = regions_.shells.half_edges();
  if (half_edges[first].loop != half_edges[last].loop) {
    throw NetworkFault("Edge " + std::to_string(edge) + ", of curve " + std::to_string(e.curve) +
                           ", begins in one region and ends in another: at one of its nodes edges "
                           "are in a wrong order.",
                       {edge});
  }
  // At one corner both ends of an edge from a node to itself are alike but for their order, which
  // tells on which side of it the new face is.
  const bool is_along = first != last || comes_first(e.from, start, end, first);
  keep(edge, regions_.shells.make_edge_face(first, last, e.curve), is_along);
}

void Drawing::check_connected() const {
  std::vector<int> apart;
  for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
    if (regions_.half_of_edge[edge] < 0) apart.push_back(static_cast<int>(edge));
  }
  if (apart.empty()) return;
  const NetworkEdge& edge = edges_[static_cast<std::size_t>(apart.front())];
  throw NetworkFault("Curve " + std::to_string(edge.curve) + " is not connected with curve " +
                         std::to_string(edges_.front().curve) + ".",
                     std::move(apart));
}

Regions Drawing::run() {
  regions_.vertex_of_node[static_cast<std::size_t>(edges_.front().from)] =
      regions_.shells.make_vertex_face_shell().vertex;
  // From node to node: an edge is drawn when the first of its nodes is reached.
  std::vector<int> reached{edges_.front().from};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (const EdgeEnd& end : around_[static_cast<std::size_t>(reached[i])]) {
      if (half_of_end_[end_number(end)] >= 0) continue;
      const NetworkEdge& edge = edges_[static_cast<std::size_t>(end.edge)];
      const int other = end.is_start ? edge.to : edge.from;
      const bool is_new = regions_.vertex_of_node[static_cast<std::size_t>(other)] < 0;
      draw(end.edge);
      if (is_new) reached.push_back(other);
    }
  }
  check_connected();
  return std::move(regions_);
}

}  // namespace

Regions regions_between(int node_count, const std::vector<NetworkEdge>& edges,
                        const std::vector<std::vector<EdgeEnd>>& around) {
  return Drawing(node_count, edges, around).run();
}

}  // namespace hull::network
