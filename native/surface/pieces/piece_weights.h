// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "surface/limit_surface.h"
#include "surface/pieces/pieces.h"
#include "surface/pieces/point_weights.h"

namespace hull::surface {

// The bicubic pieces of a surface as matrices of weights of its control points: what
// point_weights.h says of single places, for very many of them, and for derivatives. Regular cells
// are one piece each; around irregular knots there are kPlainRings rings of pieces, within which a
// square of 2^-kPlainRings is left out.
//
// Depends on topology, tags and scheme only. Immutable: queries are thread-safe.
class PieceWeights {
 public:
  struct Piece {
    int cell;
    double size;  // of its side, of the cell's
    std::vector<int> points;
    Eigen::MatrixXd rows;  // 16 x points: the B-spline points of the piece from control points
  };
  // Where in a piece a place of the surface is, along the piece's own sides.
  struct Place {
    int piece;
    double s, t;
  };
  // Weights of the piece's points in a position and its derivatives to the piece's own (s, t).
  struct Jet {
    Eigen::VectorXd at, ds, dt, dss, dst, dtt;
  };

  explicit PieceWeights(const LimitSurface& surface);

  int piece_count() const { return static_cast<int>(pieces_.size()); }
  const Piece& piece(int index) const { return pieces_[index]; }

  // None in the squares left out. REQUIRES: as LimitSurface::position().
  std::optional<Place> find(int cell, double u, double v) const;
  Eigen::VectorXd weights(const Place& place) const;
  Jet jet(const Place& place) const;

 private:
  void add_node(int cell, const SurfaceNode& node, double size, PointWeights& weights);
  void add_corner(int cell, int corner, double size, PointWeights& weights);

  std::shared_ptr<const SurfaceLayout> layout_;
  std::vector<Piece> pieces_;
  std::vector<int> of_leaf_, of_corner_;  // their first pieces
};

}  // namespace hull::surface
