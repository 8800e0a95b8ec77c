// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "mesh/topology.h"
#include "surface/scheme.h"

// The subdivision rules of Greshake 2021, equations 5.1–5.6 (after Catmull & Clark 1978 and
// Biermann, Levin & Zorin 2000), written once for values of any vector type: points, or rows of
// weights when a local matrix is wanted. `T` is Topology or RefinedView; `get(h)` returns the value
// at the origin of half-edge h.
namespace hull::surface {

// Whether the smooth rule holds at the origin of h (a dart counts as smooth).
template <class T>
bool is_smooth_at(const T& t, int h) {
  const mesh::VertexKind kind = t.kind_at(h);
  return kind == mesh::VertexKind::kSmooth || kind == mesh::VertexKind::kDart;
}

// The angle whose cosine and sine weigh a smooth edge at the origin of h (below 5.3).
template <class T>
double sector_angle(const T& t, int h) {
  const double divisor = t.kind_at(h) == mesh::VertexKind::kCorner ? 4.0 : 2.0;
  return std::numbers::pi / (divisor * t.sector_faces(h));
}

// Whether the two end weights of the smooth edge of h are other than 1/4.
template <class T>
bool is_modified_edge(const T& t, Scheme scheme, int h) {
  if (scheme != Scheme::kBiermann || t.is_crease(h)) return false;
  const int g = t.twin(h);
  const auto modifies = [&t](int end, int other) {
    const mesh::VertexKind kind = t.kind_at(end);
    const bool crease = kind == mesh::VertexKind::kCrease && t.sector_faces(end) != 2;
    const bool corner = kind == mesh::VertexKind::kCorner && t.sector_faces(end) != 1;
    return (crease || corner) && is_smooth_at(t, other);
  };
  return modifies(h, g) || modifies(g, h);
}

// Weights of the origin and the end of the smooth edge of h in its edge point.
template <class T>
std::pair<double, double> edge_end_weights(const T& t, Scheme scheme, int h) {
  if (!is_modified_edge(t, scheme, h)) return {0.25, 0.25};
  const int g = t.twin(h);
  const bool sharp_origin = !is_smooth_at(t, h);
  const double angle = sector_angle(t, sharp_origin ? h : g);
  const double sharp = 0.5 * std::cos(angle) * std::cos(angle);
  const double smooth = 0.5 * std::sin(angle) * std::sin(angle);
  return sharp_origin ? std::pair(sharp, smooth) : std::pair(smooth, sharp);
}

// 5.1, of the face of h.
template <class Value, class T, class Get>
Value face_point(const T& t, int h, const Get& get) {
  Value sum = get(h);
  int corners = 1;
  for (int i = t.next(h); i != h; i = t.next(i), ++corners) sum += get(i);
  return sum * (1.0 / corners);
}

// 5.3 and 5.4, of the edge of h.
template <class Value, class T, class Get>
Value edge_point(const T& t, Scheme scheme, int h, const Get& get) {
  const int end = t.next(h);
  if (t.is_crease(h)) return (get(h) + get(end)) * 0.5;
  const auto [at_origin, at_end] = edge_end_weights(t, scheme, h);
  const Value faces = face_point<Value>(t, h, get) + face_point<Value>(t, t.twin(h), get);
  return get(h) * at_origin + get(end) * at_end + faces * 0.25;
}

// 5.5: the fan of the origin of h is closed, or a dart's, opened at its crease.
template <class Value, class T, class Get>
Value smooth_vertex_point(const T& t, int h, const Get& get) {
  const Value centre = get(h);
  Value sum = centre * 0.0;
  int n = 0;
  int i = h;
  do {  // sums over j of f_j + q_j
    sum += face_point<Value>(t, i, get);
    sum += get(t.next(i));
    i = t.twin(t.prev(i));
    ++n;
  } while (i != h);
  return sum * (1.0 / (n * n)) + centre * ((n - 2.0) / n);
}

// The clockwise-most half-edge of the whole fan (creases do not stop it) of the origin of h; h
// itself where the fan is closed.
template <class T>
int fan_start(const T& t, int h) {
  int first = h;
  for (int g = t.twin(h); g >= 0; g = t.twin(first)) {
    first = t.next(g);
    if (first == h) break;
  }
  return first;
}

// 5.6.
template <class Value, class T, class Get>
Value crease_vertex_point(const T& t, int h, const Get& get) {
  Value sum = get(h) * 0.75;
  const int first = fan_start(t, h);
  int i = first;
  do {
    if (t.is_crease(i)) sum += get(t.next(i)) * 0.125;
    const int left = t.twin(t.prev(i));
    // The last edge of an open fan has no half-edge that leaves the vertex.
    if (left < 0) sum += get(t.prev(i)) * 0.125;
    i = left;
  } while (i >= 0 && i != first);
  return sum;
}

// The vertex point of the origin of h.
template <class Value, class T, class Get>
Value vertex_point(const T& t, int h, const Get& get) {
  switch (t.kind_at(h)) {
    case mesh::VertexKind::kSmooth:
    case mesh::VertexKind::kDart:
      return smooth_vertex_point<Value>(t, h, get);
    case mesh::VertexKind::kCrease:
      return crease_vertex_point<Value>(t, h, get);
    default:
      return get(h);
  }
}

// The value at the origin of half-edge `fine` of the once-subdivided mesh (numbered as in
// Topology::refined()).
template <class Value, class T, class Get>
Value refined_value(const T& t, Scheme scheme, int fine, const Get& get) {
  const int coarse = fine / 4;
  switch (fine & 3) {
    case 0:
      return vertex_point<Value>(t, coarse, get);
    case 1:
      return edge_point<Value>(t, scheme, coarse, get);
    case 2:
      return face_point<Value>(t, coarse, get);
    default:
      return edge_point<Value>(t, scheme, t.prev(coarse), get);
  }
}

}  // namespace hull::surface
