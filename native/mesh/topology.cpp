// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/topology.h"

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefiner.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <cassert>
#include <memory>

#include "mesh/refined_view.h"

namespace hull::mesh {

namespace far = OpenSubdiv::OPENSUBDIV_VERSION::Far;

Topology::Topology(int vertex_count, const std::vector<int>& face_sizes,
                   const std::vector<int>& face_vertices,
                   const std::vector<std::array<int, 2>>& creases, const std::vector<int>& corners,
                   bool round_border_corners) {
  kind_.resize(vertex_count);
  face_begin_.reserve(face_sizes.size() + 1);
  face_begin_.push_back(0);
  for (int size : face_sizes) face_begin_.push_back(face_begin_.back() + size);
  origin_ = face_vertices;
  face_.resize(origin_.size());
  for (int f = 0; f < face_count(); ++f) {
    for (int h = face_begin_[f]; h < face_begin_[f + 1]; ++h) face_[h] = f;
  }
  find_edges(face_sizes, face_vertices);
  find_outgoing();
  crease_.resize(origin_.size());
  for (int h = 0; h < half_edge_count(); ++h) crease_[h] = twin_[h] < 0;
  // The half-edges of a vertex are found by walking its fan, which creases do not bound yet.
  for (const auto& [a, b] : creases) {
    const int start = outgoing_[a];
    for (int h = start; h >= 0;) {
      const int incoming = prev(h);
      // By half-edges that leave a and such that come in: of a border there is one only.
      if (origin_[next(h)] == b) {
        crease_[h] = 1;
        if (twin_[h] >= 0) crease_[twin_[h]] = 1;
      }
      if (origin_[incoming] == b) {
        crease_[incoming] = 1;
        if (twin_[incoming] >= 0) crease_[twin_[incoming]] = 1;
      }
      h = twin_[incoming];
      if (h == start) break;
    }
  }
  find_sectors();
  find_kinds(corners, round_border_corners);
}

void Topology::find_edges(const std::vector<int>& face_sizes,
                          const std::vector<int>& face_vertices) {
  twin_.assign(origin_.size(), -1);
  edge_.assign(origin_.size(), -1);
  if (face_sizes.empty()) return;
  far::TopologyDescriptor descriptor;
  descriptor.numVertices = vertex_count();
  descriptor.numFaces = face_count();
  descriptor.numVertsPerFace = face_sizes.data();
  descriptor.vertIndicesPerFace = face_vertices.data();
  using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
  const std::unique_ptr<far::TopologyRefiner> refiner(
      Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK)));
  assert(refiner);
  const far::TopologyLevel& level = refiner->GetLevel(0);
  edge_count_ = level.GetNumEdges();
  for (int e = 0; e < edge_count_; ++e) {
    const far::ConstIndexArray faces = level.GetEdgeFaces(e);
    const far::ConstLocalIndexArray sides = level.GetEdgeFaceLocalIndices(e);
    // Others were refused by check_mesh().
    assert(faces.size() == 1 || faces.size() == 2);
    // Side k of a face is the half-edge that leaves its corner k.
    const int h = face_begin_[faces[0]] + sides[0];
    edge_[h] = e;
    if (faces.size() == 2) {
      const int g = face_begin_[faces[1]] + sides[1];
      edge_[g] = e;
      twin_[h] = g;
      twin_[g] = h;
    }
  }
}

void Topology::find_outgoing() {
  outgoing_.assign(kind_.size(), -1);
  for (int h = 0; h < half_edge_count(); ++h) {
    int& out = outgoing_[origin_[h]];
    // At a border the half-edge without a twin begins the fan, so that turning left passes all.
    if (out < 0 || twin_[h] < 0) out = h;
  }
}

void Topology::find_sectors() {
  sector_faces_.assign(origin_.size(), 0);
  for (int start = 0; start < half_edge_count(); ++start) {
    // All half-edges of a sector are filled in at once, so that each sector is walked but once.
    if (sector_faces_[start] > 0) continue;
    int first = start;
    // Clockwise to the crease that the sector begins at, or once around.
    for (int h = turn_right(*this, first); h >= 0 && h != start; h = turn_right(*this, h)) {
      first = h;
    }
    // Without a crease the walk came round to `start`, and any beginning will do.
    if (turn_right(*this, first) == start) first = start;
    int faces = 0;
    int h = first;
    do {
      ++faces;
      h = turn_left(*this, h);
    } while (h >= 0 && h != first);
    h = first;
    for (int i = 0; i < faces; ++i, h = turn_left(*this, h)) sector_faces_[h] = faces;
  }
}

void Topology::find_kinds(const std::vector<int>& corners, bool round_border_corners) {
  std::vector<int> creases(kind_.size(), 0);
  std::vector<std::uint8_t> cornered(kind_.size(), 0);
  for (int h = 0; h < half_edge_count(); ++h) {
    // By edges: each counts once at either end.
    if (!is_crease(h) || !is_edge_front(h)) continue;
    ++creases[origin_[h]];
    ++creases[origin_[next(h)]];
  }
  for (int v : corners) cornered[v] = 1;
  if (!round_border_corners) {
    for (int h = 0; h < half_edge_count(); ++h) {
      // A single face at the border: both its edges here are borders.
      if (twin_[h] < 0 && twin_[prev(h)] < 0) cornered[origin_[h]] = 1;
    }
  }
  for (int v = 0; v < vertex_count(); ++v) {
    if (creases[v] >= 3 || (cornered[v] && creases[v] == 2)) {
      kind_[v] = VertexKind::kCorner;
    } else if (cornered[v]) {
      kind_[v] = VertexKind::kCone;
    } else {
      // Three and more are corners already.
      constexpr VertexKind kByCreases[] = {VertexKind::kSmooth, VertexKind::kDart,
                                           VertexKind::kCrease};
      kind_[v] = kByCreases[creases[v]];
    }
  }
}

Topology Topology::refined() const {
  const RefinedView<Topology> view(*this);
  Topology fine;
  fine.edge_count_ = view.edge_count();
  const int half_edges = view.half_edge_count();
  fine.face_begin_.resize(half_edges / 4 + 1);
  for (int f = 0; f <= half_edges / 4; ++f) fine.face_begin_[f] = 4 * f;
  fine.origin_.resize(half_edges);
  fine.face_.resize(half_edges);
  fine.twin_.resize(half_edges);
  fine.edge_.resize(half_edges);
  fine.crease_.resize(half_edges);
  fine.sector_faces_.resize(half_edges);
  for (int h = 0; h < half_edges; ++h) {
    fine.origin_[h] = view.origin(h);
    fine.face_[h] = h / 4;
    fine.twin_[h] = view.twin(h);
    fine.edge_[h] = view.edge(h);
    fine.crease_[h] = view.is_crease(h);
    fine.sector_faces_[h] = view.sector_faces(h);
  }
  // All half-edges of a vertex tell one kind. Vertices without faces have none to tell it, and are
  // smooth whatever their tag was: nothing refers to them.
  fine.kind_.assign(view.vertex_count(), VertexKind::kSmooth);
  for (int h = 0; h < half_edges; ++h) fine.kind_[fine.origin_[h]] = view.kind_at(h);
  fine.find_outgoing();
  return fine;
}

}  // namespace hull::mesh
