// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/square_fan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "conversion/blocks/block_places.h"
#include "conversion/exact/seam_samples.h"

namespace hull::conversion {
namespace {

double angle_of(const SeamVectors& vectors) {
  const Vector3d one = vectors.before.cross(vectors.along),
                 two = vectors.along.cross(vectors.after);
  // Neither the arc cosine nor the sine keeps its digits at all angles.
  return std::atan2(one.cross(two).norm(), one.dot(two));
}

}  // namespace

std::vector<int> half_edges_around(const mesh::Topology& cells, int vertex) {
  std::vector<int> result;
  const int first = cells.outgoing(vertex);
  for (int h = first; h >= 0; h = cells.twin(cells.prev(h))) {
    result.push_back(h);
    if (cells.twin(cells.prev(h)) == first) break;
  }
  return result;
}

SquareFan square_fan(const surface::LimitSurface& surface, int vertex, const Grading& grading) {
  const mesh::Topology& cells = surface.cells();
  SquareFan fan;
  fan.half_edges = half_edges_around(cells, vertex);
  for (int h : fan.half_edges) {
    fan.graded.push_back(begins_at_irregular_knot(surface, h));
    fan.nets.push_back(fan.graded.back() ? corner_net(surface, h, grading) : CornerNet{});
  }
  for (int i = 0; i < fan.count(); ++i) {
    // The seam of a square is its side u = 0, the half-edge that comes back to the point.
    const bool is_crease = cells.is_crease(cells.prev(fan.half_edges[i]));
    fan.seam_smooth.push_back(!is_crease && fan.graded[i] && fan.graded[fan.after(i)]);
  }
  return fan;
}

double seam_angle(const SquareFan& fan) {
  double largest = 0.0;
  for (int i = 0; i < fan.count(); ++i) {
    if (!fan.seam_smooth[i]) continue;
    const CornerNet &before = fan.nets[i], &after = fan.nets[fan.after(i)];
    const SeamSamples samples = SeamSamples::for_measuring(before, after);
    for (int k = 0; k < samples.count(); ++k) {
      largest = std::max(largest, angle_of(samples.vectors(k, before, after)));
    }
  }
  return largest;
}

}  // namespace hull::conversion
