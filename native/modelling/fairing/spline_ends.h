// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "modelling/fairing/curve_smoothing.h"

namespace hull::modelling {

// What the ends of a spline say of its first and last coefficients over certain knots: given ones;
// and with a second derivative of zero one that is a mean of its neighbours. All others are free.
class SplineEnds {
 public:
  // Throws std::invalid_argument for ends that the degree or the dimension does not have.
  // `is_polynomial`: there are just as many points and conditions as a polynomial of the degree
  // meets, so that no knots are asked for.
  static void check(const CurveEnd& end, int degree, Eigen::Index dimension, bool is_polynomial);

  // REQUIRES: ends that check() has seen.
  SplineEnds(const CurveEnd& start, const CurveEnd& end, int degree,
             const std::vector<double>& knots);

  // Throws std::invalid_argument where what is given at both ends asks for other values of one and
  // the same coefficient, as of a low degree without knots between.
  void check_agreement() const;

  Eigen::Index free_count() const { return free_count_; }
  bool is_free(Eigen::Index coefficient) const { return free_of_[coefficient] >= 0; }

  // A row over coefficients from `from` on as one over free ones: their values, from the one that
  // is returned on, and what given ones take off the right side. -1 where none is free.
  Eigen::Index reduce(Eigen::Index from, const Eigen::VectorXd& values, Eigen::VectorXd& reduced,
                      Eigen::RowVectorXd& right) const;
  // All coefficients, from the free ones; `free` has as many columns as the ends, or given none.
  Eigen::MatrixXd complete(const Eigen::MatrixXd& free) const;

  // Conditions besides the place, each of which takes a knot more to interpolate.
  static int extra(const CurveEnd& end);

 private:
  // A coefficient that follows from two others, by their shares.
  struct Tie {
    Eigen::Index coefficient;
    std::array<std::pair<Eigen::Index, double>, 2> from;
  };
  void give(const CurveEnd& start, const CurveEnd& end, int degree,
            const std::vector<double>& knots);
  void tie(bool at_start, bool at_end, int degree, const std::vector<double>& knots);

  Eigen::MatrixXd given_;              // zero where nothing is given
  std::vector<Eigen::Index> free_of_;  // number among the free ones; -1: not free
  std::vector<Tie> ties_;
  Eigen::Index free_count_ = 0;
  bool is_contradictory_ = false;
};

}  // namespace hull::modelling
