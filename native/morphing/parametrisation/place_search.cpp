// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/parametrisation/place_search.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace hull::morphing {
namespace {

constexpr double kBeyondBorder = 1e-12;  // of the polygon's size

template <class Point>
Point mean_of(const std::vector<Point>& points, const Triangle& corners,
              const std::array<double, 3>& weights) {
  return weights[0] * points[corners[0]] + weights[1] * points[corners[1]] +
         weights[2] * points[corners[2]];
}

// Twice the areas that the place has with the edge opposite to each corner.
std::array<double, 3> areas_at(const DiscMap& map, int triangle, const Vector2d& place) {
  const auto [a, b, c] = map.disc().triangle(triangle);
  const std::vector<Vector2d>& p = map.places();
  return {orientation(p[b], p[c], place), orientation(p[c], p[a], place),
          orientation(p[a], p[b], place)};
}

}  // namespace

Vector3d position_at(const DiscMap& map, const DiscPlace& at) {
  return mean_of(map.disc().points(), map.disc().triangle(at.triangle), at.weights);
}

Vector2d place_at(const DiscMap& map, const DiscPlace& at) {
  return mean_of(map.places(), map.disc().triangle(at.triangle), at.weights);
}

PlaceSearch::PlaceSearch(const DiscMap& map) : map_(map) {
  const int count = map_.disc().triangle_count();
  std::vector<Eigen::AlignedBox2d> boxes(count);
  for (int t = 0; t < count; ++t) {
    for (int corner : map_.disc().triangle(t)) boxes[t].extend(map_.places()[corner]);
  }
  std::vector<int> triangles(count);
  std::iota(triangles.begin(), triangles.end(), 0);
  // A binary tree has a node less than twice its leaves.
  nodes_.reserve(2 * static_cast<std::size_t>(count));
  build(triangles.data(), triangles.data() + count, boxes);
}

int PlaceSearch::build(int* begin, int* end, const std::vector<Eigen::AlignedBox2d>& boxes) {
  const int index = static_cast<int>(nodes_.size());
  // A leaf, unless it is divided below.
  nodes_.push_back({{}, -1, *begin});
  for (const int* t = begin; t != end; ++t) nodes_[index].box.extend(boxes[*t]);
  if (end - begin == 1) return index;
  const int axis = nodes_[index].box.sizes().x() >= nodes_[index].box.sizes().y() ? 0 : 1;
  // Half of them to either side, so that no triangulation makes the tree deeper than the logarithm
  // of its triangles.
  int* middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end,
                   [&](int s, int t) { return boxes[s].center()[axis] < boxes[t].center()[axis]; });
  const int left = build(begin, middle, boxes);
  const int right = build(middle, end, boxes);
  nodes_[index].left = left;
  nodes_[index].right = right;
  return index;
}

DiscPlace PlaceSearch::find(const Vector2d& place) const {
  DiscPlace found{std::numeric_limits<int>::max(), {}};
  std::vector<int> waiting{0};
  while (!waiting.empty()) {
    const Node& node = nodes_[waiting.back()];
    waiting.pop_back();
    // Boxes of neighbours overlap, so that several leaves may have to be asked.
    if (!node.box.contains(place)) continue;
    if (node.left >= 0) {
      waiting.push_back(node.left);
      waiting.push_back(node.right);
      // On a common edge the triangle with the lowest number, however the tree was built.
    } else if (node.right < found.triangle) {
      // Signs of areas are exact: each place within the border has a triangle.
      const std::array<double, 3> areas = areas_at(map_, node.right, place);
      if (std::min({areas[0], areas[1], areas[2]}) >= 0.0) found = {node.right, areas};
    }
  }
  if (found.triangle == std::numeric_limits<int>::max()) return on_border(place);
  const double sum = found.weights[0] + found.weights[1] + found.weights[2];
  for (double& weight : found.weights) weight /= sum;
  return found;
}

DiscPlace PlaceSearch::on_border(const Vector2d& place) const {
  const mesh::Topology& t = map_.disc().topology();
  double least = kBeyondBorder * map_.polygon().size();
  DiscPlace found{-1, {}};
  for (const BorderPoint& at : map_.border()) {
    const Vector2d& from = map_.places()[at.point];
    const Vector2d edge = map_.places()[t.origin(t.next(at.half_edge))] - from;
    const double along = std::clamp((place - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double distance = (place - from - along * edge).norm();
    if (!(distance < least)) continue;
    least = distance;
    const int corner = at.half_edge - t.first_half_edge(t.face(at.half_edge));
    found = {t.face(at.half_edge), {0.0, 0.0, 0.0}};
    // The third corner, off the border, counts for nothing.
    found.weights[corner] = 1.0 - along;
    found.weights[(corner + 1) % 3] = along;
  }
  if (found.triangle >= 0) return found;
  std::ostringstream words;
  words << "The place (" << place.x() << ", " << place.y()
        << ") is outside of the polygon: ask for one within it.";
  throw std::invalid_argument(words.str());
}

}  // namespace hull::morphing
