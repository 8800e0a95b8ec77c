// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "modelling/fields/along_base.h"
#include "modelling/fields/curve_change.h"
#include "modelling/fields/field_base.h"

namespace hull::modelling {

// A field of influence around a base (Veelo 2004): it shifts what is near, or protects it. Its
// intensity is 1 at the base and falls to 0 at the extent, as falloff.h says.
struct ShapeField {
  std::shared_ptr<const FieldBase> base;
  bool protects = false;
  std::array<bool, 3> axes{true, true, true};  // which coordinates of shifts it has a say in
  AlongBase<double> extent{1.0};               // m, positive
  AlongBase<double> kappa{0.5};                // 0 to 1; above 0.9 curvature jumps at the extent
  AlongBase<Vector3d> shift{Vector3d::Zero().eval()};  // m, of the base
  // Instead of base and shift: the curve, which becomes the other curve. With a base, distances are
  // those from that, which has the same lengths.
  std::shared_ptr<const CurveChange> change;
};

// How fields that overlap share in a shift.
enum class FieldBlend {
  // Equation 2: shifts add up, so a base within another field misses its target.
  kSum,
  // Bases get the shift that their own field gives them, whatever other fields overlap there; a
  // field alone is that of equation 2. See field_blend.cpp for the weights.
  kExact
};

// A field itself, its image in the centre plane, or the two in one, where the base is in the plane.
enum class FieldSide { kOwn, kImage, kBoth };

struct FieldShift {
  Vector3d shift;            // m
  Eigen::Matrix3d gradient;  // of the shift by the point: row i is that of coordinate i
};

// Points at which fields are asked for again and again, as while a slider moves: where the bases
// are nearest to them is kept, and found anew for those bases alone that have changed. Not for
// several threads at once.
class FieldPlaces {
 public:
  explicit FieldPlaces(std::vector<Vector3d> points) : points_(std::move(points)) {}

  const std::vector<Vector3d>& points() const { return points_; }

 private:
  friend class ShapeFields;
  struct Feet {
    std::shared_ptr<const FieldBase> base;
    FieldSide side;
    bool with_length;
    double within;  // m: those farther are not known
    std::vector<BaseFoot> feet;
  };

  // What is known of a base; nothing where that is not so.
  std::shared_ptr<Feet> found(const FieldBase& base, FieldSide side, bool with_length,
                              double within) const;
  // Keeps these alone of what is known. The memory of one of the others; empty where there is none.
  std::vector<BaseFoot> forget_all_but(const std::vector<std::shared_ptr<Feet>>& kept);

  std::vector<Vector3d> points_;
  std::vector<std::shared_ptr<Feet>> known_;  // of the fields asked for last
};

// Fields that together shift points of space.
//
// `mirrored`: each field works on both sides of the centre plane, so that the shift is symmetric
// about it; a point on it stays on it. A base in the plane, within 1e-4 of the extent, is its own
// image: what is to starboard is shifted as its image is.
//
// Protection comes first: within a protecting field no base gets all of its shift. Where bases with
// different shifts meet, none can be met by all: there the shift is their mean.
//
// Immutable; thread-safe.
class ShapeFields {
 public:
  // Throws std::invalid_argument, naming the field, for one without base, and for extents, kappas
  // and shifts that are none, at any of the values that are given along the base.
  ShapeFields(std::vector<ShapeField> fields, bool mirrored, FieldBlend blend);

  FieldShift at(const Vector3d& p) const;
  // The same for many points, on all processors.
  std::vector<FieldShift> at(const std::vector<Vector3d>& points) const;
  std::vector<FieldShift> at(FieldPlaces& places) const;

  // The distance divided by the extent, of one field; of the nearer of the field and its image.
  double delta(int field, const Vector3d& p) const;

  const std::vector<ShapeField>& fields() const { return fields_; }

 private:
  // A field, or its image, or both in one.
  struct Side {
    std::size_t field;
    FieldSide side;
  };
  struct Scratch;
  // By the foot of each side, which are in the scratch.
  FieldShift blended(const Vector3d& p, Scratch& scratch) const;
  // Whether a foot is within the extent of a field that moves, or may be.
  bool may_move(const std::vector<BaseFoot>& feet) const;

  std::vector<ShapeField> fields_;
  std::vector<Side> sides_;
  FieldBlend blend_;
};

}  // namespace hull::modelling
