// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "network/topology/shells.h"

namespace hull::network {
namespace {

std::string of(const char* what, int number, const char* fault) {
  return std::string(what) + " " + std::to_string(number) + " " + fault;
}

std::string half_edge_fault(const Shells& shells, int number) {
  const HalfEdge& half = shells.half_edges()[number];
  const auto& all = shells.half_edges();
  if (!all.has(half.next) || all[half.next].previous != number) {
    return of("half-edge", number, "is not before its next");
  }
  if (!shells.loops().has(half.loop) || all[half.next].loop != half.loop) {
    return of("half-edge", number, "is of another loop than its next");
  }
  if (!shells.vertices().has(half.vertex)) return of("half-edge", number, "has no vertex");
  if (half.edge < 0) {
    return half.next == number ? "" : of("half-edge", number, "has no edge and is not alone");
  }
  if (!shells.edges().has(half.edge)) return of("half-edge", number, "has a removed edge");
  const int* halves = shells.edges()[half.edge].halves;
  if (halves[0] == halves[1] || (halves[0] != number && halves[1] != number)) {
    return of("half-edge", number, "is none of its edge's");
  }
  if (shells.end_of(number) != all[half.next].vertex) {
    return of("half-edge", number, "ends elsewhere than its next begins");
  }
  return "";
}

// Half-edges that begin at a vertex are all met by going around it.
std::string vertex_fault(const Shells& shells, int vertex, int beginning) {
  const int first = shells.vertices()[vertex].half_edge;
  if (!shells.half_edges().has(first) || shells.half_edges()[first].vertex != vertex) {
    return of("vertex", vertex, "has a half-edge that begins elsewhere");
  }
  if (shells.half_edges()[first].edge < 0) {
    return beginning == 1 ? "" : of("vertex", vertex, "is alone and has edges");
  }
  int met = 0, half = first;
  do {
    ++met;
    half = shells.clockwise(half);
    // Broken links may go around another vertex, and never come back.
  } while (half != first && met <= beginning);
  return met == beginning ? "" : of("vertex", vertex, "has more than one ring of half-edges");
}

std::string loop_fault(const Shells& shells, int number) {
  const Loop& loop = shells.loops()[number];
  if (!shells.faces().has(loop.face)) return of("loop", number, "has no face");
  if (!shells.half_edges().has(loop.first) || shells.half_edges()[loop.first].loop != number) {
    return of("loop", number, "begins with a half-edge of another one");
  }
  const Face& face = shells.faces()[loop.face];
  const bool is_inner = std::ranges::find(face.inner, number) != face.inner.end();
  return is_inner != (face.outer == number) ? "" : of("loop", number, "is none of its face's");
}

// Shells are what is connected, each with the holes that the formula gives it.
std::string connection_fault(const Shells& shells) {
  std::vector<int> shell_of_component;
  std::vector<bool> is_seen(static_cast<std::size_t>(shells.faces().end()), false);
  for (int face : shells.faces().numbers()) {
    if (is_seen[static_cast<std::size_t>(face)]) continue;
    const int shell = shells.faces()[face].shell;
    if (!shells.shells().has(shell)) return of("face", face, "has no shell");
    shell_of_component.push_back(shell);
    for (int other : shells.connected_faces(face)) {
      is_seen[static_cast<std::size_t>(other)] = true;
      if (shells.faces()[other].shell != shell) return of("face", other, "is of another shell");
    }
  }
  // As many as there are, and each once: so all shells have faces, too.
  std::ranges::sort(shell_of_component);
  if (std::ranges::adjacent_find(shell_of_component) != shell_of_component.end() ||
      static_cast<int>(shell_of_component.size()) != shells.shells().count()) {
    return "shells are not what is connected";
  }
  return "";
}

}  // namespace

std::string shells_fault(const Shells& shells) {
  // Links first: all that follows walks along them.
  std::vector<int> beginning(static_cast<std::size_t>(shells.vertices().end()), 0);
  for (int half : shells.half_edges().numbers()) {
    if (std::string fault = half_edge_fault(shells, half); !fault.empty()) return fault;
    ++beginning[static_cast<std::size_t>(shells.half_edges()[half].vertex)];
  }
  std::vector<int> of_loops(static_cast<std::size_t>(shells.loops().end()), 0);
  for (int loop : shells.loops().numbers()) {
    if (std::string fault = loop_fault(shells, loop); !fault.empty()) return fault;
    of_loops[static_cast<std::size_t>(loop)] = static_cast<int>(shells.half_edges_of(loop).size());
  }
  int in_loops = 0;
  for (int count : of_loops) in_loops += count;
  // Each ring is of the loop that its half-edges name; a second one of a loop is told by the count.
  if (in_loops != shells.half_edges().count()) return "a half-edge is in no ring of its loop";
  for (int vertex : shells.vertices().numbers()) {
    const int count = beginning[static_cast<std::size_t>(vertex)];
    if (std::string fault = vertex_fault(shells, vertex, count); !fault.empty()) return fault;
  }
  if (std::string fault = connection_fault(shells); !fault.empty()) return fault;
  return shells.counts().excess() == 0 ? "" : "the formula of Euler and Poincaré does not hold";
}

}  // namespace hull::network
