// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/planes/tangent_planes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace hull::network {
namespace {

// Sines of angles between edges that span no plane: of any, and of those that go on in one another.
constexpr double kOneLine = 1e-6, kPassing = 0.2588;

// The sectors of a star, run by run from one crease or border to the next, with a plane for each
// run.
class Planes {
 public:
  Planes(const NodeStar& star, std::vector<bool> creases)
      : star_(star), count_(star.directions.size()) {
    planes_.is_crease = std::move(creases);
    planes_.normals.assign(count_, Vector3d::Zero());
    planes_.is_told.assign(count_, false);
  }

  TangentPlanes run() {
    // From a crease on, if there is one: sectors around the star's first end may be of one plane.
    const std::size_t first = first_sector();
    std::size_t at = 0;
    while (at < count_) {
      const std::size_t begin = at;
      // From sector to sector, while no crease is between.
      do ++at;
      while (at < count_ && !parts((first + at) % count_));
      set_plane((first + begin) % count_, at - begin);
    }
    return std::move(planes_);
  }

 private:
  // An end between two sectors of different planes.
  bool parts(std::size_t end) const {
    return planes_.is_crease[end] || star_.is_beyond[end] ||
           star_.is_beyond[(end + count_ - 1) % count_];
  }
  std::size_t first_sector() const {
    for (std::size_t end = 0; end < count_; ++end) {
      if (parts(end)) return end;
    }
    return 0;
  }

  // Of sectors one after the other.
  void set_plane(std::size_t sector, std::size_t sectors) {
    if (star_.is_beyond[sector]) return;
    std::vector<Vector3d> edges;
    // Sectors in a row have one end more than there are of them, but for all around.
    for (std::size_t i = 0; i <= std::min(sectors, count_ - 1); ++i) {
      edges.push_back(star_.directions[(sector + i) % count_]);
    }
    const std::optional<Vector3d> told = plane_of(edges);
    const Vector3d normal = told.value_or(plane_across(edges));
    for (const Vector3d& edge : edges) {
      planes_.deviation =
          std::max(planes_.deviation, std::asin(std::min(1.0, std::abs(edge.dot(normal)))));
    }
    for (std::size_t i = 0; i < sectors; ++i) {
      planes_.normals[(sector + i) % count_] = normal;
      planes_.is_told[(sector + i) % count_] = told.has_value();
    }
  }

  Vector3d plane_across(const std::vector<Vector3d>& edges) const {
    // The line on which both edges are but for a bend.
    const Vector3d along = (edges.front() - edges.back()).normalized();
    return (star_.outwards - star_.outwards.dot(along) * along).normalized();
  }

  std::optional<Vector3d> plane_of(const std::vector<Vector3d>& edges) const {
    Vector3d normal = Vector3d::Zero();
    double most = 0.0;
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      moments += edges[i] * edges[i].transpose();
      for (std::size_t k = 0; k < i; ++k) {
        const Vector3d across = edges[k].cross(edges[i]);
        // Those two that are furthest from one line.
        if (across.norm() > most) {
          most = across.norm();
          normal = across.normalized();
        }
      }
    }
    // A curve that only bends a little tells nothing of the plane across it.
    const bool goes_on = edges.front().dot(edges.back()) < 0.0;
    if (most < kOneLine || (goes_on && most < kPassing)) return std::nullopt;
    // Of more than two that plane off which the squared sines are least; of two it is the product,
    // which is exact.
    if (edges.size() > 2) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
      normal = axes.eigenvectors().col(0);
    }
    return normal.dot(star_.outwards) < 0.0 ? Vector3d(-normal) : normal;
  }

  const NodeStar& star_;
  std::size_t count_;
  TangentPlanes planes_;
};

using EndNumbers = std::vector<std::size_t>;

// The numbers of each curve's ends.
std::vector<EndNumbers> ends_by_curve(const NodeStar& star) {
  std::map<int, EndNumbers> ends;
  for (std::size_t i = 0; i < star.curves.size(); ++i) ends[star.curves[i]].push_back(i);
  std::vector<EndNumbers> all;
  for (auto& [curve, its_ends] : ends) all.push_back(std::move(its_ends));
  return all;
}

std::vector<EndNumbers> pairs_of(const std::vector<EndNumbers>& curves) {
  std::vector<EndNumbers> pairs;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t k = i + 1; k < curves.size(); ++k) {
      pairs.push_back(curves[i]);
      pairs.back().insert(pairs.back().end(), curves[k].begin(), curves[k].end());
    }
  }
  return pairs;
}

// With creases along some ends such that the deviation is least, and within the limit.
std::optional<TangentPlanes> best_planes(const NodeStar& star, const std::vector<EndNumbers>& among,
                                         double limit) {
  std::optional<TangentPlanes> best;
  for (const EndNumbers& ends : among) {
    std::vector<bool> creases = star.is_crease;
    for (std::size_t end : ends) creases[end] = true;
    TangentPlanes tried = Planes(star, std::move(creases)).run();
    if (tried.deviation <= limit && (!best || tried.deviation < best->deviation)) {
      best = std::move(tried);
    }
  }
  return best;
}

}  // namespace

TangentPlanes tangent_planes(const NodeStar& star, double limit) {
  TangentPlanes planes = Planes(star, star.is_crease).run();
  if (planes.deviation <= limit) return planes;
  // All ends of a curve: a knuckle that comes to a node goes on beyond it along its curve.
  const std::vector<EndNumbers> curves = ends_by_curve(star);
  // Of one curve rather than of two, which may well be nearer by what tangents are inexact.
  std::optional<TangentPlanes> best = best_planes(star, curves, limit);
  if (!best) best = best_planes(star, pairs_of(curves), limit);
  if (best) return *best;
  TangentPlanes apart = Planes(star, std::vector<bool>(star.directions.size(), true)).run();
  // Sectors by themselves are off next to nothing: what is told is how far larger planes were.
  apart.deviation = planes.deviation;
  apart.has_planes = false;
  return apart;
}

}  // namespace hull::network
