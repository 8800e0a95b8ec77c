// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/shown_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "mesh/tolerances.h"
#include "surface/sampling/tessellation.h"

namespace hull::surface {
namespace {

constexpr std::size_t kCellsAtATime = 128;  // their samples stay in the processor's cache

}  // namespace

ShownPoints::ShownPoints(const LimitSurface& surface, int n, bool mirrored, double metres_per_unit)
    : stamp_(surface), n_(n), mirrored_(mirrored), metres_per_unit_(metres_per_unit) {
  if (!(metres_per_unit > 0.0) || !std::isfinite(metres_per_unit)) {
    throw std::invalid_argument("A unit must be a positive number of metres, not " +
                                std::to_string(metres_per_unit) + ".");
  }
  const Tessellation tessellation = tessellate(surface, n);
  const std::size_t count = tessellation.points.size();
  first_.assign(surface.cell_count() + 1, 0);
  for (int cell : tessellation.cells) ++first_[cell + 1];
  for (int cell = 0; cell < surface.cell_count(); ++cell) first_[cell + 1] += first_[cell];
  // By counting sort: first_ tells where the places of each cell begin in taken_.
  taken_.resize(count);
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t point = 0; point < count; ++point) {
    const Eigen::Vector2d& uv = tessellation.uv[point];
    const int i = static_cast<int>(std::lround(n * uv.x()));
    const int j = static_cast<int>(std::lround(n * uv.y()));
    taken_[next[tessellation.cells[point]]++] = {i * (n + 1) + j, static_cast<int>(point)};
  }
  follow_size();
  coordinates_.reserve(6 * count);  // what reads them may do so while images are numbered anew
  coordinates_.resize(3 * count);
  // Shared at first: the first point off the plane marks the images as stale, so that none is
  // written before number_images() has made room for it.
  shared_.assign(count, 1);
  images_.assign(count, -1);
  for (std::size_t point = 0; point < count; ++point) {
    take_point(static_cast<int>(point), tessellation.points[point]);
  }
  number_images();
}

bool ShownPoints::update() {
  const LimitSurface& surface = stamp_.surface();
  sharing_changed_ = false;
  const bool are_all_due = follow_size();
  std::vector<int> cells;
  // Whatever moved since the last update, in however many calls of set_points().
  for (const int cell : surface.cells_moved_since(are_all_due ? -1 : stamp_.revision())) {
    cells.push_back(cell);
    if (cells.size() < kCellsAtATime) continue;
    take_cells(cells);
    cells.clear();
  }
  take_cells(cells);
  stamp_.renew();
  if (!sharing_changed_) return true;
  number_images();
  return false;
}

// What is on the centre plane goes by the size of the hull, which a point that moves may change:
// whether points that did not move may have come onto it, or off it.
bool ShownPoints::follow_size() {
  centre_plane_ = kOnCentrePlane * stamp_.surface().mesh().size();
  if (!mirrored_) return false;
  if (farthest_shared_ <= centre_plane_ && nearest_other_ > centre_plane_) return false;
  // Begun anew, as all points are about to be taken; otherwise they only widen, which at worst
  // computes all in vain.
  farthest_shared_ = 0.0;
  nearest_other_ = std::numeric_limits<double>::infinity();
  return true;
}

void ShownPoints::take_cells(const std::vector<int>& cells) {
  if (cells.empty()) return;
  evaluate_cells(stamp_.surface(), cells, n_, 0, samples_);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Vector3d* samples = &samples_.points[samples_.index(static_cast<int>(k), 0, 0)];
    for (int i = first_[cells[k]]; i < first_[cells[k] + 1]; ++i) {
      take_point(taken_[i].point, samples[taken_[i].sample]);
    }
  }
}

void ShownPoints::take_point(int point, const Vector3d& position) {
  const double away = std::abs(position.y());
  const bool shared = !mirrored_ || away <= centre_plane_;
  if (shared) {
    farthest_shared_ = std::max(farthest_shared_, away);
  } else {
    nearest_other_ = std::min(nearest_other_, away);
  }
  const auto x = static_cast<float>(position.x() / metres_per_unit_);
  // On the plane exactly where both sides share the point, whatever rounding left.
  const auto y = mirrored_ && shared ? 0.0f : static_cast<float>(position.y() / metres_per_unit_);
  const auto z = static_cast<float>(position.z() / metres_per_unit_);
  float* out = &coordinates_[3 * static_cast<std::size_t>(point)];
  out[0] = x;
  out[1] = y;
  out[2] = z;
  if (shared != static_cast<bool>(shared_[point])) {
    shared_[point] = shared;
    sharing_changed_ = true;
  }
  // Once a point has left the plane or come to it the images' numbers are stale; number_images()
  // then writes all of them anew.
  if (shared || sharing_changed_) return;
  out = &coordinates_[3 * static_cast<std::size_t>(images_[point])];
  out[0] = x;
  out[1] = -y;
  out[2] = z;
}

void ShownPoints::number_images() {
  const std::size_t count = shared_.size();
  int number = static_cast<int>(count);
  for (std::size_t point = 0; point < count; ++point) {
    images_[point] = shared_[point] ? static_cast<int>(point) : number++;
  }
  coordinates_.resize(3 * static_cast<std::size_t>(number));
  for (std::size_t point = 0; point < count; ++point) {
    if (shared_[point]) continue;
    const float* from = &coordinates_[3 * point];
    float* to = &coordinates_[3 * static_cast<std::size_t>(images_[point])];
    to[0] = from[0];
    to[1] = -from[1];
    to[2] = from[2];
  }
}

}  // namespace hull::surface
