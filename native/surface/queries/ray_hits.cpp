// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/queries/ray_hits.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>

#include "surface/eigenbasis/deep_rings.h"
#include "surface/queries/infinity.h"
#include "surface/queries/patch_crossings.h"
#include "surface/wide_code.h"

namespace hull::surface {
namespace {

constexpr double kTolerance = 1e-13, kTouching = 2e-7;  // of the size
constexpr double kSteepest = 1e300;  // stands for 1 / 0, so that nothing is 0 times infinity

// A place on the surface with its t, before hits of neighbours are joined.
struct RawHit {
  RayHit hit;
  double t_error;  // infinite: touching
};

struct RawStretch {
  RayHit begin, end;
};

class Caster {
 public:
  Caster(const SurfaceTree& tree, const Ray& ray, bool first_only)
      : tree_(tree), first_only_(first_only), tolerance_(kTolerance * tree.error_size()) {
    // Seen from the point of the ray nearest to the surface's middle all lengths are of its size.
    frame_.col(2) = ray.direction.normalized();
    shift_ = (tree.box().center() - ray.origin).dot(frame_.col(2));
    origin_ = ray.origin + shift_ * frame_.col(2);
    frame_.col(0) = frame_.col(2).unitOrthogonal();
    frame_.col(1) = frame_.col(2).cross(frame_.col(0));
    for (int a = 0; a < 3; ++a) {
      const double d = frame_(a, 2);
      inverse_[a] = std::abs(d) > 1.0 / kSteepest ? 1.0 / d : kSteepest;
    }
    z_min_ = ray.t_min - shift_;
    z_max_ = ray.t_max - shift_;
  }

  std::vector<RayHit> run() {
    descend();
    return joined();
  }

 private:
  struct Waiting {
    double near;
    std::int32_t child;
  };

  // Where the line enters the four boxes of a node, widened by the tolerance; infinity where it
  // passes.
  void enter(const SurfaceTree::Node& node, double* near) const {
    double from[4], to[4];
    for (int k = 0; k < 4; ++k) {
      from[k] = z_min_ - tolerance_;
      to[k] = z_max_ + tolerance_;
    }
    for (int a = 0; a < 3; ++a) {
      // Slabs (Kay and Kajiya 1986); the signs of the inverse need no branch.
      const double low_at = origin_[a] + tolerance_, high_at = origin_[a] - tolerance_;
      for (int k = 0; k < 4; ++k) {
        const double x = (node.low[a][k] - low_at) * inverse_[a];
        const double y = (node.high[a][k] - high_at) * inverse_[a];
        const double first = x < y ? x : y, last = x < y ? y : x;
        from[k] = from[k] > first ? from[k] : first;
        to[k] = to[k] < last ? to[k] : last;
      }
    }
    for (int k = 0; k < 4; ++k) near[k] = from[k] <= to[k] ? from[k] : kInfinity;
  }

  HULL_WIDE void descend() {
    std::array<Waiting, 256> stack;
    int height = 0;
    stack[height++] = {-kInfinity, 0};
    while (height > 0) {
      const Waiting at = stack[--height];
      if (at.near > z_max_ + tolerance_) continue;
      if (at.child < 0) {
        visit_item(SurfaceTree::item(at.child));
        continue;
      }
      const SurfaceTree::Node& node = tree_.nodes()[at.child];
      double near[4];
      enter(node, near);
      // The nearest goes on top.
      Waiting* const first = stack.data() + height;
      int count = 0;
      for (int k = 0; k < 4; ++k) {
        if (node.child[k] == SurfaceTree::kNoChild || near[k] == kInfinity) continue;
        int i = count++;
        for (; i > 0 && first[i - 1].near <= near[k]; --i) first[i] = first[i - 1];
        first[i] = {near[k], node.child[k]};
      }
      height += count;
      assert(height + 4 <= static_cast<int>(stack.size()));
    }
  }

  void visit_item(int item) {
    if (item < tree_.piece_count()) {
      visit_patch(tree_.patch(item), tree_.place(item));
    } else {
      visit_deep_corner(item - tree_.piece_count());
    }
  }

  HULL_WIDE BezierPatch in_frame(const BezierPatch& patch) const {
    BezierPatch seen;
    for (int k = 0; k < 3; ++k) {
      const double a = frame_(0, k), b = frame_(1, k), c = frame_(2, k);
      for (int i = 0; i < 16; ++i) {
        seen.x[k][i] = a * (patch.x[0][i] - origin_[0]) + b * (patch.x[1][i] - origin_[1]) +
                       c * (patch.x[2][i] - origin_[2]);
      }
    }
    return seen;
  }

  void visit_patch(const BezierPatch& patch, const PiecePlace& place) {
    PatchCrossings found(tolerance_, kTouching * tree_.error_size(), z_min_ - tolerance_,
                         z_max_ + tolerance_);
    found.find(in_frame(patch));
    const auto hit = [&](const Crossing& at) {
      const Eigen::Vector2d uv = place.in_cell(at.u, at.v);
      return RayHit{at.z, place.cell, uv.x(), uv.y(), position(patch, at.u, at.v), false};
    };
    for (const Crossing& at : found.crossings()) keep({hit(at), at.z_error});
    for (const AxisStretch& along : found.stretches()) {
      stretches_.push_back({hit(along.begin), hit(along.end)});
    }
  }

  static Vector3d position(const BezierPatch& patch, double u, double v) {
    SurfaceJet jet;
    evaluate_first(patch, u, v, jet);
    return jet.point;
  }

  void visit_deep_corner(int index) {
    DeepRings rings(tree_, index);
    while (!is_passed(rings.square())) {
      if (rings.is_down_to_knot()) {
        const Vector3d knot = frame_.transpose() * (rings.knot() - origin_);
        if (knot.head<2>().norm() > tolerance_) return;
        const PiecePlace& place = rings.place();
        const Eigen::Vector2d uv = place.in_cell(0.0, 0.0);
        keep({{knot.z(), place.cell, uv.x(), uv.y(), rings.knot(), false}, tolerance_});
        return;
      }
      rings.next_ring(
          [this](const BezierPatch& patch, const PiecePlace& place) { visit_patch(patch, place); });
    }
  }

  bool is_passed(const std::vector<Vector3d>& points) const {
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : points) box.extend(frame_.transpose() * (p - origin_));
    return box.min().x() > tolerance_ || box.max().x() < -tolerance_ ||
           box.min().y() > tolerance_ || box.max().y() < -tolerance_ ||
           box.min().z() > z_max_ + tolerance_ || box.max().z() < z_min_ - tolerance_;
  }

  void keep(const RawHit& raw) {
    if (raw.hit.t < z_min_ || raw.hit.t > z_max_) return;
    hits_.push_back(raw);
    // Whatever lies farther is not wanted, but for what may have to be joined with this one.
    // A touching hit may give way to another one, so it shortens nothing.
    if (first_only_ && std::isfinite(raw.t_error)) {
      z_max_ = std::min(z_max_, raw.hit.t + 4.0 * raw.t_error);
    }
  }

  // What crosses the surface where the ray runs along it, or just before or after, is part of the
  // stretch, which reaches as far: a crossing before its beginning may be all that is wanted, and
  // what lies farther be left out already.
  void swallow_crossings(RawStretch& stretch, double gap) {
    const double from = stretch.begin.t - gap, to = stretch.end.t + gap;
    std::erase_if(hits_, [&](const RawHit& raw) {
      if (raw.hit.t < from || raw.hit.t > to) return false;
      if (raw.hit.t < stretch.begin.t) stretch.begin = raw.hit;
      if (raw.hit.t > stretch.end.t) stretch.end = raw.hit;
      return true;
    });
  }

  // Ends of the stretches that touch one another, in order.
  void join_stretches() {
    std::sort(stretches_.begin(), stretches_.end(), [](const auto& a, const auto& b) {
      return std::tie(a.begin.t, a.end.t, a.begin.cell) <
             std::tie(b.begin.t, b.end.t, b.begin.cell);
    });
    const double gap = 100.0 * tolerance_;
    std::size_t count = 0;
    for (const RawStretch& stretch : stretches_) {
      if (count > 0 && stretch.begin.t <= stretches_[count - 1].end.t + gap) {
        RayHit& end = stretches_[count - 1].end;
        if (stretch.end.t > end.t) end = stretch.end;
      } else {
        stretches_[count++] = stretch;
      }
    }
    stretches_.resize(count);
    for (RawStretch& stretch : stretches_) swallow_crossings(stretch, gap);
    for (RawStretch& stretch : stretches_) {
      stretch.begin.grazing = stretch.end.grazing = true;
      hits_.push_back({stretch.begin, gap});
      if (stretch.end.t > stretch.begin.t + gap) hits_.push_back({stretch.end, gap});
    }
  }

  // Of hits of neighbours at their common side, one; touching ones give way to others.
  std::vector<RayHit> joined() {
    join_stretches();
    std::erase_if(hits_,
                  [&](const RawHit& raw) { return raw.hit.t < z_min_ || raw.hit.t > z_max_; });
    std::sort(hits_.begin(), hits_.end(), [](const RawHit& a, const RawHit& b) {
      return std::tie(a.hit.t, a.hit.cell, a.hit.u, a.hit.v) <
             std::tie(b.hit.t, b.hit.cell, b.hit.u, b.hit.v);
    });
    const double touching = 4.0 * kTouching * tree_.error_size();
    std::vector<RawHit> kept;
    for (const RawHit& raw : hits_) {
      if (!kept.empty()) {
        RawHit& last = kept.back();
        const double apart = raw.hit.t - last.hit.t;
        const bool is_touching = !std::isfinite(raw.t_error);
        if (!std::isfinite(last.t_error) || is_touching) {
          if (apart <= touching) {
            if (!is_touching) last = raw;
            continue;
          }
        } else if (apart <= 2.0 * (raw.t_error + last.t_error)) {
          last.hit.grazing = last.hit.grazing && raw.hit.grazing;
          last.t_error = std::max(last.t_error, raw.t_error);
          continue;
        }
      }
      kept.push_back(raw);
    }
    std::vector<RayHit> result;
    for (RawHit& raw : kept) {
      if (!std::isfinite(raw.t_error)) raw.hit.grazing = true;
      raw.hit.t += shift_;
      result.push_back(raw.hit);
    }
    return result;
  }

  const SurfaceTree& tree_;
  const bool first_only_;
  const double tolerance_;
  Eigen::Matrix3d frame_;  // columns: two across the ray, and along it
  Vector3d origin_;
  double shift_;  // t of origin_
  double inverse_[3];
  double z_min_, z_max_;
  std::vector<RawHit> hits_;
  std::vector<RawStretch> stretches_;
};

void check(const Ray& ray) {
  if (!ray.origin.allFinite()) throw std::invalid_argument("the ray's origin is not finite.");
  if (!ray.direction.allFinite()) {
    throw std::invalid_argument("the ray's direction is not finite.");
  }
  if (!(ray.direction.norm() > 0.0) || !std::isfinite(ray.direction.norm())) {
    throw std::invalid_argument("the ray's direction has no length to use; give it one near 1.");
  }
  if (std::isnan(ray.t_min) || std::isnan(ray.t_max)) {
    throw std::invalid_argument("t_min and t_max must be numbers.");
  }
}

}  // namespace

std::optional<RayHit> first_ray_hit(const SurfaceTree& tree, const Ray& ray) {
  check(ray);
  const std::vector<RayHit> hits = Caster(tree, ray, true).run();
  if (hits.empty()) return std::nullopt;
  return hits.front();
}

std::vector<RayHit> all_ray_hits(const SurfaceTree& tree, const Ray& ray) {
  check(ray);
  return Caster(tree, ray, false).run();
}

}  // namespace hull::surface
