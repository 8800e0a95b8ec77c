// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/move_energy.h"

#include <vector>

#include "modelling/reshape/square_pieces.h"
#include "modelling/thin_plate.h"

namespace hull::modelling {
Eigen::SparseMatrix<double> mean_square_form(const SurfacePlaces& places) {
  Eigen::VectorXd shares(places.count());
  for (int k = 0; k < places.count(); ++k) shares[k] = places.area(k) / places.total_area();
  return places.weights()->form(shares);
}

Eigen::SparseMatrix<double> thin_plate_form(const surface::LimitSurface& surface,
                                            const surface::SquareForms& forms, double factor) {
  const surface::SurfaceSquares& squares = forms.squares();
  std::vector<std::vector<Eigen::MatrixXd>> pieces;  // of each kind
  for (const surface::SurfaceSquares::Kind& kind : squares.kinds()) {
    pieces.push_back(square_pieces(kind));
  }
  return forms.sum([&](int square, Eigen::MatrixXd& form) {
    const auto add = [&](const surface::BicubicPoints& points, const Eigen::MatrixXd& rows) {
      const Eigen::MatrixXd half = (factor * thin_plate_of_span(points)) * rows;
      form.noalias() += rows.transpose() * half;
    };
    const int kind = squares.kind(square), index = squares.index(square);
    // A leaf is one piece; those of a corner are in the order of square_pieces().
    if (!squares.kinds()[kind].basis) return add(surface.leaf(index), pieces[kind].front());
    for (std::size_t k = 0; k < pieces[kind].size(); ++k) {
      add(surface.corner(index).segments[k], pieces[kind][k]);
    }
  });
}

Eigen::SparseMatrix<double> for_all_axes(const Eigen::SparseMatrix<double>& form) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * static_cast<std::size_t>(form.nonZeros()));
  for (Eigen::Index column = 0; column < form.outerSize(); ++column) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(form, column); it; ++it) {
      for (int axis = 0; axis < 3; ++axis) {
        entries.emplace_back(3 * it.row() + axis, 3 * it.col() + axis, it.value());
      }
    }
  }
  Eigen::SparseMatrix<double> result(3 * form.rows(), 3 * form.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace hull::modelling
