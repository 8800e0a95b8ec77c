// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "modelling/reshape/surface_places.h"
#include "surface/limit_surface.h"

namespace hull::morphing {

// Hulls of one topology as the parents of a family. Its members are the hulls whose control points
// are Σ w_k P_k of the parents' control points P_k, with weights that sum to 1: the surface is
// linear in its control points, so each of its points is the same sum of the parents' points with
// the same cell, u and v, and a member has the parents' faces, creases and corners (equation 22 of
// Kang & Lee 2012 for two parents, on control meshes instead of triangles). Weights below 0 or
// above 1 extrapolate.
//
// A weight of 1 beside zeros gives that parent bit by bit, and a coordinate that all parents have
// alike stays bit by bit for all weights: the centre plane, and flats square to an axis.
//
// Immutable: queries are thread-safe.
class HullFamily {
 public:
  // Throws std::invalid_argument for fewer than two parents, and with the first of differences().
  explicit HullFamily(std::vector<surface::LimitSurface> parents);

  int parent_count() const { return static_cast<int>(parents_.size()); }
  int point_count() const { return parents_[0].mesh().topology().vertex_count(); }
  const std::vector<surface::LimitSurface>& parents() const { return parents_; }

  // Control points of a member. Throws std::invalid_argument unless there is a weight for each
  // parent, all are finite and they sum to 1, to kWeightSum.
  std::vector<Vector3d> points(const std::vector<double>& weights) const;
  // The same with weights of each control point, points x parents; see local_weights().
  std::vector<Vector3d> points(const Eigen::MatrixXd& weights) const;
  static constexpr double kWeightSum = 1e-9;

  void check_weights(const std::vector<double>& weights) const;

  // Where, on the first parent, a surface of these control points is the first time turned over: by
  // a right angle or more against each of the parents, as where weights beyond 0 to 1 or local ones
  // fold it. Throws std::invalid_argument unless there are as many points.
  std::optional<Vector3d> first_fold(const std::vector<Vector3d>& points) const;

 private:
  std::vector<surface::LimitSurface> parents_;
  std::vector<modelling::SurfacePlaces> places_;
};

}  // namespace hull::morphing
