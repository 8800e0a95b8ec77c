// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/seam_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "conversion/exact/least_squares.h"
#include "conversion/exact/seam_samples.h"

namespace hull::conversion {
namespace {

// What a move as long as the first leg of a seam's control polygon weighs, of the largest angle
// before the fit. Less leaves smaller angles and, in the end, lets squares fold.
constexpr std::array<double, 8> kStiffness{2.0, 0.5, 0.15, 0.05, 0.015, 0.005, 0.0015, 0.0005};
constexpr double kUseful = 0.9;  // of an angle: two passes that leave more are the last
// Of a fit; a step's time grows with the cube of the unknowns, so that there are fewer for many.
constexpr int kMostSteps = 30, kLeastSteps = 4;
constexpr double kManyUnknowns = 150.0;
constexpr double kLeastGain =
    1e-2;  // of a step, of the sum of squares where angles are small enough

// The derivative, by the vector, of the component of its direction along `axis`.
Vector3d unit_slope(const Vector3d& vector, const Vector3d& axis) {
  const double length = vector.norm();
  if (!(length > 0.0)) return Vector3d::Zero();
  const Vector3d unit = vector / length;
  // Of v / |v| it is (I - n n^T) / |v|.
  return (axis - unit.dot(axis) * unit) / length;
}

// The sum of squares of the angles at samples of the seams and of what moves weigh. Unknowns are
// moves of the points that may be chosen, in units of the mean first leg of the seams' control
// polygons.
class SeamProblem {
 public:
  SeamProblem(const SquareFan& fan, double sine, double stiffness, double normal_stiffness)
      : fan_(fan), normal_stiffness_(normal_stiffness / sine) {
    unknowns_.resize(fan.count());
    for (int i = 0; i < fan.count(); ++i) {
      if (fan.graded[i]) number_unknowns(i, stiffness);
      if (fan.seam_smooth[i]) add_seam(i, sine);
    }
    for (int i : seams_) unknowns_of_seam(i);
    // So unknowns are about 1 at most, however small the squares.
    if (!seams_.empty()) unit_ /= static_cast<double>(seams_.size());
  }

  int unknown_count() const { return 3 * point_count(); }
  bool is_empty() const { return seams_.empty() || !(unit_ > 0.0); }

  SquareFan moved(const Eigen::VectorXd& moves) const {
    SquareFan fan = fan_;
    for (int i = 0; i < fan.count(); ++i) {
      for (std::size_t k = 0; k < unknowns_[i].size(); ++k) {
        if (unknowns_[i][k] < 0) continue;
        const int a = static_cast<int>(k) / width(i), b = static_cast<int>(k) % width(i);
        fan.nets[i].at(a, b) += unit_ * moves.segment<3>(3 * unknowns_[i][k]);
      }
    }
    return fan;
  }

  double squares(const Eigen::VectorXd& moves) const {
    double sum = 0.0;
    for_each_sample(moves, [&](double residual, const Sample&) { sum += residual * residual; });
    for (int k = 0; k < point_count(); ++k) {
      sum += (stiffness_[k] * moves.segment<3>(3 * k)).squaredNorm();
    }
    return sum;
  }

  NormalEquations linearised(const Eigen::VectorXd& moves) const {
    NormalEquations equations(point_count());
    std::vector<PointSlope> slopes;
    for_each_sample(moves, [&](double residual, const Sample& sample) {
      find_slopes(sample, slopes);
      equations.add(residual, slopes);
    });
    for (int k = 0; k < point_count(); ++k) {
      const Vector3d weighed = stiffness_[k] * moves.segment<3>(3 * k);
      for (int c = 0; c < 3; ++c) {
        const PointSlope slope{k, stiffness_[k].row(c)};
        equations.add(weighed[c], {&slope, 1});
      }
    }
    return equations;
  }

 private:
  // A place on a seam, by its number among all seams' too, and what is there.
  struct Sample {
    int seam, place, number;
    SeamVectors vectors;
  };

  template <class Visit>
  void for_each_sample(const Eigen::VectorXd& moves, const Visit& visit) const {
    const SquareFan fan = moved(moves);
    int number = 0;
    for (int s = 0; s < static_cast<int>(seams_.size()); ++s) {
      const CornerNet &before = fan.nets[seams_[s]], &after = fan.nets[fan.after(seams_[s])];
      for (int k = 0; k < samples_[s].count(); ++k, ++number) {
        const SeamVectors v = samples_[s].vectors(k, before, after);
        // The difference of the two unit normals across the seam, over the sine of the largest
        // angle: 1 where the angle is that.
        visit(across_[number].dot(v.before.cross(v.along).normalized() -
                                  v.along.cross(v.after).normalized()),
              Sample{s, k, number, v});
      }
    }
  }

  int point_count() const { return static_cast<int>(stiffness_.size()); }
  int width(int i) const { return fan_.nets[i].inner + 1; }
  // Of point (a, b) of net i, -1: it stays.
  int unknown(int i, int a, int b) const { return unknowns_[i][a * width(i) + b]; }

  // Of the points off the sides, and of those on the seam after the square if it is smooth.
  void number_unknowns(int i, double stiffness) {
    const CornerNet& net = fan_.nets[i];
    const surface::SurfaceJet jet = net.evaluate(0.5, 0.5);
    const Vector3d normal = surface::unit_normal(jet.du, jet.dv);
    // Along the normal the larger of the two, across it `stiffness`.
    const double more = std::max(normal_stiffness_ - stiffness, 0.0);
    const Eigen::Matrix3d stiff =
        stiffness * Eigen::Matrix3d::Identity() + more * normal * normal.transpose();
    unknowns_[i].assign(width(i) * width(i), -1);
    // Row 0 is shared with the next square; column 0 is of the square before.
    for (int a = fan_.seam_smooth[i] ? 0 : 1; a < width(i); ++a) {
      for (int b = 1; b < width(i); ++b) {
        unknowns_[i][a * width(i) + b] = static_cast<int>(stiffness_.size());
        stiffness_.push_back(stiff);
      }
    }
  }

  void add_seam(int i, double sine) {
    const CornerNet &before = fan_.nets[i], &after = fan_.nets[fan_.after(i)];
    seams_.push_back(i);
    unit_ += (before.at(0, 1) - before.at(0, 0)).norm();
    samples_.push_back(SeamSamples::for_fit(before, after));
    for (int k = 0; k < samples_.back().count(); ++k) {
      const SeamVectors v = samples_.back().vectors(k, before, after);
      const Vector3d normal =
          v.before.cross(v.along).normalized() + v.along.cross(v.after).normalized();
      // Fixed before the fit, so that it has no derivatives of its own.
      across_.push_back(normal.cross(v.along).normalized() / sine);
    }
  }

  // The square after a seam has the same points there.
  void unknowns_of_seam(int i) {
    const int after = fan_.after(i);
    for (int b = 1; b < width(i); ++b) unknowns_[after][b * width(after)] = unknown(i, 0, b);
  }

  // The derivatives of a sample's residual by the moves that it depends on.
  void find_slopes(const Sample& sample, std::vector<PointSlope>& slopes) const {
    const SeamPoint& point = samples_[sample.seam].point(sample.place);
    const SeamVectors& v = sample.vectors;
    const Vector3d& across = across_[sample.number];
    const int before = seams_[sample.seam], after = fan_.after(before);
    const double first = first_slope(fan_.nets[before].inner);
    const Vector3d one = unit_slope(v.before.cross(v.along), across),
                   two = unit_slope(v.along.cross(v.after), across);
    // By the seam's tangent and by the derivatives across it.
    // Triple products are turned so that the factor in question is alone.
    const Vector3d by_along = unit_ * (one.cross(v.before) + two.cross(v.after));
    const Vector3d by_before = unit_ * first * v.along.cross(one);
    const Vector3d by_after = unit_ * first * v.along.cross(two);
    const auto add = [&](int unknown, const Vector3d& slope) {
      if (unknown >= 0) slopes.push_back({unknown, slope});
    };
    slopes.clear();
    for (int b = 0; b < width(before); ++b) {
      const double f = point.before.value[b], g = point.after.value[b];
      // Points of the seam itself are in the tangent and, with the other sign, in both derivatives
      // across.
      add(unknown(before, 0, b), point.before.slope[b] * by_along - f * by_before - g * by_after);
      add(unknown(before, 1, b), f * by_before);
      add(unknown(after, b, 1), g * by_after);
    }
  }

  const SquareFan& fan_;
  double normal_stiffness_, unit_ = 0.0;
  std::vector<int> seams_;                  // the smooth ones
  std::vector<std::vector<int>> unknowns_;  // of each net, see unknown()
  std::vector<Eigen::Matrix3d> stiffness_;  // of each unknown
  std::vector<SeamSamples> samples_;        // of each seam
  std::vector<Vector3d> across_;            // of each sample: along the surface, of length 1 / sine
};

// Whether all normals of a fan are to the same side as those of another.
bool is_unfolded(const SquareFan& fan, const SquareFan& model) {
  for (int i = 0; i < fan.count(); ++i) {
    if (!fan.graded[i]) continue;
    for (double u : {0.1, 0.5, 0.9}) {
      for (double v : {0.1, 0.5, 0.9}) {
        const surface::SurfaceJet one = fan.nets[i].evaluate(u, v),
                                  two = model.nets[i].evaluate(u, v);
        if (!(one.du.cross(one.dv).dot(two.du.cross(two.dv)) > 0.0)) return false;
      }
    }
  }
  return true;
}

// Solves the problem once; false where there is nothing to move.
bool move_points(SquareFan& fan, double angle, double enough, double stiffness,
                 double normal_stiffness) {
  const SeamProblem problem(fan, std::sin(std::min(angle, 1.5)), stiffness, normal_stiffness);
  if (problem.is_empty()) return false;
  const double size = kManyUnknowns / std::max<double>(problem.unknown_count(), kManyUnknowns);
  const int steps = std::max(static_cast<int>(kMostSteps * size * size), kLeastSteps);
  Eigen::VectorXd moves = Eigen::VectorXd::Zero(problem.unknown_count());
  minimise(problem, {steps, kLeastGain * std::pow(enough / angle, 2)}, moves);
  if (!moves.allFinite()) return false;
  fan = problem.moved(moves);
  return true;
}

}  // namespace

double fit_seams(SquareFan& fan, double enough, double normal_stiffness) {
  const SquareFan model = fan;
  const double angle = seam_angle(model);
  double least = angle;
  double before = std::numeric_limits<double>::infinity();
  for (double stiffness : kStiffness) {
    if (!(least > enough) || !(least < kUseful * before)) break;
    before = stiffness < kStiffness.front() ? least : before;
    // From the best so far, from where moves are counted anew.
    SquareFan moved = fan;
    if (!move_points(moved, angle, enough, stiffness, normal_stiffness) ||
        !is_unfolded(moved, model)) {
      continue;
    }
    const double fitted = seam_angle(moved);
    if (!(fitted < least)) continue;
    least = fitted;
    fan = std::move(moved);
  }
  return least;
}

}  // namespace hull::conversion
