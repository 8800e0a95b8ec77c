// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/square_fan.h"

#include <ceres/tiny_solver.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "conversion/block_places.h"

namespace hull {
namespace {

// Of a seam, between two of its knots: for the fit, and to measure.
constexpr int kFitted = 7, kMeasured = 17;
constexpr int kNearPoint = 4;  // and halved so many times more towards the irregular point
// What a move as long as the first leg of a seam's control polygon weighs, of the largest angle
// before the fit. Less leaves smaller angles and, in the end, lets squares fold.
constexpr std::array<double, 8> kStiffness{2.0, 0.5, 0.15, 0.05, 0.015, 0.005, 0.0015, 0.0005};
constexpr double kUseful = 0.9;  // of an angle: two passes that leave more are the last
// Of a fit; a step's time grows with the cube of the unknowns, so that there are fewer for many.
constexpr int kMostSteps = 30, kLeastSteps = 4;
constexpr double kManyUnknowns = 150.0;
constexpr double kLeastGain =
    1e-2;  // of a step, of the sum of squares where angles are small enough

// Where a seam is sampled, from 0 to 1.
std::vector<double> seam_places(int inner, int samples) {
  std::vector<double> places;
  for (int k = 0; k <= inner; ++k) {
    const double begin = k > 0 ? std::exp2(k - 1 - inner) : 0.0, end = std::exp2(k - inner);
    for (int i = 0; i < samples; ++i) places.push_back(begin + (end - begin) * i / samples);
  }
  if (samples == kFitted) return places;
  for (int k = 1; k <= kNearPoint; ++k) places.push_back(places[1] * std::exp2(-k));
  return places;
}

// The slope at 0 of function 1, and of 0 with the other sign.
double first_slope(int inner) { return 3.0 * std::exp2(inner); }

// The functions along a seam, as the nets of the squares before and after it have them.
struct SeamPoint {
  CornerFunctions before, after;
};

// What the angle at a point of a seam depends on: the seam's tangent and the derivatives across it
// in the square before and the one after.
struct SeamVectors {
  Vector3d along, before, after;
};

class SeamSamples {
 public:
  SeamSamples(const CornerNet& before, const CornerNet& after, int samples) {
    for (double t : seam_places(before.inner, samples)) {
      points_.push_back({corner_functions(before.inner, before.beyond_v, t),
                         corner_functions(after.inner, after.beyond_u, t)});
    }
  }

  int count() const { return static_cast<int>(points_.size()); }
  const SeamPoint& point(int k) const { return points_[k]; }

  SeamVectors vectors(int k, const CornerNet& before, const CornerNet& after) const {
    const SeamPoint& point = points_[k];
    const double first = first_slope(before.inner);
    SeamVectors result{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
    for (int b = 0; b < before.count(); ++b) {
      result.along += point.before.slope[b] * before.at(0, b);
      result.before += first * point.before.value[b] * (before.at(1, b) - before.at(0, b));
      result.after += first * point.after.value[b] * (after.at(b, 1) - after.at(b, 0));
    }
    return result;
  }

 private:
  std::vector<SeamPoint> points_;
};

double angle_of(const SeamVectors& vectors) {
  const Vector3d one = vectors.before.cross(vectors.along),
                 two = vectors.along.cross(vectors.after);
  return std::atan2(one.cross(two).norm(), one.dot(two));
}

// The derivative, by the vector, of the component of its direction along `axis`.
Vector3d unit_slope(const Vector3d& vector, const Vector3d& axis) {
  const double length = vector.norm();
  if (!(length > 0.0)) return Vector3d::Zero();
  const Vector3d unit = vector / length;
  return (axis - unit.dot(axis) * unit) / length;
}

// The seams' residuals as TinySolver wants them. Unknowns are moves of the points that may be
// chosen, in units of the mean first leg of the seams' control polygons.
class SeamProblem {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  SeamProblem(const SquareFan& fan, double sine, double stiffness, double normal_stiffness)
      : fan_(fan), normal_stiffness_(normal_stiffness / sine) {
    unknowns_.resize(fan.count());
    for (int i = 0; i < fan.count(); ++i) {
      if (fan.graded[i]) number_unknowns(i, stiffness);
      if (fan.seam_smooth[i]) add_seam(i, sine);
    }
    for (int i : seams_) unknowns_of_seam(i);
    if (!seams_.empty()) unit_ /= static_cast<double>(seams_.size());
  }

  int NumResiduals() const { return static_cast<int>(across_.size()) + NumParameters(); }
  int NumParameters() const { return 3 * static_cast<int>(stiffness_.size()); }
  bool is_empty() const { return seams_.empty() || !(unit_ > 0.0); }

  SquareFan moved(const double* moves) const {
    SquareFan fan = fan_;
    for (int i = 0; i < fan.count(); ++i) {
      for (std::size_t k = 0; k < unknowns_[i].size(); ++k) {
        if (unknowns_[i][k] < 0) continue;
        const int a = static_cast<int>(k) / width(i), b = static_cast<int>(k) % width(i);
        fan.nets[i].at(a, b) += unit_ * Eigen::Map<const Vector3d>(moves + 3 * unknowns_[i][k]);
      }
    }
    return fan;
  }

  bool operator()(const double* moves, double* residuals, double* jacobian) const {
    const SquareFan fan = moved(moves);
    const int rows = NumResiduals(), columns = NumParameters();
    Eigen::Map<Eigen::VectorXd> values(residuals, rows);
    Eigen::Map<Eigen::MatrixXd> slopes(jacobian, jacobian ? rows : 0, columns);
    slopes.setZero();
    int row = 0;
    for (std::size_t s = 0; s < seams_.size(); ++s) {
      for (int k = 0; k < samples_[s].count(); ++k, ++row) {
        const int before = seams_[s], after = fan.after(before);
        const SeamVectors v = samples_[s].vectors(k, fan.nets[before], fan.nets[after]);
        values(row) = across_[row].dot(v.before.cross(v.along).normalized() -
                                       v.along.cross(v.after).normalized());
        if (jacobian) add_slopes(s, k, v, across_[row], slopes.row(row));
      }
    }
    for (int c = 0; c < columns; c += 3, row += 3) {
      values.segment<3>(row) = stiffness_[c / 3] * Eigen::Map<const Vector3d>(moves + c);
      if (jacobian) slopes.block<3, 3>(row, c) = stiffness_[c / 3];
    }
    return true;
  }

 private:
  int width(int i) const { return fan_.nets[i].inner + 1; }
  // Of point (a, b) of net i, -1: it stays.
  int unknown(int i, int a, int b) const { return unknowns_[i][a * width(i) + b]; }

  // Of the points off the sides, and of those on the seam after the square if it is smooth.
  void number_unknowns(int i, double stiffness) {
    const CornerNet& net = fan_.nets[i];
    const SurfaceJet jet = net.evaluate(0.5, 0.5);
    const Vector3d normal = unit_normal(jet.du, jet.dv);
    const double more = std::max(normal_stiffness_ - stiffness, 0.0);
    const Eigen::Matrix3d stiff =
        stiffness * Eigen::Matrix3d::Identity() + more * normal * normal.transpose();
    unknowns_[i].assign(width(i) * width(i), -1);
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
    samples_.emplace_back(before, after, kFitted);
    for (int k = 0; k < samples_.back().count(); ++k) {
      const SeamVectors v = samples_.back().vectors(k, before, after);
      const Vector3d normal =
          v.before.cross(v.along).normalized() + v.along.cross(v.after).normalized();
      across_.push_back(normal.cross(v.along).normalized() / sine);
    }
  }

  // The square after a seam has the same points there.
  void unknowns_of_seam(int i) {
    const int after = fan_.after(i);
    for (int b = 1; b < width(i); ++b) unknowns_[after][b * width(after)] = unknown(i, 0, b);
  }

  // The derivatives of one sample's residual by the moves that it depends on.
  template <class Row>
  void add_slopes(std::size_t s, int k, const SeamVectors& v, const Vector3d& across,
                  Row row) const {
    const SeamPoint& point = samples_[s].point(k);
    const int before = seams_[s], after = fan_.after(before);
    const double first = first_slope(fan_.nets[before].inner);
    const Vector3d one = unit_slope(v.before.cross(v.along), across),
                   two = unit_slope(v.along.cross(v.after), across);
    // By the seam's tangent and by the derivatives across it.
    const Vector3d by_along = unit_ * (one.cross(v.before) + two.cross(v.after));
    const Vector3d by_before = unit_ * first * v.along.cross(one);
    const Vector3d by_after = unit_ * first * v.along.cross(two);
    const auto add = [&](int unknown, double weight, const Vector3d& slope) {
      if (unknown >= 0) row.template segment<3>(3 * unknown) += weight * slope.transpose();
    };
    for (int b = 0; b < width(before); ++b) {
      const double f = point.before.value[b], g = point.after.value[b];
      add(unknown(before, 0, b), point.before.slope[b], by_along);
      add(unknown(before, 0, b), -f, by_before);
      add(unknown(before, 0, b), -g, by_after);
      add(unknown(before, 1, b), f, by_before);
      add(unknown(after, b, 1), g, by_after);
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
        const SurfaceJet one = fan.nets[i].evaluate(u, v), two = model.nets[i].evaluate(u, v);
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
  ceres::TinySolver<SeamProblem> solver;
  const double size = kManyUnknowns / std::max<double>(problem.NumParameters(), kManyUnknowns);
  solver.options.max_num_iterations =
      std::max(static_cast<int>(kMostSteps * size * size), kLeastSteps);
  solver.options.function_tolerance = kLeastGain * std::pow(enough / angle, 2);
  solver.options.cost_threshold = 0.0;
  solver.options.gradient_tolerance = 0.0;
  Eigen::VectorXd moves = Eigen::VectorXd::Zero(problem.NumParameters());
  solver.Solve(problem, &moves);
  if (!moves.allFinite()) return false;
  fan = problem.moved(moves.data());
  return true;
}

}  // namespace

std::vector<int> half_edges_around(const Topology& cells, int vertex) {
  std::vector<int> result;
  const int first = cells.outgoing(vertex);
  for (int h = first; h >= 0; h = cells.twin(cells.prev(h))) {
    result.push_back(h);
    if (cells.twin(cells.prev(h)) == first) break;
  }
  return result;
}

SquareFan square_fan(const LimitSurface& surface, int vertex, const Grading& grading) {
  const Topology& cells = surface.cells();
  SquareFan fan;
  fan.half_edges = half_edges_around(cells, vertex);
  for (int h : fan.half_edges) {
    fan.graded.push_back(begins_at_irregular_knot(surface, h));
    fan.nets.push_back(fan.graded.back() ? corner_net(surface, h, grading) : CornerNet{});
  }
  for (int i = 0; i < fan.count(); ++i) {
    const bool is_crease = cells.is_crease(cells.prev(fan.half_edges[i]));
    fan.seam_smooth.push_back(!is_crease && fan.graded[i] && fan.graded[fan.after(i)]);
  }
  return fan;
}

double seam_angle(const SquareFan& fan) {
  double largest = 0.0;
  for (int i = 0; i < fan.count(); ++i) {
    if (!fan.seam_smooth[i]) continue;
    const CornerNet &before = fan.nets[i], &after = fan.nets[fan.after(i)];
    const SeamSamples samples(before, after, kMeasured);
    for (int k = 0; k < samples.count(); ++k) {
      largest = std::max(largest, angle_of(samples.vectors(k, before, after)));
    }
  }
  return largest;
}

double fit_seams(SquareFan& fan, double enough, double normal_stiffness) {
  const SquareFan model = fan;
  const double angle = seam_angle(model);
  double least = angle;
  double before = std::numeric_limits<double>::infinity();
  for (double stiffness : kStiffness) {
    if (!(least > enough) || !(least < kUseful * before)) break;
    before = stiffness < kStiffness.front() ? least : before;
    SquareFan moved = fan;
    if (!move_points(moved, angle, enough, stiffness, normal_stiffness) ||
        !is_unfolded(moved, model))
      continue;
    const double fitted = seam_angle(moved);
    if (!(fitted < least)) continue;
    least = fitted;
    fan = std::move(moved);
  }
  return least;
}

}  // namespace hull
