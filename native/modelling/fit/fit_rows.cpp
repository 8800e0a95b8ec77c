// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit_rows.h"

#include <cmath>

#include "surface/pieces/point_weights.h"

namespace hull::modelling::fit_internal {
namespace {

// Row of 3 numbers a point: weight times direction, times the root of the row's weight.
void fill_row(const FitRow& row, const Eigen::VectorXd& weights, Eigen::MatrixXd& matrix,
              Eigen::Index index) {
  const double root = std::sqrt(row.weight);
  for (Eigen::Index k = 0; k < weights.size(); ++k) {
    matrix.block<1, 3>(index, 3 * k) = root * weights[k] * row.direction.transpose();
  }
}

void add_products(const std::vector<int>& points, const Eigen::MatrixXd& matrix,
                  const Eigen::VectorXd& right, FitEquations& equations) {
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(matrix.cols(), matrix.cols());
  // The lower half alone: the equations take no more.
  hessian.selfadjointView<Eigen::Lower>().rankUpdate(matrix.transpose());
  equations.add(points, hessian, matrix.transpose() * right);
}

void add_deep_row(const FitRow& row, surface::PointWeights& weights, FitEquations& equations) {
  std::vector<int> points;
  std::vector<double> values;
  // In the squares at irregular knots that pieces leave out.
  for (const surface::PointWeight& w : weights.at(row.cell, row.u, row.v)) {
    points.push_back(w.point);
    values.push_back(w.weight);
  }
  Eigen::MatrixXd matrix(1, 3 * static_cast<Eigen::Index>(points.size()));
  fill_row(row, Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size())),
           matrix, 0);
  add_products(points, matrix, Eigen::VectorXd::Constant(1, std::sqrt(row.weight) * row.distance),
               equations);
}

}  // namespace

void add_rows(const std::vector<FitRow>& rows, const surface::LimitSurface& surface,
              const surface::PieceWeights& pieces, FitEquations& equations) {
  surface::PointWeights deep(surface);
  std::vector<std::vector<std::pair<const FitRow*, surface::PieceWeights::Place>>> by_piece(
      pieces.piece_count());
  for (const FitRow& row : rows) {
    // Rows of one piece have the same points: by pieces their squares are one dense product, and
    // each block of the equations is looked up once for all of them.
    if (const auto place = pieces.find(row.cell, row.u, row.v)) {
      by_piece[place->piece].emplace_back(&row, *place);
    } else {
      add_deep_row(row, deep, equations);
    }
  }
  for (int i = 0; i < pieces.piece_count(); ++i) {
    const auto& here = by_piece[i];
    if (here.empty()) continue;
    const std::vector<int>& points = pieces.piece(i).points;
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(here.size()),
                           3 * static_cast<Eigen::Index>(points.size()));
    Eigen::VectorXd right(matrix.rows());
    for (Eigen::Index k = 0; k < matrix.rows(); ++k) {
      const auto& [row, place] = here[static_cast<std::size_t>(k)];
      fill_row(*row, pieces.weights(place), matrix, k);
      right[k] = std::sqrt(row->weight) * row->distance;
    }
    add_products(points, matrix, right, equations);
  }
}

}  // namespace hull::modelling::fit_internal
