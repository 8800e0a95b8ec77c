// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/move_equations.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "mesh/groups.h"
#include "modelling/reshape/move_energy.h"

namespace hull::modelling {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Of the mean of the diagonal. Refinement takes away what this does where places tell of a point.
constexpr double kRegularisation = 1e-11;

// Axes that columns of the basis mix, and the columns of each set of them.
std::array<std::vector<int>, 3> columns_by_axes(const Matrix& basis) {
  mesh::Groups axes(3);
  for (int column = 0; column < basis.cols(); ++column) {
    const auto first = Matrix::InnerIterator(basis, column).row() % 3;
    for (Matrix::InnerIterator it(basis, column); it; ++it) {
      // One column along two axes makes one system of both, for all columns.
      axes.join(static_cast<int>(first), static_cast<int>(it.row() % 3));
    }
  }
  std::array<std::vector<int>, 3> columns;
  for (int column = 0; column < basis.cols(); ++column) {
    const auto axis = Matrix::InnerIterator(basis, column).row() % 3;
    columns[axes.find(static_cast<int>(axis))].push_back(column);
  }
  return columns;
}

// Some columns of the basis; of the rows of one axis where they have no others.
Matrix part_of(const Matrix& basis, const std::vector<int>& columns) {
  std::vector<Eigen::Triplet<double>> entries;
  std::array<bool, 3> has{};
  for (int column : columns) {
    for (Matrix::InnerIterator it(basis, column); it; ++it) has[it.row() % 3] = true;
  }
  const bool is_alone = std::ranges::count(has, true) == 1;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (Matrix::InnerIterator it(basis, columns[k]); it; ++it) {
      entries.emplace_back(is_alone ? it.row() / 3 : it.row(), k, it.value());
    }
  }
  Matrix part(is_alone ? basis.rows() / 3 : basis.rows(),
              static_cast<Eigen::Index>(columns.size()));
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

bool is_same(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols(), b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr()) &&
         std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr());
}

}  // namespace

MoveEquations::MoveEquations(const MoveSpace& space, const Matrix& form) {
  std::vector<Matrix> bases;  // of the parts
  for (std::vector<int>& columns : columns_by_axes(space.basis())) {
    if (columns.empty()) continue;
    const Matrix basis = part_of(space.basis(), columns);
    std::shared_ptr<const Factors> factors;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      // Without limits, or with the same ones along each axis, the parts' bases are equal to the
      // bit.
      if (is_same(bases[i], basis)) factors = parts_[i].factors;
    }
    if (!factors) {
      const bool is_alone = basis.rows() == form.rows();
      Matrix matrix = basis.transpose() * ((is_alone ? form : for_all_axes(form)) * basis);
      const double mean = matrix.diagonal().sum() / static_cast<double>(matrix.rows());
      Matrix identity(matrix.rows(), matrix.cols());
      identity.setIdentity();
      matrix += kRegularisation * mean * identity;
      auto computed = std::make_shared<Factors>(matrix);
      if (computed->info() != Eigen::Success) {
        throw std::invalid_argument(
            "The surface is so uneven that no shift of it can be computed.");
      }
      factors = std::move(computed);
    }
    parts_.push_back({std::move(columns), std::move(factors)});
    bases.push_back(basis);
  }
}

Eigen::VectorXd MoveEquations::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd result(right.size());
  for (const Part& part : parts_) {
    // By itself: a permutation in place is not noticed to be one behind indices.
    const Eigen::VectorXd own = part.factors->solve(Eigen::VectorXd(right(part.columns)));
    result(part.columns) = own;
  }
  return result;
}

}  // namespace hull::modelling
