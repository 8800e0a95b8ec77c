// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/knuckle_setting.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "surface/creases/knuckle_angle.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double kMostAngle = 170.0 / 180.0 * std::numbers::pi;
constexpr int kSolvedSamples = 4, kMeasuredSamples = 16;  // of an edge
constexpr double kDamping = 1e-6;
constexpr double kStill = 1e-10;  // rad: angles change by no more from step to step at the end

// Edges that do not end in a dart.
std::vector<int> edges_to_set(const surface::LimitSurface& surface,
                              const surface::CreaseCurve& curve, const std::vector<int>& asked) {
  const mesh::Topology& topology = surface.mesh().topology();
  const int count = static_cast<int>(curve.vertices().size());
  const auto is_dart = [&](int i) {
    // A closed curve's last edge ends in its first point.
    return topology.kind(curve.vertices()[i % count]) == mesh::VertexKind::kDart;
  };
  std::vector<int> edges;
  for (int edge : surface::knuckle_edges(curve, asked)) {
    if (!is_dart(edge) && !is_dart(edge + 1)) edges.push_back(edge);
  }
  if (edges.empty()) {
    throw std::invalid_argument(
        "All edges of the knuckle end in darts, where its angle is zero: make it longer, or tag "
        "its ends as corners.");
  }
  return edges;
}

// Of places on both sides of the knuckle, weights of the control points in the surface's
// derivatives along the sides of a piece. They stay while points move.
struct Side {
  surface::CellPlace place;
  const std::vector<int>* points;
  Eigen::VectorXd ds, dt;
};

struct Sample {
  double t;
  Vector3d along;  // of length 1
  Side left, right;
};

ReshapeLimits with_locked(ReshapeLimits limits, const std::vector<int>& points) {
  std::vector<int>& locked = limits.limits.locked;
  locked.insert(locked.end(), points.begin(), points.end());
  return limits;
}

class KnuckleProblem {
 public:
  KnuckleProblem(const surface::LimitSurface& surface, const surface::CreaseCurve& curve,
                 const ReshapeLimits& limits, const std::vector<int>& edges)
      : surface_(surface),
        start_(surface.mesh().points()),
        pieces_(surface),
        space_(with_locked(limits, curve.vertices()), static_cast<int>(start_.size())) {
    for (int edge : edges) {
      for (int i = 0; i < kSolvedSamples; ++i) {
        // An eighth of an edge or more from its ends: outside of the squares at irregular knots
        // that have no pieces, and away from corners, where the angle may not be defined. The
        // direction is taken once, as the curve's own points are locked.
        const double t = edge + (i + 0.5) / kSolvedSamples;
        samples_.push_back(
            {t, curve.evaluate(t, 1).d1.normalized(), side(curve.left(t)), side(curve.right(t))});
      }
    }
    // By what is stored, zeros included: no direction of the space reaches a point beside the
    // knuckle.
    if (jacobian().nonZeros() == 0) {
      throw std::invalid_argument(
          "No control point beside the knuckle may move: unlock some, or release a flat.");
    }
  }

  Eigen::Index freedom() const { return space_.size(); }

  // Of all control points, by as many numbers as freedom() says.
  std::vector<Vector3d> moves(const Eigen::VectorXd& x) const {
    const Eigen::VectorXd all = space_.basis() * x;
    std::vector<Vector3d> moves;
    for (std::size_t p = 0; p < start_.size(); ++p) {
      moves.emplace_back(all.segment<3>(3 * static_cast<Eigen::Index>(p)));
    }
    return moves;
  }

  void move(const Eigen::VectorXd& x) {
    std::vector<Vector3d> points = moves(x);
    for (std::size_t p = 0; p < points.size(); ++p) points[p] += start_[p];
    surface_.set_points(std::move(points));
  }

  // By how much the angles are more than is wanted. Not the short way round: that may lead by way
  // of 180°, where the sides lie on one another.
  Eigen::VectorXd errors(double angle) const {
    Eigen::VectorXd e(static_cast<Eigen::Index>(samples_.size()));
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Sample& s = samples_[i];
      const double now = surface::angle_between(normal(s.left), normal(s.right), s.along);
      if (std::isnan(now)) {
        throw std::invalid_argument("The surface has no tangent plane beside the knuckle at edge " +
                                    std::to_string(static_cast<int>(s.t)) +
                                    ": points coincide there; move them apart.");
      }
      e[static_cast<Eigen::Index>(i)] = now - angle;
    }
    return e;
  }

  Sparse jacobian() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      add_tilt(static_cast<int>(i), samples_[i].left, samples_[i].along, entries);
      add_tilt(static_cast<int>(i), samples_[i].right, -samples_[i].along, entries);
    }
    Sparse J(static_cast<Eigen::Index>(samples_.size()), space_.basis().rows());
    J.setFromTriplets(entries.begin(), entries.end());
    return J * space_.basis();
  }

  const surface::LimitSurface& surface() const { return surface_; }

 private:
  Side side(const surface::CellPlace& place) const {
    const auto found = pieces_.find(place.cell, place.u, place.v);
    surface::PieceWeights::Jet jet = pieces_.jet(*found);
    return {place, &pieces_.piece(found->piece).points, std::move(jet.ds), std::move(jet.dt)};
  }

  Vector3d normal(const Side& side) const {
    return surface_.normal(side.place.cell, side.place.u, side.place.v);
  }

  // A side turns about the knuckle as the derivative square to it rises along the normal.
  void add_tilt(int row, const Side& side, const Vector3d& along,
                std::vector<Eigen::Triplet<double>>& entries) const {
    const Vector3d n = normal(side), outwards = n.cross(along);
    Vector3d ds = Vector3d::Zero(), dt = Vector3d::Zero();
    for (std::size_t k = 0; k < side.points->size(); ++k) {
      const Vector3d& p = surface_.mesh().points()[(*side.points)[k]];
      ds += side.ds[static_cast<Eigen::Index>(k)] * p;
      dt += side.dt[static_cast<Eigen::Index>(k)] * p;
    }
    // In (s, t): the step that goes 1 m outwards, and not along the knuckle.
    Eigen::Matrix2d plane;
    plane << ds.dot(along), dt.dot(along), ds.dot(outwards), dt.dot(outwards);
    const Eigen::Vector2d step = plane.fullPivLu().solve(Eigen::Vector2d(0.0, 1.0));
    for (std::size_t k = 0; k < side.points->size(); ++k) {
      const auto index = static_cast<Eigen::Index>(k);
      const double weight = step.x() * side.ds[index] + step.y() * side.dt[index];
      for (int axis = 0; axis < 3; ++axis) {
        // A side that rises towards the water takes its tilt from the angle, whichever side it is.
        entries.emplace_back(row, 3 * (*side.points)[k] + axis, -weight * n[axis]);
      }
    }
  }

  surface::LimitSurface surface_;
  std::vector<Vector3d> start_;
  surface::PieceWeights pieces_;
  MoveSpace space_;
  std::vector<Sample> samples_;
};

// Jᵀ (J Jᵀ + μ)^-1 r.
Eigen::VectorXd least_moves(const Sparse& J, const Eigen::VectorXd& r) {
  // A row for each sample, of which only those near one another share points: sparse, and much
  // smaller than the moves' own normal equations, which would be singular besides.
  Sparse square = J * J.transpose();
  const double most = square.diagonal().maxCoeff();
  if (!(most > 0.0)) {
    throw std::invalid_argument(
        "The control points beside the knuckle may not move across the surface: release a flat, or "
        "unlock some.");
  }
  for (Eigen::Index i = 0; i < square.rows(); ++i) square.coeffRef(i, i) += kDamping * most;
  const Eigen::SimplicialLDLT<Sparse> solver(square);
  return J.transpose() * solver.solve(r);
}

double deviation_of(const surface::LimitSurface& surface, const surface::CreaseCurve& curve,
                    const std::vector<int>& edges, double angle) {
  double most = 0.0;
  for (int edge : edges) {
    for (int i = 0; i <= kMeasuredSamples; ++i) {
      const double t = edge + static_cast<double>(i) / kMeasuredSamples;
      const double now = surface::knuckle_angle(surface, curve, t);
      // At an end a side may have no tangent plane, and no angle that could be off.
      if (!std::isnan(now)) most = std::max(most, std::abs(now - angle));
    }
  }
  return most;
}

}  // namespace

KnuckleSetting set_knuckle_angle(const surface::LimitSurface& surface,
                                 const surface::CreaseCurve& curve, double angle,
                                 const ReshapeLimits& limits, const KnuckleOptions& options) {
  if (!(std::abs(angle) <= kMostAngle)) {
    throw std::invalid_argument("The angle of a knuckle is within -170° and 170°.");
  }
  KnuckleSetting result{};
  result.edges = edges_to_set(surface, curve, options.edges);
  KnuckleProblem problem(surface, curve, limits, result.edges);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.freedom());
  Eigen::VectorXd e = problem.errors(angle);
  while (result.steps < options.most_steps) {
    ++result.steps;
    const Sparse J = problem.jacobian();
    // What is to be short are the moves from the start, not the steps: each gives all of x anew.
    const Eigen::VectorXd change = least_moves(J, J * x - e) - x;
    // Far from the goal a whole step may turn a side over.
    const double part = std::min(1.0, 0.5 / std::max(1e-300, (J * change).cwiseAbs().maxCoeff()));
    x += part * change;
    problem.move(x);
    e = problem.errors(angle);
    if (part == 1.0 && (J * change).cwiseAbs().maxCoeff() < kStill) break;
  }
  const std::vector<Vector3d> moves = problem.moves(x);
  for (std::size_t p = 0; p < moves.size(); ++p) {
    if (moves[p].isZero(0.0)) continue;
    result.points.push_back(static_cast<int>(p));
    result.moves.push_back(moves[p]);
  }
  result.deviation = deviation_of(problem.surface(), curve, result.edges, angle);
  result.met = result.deviation <= options.tolerance;
  return result;
}

}  // namespace hull::modelling
