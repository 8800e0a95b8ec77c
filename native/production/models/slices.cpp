// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/models/slices.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

namespace hull::production {
namespace {

std::uint64_t side_key(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<unsigned>(std::max(a, b));
}

// The section of the triangles that pass one height.
class Slicer {
 public:
  Slicer(const ClosedModel& model, double height) : model_(model), height_(height) {}

  // Seen from outside, a triangle's section runs from the side that goes down to the one that goes
  // up: then the body is on its left, seen from above.
  void add(const std::array<int, 3>& triangle) {
    std::uint64_t down = 0, up = 0;
    for (int k = 0; k < 3; ++k) {
      const int a = triangle[k], b = triangle[(k + 1) % 3];
      if (is_above(a) == is_above(b)) continue;
      // Without direction: the side by which one triangle goes up is that by which its neighbour
      // comes down.
      (is_above(a) ? down : up) = side_key(a, b);
    }
    // A side is passed downwards by one triangle alone, so that each has one next.
    next_[down] = up;
    order_.push_back(down);
  }

  ModelSlice slice() {
    ModelSlice slice{height_, {}};
    // In the order of triangles, so that contours do not depend on the hash table's.
    for (std::uint64_t start : order_) {
      std::vector<Eigen::Vector2d> contour;
      for (auto at = next_.find(start); at != next_.end(); at = next_.find(start)) {
        const Eigen::Vector2d p = point(at->first);
        // Where a corner is at the height all of its sides that go down have it as their point.
        if (contour.empty() || p != contour.back()) contour.push_back(p);
        start = at->second;
        next_.erase(at);
      }
      if (contour.size() > 1 && contour.front() == contour.back()) contour.pop_back();
      if (contour.size() > 2) slice.contours.push_back(std::move(contour));
    }
    return slice;
  }

 private:
  bool is_above(int point) const { return model_.points[point].z() >= height_; }

  // The same for both triangles of a side.
  Eigen::Vector2d point(std::uint64_t side) const {
    const Vector3d &a = model_.points[side >> 32], &b = model_.points[side & 0xffffffffu];
    const double t = (height_ - a.z()) / (b.z() - a.z());
    return (a + t * (b - a)).head<2>();
  }

  const ClosedModel& model_;
  double height_;
  std::unordered_map<std::uint64_t, std::uint64_t> next_;
  std::vector<std::uint64_t> order_;
};

}  // namespace

double ModelSlice::area() const {
  double sum = 0.0;
  for (const auto& contour : contours) {
    // The fan of the first point's triangles, with their signs.
    const Eigen::Vector2d& origin = contour[0];
    for (std::size_t i = 0; i + 1 < contour.size(); ++i) {
      const Eigen::Vector2d a = contour[i] - origin, b = contour[i + 1] - origin;
      sum += cross(a, b);
    }
  }
  return 0.5 * sum;
}

std::vector<ModelSlice> slices(const ClosedModel& model, const std::vector<double>& heights,
                               const surface::Progress& progress) {
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!std::isfinite(heights[i]) || (i > 0 && heights[i] <= heights[i - 1])) {
      throw std::invalid_argument("Heights of slices must be finite and rise.");
    }
  }
  // By height, so that no slice looks through all of the triangles.
  std::vector<std::vector<int>> passing(heights.size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    double low = model.points[model.triangles[t][0]].z(), high = low;
    for (int corner : model.triangles[t]) {
      low = std::min(low, model.points[corner].z());
      high = std::max(high, model.points[corner].z());
    }
    // Those above the lowest corner that are at most at the highest one.
    const auto first = std::upper_bound(heights.begin(), heights.end(), low) - heights.begin();
    const auto last = std::upper_bound(heights.begin(), heights.end(), high) - heights.begin();
    for (auto i = first; i < last; ++i) passing[i].push_back(static_cast<int>(t));
  }
  std::vector<ModelSlice> result;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (i % 64 == 0) surface::tell(progress, static_cast<double>(i), heights.size());
    Slicer slicer(model, heights[i]);
    for (int t : passing[i]) slicer.add(model.triangles[t]);
    result.push_back(slicer.slice());
  }
  return result;
}

ModelLayers layers(const ClosedModel& model, double thickness, const surface::Progress& progress) {
  std::ostringstream words;
  if (!(thickness > 0.0) || !std::isfinite(thickness)) {
    words << "The thickness of layers must be a positive length, not " << thickness << ".";
    throw std::invalid_argument(words.str());
  }
  double low = model.points.at(0).z(), high = low;
  for (const Vector3d& p : model.points) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  // A rest of 1e-9 of a layer is rounding, not a layer.
  const double count = std::ceil((high - low) / thickness - 1e-9);
  if (count < 1.0) {
    throw std::invalid_argument("The model has no height to be divided into layers.");
  }
  if (count > kMostLayers) {
    words << "Layers of " << thickness << " are more than " << kMostLayers << ". "
          << (high - low) / kMostLayers << " would do.";
    throw std::invalid_argument(words.str());
  }
  ModelLayers result{thickness, low, {}, {}};
  std::vector<double> middles;
  for (int i = 0; i < count; ++i) {
    const double bottom = low + i * thickness;
    result.tops.push_back(i + 1 < count ? bottom + thickness : high);
    middles.push_back(0.5 * (bottom + result.tops.back()));
  }
  result.slices = slices(model, middles, progress);
  return result;
}

double ModelLayers::volume() const {
  double sum = 0.0, under = bottom;
  for (std::size_t i = 0; i < slices.size(); under = tops[i++]) {
    sum += slices[i].area() * (tops[i] - under);
  }
  return sum;
}

}  // namespace hull::production
