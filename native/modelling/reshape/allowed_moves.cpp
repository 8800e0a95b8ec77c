// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/allowed_moves.h"

#include <map>
#include <stdexcept>
#include <string>

#include "mesh/dense_solvers.h"

namespace hull::modelling {
namespace {

void check_moves(const std::vector<int>& points, const std::vector<Vector3d>& moves, int count) {
  if (points.size() != moves.size()) {
    throw std::invalid_argument("There must be a move for each of " +
                                std::to_string(points.size()) + " points, not " +
                                std::to_string(moves.size()) + ".");
  }
  for (int point : points) check_point(point, count, "moved");
  for (const Vector3d& move : moves) {
    if (!move.allFinite()) throw std::invalid_argument("A wanted move is no number.");
  }
}

// Of the basis: rows of these points' coordinates, columns that have a part in them.
Eigen::MatrixXd basis_rows(const MoveSpace& space, const std::vector<int>& points) {
  const Eigen::SparseMatrix<double, Eigen::RowMajor> basis(space.basis());
  std::vector<Eigen::Triplet<double>> entries;
  std::map<Eigen::Index, Eigen::Index> column;
  for (std::size_t i = 0; i < 3 * points.size(); ++i) {
    const Eigen::Index row = 3 * points[i / 3] + static_cast<Eigen::Index>(i % 3);
    for (decltype(basis)::InnerIterator it(basis, row); it; ++it) {
      // Numbered as they are met: other columns move none of these points.
      const auto own = column.emplace(it.col(), static_cast<Eigen::Index>(column.size())).first;
      entries.emplace_back(static_cast<int>(i), static_cast<int>(own->second), it.value());
    }
  }
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * points.size()),
                                               static_cast<Eigen::Index>(column.size()));
  for (const auto& entry : entries) rows(entry.row(), entry.col()) = entry.value();
  return rows;
}

}  // namespace

std::vector<Vector3d> allowed_moves(const MoveSpace& space, const std::vector<int>& points,
                                    const std::vector<Vector3d>& moves) {
  check_moves(points, moves, space.point_count());
  std::vector<Vector3d> result(points.size(), Vector3d::Zero());
  const Eigen::MatrixXd rows = basis_rows(space, points);
  if (rows.size() == 0) return result;
  Eigen::VectorXd wanted(rows.rows());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    wanted.segment<3>(3 * static_cast<Eigen::Index>(i)) = moves[i];
  }
  // The projection on what the rows span: of dependent columns any solution makes the same moves.
  const Eigen::VectorXd found = rows * mesh::least_norm_solution(rows, wanted);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = found.segment<3>(3 * static_cast<Eigen::Index>(i));
  }
  return result;
}

}  // namespace hull::modelling
