// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "network/topology/numbered.h"

namespace hull::network {

// Where it begins, and what it belongs to. Along a loop its face is to the left, seen from outside.
struct HalfEdge {
  int vertex = -1;
  int edge = -1;  // none: the only one of the loop of a vertex without edges
  int loop = -1;
  int next = -1, previous = -1;
};

struct Edge {
  int halves[2] = {-1, -1};
  int curve = -1;  // that it is a part of, by the caller's numbers
};

struct Loop {
  int first = -1;
  int face = -1;
};

struct Face {
  int outer = -1;
  std::vector<int> inner;  // loops
  int shell = -1;
};

struct Vertex {
  int half_edge = -1;  // one of those that begin there
};

struct Shell {
  int holes = 0;  // through it
};

// V, E, F, L (inner loops), S, H of the formula of Euler and Poincaré.
struct ElementCounts {
  int vertices, edges, faces, inner_loops, shells, holes;
  int excess() const { return vertices + faces - edges - inner_loops - 2 * (shells - holes); }
};

// Closed orientable surfaces as half-edges, loops and faces, changed by ten Euler operators only
// (Mäntylä 1988; Koelman 1999, 2.2.2 and 5.1.2), which keep
//
//   V + F - E - L = 2 (S - H).
//
// A hull's half is closed by a face beyond its borders. The operators throw std::invalid_argument
// and change nothing for elements that are not there or not as they must be.
class Shells {
 public:
  struct NewShell {
    int shell, face, vertex, half_edge;
  };
  struct NewEdge {
    int half, mate;
    int vertex, face;  // -1 where none was made
  };

  // Constructive: MVFS, MEV, MEF, KEML, KFMLH.
  NewShell make_vertex_face_shell();
  // From the vertex at which both begin to a new one, which takes all half-edges from `first` on to
  // before `last`, clockwise; none where they are the same. `half` begins at the old vertex.
  NewEdge make_edge_vertex(int first, int last, int curve = -1);
  // From `first`'s beginning to `last`'s, both of one loop. The part of the loop from `first` to
  // before `last` is closed by `mate` and bounds the new face; `half` stays in the old loop.
  NewEdge make_edge_face(int first, int last, int curve = -1);
  // An edge with one loop on both sides: what follows `half` becomes an inner loop, which is
  // returned.
  int kill_edge_make_loop(int half);
  // The other face's only loop becomes an inner loop of the face.
  void kill_face_make_loop_hole(int face, int other);

  // Destructive, each the inverse of one above: KVFS, KEV, KEF, MEKL, MFKLH.
  void kill_vertex_face_shell(int shell);
  // The edge, and the vertex where `half` ends.
  void kill_edge_vertex(int half);
  // The edge, and the face beyond it, which has no other loop.
  void kill_edge_face(int half);
  // From `first`'s beginning to `second`'s, which are of two loops of one face.
  NewEdge make_edge_kill_loop(int first, int second, int curve = -1);
  // The inner loop bounds a face of its own, which is returned.
  int make_face_kill_loop_hole(int loop);

  const Numbered<HalfEdge>& half_edges() const { return half_edges_; }
  const Numbered<Edge>& edges() const { return edges_; }
  const Numbered<Loop>& loops() const { return loops_; }
  const Numbered<Face>& faces() const { return faces_; }
  const Numbered<Vertex>& vertices() const { return vertices_; }
  const Numbered<Shell>& shells() const { return shells_; }
  ElementCounts counts() const;

  // The other half of its edge. REQUIRES: it has an edge.
  int mate(int half) const;
  // The next half-edge that begins at the vertex, clockwise.
  int clockwise(int half) const { return half_edges_[mate(half)].next; }
  int end_of(int half) const { return half_edges_[mate(half)].vertex; }
  int face_of(int half) const { return loops_[half_edges_[half].loop].face; }
  // In order from the first.
  std::vector<int> half_edges_of(int loop) const;
  // Those that can be reached over edges, the face itself among them.
  std::vector<int> connected_faces(int face) const;

 private:
  bool is_bare(int half) const { return half_edges_[half].edge < 0; }
  void link(int half, int next);
  // A new half-edge that begins at a vertex, before another one in its loop; where that one is
  // bare it is taken itself.
  int insert_before(int half, int vertex, int edge);
  // The loop is that of all half-edges from one on.
  void take_loop(int first, int loop);
  int bare_half_edge(int vertex, int loop);
  int new_edge(int curve);
  // Half-edges `from` … `to` in a ring, or a bare one at the vertex where there are none.
  void close_ring(bool is_empty, int from, int to, int vertex, int loop);
  void remove_edge(int half);
  void remove_inner(int face, int loop);
  void separate(int face, int new_face);
  int genus_of(const std::vector<int>& faces) const;

  Numbered<HalfEdge> half_edges_{"half-edge"};
  Numbered<Edge> edges_{"edge"};
  Numbered<Loop> loops_{"loop"};
  Numbered<Face> faces_{"face"};
  Numbered<Vertex> vertices_{"vertex"};
  Numbered<Shell> shells_{"shell"};
};

// What is wrong with the links between elements, or with the formula; empty where nothing is.
std::string shells_fault(const Shells& shells);

}  // namespace hull::network
