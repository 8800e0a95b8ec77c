// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <memory>
#include <vector>

#include "surface/pieces/square_forms.h"

namespace hull::modelling {

// Lies in memory as vectors do: products with sparse matrices go through these once, not for each
// coordinate.
template <int kColumns>
using NumberRows = Eigen::Matrix<double, Eigen::Dynamic, kColumns,
                                 kColumns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;
using VectorRows = NumberRows<3>;

// Places all over a surface with what its points and derivatives there are as sums of control
// points: all of them that depends on topology, tags and scheme alone, so that it serves every
// surface that differs in its points only.
//
// In each bicubic piece they are those of Gauss's rule, three a side or two; in the rings around
// irregular knots always two. The innermost square there is one place, at the knot.
//
// Weights are not multiplied out: places are sums of their square's points by one matrix for all
// squares of a kind, and these are sums of control points. On a hull with thousands of irregular
// points that takes a fortieth of the memory.
class PlaceWeights {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  // The place of an irregular knot. Those of its innermost ring come just before it, as many as in
  // the ring around that, which come before these.
  struct Knot {
    int place, per_ring;
  };
  // Places that follow one another, of one square of the surface, from `first` on: weights of their
  // positions, a row each, and whose, rising.
  struct SquareRows {
    int first;
    std::vector<int> points;
    Eigen::MatrixXd rows;
  };

  // Throws std::invalid_argument unless `per_side` is 2 or 3.
  explicit PlaceWeights(const surface::LimitSurface& surface, int per_side = 3);

  // Whether these are the weights of a surface: it has the same topology, tags and scheme.
  bool fit(const surface::LimitSurface& surface) const;

  int count() const { return static_cast<int>(cells_.size()); }
  int point_count() const { return static_cast<int>(squares().weights().cols()); }
  int cell(int place) const { return cells_[place]; }
  // Of the unit square of the place's piece; 0 at knots.
  double share(int place) const { return shares_[place]; }
  const std::vector<Knot>& knots() const { return knots_; }

  // At the places, of what control points carry, a row each: it, and its derivatives along s and
  // along t of the places' pieces, which are zero at knots.
  VectorRows at(const VectorRows& control) const {
    return std::get<0>(applied<1, 3>(control, {0}));
  }
  std::array<VectorRows, 2> along(const VectorRows& control) const {
    return applied<2, 3>(control, {1, 2});
  }
  // Position and both derivatives.
  std::array<VectorRows, 3> jets(const VectorRows& control) const {
    return applied<3, 3>(control, {0, 1, 2});
  }
  // By control points, of what is known by the places: at's matrix, transposed, times it.
  VectorRows back(const VectorRows& by_places) const { return taken_back<3>(by_places); }
  // The same of one number each, as of one axis: in a third of the time.
  Eigen::VectorXd numbers_at(const Eigen::VectorXd& control) const {
    return std::get<0>(applied<1, 1>(control, {0}));
  }
  Eigen::VectorXd numbers_back(const Eigen::VectorXd& by_places) const {
    return taken_back<1>(by_places);
  }
  // atᵀ · diagonal · at, by control points.
  Matrix form(const Eigen::VectorXd& diagonal) const;

  const surface::SquareForms& forms() const { return forms_; }
  SquareRows rows(int square) const;

 private:
  const surface::SurfaceSquares& squares() const { return forms_.squares(); }
  // Of the places in a square of a kind, by the square's points.
  struct KindRows {
    Eigen::MatrixXd rows[3];  // of positions and derivatives
    std::vector<double> shares;
  };
  class Builder;

  // By each of the rows of kinds that are asked for.
  template <std::size_t kAsked, int kColumns>
  std::array<NumberRows<kColumns>, kAsked> applied(const NumberRows<kColumns>& control,
                                                   const std::array<int, kAsked>& asked) const;
  template <int kColumns>
  NumberRows<kColumns> taken_back(const NumberRows<kColumns>& by_places) const;
  const KindRows& kind_of(int square) const { return kinds_[squares().kind(square)]; }

  mesh::ControlMesh mesh_;  // whose places they are
  std::shared_ptr<const surface::SurfaceLayout> layout_;
  surface::SquareForms forms_;
  std::vector<KindRows> kinds_;
  std::vector<int> first_;  // places of the squares
  std::vector<int> cells_;
  std::vector<double> shares_;
  std::vector<Knot> knots_;
};

}  // namespace hull::modelling
