// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/quadratic_energy.h"

#include <cassert>
#include <stdexcept>

#include "modelling/fairing/blend_energy.h"

namespace hull::modelling {

Eigen::SparseMatrix<double> along_each_axis(const std::vector<Eigen::Triplet<double>>& entries,
                                            Eigen::Index size) {
  std::vector<Eigen::Triplet<double>> all;
  all.reserve(3 * entries.size());
  for (const auto& entry : entries) {
    for (int axis = 0; axis < 3; ++axis) {
      all.emplace_back(3 * entry.row() + axis, 3 * entry.col() + axis, entry.value());
    }
  }
  Eigen::SparseMatrix<double> result(3 * size, 3 * size);
  result.setFromTriplets(all.begin(), all.end());
  return result;
}

void visit_energy_forms(const surface::LimitSurface& surface, const surface::PieceWeights& weights,
                        const std::vector<int>& some, FairEnergy energy, const VisitForm& visit) {
  switch (energy) {
    case FairEnergy::kLengthwise:
      return visit_lengthwise_forms(surface, weights, some, visit);
    case FairEnergy::kBlend:
      return visit_blend_forms(weights, some, visit);
    default:
      assert(energy == FairEnergy::kThinPlate);
      return visit_thin_plate_forms(surface, weights, some, 1.0, visit);
  }
}

QuadraticEnergy quadratic_energy(const surface::LimitSurface& surface,
                                 const surface::PieceWeights& weights, const std::vector<int>& some,
                                 FairEnergy energy, const std::vector<char>& counts) {
  const std::vector<Vector3d>& points = surface.mesh().points();
  const auto size = static_cast<Eigen::Index>(points.size());
  QuadraticEnergy sum{{}, Eigen::VectorXd::Zero(3 * size)};
  std::vector<Eigen::Triplet<double>> entries;
  visit_energy_forms(surface, weights, some, energy,
                     [&](const std::vector<int>& which, const Eigen::MatrixXd& form) {
                       for (Eigen::Index i = 0; i < form.rows(); ++i) {
                         for (Eigen::Index j = 0; j < form.cols(); ++j) {
                           // Points that stay bend the surface, too: they are in gradient and
                           // constant.
                           sum.gradient.segment<3>(3 * which[i]) += form(i, j) * points[which[j]];
                           sum.constant += form(i, j) * points[which[i]].dot(points[which[j]]);
                           // Entries of others would be multiplied by moves that are zero.
                           if (counts[which[i]] && counts[which[j]]) {
                             entries.emplace_back(which[i], which[j], form(i, j));
                           }
                         }
                       }
                     });
  if (energy == FairEnergy::kBlend && entries.empty()) {
    throw std::invalid_argument(
        "That energy tells nothing of the chosen points: irregular points are all around. Choose "
        "another one, or subdivide.");
  }
  sum.matrix = along_each_axis(entries, size);
  return sum;
}

}  // namespace hull::modelling
