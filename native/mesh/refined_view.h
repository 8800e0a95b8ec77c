// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/topology.h"

namespace hull::mesh {

// The topology of a once more subdivided mesh, computed on demand from the coarser one: the same
// queries as Topology, with nothing stored. Numbering as in Topology::refined(). `Base` is Topology
// or again a RefinedView, and must outlive the view.
template <class Base>
class RefinedView {
 public:
  explicit RefinedView(const Base& base) : base_(&base) {}

  int vertex_count() const {
    return base_->vertex_count() + base_->face_count() + base_->edge_count();
  }
  int face_count() const { return base_->half_edge_count(); }
  int edge_count() const { return 2 * base_->edge_count() + base_->half_edge_count(); }
  int half_edge_count() const { return 4 * base_->half_edge_count(); }

  int first_half_edge(int face) const { return 4 * face; }
  int face_size(int) const { return 4; }
  int face(int h) const { return h / 4; }
  int next(int h) const { return (h & 3) == 3 ? h - 3 : h + 1; }
  int prev(int h) const { return (h & 3) == 0 ? h + 3 : h - 1; }

  int origin(int h) const {
    const int c = h / 4;
    switch (h & 3) {
      case 0:
        return base_->origin(c);
      case 1:
        return edge_point(c);
      case 2:
        return base_->vertex_count() + base_->face(c);
      default:
        return edge_point(base_->prev(c));
    }
  }

  int twin(int h) const {
    const int c = h / 4;
    switch (h & 3) {
      case 0: {
        const int t = base_->twin(c);
        return t < 0 ? -1 : 4 * base_->next(t) + 3;
      }
      case 1:
        return 4 * base_->next(c) + 2;
      case 2:
        return 4 * base_->prev(c) + 1;
      default: {
        const int t = base_->twin(base_->prev(c));
        return t < 0 ? -1 : 4 * t;
      }
    }
  }

  // The halves of coarse edge e are 2e (at the origin of its front half-edge) and 2e + 1; the edges
  // from edge points to face points follow in the order of the coarse half-edges.
  int edge(int h) const {
    const int c = h / 4;
    switch (h & 3) {
      case 0:
        return 2 * base_->edge(c) + (base_->is_edge_front(c) ? 0 : 1);
      case 1:
        return 2 * base_->edge_count() + c;
      case 2:
        return 2 * base_->edge_count() + base_->prev(c);
      default: {
        const int p = base_->prev(c);
        return 2 * base_->edge(p) + (base_->is_edge_front(p) ? 1 : 0);
      }
    }
  }

  bool is_edge_front(int h) const {
    const int t = twin(h);
    return t < 0 || h < t;
  }

  bool is_crease(int h) const {
    switch (h & 3) {
      case 0:
        return base_->is_crease(h / 4);
      case 3:
        return base_->is_crease(base_->prev(h / 4));
      default:
        return false;
    }
  }

  VertexKind kind_at(int h) const {
    switch (h & 3) {
      case 0:
        return base_->kind_at(h / 4);
      case 2:
        return VertexKind::kSmooth;
      default:
        return is_crease(h) || is_crease(prev(h)) ? VertexKind::kCrease : VertexKind::kSmooth;
    }
  }

  int sector_faces(int h) const {
    const int c = h / 4;
    switch (h & 3) {
      case 0:
        return base_->sector_faces(c);
      case 1:
        return base_->is_crease(c) ? 2 : 4;
      case 2:
        return base_->face_size(base_->face(c));
      default:
        return base_->is_crease(base_->prev(c)) ? 2 : 4;
    }
  }

 private:
  int edge_point(int coarse_half_edge) const {
    return base_->vertex_count() + base_->face_count() + base_->edge(coarse_half_edge);
  }

  const Base* base_;
};

}  // namespace hull::mesh
