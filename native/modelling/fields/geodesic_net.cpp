// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/geodesic_net.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <stdexcept>
#include <utility>

#include "mesh/tolerances.h"
#include "surface/queries/closest_point.h"
#include "surface/sampling/tessellation.h"

namespace hull::modelling {
namespace {

constexpr double kNetPoints = 50000.0;
constexpr int kLeastPerSide = 2, kMostPerSide = 16;
// Of the longest side or diagonal at a point of the net: a base so near begins there.
constexpr double kBegins = 0.75;
// Of the spacing: up to where straight distances are taken, and from where on none are.
constexpr double kStraight = 2.0, kMarched = 4.0;
constexpr double kRipple = 1e-3;  // of the spacing

int per_side_of(const surface::LimitSurface& surface) {
  const double cells = std::max(1, surface.cell_count());
  const int n = static_cast<int>(std::sqrt(kNetPoints / cells));
  return std::clamp(n, kLeastPerSide, kMostPerSide);
}

// The distance at c of a front that passes a and b at distances `at_a` and `at_b`: that of the
// plane front through all three where it comes out of the triangle, else along its sides.
double front_at(const Vector3d& c, const Vector3d& a, double at_a, const Vector3d& b, double at_b) {
  const Vector3d to_a = a - c, to_b = b - c;
  const double along_sides = std::min(at_a + to_a.norm(), at_b + to_b.norm());
  const double e = to_a.squaredNorm(), f = to_a.dot(to_b), g = to_b.squaredNorm();
  const double determinant = e * g - f * f;
  if (!(determinant > 1e-12 * e * g)) return along_sides;
  Eigen::Matrix2d inverse;
  inverse << g, -f, -f, e;
  inverse /= determinant;
  // From the nearer of the two on, as differences of long ways are rounded.
  const double base = std::min(at_a, at_b);
  const Eigen::Vector2d passed(at_a - base, at_b - base), one(1.0, 1.0);
  // A plane front with the gradient n, |n| = 1, has to_a . n = at_a - d, and the same for b, d the
  // distance at c. In the basis of both sides: p d^2 - 2 q d + passed . inverse passed = 1, with
  // the later of its two roots.
  const Eigen::Vector2d by_one = inverse * one;
  const double p = one.dot(by_one), q = passed.dot(by_one);
  const double root = q * q - p * (passed.dot(inverse * passed) - 1.0);
  if (!(root >= 0.0)) return along_sides;
  const double distance = (q + std::sqrt(root)) / p;
  const Eigen::Vector2d way = inverse * (passed - distance * one);
  // Minus the gradient lies between both sides: the front came through the third one.
  const bool comes_out = way.x() < 0.0 && way.y() < 0.0;
  return comes_out ? std::min(base + distance, along_sides) : along_sides;
}

class SurfaceBase final : public FieldBase {
 public:
  SurfaceBase(std::shared_ptr<const FieldBase> base, std::shared_ptr<const GeodesicNet> net)
      : base_(std::move(base)), net_(std::move(net)), distances_(net_->from(*base_)) {}

  BaseFoot foot_within(const Vector3d& p, bool with_length, double) const override {
    BaseFoot foot = base_->foot(p, with_length);
    const GeodesicNet::Reading marched = net_->at(distances_, p);
    const double from = kStraight * marched.spacing, to = kMarched * marched.spacing;
    // No way along the surface is shorter than the straight one, whatever the net says.
    const double way = std::max(marched.distance, foot.distance);
    if (way <= from) return foot;
    // The share of the marched distance rises without a bend at either end.
    const double t = std::min((way - from) / (to - from), 1.0);
    const double share = t * t * (3.0 - 2.0 * t);
    const double rise = way < to ? 6.0 * t * (1.0 - t) / (to - from) : 0.0;
    const Vector3d slope = way > foot.distance ? marched.slope : foot.distance_slope;
    foot.distance_slope =
        (1.0 - share) * foot.distance_slope + share * slope + rise * (way - foot.distance) * slope;
    foot.distance += share * (way - foot.distance);
    return foot;
  }
  bool is_same(const FieldBase& other) const override {
    const auto* along = dynamic_cast<const SurfaceBase*>(&other);
    return along && along->net_ == net_ && base_->is_same(*along->base_);
  }
  bool is_in_centre_plane(double near) const override { return base_->is_in_centre_plane(near); }
  bool has_rim() const override { return base_->has_rim(); }

 private:
  std::shared_ptr<const FieldBase> base_;
  std::shared_ptr<const GeodesicNet> net_;
  std::vector<double> distances_;
};

}  // namespace

GeodesicNet::GeodesicNet(const surface::LimitSurface& surface, bool mirrored)
    : tree_(surface), per_side_(per_side_of(surface)), mirrored_(mirrored) {
  surface::Tessellation net = surface::tessellate(surface, per_side_);
  points_ = std::move(net.points);
  quads_ = std::move(net.quads);
  own_quads_ = quads_.size();
  near_ = kOnCentrePlane * surface.mesh().size();
  side_ = tree_.box().max().y() >= -tree_.box().min().y() ? 1.0 : -1.0;
  if (mirrored_) {
    const int own = static_cast<int>(points_.size());
    for (int i = 0; i < own; ++i) {
      const Vector3d p = points_[i];
      const bool is_shared = std::abs(p.y()) <= near_;
      images_.push_back(is_shared ? i : static_cast<int>(points_.size()));
      if (!is_shared) points_.emplace_back(p.x(), -p.y(), p.z());
    }
    for (std::size_t k = 0; k < own_quads_; ++k) {
      Quad image = quads_[k];
      // Turned over, which means nothing here: cells, and places in them, are as those of the own
      // side.
      for (int& corner : image) corner = images_[corner];
      quads_.push_back(image);
    }
  }
  quads_at_.resize(points_.size());
  longest_.resize(points_.size(), near_);
  for (std::size_t k = 0; k < quads_.size(); ++k) {
    for (int a : quads_[k]) {
      quads_at_[a].push_back(static_cast<int>(k));
      for (int b : quads_[k]) {
        longest_[a] = std::max(longest_[a], (points_[a] - points_[b]).norm());
      }
    }
  }
}

// Every corner from each two others.
void GeodesicNet::relax(const Quad& quad, std::vector<double>& distances,
                        std::vector<int>& changed) const {
  for (int i = 0; i < 4; ++i) {
    double least = distances[quad[i]];
    for (int j = 0; j < 4; ++j) {
      for (int k = j + 1; k < 4; ++k) {
        if (i == j || i == k) continue;
        const int a = quad[j], b = quad[k];
        // A front is never earlier at c than at the first of both.
        if (distances[a] >= least && distances[b] >= least) continue;
        // Where one of both is not known yet the way is along the side from the other.
        if (distances[a] >= kUnreached || distances[b] >= kUnreached) {
          const int known = distances[a] < distances[b] ? a : b;
          least = std::min(least, distances[known] + (points_[known] - points_[quad[i]]).norm());
          continue;
        }
        least = std::min(
            least, front_at(points_[quad[i]], points_[a], distances[a], points_[b], distances[b]));
      }
    }
    if (least < distances[quad[i]] - kRipple * longest_[quad[i]]) {
      distances[quad[i]] = least;
      changed.push_back(quad[i]);
    }
  }
}

std::vector<double> GeodesicNet::from(const FieldBase& base) const {
  std::vector<double> distances(points_.size(), kUnreached);
  using Front = std::pair<double, int>;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double straight = base.foot(points_[i], false).distance;
    if (straight > kBegins * longest_[i]) continue;
    distances[i] = straight;
    front.emplace(straight, static_cast<int>(i));
  }
  if (front.empty()) {
    throw std::invalid_argument(
        "The base is nowhere on the hull: distances along the surface have no beginning there. "
        "Place it on the hull, or measure through space.");
  }
  // What improves a point that was passed by less than this share of the spacing is let be: such
  // ripples would run about for seconds.
  std::vector<int> changed;
  while (!front.empty()) {
    const auto [distance, point] = front.top();
    front.pop();
    // Reached sooner in the meantime, and queued anew then.
    if (distance > distances[point]) continue;
    changed.clear();
    // Not only points that are still open: in obtuse triangles a front may come to a passed point
    // once more, and sooner.
    for (int quad : quads_at_[point]) relax(quads_[quad], distances, changed);
    for (int other : changed) front.emplace(distances[other], other);
  }
  return distances;
}

GeodesicNet::Reading GeodesicNet::at(const std::vector<double>& distances,
                                     const Vector3d& p) const {
  surface::ClosestPoint foot = surface::closest_point(tree_, p);
  bool is_image = false;
  // Halves may reach over the centre plane a little.
  if (mirrored_ && side_ * p.y() < -near_) {
    const surface::ClosestPoint image =
        surface::closest_point(tree_, Vector3d(p.x(), -p.y(), p.z()));
    is_image = image.distance < foot.distance;
    if (is_image) foot = image;
  }
  // The quadrilateral of the net in which the foot lies; in it distances are bilinear.
  const double n = per_side_;
  const int i = std::clamp(static_cast<int>(foot.u * n), 0, per_side_ - 1),
            j = std::clamp(static_cast<int>(foot.v * n), 0, per_side_ - 1);
  const double u = foot.u * n - i, v = foot.v * n - j;
  const std::size_t quad = (is_image ? own_quads_ : 0) +
                           static_cast<std::size_t>((foot.cell * per_side_ + j) * per_side_ + i);
  const Quad& corners = quads_[quad];
  const double weights[4] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
  const double by_u[4] = {-(1 - v), 1 - v, v, -v}, by_v[4] = {-(1 - u), -u, u, 1 - u};
  Reading reading{0.0, Vector3d::Zero(), 0.0};
  double slope_u = 0.0, slope_v = 0.0;
  Vector3d du = Vector3d::Zero(), dv = du;
  for (int k = 0; k < 4; ++k) {
    const double distance = distances[corners[k]];
    const Vector3d& point = points_[corners[k]];
    if (distance >= kUnreached) return {kUnreached, Vector3d::Zero(), 0.0};
    reading.distance += weights[k] * distance;
    slope_u += by_u[k] * distance;
    slope_v += by_v[k] * distance;
    du += by_u[k] * point;
    dv += by_v[k] * point;
    reading.spacing = std::max(reading.spacing, longest_[corners[k]]);
  }
  const double e = du.squaredNorm(), f = du.dot(dv), g = dv.squaredNorm();
  const double determinant = e * g - f * f;
  if (determinant > 1e-12 * e * g) {
    // By the metric of the quadrilateral: the slope within the surface that has these slopes by u
    // and v.
    reading.slope =
        ((g * slope_u - f * slope_v) * du + (e * slope_v - f * slope_u) * dv) / determinant;
  }
  return reading;
}

std::shared_ptr<const FieldBase> along_surface(std::shared_ptr<const FieldBase> base,
                                               std::shared_ptr<const GeodesicNet> distances) {
  return std::make_shared<SurfaceBase>(std::move(base), std::move(distances));
}

}  // namespace hull::modelling
