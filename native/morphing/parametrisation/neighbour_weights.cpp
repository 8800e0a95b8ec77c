// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/parametrisation/neighbour_weights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "morphing/orientation.h"

namespace hull::morphing {
namespace {

// The edges that leave an inner point, in order around it.
struct Star {
  std::vector<int> neighbours;
  std::vector<Vector3d> edges;

  int size() const { return static_cast<int>(neighbours.size()); }
  int after(int k) const { return k + 1 < size() ? k + 1 : 0; }
};

Star star_of(const TriangleDisc& disc, int point) {
  const mesh::Topology& t = disc.topology();
  Star star;
  const int begin = t.outgoing(point);
  int h = begin;
  do {
    star.neighbours.push_back(t.origin(t.next(h)));
    star.edges.push_back(disc.points()[star.neighbours.back()] - disc.points()[point]);
    // Around an inner point the turn comes back to its beginning.
    h = t.twin(t.prev(h));
  } while (h != begin);
  return star;
}

[[noreturn]] void refuse_flat(int point) {
  throw std::invalid_argument("The triangles around point " + std::to_string(point) +
                              " have no area: leave the point out.");
}

// Directions of the edges laid flat, from 0 to 2 pi; the last, 2 pi, is the first edge again.
std::vector<double> flat_directions(const Star& star, int point) {
  std::vector<double> directions{0.0};
  for (int k = 0; k < star.size(); ++k) {
    const Vector3d &e = star.edges[k], &f = star.edges[star.after(k)];
    // By sine and cosine: near 0 and pi either alone loses half the digits.
    directions.push_back(directions.back() + std::atan2(e.cross(f).norm(), e.dot(f)));
  }
  if (!(directions.back() > 0.0)) refuse_flat(point);
  const double scale = 2.0 * std::numbers::pi / directions.back();
  for (double& direction : directions) direction *= scale;
  // No gap is left by rounding before the first edge.
  directions.back() = 2.0 * std::numbers::pi;
  return directions;
}

// Adds the weights by which the origin is the mean of three points, divided by `count`.
void add_barycentric(const std::vector<Vector2d>& flat, const std::array<int, 3>& corners,
                     int count, std::vector<double>& weights) {
  const Vector2d origin(0.0, 0.0);
  std::array<double, 3> areas;
  for (int i = 0; i < 3; ++i) {
    // An origin on an edge is beyond it by rounding as often as not.
    areas[i] =
        std::max(0.0, orientation(flat[corners[(i + 1) % 3]], flat[corners[(i + 2) % 3]], origin));
  }
  double sum = areas[0] + areas[1] + areas[2];
  if (sum == 0.0) {
    // The second and third in one direction, opposite to the first: the first two alone.
    areas = {flat[corners[1]].norm(), flat[corners[0]].norm(), 0.0};
    sum = areas[0] + areas[1];
  }
  for (int i = 0; i < 3; ++i) weights[corners[i]] += areas[i] / sum / count;
}

std::vector<double> shape_preserving(const Star& star, int point) {
  const int count = star.size();
  const std::vector<double> directions = flat_directions(star, point);
  std::vector<Vector2d> flat;
  for (int k = 0; k < count; ++k) {
    flat.push_back(star.edges[k].norm() *
                   Vector2d(std::cos(directions[k]), std::sin(directions[k])));
  }
  std::vector<double> weights(count, 0.0);
  // Opposite to each of three are both others: all means are one.
  if (count == 3) {
    add_barycentric(flat, {0, 1, 2}, 1, weights);
    return weights;
  }
  for (int l = 0; l < count; ++l) {
    // The ray opposite to neighbour l leaves between neighbours r and r + 1, neither of them l.
    double opposite = directions[l] + std::numbers::pi;
    if (opposite >= 2.0 * std::numbers::pi) opposite -= 2.0 * std::numbers::pi;
    const auto beyond = std::upper_bound(directions.begin(), directions.end(), opposite);
    // The last of the directions is the first edge again, and begins no sector.
    int r = std::min(static_cast<int>(beyond - directions.begin()) - 1, count - 1);
    // A sector has pi at most, as no angle in space is more than the others together; of one that
    // has, the ray opposite to its edge may by rounding be found within.
    if (r == l) r = star.after(l);
    if (star.after(r) == l) r = (r + count - 1) % count;
    add_barycentric(flat, {l, r, star.after(r)}, count, weights);
  }
  return weights;
}

std::vector<double> mean_value(const Star& star, int point) {
  const int count = star.size();
  std::vector<double> half_tangents;
  for (int k = 0; k < count; ++k) {
    const Vector3d &e = star.edges[k], &f = star.edges[star.after(k)];
    // tan(a / 2) = sin a / (1 + cos a), by the product of both lengths.
    const double cosine = e.norm() * f.norm() + e.dot(f);
    if (!(cosine > 0.0)) {
      throw std::invalid_argument("The triangle of points " + std::to_string(point) + ", " +
                                  std::to_string(star.neighbours[k]) + " and " +
                                  std::to_string(star.neighbours[star.after(k)]) +
                                  " has no area, and mean values none beside it: take "
                                  "shape-preserving weights, or mend the triangle.");
    }
    half_tangents.push_back(e.cross(f).norm() / cosine);
  }
  if (!(std::ranges::max(half_tangents) > 0.0)) refuse_flat(point);
  std::vector<double> weights;
  for (int k = 0; k < count; ++k) {
    weights.push_back((half_tangents[(k + count - 1) % count] + half_tangents[k]) /
                      star.edges[k].norm());
  }
  return weights;
}

std::vector<double> weights_of(const Star& star, int point, WeightKind kind) {
  if (kind == WeightKind::kShapePreserving) return shape_preserving(star, point);
  if (kind == WeightKind::kMeanValue) return mean_value(star, point);
  return std::vector<double>(star.size(), 1.0);
}

}  // namespace

std::vector<NeighbourWeight> neighbour_weights(const TriangleDisc& disc, int point,
                                               WeightKind kind) {
  const Star star = star_of(disc, point);
  const std::vector<double> weights = weights_of(star, point, kind);
  double sum = 0.0;
  // Barycentric ones sum to 1 but for rounding; the others to anything.
  for (double weight : weights) sum += weight;
  std::vector<NeighbourWeight> result;
  for (int k = 0; k < star.size(); ++k) {
    result.push_back({star.neighbours[k], weights[k] / sum});
  }
  return result;
}

}  // namespace hull::morphing
