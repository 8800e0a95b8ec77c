// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fields/field_base.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mesh/tolerances.h"
#include "surface/queries/closest_point.h"
#include "surface/queries/surface_tree.h"

namespace hull::modelling {
namespace {

BaseFoot foot_at(const Vector3d& p, const Vector3d& closest, double distance) {
  const Vector3d from = p - closest;
  const Vector3d slope = distance > 0.0 ? Vector3d(from / distance) : Vector3d::Zero().eval();
  return {distance, slope, 0.0, Vector3d::Zero()};
}

class PointBase final : public FieldBase {
 public:
  explicit PointBase(const Vector3d& point) : point_(point) {}
  BaseFoot foot_within(const Vector3d& p, bool, double) const override {
    return foot_at(p, point_, (p - point_).norm());
  }
  bool is_same(const FieldBase& other) const override {
    const auto* point = dynamic_cast<const PointBase*>(&other);
    return point && point->point_ == point_;
  }
  bool is_in_centre_plane(double near) const override { return std::abs(point_.y()) <= near; }

 private:
  Vector3d point_;
};

class PlaneBase final : public FieldBase {
 public:
  PlaneBase(const Vector3d& point, const Vector3d& normal) : point_(point), normal_(normal) {}
  BaseFoot foot_within(const Vector3d& p, bool, double) const override {
    const double height = (p - point_).dot(normal_);
    // On the plane itself either side will do: no intensity has a slope at the base.
    return {std::abs(height), height < 0.0 ? Vector3d(-normal_) : normal_, 0.0, Vector3d::Zero()};
  }
  bool is_same(const FieldBase& other) const override {
    const auto* plane = dynamic_cast<const PlaneBase*>(&other);
    return plane && plane->point_ == point_ && plane->normal_ == normal_;
  }
  bool is_in_centre_plane(double near) const override {
    // The sine of its angle to the centre plane.
    const bool is_parallel = std::hypot(normal_.x(), normal_.z()) <= kOnCentrePlane;
    return is_parallel && std::abs(point_.y()) <= near;
  }

 private:
  Vector3d point_, normal_;
};

class CurveBase final : public FieldBase {
 public:
  explicit CurveBase(FieldCurve curve) : curve_(std::move(curve)) {}
  BaseFoot foot_within(const Vector3d& p, bool with_length, double) const override {
    const CurveFoot found = curve_.foot(p, with_length);
    BaseFoot foot = foot_at(p, found.point, found.distance);
    foot.length = found.length;
    foot.length_slope = found.length_slope;
    return foot;
  }
  bool is_same(const FieldBase& other) const override {
    const auto* curve = dynamic_cast<const CurveBase*>(&other);
    return curve && curve->curve_.arcs() == curve_.arcs();
  }
  bool is_in_centre_plane(double near) const override {
    for (const FieldCurve::Arc& arc : curve_.arcs()) {
      for (const Vector3d& point : arc) {
        if (!(std::abs(point.y()) <= near)) return false;
      }
    }
    return true;
  }

 private:
  FieldCurve curve_;
};

class RegionBase final : public FieldBase {
 public:
  RegionBase(const surface::LimitSurface& surface, const std::vector<int>& cells)
      : tree_(surface, cells) {}
  BaseFoot foot_within(const Vector3d& p, bool, double within) const override {
    const surface::ClosestPoint closest = surface::closest_point(tree_, p, within);
    if (closest.cell < 0) return {surface::kInfinity, Vector3d::Zero(), 0.0, Vector3d::Zero()};
    // Of its own points rounding is left.
    const bool is_on_it = closest.distance <= kOnRegion * tree_.error_size();
    return foot_at(p, closest.point, is_on_it ? 0.0 : closest.distance);
  }
  bool is_same(const FieldBase& other) const override {
    const auto* region = dynamic_cast<const RegionBase*>(&other);
    if (!region || region->tree_.piece_count() != tree_.piece_count()) return false;
    for (int i = 0; i < tree_.piece_count(); ++i) {
      // Cells and their 16 points to the bit: so a surface that was moved is another base.
      const surface::PiecePlace &own = tree_.place(i), &its = region->tree_.place(i);
      const double *points = tree_.patch(i).x[0], *others = region->tree_.patch(i).x[0];
      if (own.cell != its.cell || !std::equal(points, points + 48, others)) return false;
    }
    return true;
  }
  bool is_in_centre_plane(double near) const override {
    return std::max(std::abs(tree_.box().min().y()), std::abs(tree_.box().max().y())) <= near;
  }
  bool has_rim() const override { return true; }

 private:
  static constexpr double kOnRegion = 1e-13;  // of the size
  surface::SurfaceTree tree_;
};

}  // namespace

std::shared_ptr<const FieldBase> point_base(const Vector3d& point) {
  if (!point.allFinite()) throw std::invalid_argument("The base's point is no number.");
  return std::make_shared<PointBase>(point);
}

std::shared_ptr<const FieldBase> plane_base(const Vector3d& point, const Vector3d& normal) {
  if (!point.allFinite()) throw std::invalid_argument("The base's point is no number.");
  if (!normal.allFinite() || normal.isZero(0.0)) {
    throw std::invalid_argument("The normal of the base's plane has no length.");
  }
  return std::make_shared<PlaneBase>(point, normal.stableNormalized());
}

std::shared_ptr<const FieldBase> curve_base(FieldCurve curve) {
  return std::make_shared<CurveBase>(std::move(curve));
}

std::shared_ptr<const FieldBase> region_base(const surface::LimitSurface& surface,
                                             const std::vector<int>& cells) {
  return std::make_shared<RegionBase>(surface, cells);
}

}  // namespace hull::modelling
