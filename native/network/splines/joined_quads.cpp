// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/joined_quads.h"

#include <algorithm>
#include <cmath>

namespace hull::network {
namespace {

using conversion::PatchSet;
using conversion::SideEdge;

constexpr double kSameCut = 1e-9;  // of an edge's parameter

// Patches on either side of an edge may divide it in other places: first all cuts are gathered,
// then numbered, and then each patch has the parts of edges between them as its sides.
class QuadJoiner {
 public:
  QuadJoiner(const NetworkFrame& frame, const std::vector<PlacedQuads>& regions)
      : frame_(frame), regions_(regions), cuts_(frame.joined.edges.size(), {0.0, 1.0}) {}

  JoinedQuads run() {
    for (const PlacedQuads& region : regions_) {
      for (const auto& borders : region.borders) {
        for (const QuadBorder& border : borders) collect(border);
      }
    }
    // After all cuts, by which edges and vertices are counted.
    number();
    for (const PlacedQuads& region : regions_) add(region);
    set_.vertex_count = vertex_count_;
    set_.edge_count = edge_count_;
    std::vector<int> edges(static_cast<std::size_t>(edge_count_), -1);
    for (std::size_t e = 0; e < cuts_.size(); ++e) {
      std::fill_n(edges.begin() + first_edge_[e], cuts_[e].size() - 1, static_cast<int>(e));
    }
    return {std::move(set_), std::move(edges)};
  }

 private:
  void collect(const QuadBorder& border) {
    for (const EdgePiece& piece : border.pieces) {
      // What patches on either side of an edge need: borders on both sides are cut at all of these
      // places.
      auto& cuts = cuts_[static_cast<std::size_t>(piece.edge)];
      for (double t : {piece.from, piece.to}) {
        const auto at = std::lower_bound(cuts.begin(), cuts.end(), t - kSameCut);
        if (at == cuts.end() || *at > t + kSameCut) cuts.insert(at, t);
      }
    }
  }

  // Vertices are the nodes, then the cuts of edges.
  void number() {
    vertex_count_ = static_cast<int>(frame_.joined.nodes.size());
    for (const auto& cuts : cuts_) {
      first_vertex_.push_back(vertex_count_);
      first_edge_.push_back(edge_count_);
      vertex_count_ += static_cast<int>(cuts.size()) - 2;
      edge_count_ += static_cast<int>(cuts.size()) - 1;
    }
  }

  std::size_t cut_at(int edge, double t) const {
    const auto& cuts = cuts_[static_cast<std::size_t>(edge)];
    const auto at = std::lower_bound(cuts.begin(), cuts.end(), t - kSameCut);
    return static_cast<std::size_t>(at - cuts.begin());
  }

  int vertex_of(int edge, std::size_t cut) const {
    const auto at = static_cast<std::size_t>(edge);
    // Ends of edges are nodes, which other edges have, too.
    if (cut == 0) return frame_.joined.edges[at].from;
    if (cut + 1 == cuts_[at].size()) return frame_.joined.edges[at].to;
    return first_vertex_[at] + static_cast<int>(cut) - 1;
  }

  void add_pieces(conversion::PatchSide& side, const EdgePiece& piece) const {
    const auto& cuts = cuts_[static_cast<std::size_t>(piece.edge)];
    const std::size_t last = cut_at(piece.edge, piece.to);
    const bool is_along = piece.to > piece.from;
    for (std::size_t cut = cut_at(piece.edge, piece.from); cut != last;) {
      const std::size_t next = is_along ? cut + 1 : cut - 1;
      const int number =
          first_edge_[static_cast<std::size_t>(piece.edge)] + static_cast<int>(std::min(cut, next));
      const auto on_side = [&](double t) {
        return piece.begin + (piece.end - piece.begin) * (t - piece.from) / (piece.to - piece.from);
      };
      // The last end bit for bit, and at the piece's end its own: a side's edges leave nothing
      // open.
      const double begin = side.empty() ? 0.0 : side.back().end;
      side.push_back({number, vertex_of(piece.edge, cut), vertex_of(piece.edge, next), begin,
                      next == last ? piece.end : on_side(cuts[next])});
      cut = next;
    }
  }

  // The vertex in which a border begins on the network.
  int start_of(const QuadBorder& border) const {
    const EdgePiece& piece = border.pieces.front();
    return vertex_of(piece.edge, cut_at(piece.edge, piece.from));
  }
  int end_of(const QuadBorder& border) const {
    const EdgePiece& piece = border.pieces.back();
    return vertex_of(piece.edge, cut_at(piece.edge, piece.to));
  }

  void add(const PlacedQuads& region) {
    // Behind all that are there: what a region has within it no other one has.
    const int centre = vertex_count_, first_spoke = edge_count_;
    const auto count = region.quads->patches.size();
    if (count > 1) {
      ++vertex_count_;
      edge_count_ += static_cast<int>(count);
    }
    for (std::size_t q = 0; q < count; ++q) {
      set_.patches.push_back(region.quads->patches[q]);
      auto& corners = set_.corners.emplace_back();
      auto& sides = set_.sides.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) {
        const QuadBorder& border = region.borders[q][k];
        if (border.spoke < 0) {
          for (const EdgePiece& piece : border.pieces) add_pieces(sides[k], piece);
        } else {
          // A spoke has no border of the network: its outer end is that of the half of a side
          // beside it.
          const int middle =
              border.is_inwards ? end_of(region.borders[q][0]) : start_of(region.borders[q][3]);
          const int edge = first_spoke + border.spoke;
          sides[k] = border.is_inwards ? conversion::whole_side(edge, middle, centre)
                                       : conversion::whole_side(edge, centre, middle);
        }
        corners[k] = sides[k].front().from;
      }
    }
  }

  const NetworkFrame& frame_;
  const std::vector<PlacedQuads>& regions_;
  std::vector<std::vector<double>> cuts_;  // of edges, rising, with both ends
  std::vector<int> first_vertex_, first_edge_;
  int vertex_count_ = 0, edge_count_ = 0;
  PatchSet set_;
};

}  // namespace

JoinedQuads joined_quads(const NetworkFrame& frame, const std::vector<PlacedQuads>& regions) {
  return QuadJoiner(frame, regions).run();
}

}  // namespace hull::network
