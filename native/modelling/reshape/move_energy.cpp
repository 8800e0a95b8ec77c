// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/move_energy.h"

#include <vector>

#include "modelling/thin_plate.h"

namespace hull::modelling {

Eigen::SparseMatrix<double> mean_square_form(const SurfacePlaces& places) {
  Eigen::VectorXd shares(places.count());
  for (int k = 0; k < places.count(); ++k) shares[k] = places.area(k) / places.total_area();
  return places.weights()->form(shares);
}

Eigen::SparseMatrix<double> thin_plate_form(const surface::LimitSurface& surface, double factor) {
  std::vector<Eigen::Triplet<double>> entries;
  // Pieces that follow one another, those around a knot above all, often have the same points.
  std::vector<int> same;
  Eigen::MatrixXd sum;
  const auto add_sum = [&] {
    for (Eigen::Index j = 0; j < sum.cols(); ++j) {
      for (Eigen::Index i = 0; i < sum.rows(); ++i) {
        entries.emplace_back(same[i], same[j], sum(i, j));
      }
    }
  };
  visit_thin_plate_forms(surface, surface::PieceWeights(surface), factor,
                         [&](const std::vector<int>& points, const Eigen::MatrixXd& form) {
                           if (points == same) {
                             sum += form;
                             return;
                           }
                           add_sum();
                           same = points;
                           sum = form;
                         });
  add_sum();
  const auto size = static_cast<Eigen::Index>(surface.mesh().points().size());
  Eigen::SparseMatrix<double> form(size, size);
  form.setFromTriplets(entries.begin(), entries.end());
  return form;
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
