// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace hull::mesh {

// What the subdivision rules do at a vertex (the number of its crease edges tells, unless the
// user tags a corner). A border edge counts as a crease edge.
enum class VertexKind : std::uint8_t {
  kSmooth,  // no crease edge
  kDart,    // one: a crease fades out here
  kCrease,  // two
  kCorner,  // three or more, or tagged a corner and at least two: interpolated
  kCone     // tagged a corner with fewer than two: an interpolated point, a cone's tip
};

// Half-edge topology of a manifold polygon mesh with border, with crease edges and vertex kinds.
//
// Half-edge h belongs to one face and runs, counter-clockwise around it, from origin(h) to the
// origin of next(h). Half-edges of face f are first_half_edge(f) … +face_size(f)-1, in the order of
// the face's corners. A *sector* of a vertex is a maximal fan of its faces not crossed by a crease.
//
// Values are immutable after construction. Queries cost O(1).
class Topology {
 public:
  // REQUIRES: the arrays have passed check_mesh() without errors. `creases` may name border edges
  // and edges that no face has (ignored). A border vertex of a single face is a corner unless
  // `round_border_corners`.
  Topology(int vertex_count, const std::vector<int>& face_sizes,
           const std::vector<int>& face_vertices, const std::vector<std::array<int, 2>>& creases,
           const std::vector<int>& corners, bool round_border_corners = false);

  int vertex_count() const { return static_cast<int>(kind_.size()); }
  int face_count() const { return static_cast<int>(face_begin_.size()) - 1; }
  int edge_count() const { return edge_count_; }
  int half_edge_count() const { return static_cast<int>(origin_.size()); }

  int first_half_edge(int face) const { return face_begin_[face]; }
  int face_size(int face) const { return face_begin_[face + 1] - face_begin_[face]; }

  int origin(int h) const { return origin_[h]; }
  int face(int h) const { return face_[h]; }
  int twin(int h) const { return twin_[h]; }  // -1 at a border
  int edge(int h) const { return edge_[h]; }  // the same for both half-edges of an edge
  int next(int h) const {
    const int f = face_[h];
    return h + 1 == face_begin_[f + 1] ? face_begin_[f] : h + 1;
  }
  int prev(int h) const {
    const int f = face_[h];
    return h == face_begin_[f] ? face_begin_[f + 1] - 1 : h - 1;
  }
  bool is_crease(int h) const { return crease_[h] != 0; }  // borders included
  VertexKind kind(int vertex) const { return kind_[vertex]; }
  VertexKind kind_at(int h) const { return kind_[origin_[h]]; }
  // Number of faces of the origin's sector that holds face(h); of the whole fan where no crease
  // divides it.
  int sector_faces(int h) const { return sector_faces_[h]; }
  // A half-edge leaving the vertex (at a border, the one whose clockwise side is open); -1 for a
  // vertex without faces.
  int outgoing(int vertex) const { return outgoing_[vertex]; }
  // Whether h is the half-edge that gives its edge its direction.
  bool is_edge_front(int h) const { return twin_[h] < 0 || h < twin_[h]; }

  // Topology of the once-subdivided mesh. Vertices: first the vertex points, then the face points,
  // then the edge points, each in the order of what they come from. Face (cell) c comes from
  // half-edge c: its half-edges 4c … 4c+3 start at the vertex point of origin(c), the edge point of
  // c, the face point, and the edge point of prev(c).
  Topology refined() const;

 private:
  Topology() = default;
  void find_edges(const std::vector<int>& face_sizes, const std::vector<int>& face_vertices);
  void find_outgoing();
  void find_sectors();
  void find_kinds(const std::vector<int>& corners, bool round_border_corners);

  int edge_count_ = 0;
  std::vector<int> face_begin_;
  std::vector<int> origin_, face_, twin_, edge_;
  std::vector<std::uint8_t> crease_;
  std::vector<int> sector_faces_;
  std::vector<VertexKind> kind_;
  std::vector<int> outgoing_;
};

// Walks around the origin of h, within its sector. All return a half-edge with the same origin.
// The next one counter-clockwise, or -1 when a crease (or border) is met.
template <class T>
int turn_left(const T& t, int h) {
  const int p = t.prev(h);
  return t.is_crease(p) ? -1 : t.twin(p);
}
// The next one clockwise, or -1 when a crease (or border) is met.
template <class T>
int turn_right(const T& t, int h) {
  return t.is_crease(h) ? -1 : t.next(t.twin(h));
}

}  // namespace hull::mesh
