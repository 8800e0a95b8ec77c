// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace hull::modelling {

// The multipliers of a least step that brings a few numbers r within bounds, as far as prices up to
// `most` allow: with r = start + S λ, S symmetric and not negative,
//
//   r = low  where 0 < λ < most,     r >= low  where λ = 0,     r <= low  where λ = most,
//
// and the same mirrored for high and λ < 0. It is the dual of the quadratic problem: least
// ½ z'Hz with J z + start within the bounds, S = J H⁻¹ J', what is missing priced by `most`.
// Equal bounds ask for a value. S may be singular: then some λ is as good as others, or prices are
// at their most. Active sets as in bounded least squares (Stark & Parker 1995): every step lowers
// the dual's function, so that it ends.
struct DualBounds {
  Eigen::VectorXd low, high, most;
};
Eigen::VectorXd bounded_dual(const Eigen::MatrixXd& S, const Eigen::VectorXd& start,
                             const DualBounds& bounds);

}  // namespace hull::modelling
