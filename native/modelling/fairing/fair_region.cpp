// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fairing/fair_region.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "modelling/fairing/bounded_minimum.h"
#include "modelling/fairing/fair_limits.h"
#include "modelling/fairing/quadratic_energy.h"

namespace hull::modelling {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Damping, of the mean of the normal equations' diagonal over that of the mass.
constexpr double kFirstDamping = 1e-3, kLeastDamping = 1e-12, kMostDamping = 1e9;
// Of the energy: steps that gain less, this many in a row, end the descent.
constexpr double kNoGain = 1e-9;
constexpr int kIdleSteps = 2;

}  // namespace

// What is prepared once: everything but the deviation.
class FairRegion::Problem {
 public:
  Problem(const surface::LimitSurface& surface, const FairOptions& options)
      : most_steps_(options.most_steps),
        energy_(options.energy),
        points_(surface.mesh().points()),
        places_(surface),
        weights_(surface),
        space_(fair_limits(surface, options), static_cast<int>(points_.size())),
        conditions_(condition_rows(options.conditions, static_cast<int>(points_.size()))) {
    if (space_.size() == 0) {
      throw std::invalid_argument(
          "None of the chosen points may move: they are locked, or of creases or borders that are "
          "kept.");
    }
    find_moving();
    find_region();
    if (options.before) {
      take(bend_change(points_, *options.before, weights_, pieces_, may_move_));
    } else if (energy_ == FairEnergy::kCurvature || energy_ == FairEnergy::kVariation) {
      geometric_.emplace(weights_, pieces_, energy_);
    } else {
      take(quadratic_energy(surface, weights_, pieces_, energy_, may_move_));
    }
    take_wishes(options.wishes);
    minimum_.emplace(mass(), Sparse(conditions_ * space_.basis()));
  }

  const SurfacePlaces& places() const { return places_; }
  const std::vector<int>& region() const { return region_; }
  double area() const { return area_; }

  Faired solve(double deviation, double largest, const std::vector<double>& values,
               const surface::Progress& progress) const;

 private:
  using Result = BoundedMinimum::Result;

  void find_moving();
  void find_region();
  void take(const QuadraticEnergy& energy);
  void take_wishes(const std::vector<WishedSum>& wishes);
  Sparse mass() const;

  Result descend(const Eigen::VectorXd& values, double deviation, double largest,
                 const surface::Progress& progress, Faired& faired) const;
  // Normal equations of the geometric energy about control points: by freedom.
  void linearise(const std::vector<Vector3d>& points, Sparse& h, Eigen::VectorXd& g) const;
  double energy_at(const Eigen::VectorXd& x) const;
  Eigen::VectorXd shifts(const Eigen::VectorXd& x) const;
  double excess(const Eigen::VectorXd& x, double largest) const {
    return std::isfinite(largest) ? shifts(x).maxCoeff() / largest : 0.0;
  }
  std::vector<Vector3d> moved(const Eigen::VectorXd& x) const;

  int most_steps_;
  FairEnergy energy_;
  std::vector<Vector3d> points_;
  SurfacePlaces places_;
  surface::PieceWeights weights_;
  MoveSpace space_;
  Sparse conditions_;
  std::vector<char> may_move_;  // of each control point
  std::vector<int> region_, pieces_;
  double area_ = 0.0;
  Sparse h_;             // of quadratic energies, by freedom
  Eigen::VectorXd g_;    // half its gradient
  double constant_ = 0;  // the energy without moves
  std::optional<SurfaceEnergy> geometric_;
  std::optional<BoundedMinimum> minimum_;
};

void FairRegion::Problem::find_moving() {
  may_move_.assign(points_.size(), 0);
  const Sparse& basis = space_.basis();
  for (Eigen::Index column = 0; column < basis.outerSize(); ++column) {
    for (Sparse::InnerIterator it(basis, column); it; ++it) may_move_[it.row() / 3] = 1;
  }
}

void FairRegion::Problem::find_region() {
  const auto moves = [&](int point) { return may_move_[point] != 0; };
  const PlaceWeights& weights = *places_.weights();
  for (int square = 0; square < weights.forms().squares().count(); ++square) {
    const PlaceWeights::SquareRows own = weights.rows(square);
    for (Eigen::Index k = 0; k < own.rows.rows(); ++k) {
      bool is_in = false;
      for (std::size_t i = 0; i < own.points.size() && !is_in; ++i) {
        is_in = own.rows(k, static_cast<Eigen::Index>(i)) != 0.0 && moves(own.points[i]);
      }
      if (!is_in) continue;
      region_.push_back(own.first + static_cast<int>(k));
      area_ += places_.area(region_.back());
    }
  }
  if (!(area_ > 0.0)) {
    throw std::invalid_argument("The surface has no area around the chosen points.");
  }
  for (int piece = 0; piece < weights_.piece_count(); ++piece) {
    if (std::ranges::any_of(weights_.piece(piece).points, moves)) pieces_.push_back(piece);
  }
}

Sparse FairRegion::Problem::mass() const {
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(places_.count());
  for (int place : region_) shares[place] = places_.area(place) / area_;
  const Sparse form = places_.weights()->form(shares);
  Triplets entries;
  for (Eigen::Index column = 0; column < form.outerSize(); ++column) {
    for (Sparse::InnerIterator it(form, column); it; ++it) {
      // Others have no part in the basis: without them the products are small.
      if (may_move_[it.row()] && may_move_[it.col()]) {
        entries.emplace_back(it.row(), it.col(), it.value());
      }
    }
  }
  const Sparse full = along_each_axis(entries, static_cast<Eigen::Index>(points_.size()));
  return space_.basis().transpose() * (full * space_.basis());
}

void FairRegion::Problem::take(const QuadraticEnergy& energy) {
  h_ = space_.basis().transpose() * (energy.matrix * space_.basis());
  g_ = space_.basis().transpose() * energy.gradient;
  constant_ = energy.constant;
}

void FairRegion::Problem::take_wishes(const std::vector<WishedSum>& wishes) {
  if (wishes.empty()) return;
  if (geometric_) {
    throw std::invalid_argument("Sums can be wished for with quadratic energies alone.");
  }
  std::vector<MoveCondition> sums;
  Eigen::VectorXd values(wishes.size()), weights(wishes.size());
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    sums.push_back(wishes[i].sum);
    values[static_cast<Eigen::Index>(i)] = wishes[i].value;
    weights[static_cast<Eigen::Index>(i)] = wishes[i].weight;
  }
  if (!values.allFinite() || !weights.allFinite() || !(weights.minCoeff() >= 0.0)) {
    throw std::invalid_argument(
        "What is wished for must be finite, and its weight not below zero.");
  }
  const Sparse rows = condition_rows(sums, static_cast<int>(points_.size())) * space_.basis();
  h_ += Sparse(rows.transpose() * weights.asDiagonal() * rows);
  // Half the gradient, as g_ is throughout.
  g_ -= rows.transpose() * weights.cwiseProduct(values);
  constant_ += values.dot(weights.cwiseProduct(values));
}

std::vector<Vector3d> FairRegion::Problem::moved(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd moves = space_.basis() * x;
  std::vector<Vector3d> points = points_;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] += moves.segment<3>(3 * static_cast<Eigen::Index>(i));
  }
  return points;
}

Eigen::VectorXd FairRegion::Problem::shifts(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd moves = space_.basis() * x;
  const VectorRows shifts = places_.weights()->at(as_rows(moves));
  return shifts.rowwise().norm();
}

double FairRegion::Problem::energy_at(const Eigen::VectorXd& x) const {
  if (geometric_) return geometric_->value(moved(x));
  return constant_ + x.dot(h_ * x) + 2.0 * g_.dot(x);
}

void FairRegion::Problem::linearise(const std::vector<Vector3d>& points, Sparse& h,
                                    Eigen::VectorXd& g) const {
  const SurfaceEnergy::Normal normal = geometric_->normal(points, may_move_);
  h = space_.basis().transpose() * (normal.matrix * space_.basis());
  g = space_.basis().transpose() * normal.gradient;
}

BoundedMinimum::Result FairRegion::Problem::descend(const Eigen::VectorXd& values, double deviation,
                                                    double largest,
                                                    const surface::Progress& progress,
                                                    Faired& faired) const {
  const Sparse weights = mass();
  // From the shortest moves that meet the conditions.
  Result now{minimum_->shortest(values), 0.0, 0.0, false};
  double energy = energy_at(now.x), damping = kFirstDamping;
  int idle = 0;
  for (; faired.steps < most_steps_ && idle < kIdleSteps; ++faired.steps) {
    surface::tell(progress, faired.steps, most_steps_);
    Sparse h;
    Eigen::VectorXd g;
    linearise(moved(now.x), h, g);
    const double unit = h.diagonal().sum() / weights.diagonal().sum();
    double gain = 0.0;
    for (; damping <= kMostDamping; damping *= 10.0) {
      const Sparse damped = h + damping * unit * weights;
      // About now.x, but in x itself, which is what the bounds are of.
      Result next = minimum_->solve(damped, g - damped * now.x, values, deviation,
                                    [&](const Eigen::VectorXd& x) { return excess(x, largest); });
      const double after = energy_at(next.x);
      if (!(after < energy)) continue;
      gain = energy - after;
      now = std::move(next);
      energy = after;
      damping = std::max(kLeastDamping, 0.1 * damping);
      break;
    }
    if (damping > kMostDamping) damping = kFirstDamping;
    idle = gain > kNoGain * energy ? 0 : idle + 1;
  }
  surface::tell(progress, 1.0, 1.0);
  faired.settled = idle >= kIdleSteps;
  return now;
}

Faired FairRegion::Problem::solve(double deviation, double largest,
                                  const std::vector<double>& values,
                                  const surface::Progress& progress) const {
  check_bounds(deviation, largest);
  if (static_cast<Eigen::Index>(values.size()) != conditions_.rows()) {
    throw std::invalid_argument("There must be " + std::to_string(conditions_.rows()) +
                                " values of conditions, not " + std::to_string(values.size()) +
                                ".");
  }
  const auto wished = Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
  if (!wished.allFinite()) throw std::invalid_argument("A condition's value is no number.");
  Faired faired{};
  faired.settled = true;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(space_.size());
  faired.energy_before = energy_at(none);
  // Without any deviation what conditions ask for is told, and so refused.
  const bool is_still = deviation > 0.0 || wished.isZero(0.0);
  Result found{is_still ? none : minimum_->shortest(wished), 0.0, 0.0, true};
  if (deviation > 0.0) {
    found = geometric_ ? descend(wished, deviation, largest, progress, faired)
                       : minimum_->solve(h_, g_, wished, deviation, [&](const Eigen::VectorXd& x) {
                           return excess(x, largest);
                         });
  }
  faired.energy_after = energy_at(found.x);
  const Eigen::VectorXd far = shifts(found.x);
  Eigen::Index place = -1;
  faired.largest = far.maxCoeff(&place);
  faired.largest_place = faired.largest > 0.0 ? static_cast<int>(place) : -1;
  for (int k : region_) faired.rms += places_.area(k) / area_ * far[k] * far[k];
  faired.rms = std::sqrt(faired.rms);
  refuse_farther(faired, deviation, largest);
  // Of two bounds the one that is just met.
  faired.bound = !found.is_bound                         ? Faired::Bound::kNothing
                 : faired.rms < deviation * (1.0 - 1e-6) ? Faired::Bound::kLargest
                                                         : Faired::Bound::kDeviation;
  const Eigen::VectorXd moves = space_.basis() * found.x;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    faired.moves.emplace_back(moves.segment<3>(3 * static_cast<Eigen::Index>(i)));
  }
  faired.folded_place = places_.first_fold(moved(found.x));
  return faired;
}

FairRegion::FairRegion(const surface::LimitSurface& surface, const FairOptions& options)
    : problem_(std::make_unique<Problem>(surface, options)) {}
FairRegion::~FairRegion() = default;
FairRegion::FairRegion(FairRegion&&) noexcept = default;

const SurfacePlaces& FairRegion::places() const { return problem_->places(); }
const std::vector<int>& FairRegion::region() const { return problem_->region(); }
double FairRegion::area() const { return problem_->area(); }

Faired FairRegion::solve(double deviation, double largest, const std::vector<double>& values,
                         const surface::Progress& progress) const {
  return problem_->solve(deviation, largest, values, progress);
}

}  // namespace hull::modelling
