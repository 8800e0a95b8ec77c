// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/parent_faces.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

namespace hull::mesh {
namespace {

// The phase of a half-edge is where it begins: at a vertex point, in the middle of an edge on its
// way to that of a face, there, and, 3, in the middle of an edge on its way back.
constexpr int kAtVertex = 0, kToFace = 1, kAtFace = 2;
constexpr int kUnknown = -1;

// What is at odds with one way of taking the mesh for a subdivided one.
struct Oddities {
  int count = 0;
  std::string first;
  void add(const std::string& what) {
    if (count++ == 0) first = what;
  }
};

std::string name_of(int vertex) { return "point " + std::to_string(vertex); }

// One connected part of a mesh, taken for a subdivided one in one way.
class Part {
 public:
  // The part that `face` is of, with its first half-edge beginning in phase `start`. `phase` holds
  // kUnknown for all half-edges, and does so again when the part is gone.
  Part(const Topology& mesh, int face, int start, std::vector<int>& phase)
      : mesh_(mesh), phase_(phase) {
    spread(face, start);
    for (int f : faces_) {
      for (int k = 0; k < 4; ++k) check(mesh.first_half_edge(f) + k);
    }
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  // Only what was written is put back: many small parts of a large mesh cost no more than one.
  ~Part() {
    for (int f : faces_) forget(f);
  }

  const Oddities& oddities() const { return oddities_; }
  const std::vector<int>& faces() const { return faces_; }

  // REQUIRES: no oddities. To be called once.
  ParentFaces take_parents() {
    ParentFaces result;
    for (int f : faces_) {
      int h = mesh_.first_half_edge(f);
      // Its cell went to a parent's face before.
      if (phase_[h] == kUnknown) continue;
      // Without oddities each face has all four phases, one after the other.
      while (phase_[h] != kAtVertex) ++h;
      int size = 0;
      // Neither border nor crease runs into a parent's face, so that the turn ends where it began,
      // at a cell that is taken already.
      for (; phase_[h] != kUnknown; ++size) {
        result.cells.push_back(h);
        forget(mesh_.face(h));
        // The next cell around the face's middle, across the edge that leads there.
        h = mesh_.prev(mesh_.prev(mesh_.twin(mesh_.next(h))));
      }
      result.sizes.push_back(size);
    }
    return result;
  }

 private:
  void forget(int face) {
    for (int k = 0; k < 4; ++k) phase_[mesh_.first_half_edge(face) + k] = kUnknown;
  }

  void spread(int face, int start) {
    std::vector<int> waiting;
    // A half-edge's phase decides those of its face; these decide, across the edges, the
    // neighbours'.
    const auto enter = [&](int h, int phase) {
      if (phase_[h] != kUnknown) {
        if (phase_[h] != phase) {
          oddities_.add("the rows of faces around " + name_of(mesh_.origin(h)) +
                        " do not alternate");
        }
        return;
      }
      faces_.push_back(mesh_.face(h));
      for (int k = 0; k < 4; ++k, h = mesh_.next(h)) {
        phase_[h] = (phase + k) % 4;
        waiting.push_back(h);
      }
    };
    enter(mesh_.first_half_edge(face), start);
    while (!waiting.empty()) {
      const int h = waiting.back();
      waiting.pop_back();
      // Seen from the other side the way from a vertex, 0, is the one back to it, 3; and so are 1
      // and 2.
      if (mesh_.twin(h) >= 0) enter(mesh_.twin(h), 3 - phase_[h]);
    }
    // In the order of the mesh, whichever way the part was walked.
    std::sort(faces_.begin(), faces_.end());
  }

  // Whether the edge of h, and the point at which it begins, are what the phase says; a point once.
  void check(int h) {
    const std::string name = name_of(mesh_.origin(h));
    const int phase = phase_[h];
    if (phase == kToFace || phase == kAtFace) {
      if (mesh_.twin(h) < 0) {
        oddities_.add("a border would run into a face at " + name);
      } else if (mesh_.is_crease(h)) {
        oddities_.add("a crease would run into a face at " + name);
      }
    }
    // Vertex points may be of any kind, with any number of faces.
    if (mesh_.outgoing(mesh_.origin(h)) != h || phase == kAtVertex) return;
    const VertexKind kind = mesh_.kind(mesh_.origin(h));
    const int faces = faces_around(h);
    if (phase == kAtFace) {
      if (kind != VertexKind::kSmooth)
        oddities_.add(name + " would be the middle of a face, and is tagged");
      if (faces < 3) oddities_.add(name + " would be the middle of a face with two corners");
      return;
    }
    // At a border outgoing() is the half-edge without a twin.
    const int wanted = mesh_.twin(h) < 0 ? 2 : 4;
    if (faces != wanted) {
      oddities_.add(name + " needs " + std::to_string(wanted) +
                    " faces around it to be the middle of an edge, and has " +
                    std::to_string(faces));
    } else if (kind != VertexKind::kSmooth && kind != VertexKind::kCrease) {
      oddities_.add(name + " would be the middle of an edge, and is a corner or a crease's end");
    }
  }

  int faces_around(int h) const {
    int count = 0, i = h;
    do {
      ++count;
      i = mesh_.twin(mesh_.prev(i));
    } while (i >= 0 && i != h);
    return count;
  }

  const Topology& mesh_;
  std::vector<int>& phase_;  // of half-edges
  std::vector<int> faces_;
  Oddities oddities_;
};

void refuse_other_faces(const Topology& mesh) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face_size(f) == 4) continue;
    throw std::invalid_argument("The mesh is no subdivided one: a face at point " +
                                std::to_string(mesh.origin(mesh.first_half_edge(f))) + " has " +
                                std::to_string(mesh.face_size(f)) +
                                " corners instead of four. Take back what changed faces there.");
  }
}

}  // namespace

std::vector<std::vector<ParentFaces>> parent_faces(const Topology& mesh) {
  refuse_other_faces(mesh);
  std::vector<std::vector<ParentFaces>> parts;
  std::vector<char> is_known(mesh.face_count(), 0);
  std::vector<int> phase(mesh.half_edge_count(), kUnknown);
  for (int face = 0; face < mesh.face_count(); ++face) {
    if (is_known[face]) continue;
    std::vector<ParentFaces> ways;
    std::optional<Oddities> least;
    // The phase of one half-edge decides those of its whole part: there are four ways at most.
    for (int start = 0; start < 4; ++start) {
      Part part(mesh, face, start, phase);
      for (int f : part.faces()) is_known[f] = 1;
      if (part.oddities().count == 0) {
        ways.push_back(part.take_parents());
      } else if (!least || part.oddities().count < least->count) {
        least = part.oddities();
      }
    }
    if (ways.empty()) {
      throw std::invalid_argument("The mesh is no subdivided one: " + least->first +
                                  ". Take back what changed faces or creases there.");
    }
    parts.push_back(std::move(ways));
  }
  return parts;
}

}  // namespace hull::mesh
