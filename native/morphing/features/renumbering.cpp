// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/renumbering.h"

#include <limits>

#include "morphing/features/hull_box.h"

namespace hull::morphing {
namespace {

using mesh::Topology;

constexpr int kFree = -1;

// A map of half-edges and vertices that grows from one half-edge, body by body.
class Isomorphism {
 public:
  Isomorphism(const Topology& from, const Topology& to)
      : from_(from),
        to_(to),
        image_(from.half_edge_count(), kFree),
        vertex_image_(from.vertex_count(), kFree),
        is_taken_(to.half_edge_count(), 0),
        is_vertex_taken_(to.vertex_count(), 0) {}

  const std::vector<int>& vertices() const { return vertex_image_; }
  int image(int h) const { return image_[h]; }
  bool is_taken(int h) const { return is_taken_[h] != 0; }
  // Vertices of the body that was mapped last.
  const std::vector<int>& last_body() const { return body_; }

  // Maps the body of half-edge h so that h goes to k; leaves all as it was where that fails.
  bool extend(int h, int k) {
    edges_.clear();
    body_.clear();
    // One pair decides all of a body: every other one is reached by next() and twin().
    std::vector<std::pair<int, int>> open{{h, k}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (image_[a] == b) continue;
      if (!take(a, b)) {
        withdraw();
        return false;
      }
      open.emplace_back(from_.next(a), to_.next(b));
      if (from_.twin(a) >= 0) open.emplace_back(from_.twin(a), to_.twin(b));
    }
    return true;
  }

  void withdraw() {
    for (int a : edges_) {
      is_taken_[image_[a]] = 0;
      image_[a] = kFree;
    }
    for (int v : body_) {
      is_vertex_taken_[vertex_image_[v]] = 0;
      vertex_image_[v] = kFree;
    }
    edges_.clear();
    body_.clear();
  }

 private:
  bool take(int a, int b) {
    if (image_[a] != kFree || is_taken_[b] || from_.is_crease(a) != to_.is_crease(b) ||
        (from_.twin(a) < 0) != (to_.twin(b) < 0) ||
        from_.face_size(from_.face(a)) != to_.face_size(to_.face(b))) {
      return false;
    }
    // A vertex is reached by each of its half-edges, and must go to one place by all.
    const int v = from_.origin(a), w = to_.origin(b);
    if (vertex_image_[v] == kFree) {
      // Kinds tell tags of corners, which no half-edge has.
      if (is_vertex_taken_[w] || from_.kind(v) != to_.kind(w)) return false;
      vertex_image_[v] = w;
      is_vertex_taken_[w] = 1;
      body_.push_back(v);
    } else if (vertex_image_[v] != w) {
      return false;
    }
    image_[a] = b;
    is_taken_[b] = 1;
    edges_.push_back(a);
    return true;
  }

  const Topology& from_;
  const Topology& to_;
  std::vector<int> image_, vertex_image_;
  std::vector<char> is_taken_, is_vertex_taken_;
  std::vector<int> edges_, body_;
};

}  // namespace

std::optional<std::vector<int>> renumbering(const mesh::ControlMesh& mesh,
                                            const mesh::ControlMesh& other) {
  const Topology &from = mesh.topology(), &to = other.topology();
  if (from.half_edge_count() != to.half_edge_count() || from.vertex_count() != to.vertex_count() ||
      from.face_count() != to.face_count()) {
    return std::nullopt;
  }
  const HullBox box = box_of(mesh.points()), other_box = box_of(other.points());
  Isomorphism map(from, to);
  for (int h = 0; h < from.half_edge_count(); ++h) {
    if (map.image(h) != kFree) continue;
    // Bodies that are symmetric, or alike, go onto one another in several ways: of these the
    // nearest is meant.
    int best = kFree;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < to.half_edge_count(); ++k) {
      if (map.is_taken(k) || !map.extend(h, k)) continue;
      double sum = 0.0;
      for (int v : map.last_body()) {
        const int w = map.vertices()[v];
        sum +=
            (box.relative(mesh.points()[v]) - other_box.relative(other.points()[w])).squaredNorm();
      }
      // All ways are looked at first: the best one is taken again below.
      map.withdraw();
      if (sum >= least) continue;
      least = sum;
      best = k;
    }
    if (best == kFree) return std::nullopt;
    map.extend(h, best);
  }
  for (int image : map.vertices()) {
    // A point without faces belongs to no body.
    if (image == kFree) return std::nullopt;
  }
  return map.vertices();
}

}  // namespace hull::morphing
