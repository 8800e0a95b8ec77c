// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "conversion/caps/caps.h"
#include "conversion/patches/edge_uses.h"
#include "conversion/patches/mirror.h"
#include "conversion/place_error.h"
#include "mesh/tolerances.h"

namespace hull::conversion {

// An edge of a border, its curve in the direction of the set's patch.
struct BorderStep {
  int edge = -1;
  BSplineCurve curve;
  int from = -1, to = -1;  // as EdgeUses::vertex() numbers them
};
using BorderChain = std::vector<BorderStep>;

// What lies athwart: the centre plane of a half hull, or the other side of a symmetric border.
struct FarSide {
  double y = 0.0;            // of the plane between the sides
  bool is_plane = true;      // the plane itself is the far side
  std::map<int, int> edges;  // otherwise, of every edge its mirror image, and of every vertex
  std::map<int, int> vertices;
};

// Makes the caps of closing_of(), chain by chain.
class CapMaker {
 public:
  // The set outlives this.
  CapMaker(const PatchSet& set, const EdgeUses& uses);

  const PatchSet& set() const { return set_; }
  const EdgeUses& uses() const { return uses_; }
  double tolerance() const { return kInCap * size_; }
  BorderStep step(const EdgeUse& use) const;
  // Whether an edge runs straight athwartships.
  bool is_athwart(const BorderStep& step) const;
  int from(const DirectedEdge& edge) const;
  int to(const DirectedEdge& edge) const { return from(-edge); }
  BSplineCurve curve(const DirectedEdge& edge) const;

  // A plane face within loops of edges, which run counter-clockwise around its outer border.
  void add_plane(Cap::Kind kind, std::vector<EdgePath> loops);
  // A plane face with the kind that goes with its direction.
  void add_plane(EdgePath loop);

  // The caps between a chain and its far side. Both its ends are there, or belong to edges that are
  // their own mirror images: `start` and `end` are these edges, from the chain's end athwart.
  void close(const BorderChain& chain, FarSide& far, const EdgePath& start, const EdgePath& end);

  // Edges that caps have in the plane of a half hull, as these caps run along them.
  const EdgePath& in_plane() const { return in_plane_; }
  Closing take() { return std::move(result_); }

 private:
  struct Run {
    std::size_t begin = 0, end = 0;  // steps
    bool is_plane = false;
    EdgePath start, finish;  // from the run's ends athwart
  };

  std::vector<Run> runs_of(const BorderChain& chain) const;
  void find_ends(const BorderChain& chain, std::vector<Run>& runs, FarSide& far);
  int far_vertex(int vertex, const Vector3d& position, FarSide& far);
  EdgePath straight(int vertex, const Vector3d& position, FarSide& far);
  DirectedEdge add_edge(BSplineCurve curve, int from, int to);
  void close_run(const BorderChain& chain, const Run& run, FarSide& far);
  EdgePath far_path(const BorderChain& chain, const Run& run, FarSide& far);
  void add_patch(const BorderStep& step, const Run& run, const EdgePath& far_edge,
                 const FarSide& far);

  const PatchSet& set_;
  const EdgeUses& uses_;
  double size_;
  Closing result_;
  std::map<int, EdgePath> straight_;  // by vertex
  EdgePath in_plane_;
};

}  // namespace hull::conversion
