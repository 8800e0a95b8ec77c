// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/families/wanted_weights.h"

#include <stdexcept>
#include <utility>

#include "mesh/dense_solvers.h"

namespace hull::morphing {
namespace {

using modelling::MoveMode;

std::vector<MoveMode> differences_from_first(const HullFamily& family) {
  const std::vector<Vector3d>& first = family.parents()[0].mesh().points();
  std::vector<MoveMode> modes;
  for (int k = 1; k < family.parent_count(); ++k) {
    MoveMode mode = family.parents()[k].mesh().points();
    for (std::size_t i = 0; i < mode.size(); ++i) mode[i] -= first[i];
    modes.push_back(std::move(mode));
  }
  return modes;
}

Eigen::VectorXd coordinates(const std::vector<Vector3d>& vectors) {
  Eigen::VectorXd all(3 * static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    all.segment<3>(3 * static_cast<Eigen::Index>(i)) = vectors[i];
  }
  return all;
}

// How much of each mode is in the moves, which begin with a member and end scaled.
Eigen::VectorXd shares(const std::vector<MoveMode>& modes, const std::vector<Vector3d>& start,
                       const modelling::TargetsReached& reached) {
  std::vector<Vector3d> moves = reached.moves;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    // Scaled about the origin, after the modes: so the scale goes first.
    moves[i] = (start[i] + moves[i]).cwiseQuotient(reached.scale) - start[i];
  }
  Eigen::MatrixXd columns(3 * static_cast<Eigen::Index>(moves.size()),
                          static_cast<Eigen::Index>(modes.size()));
  for (std::size_t k = 0; k < modes.size(); ++k) {
    columns.col(static_cast<Eigen::Index>(k)) = coordinates(modes[k]);
  }
  // Parents may depend on one another, as three in a row do: of all shares the least.
  return mesh::least_norm_solution(columns, coordinates(moves));
}

}  // namespace

WantedWeights wanted_weights(const HullFamily& family, const std::vector<double>& start,
                             const std::vector<modelling::FormTarget>& targets,
                             modelling::TargetOptions options, const surface::Progress& progress) {
  const std::vector<Vector3d> points = family.points(start);
  surface::LimitSurface surface = family.parents()[0];
  surface.set_points(points);
  options.limits = {};
  options.modes = differences_from_first(family);
  bool is_any = false;
  for (const MoveMode& mode : options.modes) is_any = is_any || !coordinates(mode).isZero(0.0);
  if (!is_any) {
    throw std::invalid_argument("All parents are the same hull: no weights change it.");
  }
  WantedWeights found{start, modelling::reach_targets(surface, targets, options, progress)};
  const Eigen::VectorXd gains = shares(options.modes, points, found.reached);
  for (Eigen::Index k = 0; k < gains.size(); ++k) {
    found.weights[static_cast<std::size_t>(k) + 1] += gains[k];
    // Modes are differences from the first parent: what another gains it loses, and the sum stays
    // 1.
    found.weights[0] -= gains[k];
  }
  return found;
}

}  // namespace hull::morphing
