// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/blend_energy.h"

#include "surface/pieces/bicubic_basis.h"

namespace hull::modelling {

void visit_blend_forms(const surface::PieceWeights& pieces, const std::vector<int>& some,
                       const VisitForm& visit) {
  const Eigen::Matrix<double, 1, 16> sixth =
      surface::bicubic_basis(kThirdDerivative, kThirdDerivative).transpose();
  for (int index : some) {
    const surface::PieceWeights::Piece& piece = pieces.piece(index);
    // Pieces of rings are smaller than their cell.
    if (piece.size < 1.0) continue;
    const Eigen::RowVectorXd row = sixth * piece.rows;
    visit(piece.points, row.transpose() * row);
  }
}

}  // namespace hull::modelling
