// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hull::surface {

// A group of eigenvalues that are equal, nearly so, or a complex pair, with the matrix's action on
// its subspace: `eigenvalue` (their mean) times the identity, or, if `coupled`, `action`: a Jordan
// block, or a rotation.
struct DominantBlock {
  double eigenvalue;
  int begin, size;  // columns of DominantSpectrum::right and left
  bool coupled;
  Eigen::MatrixXd action;  // size x size
};

// The part of a subdivision matrix S that decays slowly under S, S^2, …:
//   S right = right diag(blocks),  left^T S = diag(blocks) left^T,  left^T right = I.
// What is left of a vector, x - right (left^T x), is multiplied by at most `rest` (asymptotically)
// in each step.
struct DominantSpectrum {
  Eigen::MatrixXd left, right;        // N x m
  std::vector<DominantBlock> blocks;  // by falling modulus; the first is the eigenvalue 1
  double rest;                        // largest modulus of the other eigenvalues
};

// Splits off all eigenvalues above a threshold chosen in the widest gap between `floor` and 1/4.
// Subspaces come from inverse iteration with groups of close eigenvalues kept together, so that a
// Jordan block (docs/surface.md, trap 1) costs no accuracy. REQUIRES: S is a local subdivision
// matrix: its rows sum to one, and the eigenvalue 1 is simple.
DominantSpectrum dominant_spectrum(const Eigen::MatrixXd& S, double floor);

}  // namespace hull::surface
