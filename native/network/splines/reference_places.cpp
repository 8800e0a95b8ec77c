// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/reference_places.h"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "mesh/dense_solvers.h"
#include "network/splines/fitted_spline.h"
#include "network/splines/side_parts.h"

namespace hull::network {
namespace {

// Edges of a piece of a curve one after the other.
struct Chain {
  std::vector<std::size_t> references;
  std::vector<int> nodes;
  std::vector<double> parameters;    // at the nodes
  double first_length, last_length;  // m, of the first and the last edge
};

std::vector<Chain> chains_of(const NetworkFrame& frame, const std::vector<int>& references) {
  const JoinedCurves& joined = frame.joined;
  std::vector<std::size_t> order(references.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto edge_of = [&](std::size_t i) -> const CurveEdge& {
    return joined.edges[static_cast<std::size_t>(references[i])];
  };
  std::ranges::sort(order, {}, [&](std::size_t i) { return references[i]; });
  std::vector<Chain> chains;
  const CurveEdge* last = nullptr;
  for (std::size_t i : order) {
    const CurveEdge& edge = edge_of(i);
    // Edges of a piece have numbers in its order.
    const bool goes_on = last != nullptr && last->curve == edge.curve &&
                         last->piece == edge.piece && last->to == edge.from &&
                         last->high == edge.low;
    const double length = frame.shapes[static_cast<std::size_t>(references[i])].length();
    if (!goes_on) chains.push_back({{}, {edge.from}, {edge.low}, length, length});
    chains.back().references.push_back(i);
    chains.back().nodes.push_back(edge.to);
    chains.back().parameters.push_back(edge.high);
    chains.back().last_length = length;
    last = &edge;
  }
  return chains;
}

using NodePlaces = std::map<int, Vector2d>;

NodePlaces places_on_sides(const NetworkFrame& frame, const std::vector<RegionSide>& sides) {
  NodePlaces places;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::vector<double> ends = side_ends(frame, sides[k]);
    for (std::size_t i = 0; i < sides[k].size(); ++i) {
      const CurveEdge& edge = frame.joined.edges[static_cast<std::size_t>(sides[k][i].edge)];
      const double t = ends[i];
      // Sides run around the square: the third against u, the fourth against v.
      const Vector2d on[] = {{t, 0.0}, {1.0, t}, {1.0 - t, 1.0}, {0.0, 1.0 - t}};
      places[sides[k][i].is_along ? edge.from : edge.to] = on[k];
    }
  }
  return places;
}

// An end of a chain: the node there, the next one, and how far that is, m.
struct ChainEnd {
  int next;
  double length;
};

// Of nodes inside at which chains only end, all their ends: as where curves meet end to end.
std::map<int, std::vector<ChainEnd>> ends_within(const std::vector<Chain>& chains,
                                                 const NodePlaces& places) {
  std::map<int, std::vector<ChainEnd>> ends;
  for (const Chain& chain : chains) {
    const auto& nodes = chain.nodes;
    ends[nodes.front()].push_back({nodes[1], chain.first_length});
    ends[nodes.back()].push_back({nodes[nodes.size() - 2], chain.last_length});
  }
  for (const Chain& chain : chains) {
    for (std::size_t i = 1; i + 1 < chain.nodes.size(); ++i) ends.erase(chain.nodes[i]);
  }
  std::erase_if(ends, [&](const auto& end) { return places.contains(end.first); });
  return ends;
}

// Adds the places of nodes inside to those on the sides.
// Both coordinates at once, by least squares, for curves that cross do not agree on a node's place.
void place_inner(const std::vector<Chain>& chains, NodePlaces& places) {
  std::map<int, Eigen::Index> unknown;
  Eigen::Index rows = 0;
  for (const Chain& chain : chains) {
    // An equation for each node that a chain passes; a node where two chains cross has two, and
    // one where chains only end has one of its own below.
    rows += std::ssize(chain.nodes) - 2;
    for (int node : chain.nodes) {
      if (!places.contains(node)) unknown.try_emplace(node, std::ssize(unknown));
    }
  }
  if (unknown.empty()) return;
  const auto ends = ends_within(chains, places);
  rows += std::ssize(ends);
  Eigen::MatrixXd form = Eigen::MatrixXd::Zero(rows, std::ssize(unknown));
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(rows, 2);
  Eigen::Index row = 0;
  // What is known goes to the right.
  const auto add = [&](int node, double weight) {
    const auto known = places.find(node);
    if (known != places.end()) {
      right.row(row) -= weight * known->second.transpose();
    } else {
      form(row, unknown[node]) += weight;
    }
  };
  for (const Chain& chain : chains) {
    for (std::size_t i = 1; i + 1 < chain.nodes.size(); ++i, ++row) {
      const auto& t = chain.parameters;
      const double share = (t[i] - t[i - 1]) / (t[i + 1] - t[i - 1]);
      // p_i = (1 - share) p_(i-1) + share p_(i+1).
      add(chain.nodes[i], 1.0);
      add(chain.nodes[i - 1], share - 1.0);
      add(chain.nodes[i + 1], -share);
    }
  }
  for (const auto& [node, its_ends] : ends) {
    double sum = 0.0;
    for (const ChainEnd& end : its_ends) sum += 1.0 / end.length;
    // The mean of its neighbours, the nearer ones by more: of two curves end to end the place is by
    // lengths what it is by parameters within one.
    add(node, 1.0);
    for (const ChainEnd& end : its_ends) add(end.next, -1.0 / (end.length * sum));
    ++row;
  }
  const Eigen::MatrixXd found = mesh::least_norm_solutions(form, right);
  for (const auto& [node, number] : unknown) {
    places[node] = found.row(number).transpose().cwiseMax(0.0).cwiseMin(1.0);
  }
}

// Through places at parameters, which are brought to 0 … 1; slopes at the ends are those of a
// parabola.
conversion::BSplineCurve spline_through(const std::vector<Vector3d>& places,
                                        const std::vector<double>& parameters) {
  SplineBreaks breaks;
  for (std::size_t i = 0; i < places.size(); ++i) {
    breaks.at.push_back((parameters[i] - parameters.front()) /
                        (parameters.back() - parameters.front()));
  }
  breaks.at.back() = 1.0;
  breaks.places = places;
  const std::size_t spans = breaks.spans();
  const auto rise = [&](std::size_t s) {
    return Vector3d((places[s + 1] - places[s]) / breaks.width(s));
  };
  Vector3d start = rise(0), end = rise(spans - 1);
  if (spans > 1) {
    const auto bend = [&](std::size_t s) {
      return Vector3d((rise(s + 1) - rise(s)) / (breaks.width(s) + breaks.width(s + 1)));
    };
    start -= breaks.width(0) * bend(0);
    end += breaks.width(spans - 1) * bend(spans - 2);
  }
  return complete_spline(breaks, start, end);
}

}  // namespace

ReferencePlaces::ReferencePlaces(const NetworkFrame& frame, const std::vector<RegionSide>& sides,
                                 const std::vector<int>& references)
    : parts_(references.size()) {
  const std::vector<Chain> chains = chains_of(frame, references);
  NodePlaces places = places_on_sides(frame, sides);
  place_inner(chains, places);
  for (const Chain& chain : chains) {
    std::vector<Vector3d> through;
    for (int node : chain.nodes) through.emplace_back(places[node].x(), places[node].y(), 0.0);
    chains_.push_back(spline_through(through, chain.parameters));
    // A chain has one parameter from 0 to 1, and each of its edges a part of it.
    const double first = chain.parameters.front(), whole = chain.parameters.back() - first;
    for (std::size_t i = 0; i < chain.references.size(); ++i) {
      parts_[chain.references[i]] = {chains_.size() - 1, (chain.parameters[i] - first) / whole,
                                     (chain.parameters[i + 1] - first) / whole};
    }
  }
}

Vector2d ReferencePlaces::at(std::size_t reference, double t) const {
  const Part& part = parts_[reference];
  const Vector3d place =
      chains_[part.chain].position(std::clamp(part.low + t * (part.high - part.low), 0.0, 1.0));
  // Between nodes beside a side the spline may swing out of the square.
  return place.head<2>().cwiseMax(0.0).cwiseMin(1.0);
}

}  // namespace hull::network
