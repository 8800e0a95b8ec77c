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

class KnuckleProblem {
 public:
  KnuckleProblem(const surface::LimitSurface& surface, const surface::CreaseCurve& curve,
                 const MoveLimits& limits, const std::vector<int>& edges)
      : surface_(surface), start_(surface.mesh().points()), pieces_(surface) {
    MoveLimits all = limits;
    all.locked.insert(all.locked.end(), curve.vertices().begin(), curve.vertices().end());
    freedoms_ = freedoms_within(all, static_cast<int>(start_.size()));
    for (int edge : edges) {
      for (int i = 0; i < kSolvedSamples; ++i) {
        const double t = edge + (i + 0.5) / kSolvedSamples;
        samples_.push_back(
            {t, curve.evaluate(t, 1).d1.normalized(), side(curve.left(t)), side(curve.right(t))});
      }
    }
    first_column_.assign(start_.size(), -1);
    for (const Sample& sample : samples_) {
      for (const Side* s : {&sample.left, &sample.right}) {
        for (int point : *s->points) add_columns(point);
      }
    }
    if (columns_ == 0) {
      throw std::invalid_argument(
          "No control point beside the knuckle may move: unlock some, or release a flat.");
    }
  }

  Eigen::Index columns() const { return columns_; }

  void move(const Eigen::VectorXd& x) {
    std::vector<Vector3d> points = start_;
    for (std::size_t p = 0; p < points.size(); ++p) points[p] += move_of(static_cast<int>(p), x);
    surface_.set_points(std::move(points));
  }

  Vector3d move_of(int point, const Eigen::VectorXd& x) const {
    Vector3d move = Vector3d::Zero();
    if (first_column_[point] < 0) return move;
    for (int k = 0; k < freedoms_[point].count; ++k) {
      move += x[first_column_[point] + k] * freedoms_[point].directions[k];
    }
    return move;
  }

  // By how much the angles are more than is wanted, the short way round.
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
    Sparse J(static_cast<Eigen::Index>(samples_.size()), columns_);
    J.setFromTriplets(entries.begin(), entries.end());
    return J;
  }

  const surface::LimitSurface& surface() const { return surface_; }

 private:
  Side side(const surface::CellPlace& place) const {
    const auto found = pieces_.find(place.cell, place.u, place.v);
    surface::PieceWeights::Jet jet = pieces_.jet(*found);
    return {place, &pieces_.piece(found->piece).points, std::move(jet.ds), std::move(jet.dt)};
  }

  void add_columns(int point) {
    if (first_column_[point] >= 0 || freedoms_[point].count == 0) return;
    first_column_[point] = columns_;
    columns_ += freedoms_[point].count;
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
    Eigen::Matrix2d plane;
    plane << ds.dot(along), dt.dot(along), ds.dot(outwards), dt.dot(outwards);
    const Eigen::Vector2d step = plane.fullPivLu().solve(Eigen::Vector2d(0.0, 1.0));
    for (std::size_t k = 0; k < side.points->size(); ++k) {
      const int point = (*side.points)[k];
      if (first_column_[point] < 0) continue;
      const auto index = static_cast<Eigen::Index>(k);
      const double weight = step.x() * side.ds[index] + step.y() * side.dt[index];
      for (int d = 0; d < freedoms_[point].count; ++d) {
        entries.emplace_back(row, static_cast<int>(first_column_[point]) + d,
                             -weight * n.dot(freedoms_[point].directions[d]));
      }
    }
  }

  surface::LimitSurface surface_;
  std::vector<Vector3d> start_;
  surface::PieceWeights pieces_;
  std::vector<Freedom> freedoms_;
  std::vector<Sample> samples_;
  std::vector<Eigen::Index> first_column_;
  Eigen::Index columns_ = 0;
};

// Jᵀ (J Jᵀ + μ)^-1 r.
Eigen::VectorXd least_moves(const Sparse& J, const Eigen::VectorXd& r) {
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
      if (!std::isnan(now)) most = std::max(most, std::abs(now - angle));
    }
  }
  return most;
}

}  // namespace

KnuckleSetting set_knuckle_angle(const surface::LimitSurface& surface,
                                 const surface::CreaseCurve& curve, double angle,
                                 const MoveLimits& limits, const KnuckleOptions& options) {
  if (!(std::abs(angle) <= kMostAngle)) {
    throw std::invalid_argument("The angle of a knuckle is within -170° and 170°.");
  }
  KnuckleSetting result{};
  result.edges = edges_to_set(surface, curve, options.edges);
  KnuckleProblem problem(surface, curve, limits, result.edges);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.columns());
  Eigen::VectorXd e = problem.errors(angle);
  while (result.steps < options.most_steps) {
    ++result.steps;
    const Sparse J = problem.jacobian();
    const Eigen::VectorXd change = least_moves(J, J * x - e) - x;
    // Far from the goal a whole step may turn a side over.
    const double part = std::min(1.0, 0.5 / std::max(1e-300, (J * change).cwiseAbs().maxCoeff()));
    x += part * change;
    problem.move(x);
    e = problem.errors(angle);
    if (part == 1.0 && (J * change).cwiseAbs().maxCoeff() < kStill) break;
  }
  for (int p = 0; p < static_cast<int>(surface.mesh().points().size()); ++p) {
    const Vector3d move = problem.move_of(p, x);
    if (move.isZero(0.0)) continue;
    result.points.push_back(p);
    result.moves.push_back(move);
  }
  result.deviation = deviation_of(problem.surface(), curve, result.edges, angle);
  result.met = result.deviation <= options.tolerance;
  return result;
}

}  // namespace hull::modelling
