// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/spline_ends.h"

#include <algorithm>
#include <stdexcept>

namespace hull::modelling {
namespace {

using Eigen::Index;

constexpr int kDegreeOfSecond = 5;  // with second derivatives given
constexpr double kAgreeing = 1e-9;  // of a coefficient's size

// The first coefficients of a spline that has a place and derivatives at its start, by the lengths
// from there to the next knots; of the last ones these are the negative lengths back.
Eigen::MatrixXd end_coefficients(const Eigen::MatrixXd& given, int degree, double to_first,
                                 double to_second) {
  Eigen::MatrixXd rows = given;
  // With d the degree: f' = d (c1 - c0) / (k1 - k0), and f'' = d (d - 1) / (k1 - k0) times ((c2 -
  // c1) / (k2 - k0) - (c1 - c0) / (k1 - k0)).
  if (given.rows() > 1) rows.row(1) = given.row(0) + given.row(1) * to_first / degree;
  if (given.rows() > 2) {
    const Eigen::RowVectorXd slope = (rows.row(1) - rows.row(0)) / to_first;
    rows.row(2) =
        rows.row(1) + to_second * (given.row(2) * to_first / (degree * (degree - 1.0)) + slope);
  }
  return rows;
}

}  // namespace

void SplineEnds::check(const CurveEnd& end, int degree, Index dimension, bool is_polynomial) {
  const Index rows = end.given.rows();
  if (rows > 0 && (rows > 3 || end.given.cols() != dimension || !end.given.allFinite())) {
    throw std::invalid_argument(
        "At an end a curve may have a place, a first and a second derivative, each with as many "
        "coordinates as the points.");
  }
  if ((rows > 2 || (rows > 1 && end.is_straight)) && degree < kDegreeOfSecond && !is_polynomial) {
    throw std::invalid_argument(
        "A tangent and a curvature at one end need a curve of degree 5, not " +
        std::to_string(degree) + ".");
  }
  if (end.is_straight && (degree < 3 || rows > 2)) {
    throw std::invalid_argument(
        "An end without curvature needs a degree of 3 or more, and no curvature given there.");
  }
}

int SplineEnds::extra(const CurveEnd& end) {
  return std::max(0, static_cast<int>(end.given.rows()) - 1) + (end.is_straight ? 1 : 0);
}

SplineEnds::SplineEnds(const CurveEnd& start, const CurveEnd& end, int degree,
                       const std::vector<double>& knots)
    : free_of_(knots.size() - static_cast<std::size_t>(degree) - 1, 0) {
  give(start, end, degree, knots);
  tie(start.is_straight && start.given.rows() < 2, end.is_straight && end.given.rows() < 2, degree,
      knots);
  for (Index& number : free_of_) {
    if (number >= 0) number = free_count_++;
  }
}

void SplineEnds::give(const CurveEnd& start, const CurveEnd& end, int degree,
                      const std::vector<double>& knots) {
  const Index count = static_cast<Index>(free_of_.size());
  const std::size_t n = knots.size(), d = static_cast<std::size_t>(degree);
  const auto with_straight = [](const CurveEnd& at) {
    Eigen::MatrixXd rows = at.given;
    if (at.is_straight && rows.rows() == 2) {
      // With a place and a tangent, no curvature is one more given coefficient rather than a tie.
      rows.conservativeResize(3, Eigen::NoChange);
      rows.row(2).setZero();
    }
    return rows;
  };
  const Eigen::MatrixXd first = end_coefficients(with_straight(start), degree,
                                                 knots[d + 1] - knots[d], knots[d + 2] - knots[d]);
  const Eigen::MatrixXd last =
      end_coefficients(with_straight(end), degree, knots[n - d - 2] - knots[n - d - 1],
                       knots[n - d - 3] - knots[n - d - 1]);
  given_ = Eigen::MatrixXd::Zero(count, std::max(first.cols(), last.cols()));
  // Backwards from the end.
  for (Index row = 0; row < last.rows(); ++row) {
    given_.row(count - 1 - row) = last.row(row);
    free_of_[count - 1 - row] = -1;
  }
  for (Index row = 0; row < first.rows(); ++row) {
    const bool is_given = free_of_[row] < 0;
    if (is_given && !first.row(row).isApprox(given_.row(row), kAgreeing)) is_contradictory_ = true;
    given_.row(row) = first.row(row);
    free_of_[row] = -1;
  }
}

void SplineEnds::check_agreement() const {
  if (!is_contradictory_) return;
  throw std::invalid_argument(
      "The curve cannot have the places and tangents of both ends without knots between: take a "
      "degree of 3, or a smaller deviation.");
}

// f″ = 0 where (c2 - c1) / (k2 - k0) = (c1 - c0) / (k1 - k0), with k1 and k2 the knots after the
// end's k0.
void SplineEnds::tie(bool at_start, bool at_end, int degree, const std::vector<double>& knots) {
  const Index count = static_cast<Index>(free_of_.size());
  const std::size_t n = knots.size(), d = static_cast<std::size_t>(degree);
  // What the coefficient beside the end has of the end's; the rest is its other neighbour's.
  const auto share = [](double to_first, double to_second) {
    return to_second / (to_first + to_second);
  };
  const double start = share(knots[d + 1] - knots[d], knots[d + 2] - knots[d]);
  const double end =
      share(knots[n - d - 1] - knots[n - d - 2], knots[n - d - 1] - knots[n - d - 3]);
  if (at_start && at_end && count == 4) {
    // Each is a neighbour of the other: a straight line.
    const double common = 1.0 - (1.0 - start) * (1.0 - end);
    ties_.push_back({1, {{{0, start / common}, {3, (1.0 - start) * end / common}}}});
    ties_.push_back({2, {{{0, (1.0 - end) * start / common}, {3, end / common}}}});
  } else {
    if (at_start) ties_.push_back({1, {{{0, start}, {2, 1.0 - start}}}});
    if (at_end) ties_.push_back({count - 2, {{{count - 1, end}, {count - 3, 1.0 - end}}}});
  }
  for (const Tie& tied : ties_) free_of_[tied.coefficient] = -1;
}

Index SplineEnds::reduce(Index from, const Eigen::VectorXd& values, Eigen::VectorXd& reduced,
                         Eigen::RowVectorXd& right) const {
  std::array<std::pair<Index, double>, 24> parts;
  std::size_t part_count = 0;
  Index low = -1, high = -1;
  const auto add = [&](Index coefficient, double value) {
    // What is given goes to the right side.
    const Index number = free_of_[coefficient];
    if (number < 0) {
      right -= value * given_.row(coefficient);
      return;
    }
    low = low < 0 ? number : std::min(low, number);
    high = std::max(high, number);
    parts[part_count++] = {number, value};
  };
  for (Index k = 0; k < values.size(); ++k) {
    const auto tied = std::ranges::find(ties_, from + k, &Tie::coefficient);
    if (tied == ties_.end()) {
      add(from + k, values[k]);
    } else {
      // A tied one is replaced by its share of each neighbour, so that a row may begin one earlier
      // or end one later.
      for (const auto& [other, part] : tied->from) add(other, part * values[k]);
    }
  }
  if (low < 0) return -1;
  // Numbers of free ones rise with the coefficients, so that rows stay narrow.
  reduced = Eigen::VectorXd::Zero(high - low + 1);
  for (std::size_t i = 0; i < part_count; ++i) reduced[parts[i].first - low] += parts[i].second;
  return low;
}

Eigen::MatrixXd SplineEnds::complete(const Eigen::MatrixXd& free) const {
  Eigen::MatrixXd all =
      given_.cols() > 0 ? given_ : Eigen::MatrixXd::Zero(given_.rows(), free.cols());
  for (std::size_t i = 0; i < free_of_.size(); ++i) {
    if (free_of_[i] >= 0) all.row(static_cast<Index>(i)) = free.row(free_of_[i]);
  }
  for (const Tie& tied : ties_) {
    all.row(tied.coefficient) = tied.from[0].second * all.row(tied.from[0].first) +
                                tied.from[1].second * all.row(tied.from[1].first);
  }
  return all;
}

}  // namespace hull::modelling
