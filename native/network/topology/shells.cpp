// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/topology/shells.h"

#include <algorithm>

namespace hull::network {
namespace {

void require_shells(bool is_so, const std::string& otherwise) {
  if (!is_so) throw std::invalid_argument(otherwise);
}

std::string half_edges_named(int a, int b) {
  return "Half-edges " + std::to_string(a) + " and " + std::to_string(b);
}

}  // namespace

int Shells::mate(int half) const {
  const Edge& edge = edges_[half_edges_[half].edge];
  return edge.halves[edge.halves[0] == half ? 1 : 0];
}

std::vector<int> Shells::half_edges_of(int loop) const {
  std::vector<int> all;
  const int first = loops_.at(loop).first;
  int half = first;
  do {
    all.push_back(half);
    half = half_edges_[half].next;
  } while (half != first);
  return all;
}

ElementCounts Shells::counts() const {
  int holes = 0;
  for (int shell : shells_.numbers()) holes += shells_[shell].holes;
  return {vertices_.count(), edges_.count(), faces_.count(), loops_.count() - faces_.count(),
          shells_.count(),   holes};
}

void Shells::link(int half, int next) {
  half_edges_[half].next = next;
  half_edges_[next].previous = half;
}

int Shells::bare_half_edge(int vertex, int loop) {
  const int half = half_edges_.add({.vertex = vertex, .loop = loop});
  // The only half-edge of a vertex without edges follows itself.
  link(half, half);
  vertices_[vertex].half_edge = half;
  loops_[loop].first = half;
  return half;
}

int Shells::new_edge(int curve) { return edges_.add({.curve = curve}); }

int Shells::insert_before(int half, int vertex, int edge) {
  // The half-edge that stands for a vertex without edges becomes that of its first edge.
  int added = half;
  if (!is_bare(half)) {
    added = half_edges_.add({.vertex = vertex, .loop = half_edges_[half].loop});
    link(half_edges_[half].previous, added);
    link(added, half);
  }
  half_edges_[added].edge = edge;
  int* halves = edges_[edge].halves;
  // Which of both comes first does not matter: mate() finds the other.
  halves[halves[0] < 0 ? 0 : 1] = added;
  vertices_[vertex].half_edge = added;
  return added;
}

void Shells::take_loop(int first, int loop) {
  loops_[loop].first = first;
  int half = first;
  do {
    half_edges_[half].loop = loop;
    half = half_edges_[half].next;
  } while (half != first);
}

void Shells::close_ring(bool is_empty, int from, int to, int vertex, int loop) {
  if (is_empty) {
    bare_half_edge(vertex, loop);
    return;
  }
  link(to, from);
  vertices_[vertex].half_edge = from;
  take_loop(from, loop);
}

void Shells::remove_edge(int half) {
  const int other = mate(half);
  edges_.remove(half_edges_[half].edge);
  half_edges_.remove(half);
  half_edges_.remove(other);
}

void Shells::remove_inner(int face, int loop) { std::erase(faces_[face].inner, loop); }

Shells::NewShell Shells::make_vertex_face_shell() {
  const int shell = shells_.add({}), vertex = vertices_.add({});
  const int face = faces_.add({.outer = -1, .inner = {}, .shell = shell});
  const int loop = loops_.add({.face = face});
  faces_[face].outer = loop;
  return {shell, face, vertex, bare_half_edge(vertex, loop)};
}

void Shells::kill_vertex_face_shell(int shell) {
  shells_.at(shell);
  std::vector<int> faces = faces_.numbers();
  std::erase_if(faces, [&](int face) { return faces_[face].shell != shell; });
  const Face& face = faces_[faces.front()];
  const int half = loops_[face.outer].first;
  require_shells(faces.size() == 1 && face.inner.empty() && is_bare(half),
                 "Shell " + std::to_string(shell) + " is more than a vertex.");
  vertices_.remove(half_edges_[half].vertex);
  half_edges_.remove(half);
  loops_.remove(face.outer);
  faces_.remove(faces.front());
  shells_.remove(shell);
}

// Here as below all that may be refused is asked first: then nothing is left half changed.
Shells::NewEdge Shells::make_edge_vertex(int first, int last, int curve) {
  const int old = half_edges_.at(first).vertex;
  require_shells(half_edges_.at(last).vertex == old,
                 half_edges_named(first, last) + " begin at two vertices.");
  const int vertex = vertices_.add({}), edge = new_edge(curve);
  for (int half = first; half != last;) {
    const int following = clockwise(half);
    half_edges_[half].vertex = vertex;
    half = following;
  }
  // In this order: where both are one half-edge, `half` and `mate` come before it one after the
  // other, and a bare one is taken by `half`.
  const int half = insert_before(first, old, edge);
  return {half, insert_before(last, vertex, edge), vertex, -1};
}

Shells::NewEdge Shells::make_edge_face(int first, int last, int curve) {
  const int loop = half_edges_.at(first).loop;
  require_shells(half_edges_.at(last).loop == loop,
                 half_edges_named(first, last) + " are of two loops.");
  const int from = half_edges_[first].vertex, to = half_edges_[last].vertex;
  const int before_first = half_edges_[first].previous, before_last = half_edges_[last].previous;
  const bool was_bare = is_bare(first);
  const int edge = new_edge(curve);
  const int face = faces_.add({.outer = -1, .inner = {}, .shell = faces_[loops_[loop].face].shell});
  const int part = loops_.add({.face = face});
  faces_[face].outer = part;
  // One loop becomes that of `half` and of all from `last` to before `first`, the other one that of
  // `mate` and of all from `first` to before `last`.
  const int half = was_bare ? first : half_edges_.add({.vertex = from});
  const int mate = half_edges_.add({.vertex = to, .edge = edge});
  half_edges_[half].edge = edge;
  edges_[edge].halves[0] = half;
  edges_[edge].halves[1] = mate;
  if (!was_bare) {
    link(before_first, half);
    link(half, last);
  }
  if (first == last) {
    link(mate, mate);
  } else {
    link(before_last, mate);
    link(mate, first);
  }
  take_loop(half, loop);
  take_loop(mate, part);
  return {half, mate, -1, face};
}

int Shells::kill_edge_make_loop(int half) {
  // Copies: what they link is asked for after they are gone.
  const HalfEdge going = half_edges_.at(half);
  require_shells(!is_bare(half) && half_edges_[mate(half)].loop == going.loop,
                 "Half-edge " + std::to_string(half) + " has not one loop on both sides.");
  const int other = mate(half);
  const HalfEdge coming = half_edges_[other];
  const int face = loops_[going.loop].face;
  // The face is kept: it is a loop of it that falls in two.
  const int inner = loops_.add({.face = face});
  faces_[face].inner.push_back(inner);
  remove_edge(half);
  // What comes back to the beginning of `half` keeps the loop; what goes on from its end is inner.
  close_ring(coming.next == half, coming.next, going.previous, going.vertex, going.loop);
  close_ring(going.next == other, going.next, coming.previous, coming.vertex, inner);
  return inner;
}

Shells::NewEdge Shells::make_edge_kill_loop(int first, int second, int curve) {
  int kept = half_edges_.at(first).loop, killed = half_edges_.at(second).loop;
  const int face = loops_[kept].face;
  require_shells(kept != killed && loops_[killed].face == face,
                 half_edges_named(first, second) + " are not of two loops of one face.");
  // Whichever was named first, it is the inner loop that goes: a face needs its outer one.
  if (faces_[face].outer == killed) std::swap(kept, killed);
  const int from = half_edges_[first].vertex, to = half_edges_[second].vertex;
  const int before_first = half_edges_[first].previous,
            before_second = half_edges_[second].previous;
  const bool is_first_bare = is_bare(first), is_second_bare = is_bare(second);
  const int edge = new_edge(curve);
  const int half = is_first_bare ? first : half_edges_.add({.vertex = from});
  const int mate = is_second_bare ? second : half_edges_.add({.vertex = to});
  half_edges_[half].edge = half_edges_[mate].edge = edge;
  edges_[edge].halves[0] = half;
  edges_[edge].halves[1] = mate;
  // … before first, half, second … before second, mate, first …
  if (!is_first_bare) link(before_first, half);
  if (!is_second_bare) link(before_second, mate);
  link(half, is_second_bare ? mate : second);
  link(mate, is_first_bare ? half : first);
  take_loop(half, kept);
  remove_inner(face, killed);
  loops_.remove(killed);
  return {half, mate, -1, -1};
}

void Shells::kill_edge_vertex(int half) {
  const HalfEdge going = half_edges_.at(half);
  require_shells(!is_bare(half) && end_of(half) != going.vertex,
                 "Half-edge " + std::to_string(half) + " does not end at another vertex.");
  const int other = mate(half);
  const HalfEdge coming = half_edges_[other];
  // What begins at the vertex that goes begins at the other one from now on.
  for (int around = clockwise(other); around != other; around = clockwise(around)) {
    half_edges_[around].vertex = going.vertex;
  }
  const bool is_alone = going.next == other && coming.next == half;
  // Each leaves its loop; they may follow one another.
  const int left = going.next == other ? coming.next : going.next;
  const int right = coming.next == half ? going.next : coming.next;
  if (!is_alone) {
    link(going.previous, going.next);
    link(half_edges_[other].previous, half_edges_[other].next);
    loops_[going.loop].first = left;
    loops_[coming.loop].first = right;
    vertices_[going.vertex].half_edge = right;
  }
  vertices_.remove(coming.vertex);
  remove_edge(half);
  if (is_alone) bare_half_edge(going.vertex, going.loop);
}

void Shells::kill_edge_face(int half) {
  const HalfEdge going = half_edges_.at(half);
  require_shells(!is_bare(half), "Half-edge " + std::to_string(half) + " has no edge.");
  const int other = mate(half);
  const HalfEdge coming = half_edges_[other];
  const int killed = loops_[coming.loop].face;
  require_shells(killed != loops_[going.loop].face && faces_[killed].inner.empty(),
                 "Face " + std::to_string(killed) + ", beyond half-edge " + std::to_string(half) +
                     ", is the same or has inner loops.");
  // A half whose loop it is alone goes around by itself: then there is nothing before or behind it
  // to be linked, and where that is so on both sides the vertex is left bare.
  const bool is_loop = going.next == half, is_other_loop = coming.next == other;
  remove_edge(half);
  if (is_loop) {
    close_ring(is_other_loop, coming.next, coming.previous, going.vertex, going.loop);
  } else {
    // What is before `half` goes on with what follows its mate, and the other way round.
    if (!is_other_loop) link(going.previous, coming.next);
    close_ring(false, going.next, is_other_loop ? going.previous : coming.previous, coming.vertex,
               going.loop);
    vertices_[going.vertex].half_edge = is_other_loop ? going.next : coming.next;
  }
  loops_.remove(coming.loop);
  faces_.remove(killed);
}

void Shells::kill_face_make_loop_hole(int face, int other) {
  const int shell = faces_.at(face).shell, other_shell = faces_.at(other).shell;
  require_shells(face != other && faces_[other].inner.empty(),
                 "Face " + std::to_string(other) + " is the same or has inner loops.");
  const int loop = faces_[other].outer;
  loops_[loop].face = face;
  faces_[face].inner.push_back(loop);
  faces_.remove(other);
  // Within one shell the joint is a handle; else it makes one shell of two.
  if (shell == other_shell) {
    ++shells_[shell].holes;
    return;
  }
  for (int number : faces_.numbers()) {
    if (faces_[number].shell == other_shell) faces_[number].shell = shell;
  }
  shells_[shell].holes += shells_[other_shell].holes;
  shells_.remove(other_shell);
}

int Shells::make_face_kill_loop_hole(int loop) {
  const int face = loops_.at(loop).face;
  require_shells(faces_[face].outer != loop,
                 "Loop " + std::to_string(loop) + " is the outer one of its face.");
  remove_inner(face, loop);
  const int made = faces_.add({.outer = loop, .inner = {}, .shell = faces_[face].shell});
  loops_[loop].face = made;
  separate(face, made);
  return made;
}

// What a loop held together is one shell with a hole less, or two.
void Shells::separate(int face, int new_face) {
  const std::vector<int> part = connected_faces(new_face);
  const int shell = faces_[face].shell;
  if (std::ranges::find(part, face) != part.end()) {
    --shells_[shell].holes;
    return;
  }
  const int genus = genus_of(part);
  shells_[shell].holes -= genus;
  const int made = shells_.add({.holes = genus});
  for (int number : part) faces_[number].shell = made;
}

std::vector<int> Shells::connected_faces(int face) const {
  faces_.at(face);
  std::vector<bool> is_seen(static_cast<std::size_t>(faces_.end()), false);
  std::vector<int> found{face};
  is_seen[static_cast<std::size_t>(face)] = true;
  const auto walk = [&](int loop) {
    for (int half : half_edges_of(loop)) {
      if (is_bare(half)) continue;
      const int beyond = face_of(mate(half));
      if (is_seen[static_cast<std::size_t>(beyond)]) continue;
      is_seen[static_cast<std::size_t>(beyond)] = true;
      found.push_back(beyond);
    }
  };
  // By inner loops, too: it is these that hold the rings of a face together.
  for (std::size_t i = 0; i < found.size(); ++i) {
    walk(faces_[found[i]].outer);
    for (int loop : faces_[found[i]].inner) walk(loop);
  }
  return found;
}

// By V + F - E - L = 2 (1 - genus), as it holds for one shell.
int Shells::genus_of(const std::vector<int>& faces) const {
  int sum = 0;
  // Each half-edge begins at one vertex, and each vertex has one: so all are met, if several times.
  std::vector<int> vertices;
  int half_edges = 0;
  const auto count = [&](int loop) {
    for (int half : half_edges_of(loop)) {
      vertices.push_back(half_edges_[half].vertex);
      if (!is_bare(half)) ++half_edges;
    }
  };
  for (int face : faces) {
    sum += 1 - static_cast<int>(faces_[face].inner.size());
    count(faces_[face].outer);
    for (int loop : faces_[face].inner) count(loop);
  }
  std::ranges::sort(vertices);
  const auto repeated = std::unique(vertices.begin(), vertices.end());
  sum += static_cast<int>(repeated - vertices.begin()) - half_edges / 2;
  return 1 - sum / 2;
}

}  // namespace hull::network
