// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/targets/move_family.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "modelling/reshape/move_energy.h"

namespace hull::modelling {
namespace {

// Of the mean of the diagonal, added to it: points of which no place tells, and modes that depend
// on one another.
constexpr double kEnergyRegularisation = 1e-10;

Eigen::SparseMatrix<double> columns_of(const std::vector<MoveMode>& modes, std::size_t points) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    if (modes[k].size() != points) {
      throw std::invalid_argument("Mode " + std::to_string(k) + " must have " +
                                  std::to_string(points) + " moves, not " +
                                  std::to_string(modes[k].size()) + ".");
    }
    for (std::size_t i = 0; i < points; ++i) {
      if (!modes[k][i].allFinite()) {
        throw std::invalid_argument("Mode " + std::to_string(k) + " has a move that is no number.");
      }
      for (int axis = 0; axis < 3; ++axis) {
        if (modes[k][i][axis] == 0.0) continue;
        entries.emplace_back(3 * static_cast<int>(i) + axis, static_cast<int>(k),
                             modes[k][i][axis]);
      }
    }
  }
  Eigen::SparseMatrix<double> columns(3 * static_cast<Eigen::Index>(points),
                                      static_cast<Eigen::Index>(modes.size()));
  columns.setFromTriplets(entries.begin(), entries.end());
  return columns;
}

}  // namespace

MoveFamily::MoveFamily(const surface::LimitSurface& surface, const ReshapeLimits& limits,
                       const std::vector<MoveMode>& modes, double stiffness,
                       const std::shared_ptr<const PlaceWeights>& weights)
    : places_(surface, weights ? weights : std::make_shared<PlaceWeights>(surface)) {
  if (!(places_.total_area() > 0.0)) {
    throw std::invalid_argument("The surface has no area: nothing of it can be changed.");
  }
  if (!(stiffness >= 0.0) || !std::isfinite(stiffness)) {
    throw std::invalid_argument("The stiffness must be 0 or more.");
  }
  const std::size_t points = surface.mesh().points().size();
  basis_ = modes.empty() ? MoveSpace(limits, static_cast<int>(points)).basis()
                         : columns_of(modes, points);
  Sparse form = mean_square_form(places_);
  if (stiffness > 0.0) {
    form += thin_plate_form(surface, places_.weights()->forms(),
                            std::pow(stiffness * surface.mesh().size(), 2));
  }
  // A move costs the same along x, y and z; only the basis tells these apart.
  form_ = basis_.transpose() * (for_all_axes(form) * basis_);
  // Dimensions may be free, even so.
  if (size() == 0) return;
  const double mean = form_.diagonal().sum() / static_cast<double>(size());
  Sparse identity(size(), size());
  identity.setIdentity();
  // Kept in the form: what is told as the cost is what is made least.
  form_ += kEnergyRegularisation * mean * identity;
  factors_.compute(form_);
  if (factors_.info() != Eigen::Success) {
    throw std::invalid_argument("The moves that may be taken do not change the surface.");
  }
}

std::array<double, 3> MoveFamily::mean_squares() const {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < places_.count(); ++k) {
    sum += places_.area(k) / places_.total_area() * places_.position(k).cwiseAbs2();
  }
  return {sum.x(), sum.y(), sum.z()};
}

}  // namespace hull::modelling
