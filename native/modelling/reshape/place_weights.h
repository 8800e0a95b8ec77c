// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <vector>

#include "surface/limit_surface.h"

namespace hull::modelling {

// Places all over a surface with what its points and derivatives there are as sums of control
// points: all of them that depends on topology, tags and scheme alone, so that it serves every
// surface that differs in its points only.
//
// In each bicubic piece they are those of Gauss's rule, three a side or two; in the rings around
// irregular knots always two. The innermost square there is one place, at the knot.
class PlaceWeights {
 public:
  using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  using Matrix = Eigen::SparseMatrix<double>;

  // The place of an irregular knot. Those of its innermost ring come just before it, as many as in
  // the ring around that, which come before these.
  struct Knot {
    int place, per_ring;
  };

  // Throws std::invalid_argument unless `per_side` is 2 or 3.
  explicit PlaceWeights(const surface::LimitSurface& surface, int per_side = 3);

  // Whether these are the weights of a surface: it has the same topology, tags and scheme.
  bool fit(const surface::LimitSurface& surface) const;

  int count() const { return static_cast<int>(cells_.size()); }
  int cell(int place) const { return cells_[place]; }
  // Of the unit square of the place's piece; 0 at knots.
  double share(int place) const { return shares_[place]; }
  const std::vector<Knot>& knots() const { return knots_; }

  // Places x control points: weights of positions, and of the two derivatives along the place's
  // piece; empty rows of these at knots.
  const Rows& at() const { return at_; }
  const Rows& along_s() const { return along_s_; }
  const Rows& along_t() const { return along_t_; }

  // atᵀ · diagonal · at, by control points.
  Matrix form(const Eigen::VectorXd& diagonal) const;

 private:
  class Builder;
  // Places that follow one another with weights of the same control points, and where the products
  // of these, column by column, are among the values of form().
  struct Block {
    int first, count, size;
    std::vector<int> slots;
  };
  void find_slots();

  // Whose places they are.
  std::shared_ptr<const surface::SurfaceLayout> layout_;
  mesh::ControlMesh mesh_;
  std::vector<int> cells_;
  std::vector<double> shares_;
  std::vector<Knot> knots_;
  Rows at_, along_s_, along_t_;
  Matrix pattern_;  // of form()
  std::vector<Block> blocks_;
};

}  // namespace hull::modelling
