// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/fair_shifts.h"

#include <algorithm>
#include <cmath>

#include "mesh/dense_solvers.h"

namespace hull::modelling {
namespace {

constexpr int kSpans = 48, kSamples = 385;
constexpr double kEven = 0.08, kFloor = 0.1;
// A normal as near to the x axis is that of a transom, which has no lines along the ship.
constexpr double kAcross = 0.9;
// Against bends of order 1: what is to stay moves by a millionth part.
constexpr double kHeld = 1e8;

// The uniform cubic B-spline about 0, or a derivative of it.
double spline(double t, int derivative) {
  // By its halves: even itself and by its second derivative, odd by its first; zero from 2 on.
  const double a = std::abs(t), r = std::max(2.0 - a, 0.0), sign = t < 0.0 ? -1.0 : 1.0;
  switch (derivative) {
    case 0:
      return a < 1.0 ? (4.0 - 6.0 * a * a + 3.0 * a * a * a) / 6.0 : r * r * r / 6.0;
    case 1:
      return sign * (a < 1.0 ? -2.0 * a + 1.5 * a * a : -0.5 * r * r);
    default:
      return a < 1.0 ? -2.0 + 3.0 * a : r;
  }
}

bool is_within(const std::vector<HullRange>& ranges, double x) {
  return std::ranges::any_of(
      ranges, [x](const HullRange& range) { return x >= range.aft && x <= range.forward; });
}

}  // namespace

FairShifts::FairShifts(const AreaCurve& areas, const HullRange& immersed,
                       const SurfacePlaces& places, const ShiftConstraints& constraints)
    : forward_(constraints.length_pp) {
  for (int k = 0; k < places.count(); ++k) {
    aft_ = std::min(aft_, places.position(k).x());
    forward_ = std::max(forward_, places.position(k).x());
  }
  const Eigen::VectorXd samples = Eigen::VectorXd::LinSpaced(kSamples, aft_, forward_);
  Row volume = Row::Zero(kSpans + 3), moment = volume;
  const double middle = 0.5 * constraints.length_pp;
  for (double x : samples) {
    if (x < immersed.aft || x > immersed.forward) continue;
    const Row slope = areas.at(x) * row(x, 1);
    volume += slope;
    // About amidships: about x = 0 it would nearly be a multiple of the volume's.
    moment += (x - middle) * slope + areas.at(x) * row(x, 0);
  }
  const Eigen::Index size = kSpans + 3;
  // Both perpendiculars stay.
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(size + 2, size + 2);
  // The energy bordered by the conditions (Lagrange): alone it is singular, as straight shifts bend
  // nothing.
  equations.topLeftCorner(size, size) = energy(places, constraints);
  equations.row(size).head(size) = row(0.0, 0);
  equations.row(size + 1).head(size) = row(constraints.length_pp, 0);
  equations.rightCols(2) = equations.bottomRows(2).transpose().eval();
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(size + 2, 2);
  // Sums over samples stand for integrals: the spacing drops out with their lengths.
  changes.col(0).head(size) = volume.transpose() / volume.norm();
  changes.col(1).head(size) = moment.transpose() / moment.norm();
  // The least energy for a change is the response to its slope; by how much, the caller's
  // coefficients say.
  const Eigen::MatrixXd responses = mesh::least_norm_solutions(equations, changes);
  coefficients_ = {responses.col(0).head(size), responses.col(1).head(size)};
  // Of LCB's function as much of the other as takes the volume back.
  coefficients_[1] -=
      volume.dot(coefficients_[1]) / volume.dot(coefficients_[0]) * coefficients_[0];
  for (Eigen::VectorXd& own : coefficients_) {
    double steepest = 0.0;
    for (double x : samples) steepest = std::max(steepest, std::abs(row(x, 1).dot(own)));
    if (steepest > 0.0) own /= steepest;
  }
}

FairShifts::Row FairShifts::row(double x, int derivative) const {
  const double span = (forward_ - aft_) / kSpans, t = (x - aft_) / span;
  Row result = Row::Zero(kSpans + 3);
  const auto first = static_cast<Eigen::Index>(std::floor(t));
  for (Eigen::Index k = std::max<Eigen::Index>(first, 0); k < first + 4 && k < result.size(); ++k) {
    // Number k is centred at the knot k - 1: the first and the last beyond the ends.
    result[k] = spline(t - static_cast<double>(k - 1), derivative) / std::pow(span, derivative);
  }
  return result;
}

Eigen::VectorXd FairShifts::weights(const SurfacePlaces& places,
                                    const Eigen::VectorXd& samples) const {
  const double reach = kEven * (forward_ - aft_), step = samples[1] - samples[0];
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(samples.size());
  for (int k = 0; k < places.count(); ++k) {
    const double along = places.normal(k).x(), x = places.position(k).x();
    if (std::abs(along) > kAcross) continue;
    const auto first = static_cast<Eigen::Index>(std::max(0.0, (x - reach - aft_) / step));
    for (Eigen::Index i = first; i < samples.size() && samples[i] < x + reach; ++i) {
      // Each place counts in a triangle about it: so the rows of places do not show.
      const double share = 1.0 - std::abs(samples[i] - x) / reach;
      sums[i] += std::max(share, 0.0) * places.area(k) * along * along;
    }
  }
  const double most = sums.maxCoeff();
  if (most > 0.0) sums /= most;
  return sums.array() + kFloor;
}

Eigen::MatrixXd FairShifts::energy(const SurfacePlaces& places,
                                   const ShiftConstraints& constraints) const {
  const Eigen::VectorXd samples = Eigen::VectorXd::LinSpaced(kSamples, aft_, forward_);
  const Eigen::VectorXd bent = weights(places, samples);
  const double length = forward_ - aft_;
  Eigen::MatrixXd form = Eigen::MatrixXd::Zero(kSpans + 3, kSpans + 3);
  // All without dimension: s over the length, x over the length.
  for (Eigen::Index i = 0; i < samples.size(); ++i) {
    const double x = samples[i], share = 1.0 / kSamples;
    const Row bend = length * row(x, 2), slope = row(x, 1), shift = row(x, 0) / length;
    form += share * bent[i] * bend.transpose() * bend;
    if (is_within(constraints.rigid, x)) form += share * kHeld * slope.transpose() * slope;
    if (is_within(constraints.still, x)) form += share * kHeld * shift.transpose() * shift;
  }
  return form;
}

double FairShifts::value(int k, double x) const {
  const double within = std::clamp(x, aft_, forward_);
  const Eigen::VectorXd& own = coefficients_[k];
  const double value = row(within, 0).dot(own);
  return x == within ? value : value + row(within, 1).dot(own) * (x - within);
}

}  // namespace hull::modelling
