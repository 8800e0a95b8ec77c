// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/pull/pull_spread.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hull::modelling {
namespace {

using Eigen::Matrix3d;

// Stands for an infinite stiffness: what is left of a move there is below what pulls are met to.
constexpr double kStiff = 1e9;

double falloff(double distance, double radius) {
  const double q = distance / radius;
  return q < 1.0 ? std::pow(1.0 - q * q, 3) : 0.0;
}

Matrix3d projection(const Freedom& freedom) {
  Matrix3d onto = Matrix3d::Zero();
  for (int k = 0; k < freedom.count; ++k) {
    onto += freedom.directions[k] * freedom.directions[k].transpose();
  }
  return onto;
}

// The points that follow, and those around and among them that are held in some direction.
struct Region {
  std::vector<int> points, held;
};

// From the points with a weight along edges, through all that are within the radius and not locked.
Region region_around(const surface::LimitSurface& surface,
                     const std::vector<surface::PointWeight>& weights, const Vector3d& place,
                     const std::vector<Freedom>& freedoms, double radius) {
  const mesh::Topology& topology = surface.mesh().topology();
  const std::vector<Vector3d>& points = surface.mesh().points();
  const auto is_near = [&](int point) { return (points[point] - place).norm() < radius; };
  std::vector<std::vector<int>> neighbours(topology.vertex_count());
  for (int h = 0; h < topology.half_edge_count(); ++h) {
    const int from = topology.origin(h), to = topology.origin(topology.next(h));
    // Of an inner edge the other half-edge tells the other way.
    if (is_near(from)) neighbours[from].push_back(to);
    // A border's edge has no other half-edge that would say so.
    if (topology.twin(h) < 0 && is_near(to)) neighbours[to].push_back(from);
  }
  Region region;
  std::vector<char> is_seen(topology.vertex_count(), 0);
  const auto see = [&](int point) {
    if (is_seen[point]) return;
    is_seen[point] = 1;
    if (freedoms[point].count < 3) region.held.push_back(point);
    if (freedoms[point].count > 0) region.points.push_back(point);
  };
  for (const surface::PointWeight& w : weights) see(w.point);
  // Breadth first: the list grows while it is gone through. Locked points are seen, as they hold
  // their surroundings, but nothing goes on from them.
  for (std::size_t i = 0; i < region.points.size(); ++i) {
    for (int neighbour : neighbours[region.points[i]]) {
      if (freedoms[neighbour].count == 0 || is_near(neighbour)) see(neighbour);
    }
  }
  return region;
}

// What a held point does to the moves around it.
struct Hold {
  Vector3d point;
  double reach;   // the distance from it at which its stiffness is gone, m
  double weight;  // goes to zero where the held point leaves the pull's radius
  Matrix3d across;
};

std::vector<Hold> holds_of(const Region& region, const std::vector<Vector3d>& points,
                           const Vector3d& place, const std::vector<Freedom>& freedoms,
                           double radius) {
  std::vector<Hold> holds;
  for (int point : region.held) {
    const double reach = (points[point] - place).norm();
    const double weight = 1.0 - std::pow(reach / radius, 2);
    // A point at the place itself is what is pulled: it holds nothing but what it may not do
    // anyway.
    if (reach == 0.0 || weight <= 0.0) continue;
    holds.push_back(
        {points[point], reach, weight, Matrix3d::Identity() - projection(freedoms[point])});
  }
  return holds;
}

// (1 + S)^-1. S is a mean over the holds, weighted by their stiffnesses, so that it is not the more
// the denser held points lie.
Matrix3d fading(const Vector3d& at, const std::vector<Hold>& holds) {
  Matrix3d squares = Matrix3d::Zero();
  double sum = 0.0;
  for (const Hold& hold : holds) {
    const double t = (at - hold.point).norm() / hold.reach;
    if (t >= 1.0) continue;
    // Level at both ends, so that the stiffness ends at t = 1 without a bend; 1 / risen is infinite
    // at the held point.
    const double risen = t * t * (3.0 - 2.0 * t);
    const double stiffness =
        std::min(kStiff, hold.weight * (1.0 - risen) / std::max(risen, 1.0 / kStiff));
    // A mean weighted by the stiffnesses themselves: their squares over their sum.
    squares += stiffness * stiffness * hold.across;
    sum += stiffness;
  }
  if (sum == 0.0) return Matrix3d::Identity();
  return (Matrix3d::Identity() + squares / sum).inverse();
}

}  // namespace

void check_spread(const PullSpread& spread) {
  if (spread.radius >= 0.0 && std::isfinite(spread.radius)) return;
  throw std::invalid_argument("The radius is " + std::to_string(spread.radius) +
                              " m, but must be 0 or more.");
}

Following following(const surface::LimitSurface& surface,
                    const std::vector<surface::PointWeight>& weights, const Vector3d& place,
                    const std::vector<Freedom>& freedoms, const PullSpread& spread) {
  const std::vector<Vector3d>& points = surface.mesh().points();
  const Region region = region_around(surface, weights, place, freedoms, spread.radius);
  const std::vector<Hold> holds = holds_of(region, points, place, freedoms, spread.radius);
  std::map<int, double> weight_of;
  double largest = 0.0, nearest = 0.0;
  for (const surface::PointWeight& w : weights) {
    weight_of[w.point] = w.weight;
    largest = std::max(largest, w.weight);
    nearest = std::max(nearest, falloff((points[w.point] - place).norm(), spread.radius));
  }
  Vector3d image = place;
  image.y() = -image.y();
  Following result;
  for (int point : region.points) {
    const Vector3d& at = points[point];
    const Matrix3d onto = projection(freedoms[point]);
    const double near = falloff((at - place).norm(), spread.radius);
    // Athwartships the two pulls are against one another, and what is held in the plane fades them
    // out; else they add up.
    Vector3d both(near, near, near);
    if (spread.mirrored) {
      const double far = falloff((at - image).norm(), spread.radius);
      both.x() += far;
      both.z() += far;
    }
    const auto own = weight_of.find(point);
    const double share = own == weight_of.end() ? 0.0 : own->second / largest;
    // From both sides: neither may a pull along what is held move the point, nor may the point
    // leave it.
    const Matrix3d faded = onto * fading(at, holds) * onto;
    result[point] = faded * both.asDiagonal() + (1.0 - nearest) * share * onto;
  }
  return result;
}

}  // namespace hull::modelling
