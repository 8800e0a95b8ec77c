// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/row_development.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mesh/dense_solvers.h"

namespace hull::production {

namespace {

constexpr int kOnEdge = 9, kOldOnEdge = 33;
constexpr int kMostSteps = 80, kMostOfStage = 20, kMostHalvings = 10;
constexpr double kStage = 0.6;  // of a stage's warp, that of the next
// What leaving the distance, and edges shorter than this part of what they were, count for.
constexpr double kAtDistance = 3.0, kAtShort = 10.0, kShortest = 0.5;
// Rulings are brought a little below the limit, creases a little within their distance.
constexpr double kWarpAim = 0.97, kDistanceAim = 0.9;
// What moves of the distance count for beside warp of the limit: along a crease, and across it.
constexpr double kAlong = 1e-5, kAcross = 1e-3;
constexpr double kStep = 1e-6;  // of lengths, for slopes by central differences

using Points = std::vector<Vector3d>;

surface::CurveJet jet_of(const BezierSpan& c, double t) {
  const double s = 1.0 - t;
  surface::CurveJet jet;
  jet.point = s * s * s * c[0] + 3.0 * s * s * t * c[1] + 3.0 * s * t * t * c[2] + t * t * t * c[3];
  jet.d1 = 3.0 * (s * s * (c[1] - c[0]) + 2.0 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
  return jet;
}

// With its sign: which way the ruling is twisted.
double warp_between(const Vector3d& da, const Vector3d& db, const Vector3d& q) {
  const double length = q.norm();
  return std::atan2(da.cross(db).dot(q) * length, da.cross(q).dot(db.cross(q))) / length;
}

class Development {
 public:
  Development(const surface::LimitSurface& surface, const RuledRow& row, const Points& control,
              const RowLimits& limits)
      : row_(row), control_(control), limits_(limits) {
    find_freedom(surface);
    for (int k = 0; k < row.span_count(); ++k) {
      for (const bool second : {false, true}) {
        const BezierSpan curve = row.curve(k, second, control);
        chords_.push_back(std::max((curve[3] - curve[0]).norm(), 1e-300));
        for (int i = 0; i < kOldOnEdge; ++i)
          old_.push_back(jet_of(curve, i / (kOldOnEdge - 1.0)).point);
      }
    }
  }

  DevelopedRow run() {
    DevelopedRow made{control_, warp_of(row_, control_), 0.0, 0.0, 0, false};
    if (!std::isfinite(made.before)) {
      throw std::invalid_argument(
          "Rulings of the region have no length, or run along a knuckle: its two knuckles meet "
          "there. Leave the faces at the point out.");
    }
    Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<int>(freedom_.size())), best = x;
    made.after = made.before;
    // By and by down to the limit: from far above it the way is often lost.
    for (aim_ = made.before; aim_ > limits_.warp && made.iterations < kMostSteps && x.size() > 0;) {
      aim_ = std::max(kStage * aim_, limits_.warp);
      descend(x, best, made);
      if (made.after > aim_) break;  // a stage that is not reached
    }
    made.points = moved(best);
    made.after = warp_of(row_, made.points);
    made.distance = distance(made.points);
    made.reached = made.after <= limits_.warp;
    return made;
  }

 private:
  // A way in which a control point may move.
  struct Freedom {
    int place;  // in row_.points()
    Vector3d way;
    double cost;  // of a metre
  };

  void find_freedom(const surface::LimitSurface& surface);
  // Steps until no ruling has more warp than aim_; `best` has the least warp of what was met.
  void descend(Eigen::VectorXd& x, Eigen::VectorXd& best, DevelopedRow& made) const;
  std::vector<Vector3d> tangents() const;

  Points moved(const Eigen::VectorXd& x) const {
    Points points = control_;
    for (int i = 0; i < x.size(); ++i)
      points[row_.points()[freedom_[i].place]] += x[i] * freedom_[i].way;
    return points;
  }

  // Of sampled points of the creases, from the old creases.
  double distance(const Points& points) const {
    double most = 0.0;
    for (int k = 0; k < row_.span_count(); ++k) {
      for (const bool second : {false, true}) {
        const BezierSpan curve = row_.curve(k, second, points);
        for (int i = 0; i < kOnEdge; ++i)
          most = std::max(
              most, from_old(2 * k + (second ? 1 : 0), jet_of(curve, i / (kOnEdge - 1.0)).point));
      }
    }
    return most;
  }
  // A point of an edge from the old creases: from the old edge, but where it is beyond its ends.
  double from_old(int edge, const Vector3d& p) const {
    const int begin = edge * kOldOnEdge, end = begin + kOldOnEdge - 1;
    bool is_at_end = false;
    const double own = nearest(begin, end, p, is_at_end);
    if (!is_at_end || own <= kDistanceAim * limits_.distance) return own;
    return nearest(0, static_cast<int>(old_.size()) - 1, p, is_at_end);
  }
  double nearest(int begin, int end, const Vector3d& p, bool& is_at_end) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = begin; i < end; ++i) {
      if ((i + 1) % kOldOnEdge == 0) continue;  // from an edge's end to the next one's begin
      const Vector3d along = old_[i + 1] - old_[i];
      const double t = (p - old_[i]).dot(along) / std::max(along.squaredNorm(), 1e-300);
      const double off = (old_[i] + std::clamp(t, 0.0, 1.0) * along - p).squaredNorm();
      if (off >= least) continue;
      least = off;
      is_at_end = (i == begin && t <= 0.0) || (i + 1 == end && t >= 1.0);
    }
    return std::sqrt(least);
  }

  // What of the warp at the samples is beyond the aim, in parts of it; what of the creases is
  // about to leave their distance; edges that become short; then what moves cost.
  Eigen::VectorXd residuals(const Eigen::VectorXd& x) const {
    const Points points = moved(x);
    std::vector<double> r;
    for (int k = 0; k < row_.span_count(); ++k) {
      const BezierSpan a = row_.curve(k, false, points), b = row_.curve(k, true, points);
      for (int i = 0; i < kOnEdge; ++i) {
        const double t = i / (kOnEdge - 1.0);
        const surface::CurveJet one = jet_of(a, t), other = jet_of(b, t);
        r.push_back(beyond_warp(warp_between(one.d1, other.d1, other.point - one.point)));
        for (const bool second : {false, true}) {
          const double off = from_old(2 * k + (second ? 1 : 0), (second ? other : one).point);
          r.push_back(kAtDistance * std::max(off / limits_.distance - kDistanceAim, 0.0));
        }
      }
      for (const bool second : {false, true}) {
        const BezierSpan& now = second ? b : a;
        const double length = (now[3] - now[0]).norm() / chords_[2 * k + (second ? 1 : 0)];
        r.push_back(kAtShort * std::max(kShortest - length, 0.0));
      }
    }
    for (int i = 0; i < x.size(); ++i) r.push_back(freedom_[i].cost * x[i]);
    return Eigen::Map<const Eigen::VectorXd>(r.data(), static_cast<int>(r.size()));
  }
  double beyond_warp(double warp) const {
    const double part = std::abs(warp) / aim_ - kWarpAim;
    return part > 0.0 ? std::copysign(part, warp) : 0.0;
  }
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) const {
    Eigen::MatrixXd j(residuals(x).size(), x.size());
    for (int i = 0; i < x.size(); ++i) {
      Eigen::VectorXd up = x, down = x;
      up[i] += kStep * limits_.distance;
      down[i] -= kStep * limits_.distance;
      j.col(i) = (residuals(up) - residuals(down)) / (2.0 * kStep * limits_.distance);
    }
    return j;
  }

  const RuledRow& row_;
  const Points& control_;
  const RowLimits& limits_;
  std::vector<Freedom> freedom_;
  Points old_;                  // of the creases, kOldOnEdge an edge
  std::vector<double> chords_;  // of the edges, two a face
  double aim_ = 0.0;            // rad/m
};

void Development::descend(Eigen::VectorXd& x, Eigen::VectorXd& best, DevelopedRow& made) const {
  double cost = residuals(x).squaredNorm(), damping = 1e-3;
  for (int k = 0; k < kMostOfStage && made.after > aim_; ++k) {
    ++made.iterations;
    const Eigen::MatrixXd j = jacobian(x);
    Eigen::MatrixXd square = j.transpose() * j;
    square.diagonal() *= 1.0 + damping;
    square.diagonal().array() += 1e-12 * square.trace();  // for what changes nothing
    Eigen::VectorXd step = -square.ldlt().solve(j.transpose() * residuals(x));
    Eigen::VectorXd tried = x + step;
    for (int i = 0; i < kMostHalvings && distance(moved(tried)) > limits_.distance; ++i) {
      step *= 0.5;
      tried = x + step;
    }
    const double there = residuals(tried).squaredNorm();
    if (there >= cost || distance(moved(tried)) > limits_.distance) {
      damping *= 10.0;  // nearer to the steepest descent
      if (damping > 1e6) return;
      continue;
    }
    const bool is_small = cost - there < 1e-6 * cost;
    x = tried;
    cost = there;
    damping = std::max(0.1 * damping, 1e-9);
    if (const double warp = warp_of(row_, moved(x)); warp < made.after) {
      made.after = warp;
      best = x;
    }
    if (is_small) return;  // it hardly gets on
  }
}

// Unit tangents of the creases at the row's control points; zero for those beyond.
std::vector<Vector3d> Development::tangents() const {
  std::vector<Vector3d> sums(row_.points().size(), Vector3d::Zero());
  for (int k = 0; k < row_.span_count(); ++k) {
    const RuledRow::Span& span = row_.span(k);
    for (const bool second : {false, true}) {
      const BezierSpan curve = row_.curve(k, second, control_);
      const Eigen::MatrixXd& m = second ? span.b : span.a;
      for (int j = 0; j < m.cols(); ++j) {
        sums[span.points[j]] +=
            std::abs(m(0, j)) * (curve[1] - curve[0]) + std::abs(m(3, j)) * (curve[3] - curve[2]);
      }
    }
  }
  for (Vector3d& t : sums) t = t.norm() > 0.0 ? Vector3d(t.normalized()) : t;
  return sums;
}

void Development::find_freedom(const surface::LimitSurface& surface) {
  const mesh::Topology& topology = surface.mesh().topology();
  const std::vector<Vector3d> along = tangents();
  for (int i = 0; i < static_cast<int>(row_.points().size()); ++i) {
    const int p = row_.points()[i];
    const mesh::VertexKind kind = topology.kind(p);
    const bool is_end = kind != mesh::VertexKind::kCrease;  // corners and darts
    const auto& locked = limits_.locked;
    if (!row_.is_own()[i] || is_end || std::find(locked.begin(), locked.end(), p) != locked.end()) {
      continue;
    }
    // What the normals leave free.
    Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(3, 3);
    for (const auto& [held, normal] : limits_.held) {
      if (held == p) normals += normal.normalized() * normal.normalized().transpose();
    }
    const mesh::SingularValues svd = mesh::singular_values(normals);
    Eigen::Matrix3d free = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) {
      if (svd.values[k] < 1e-9) free += svd.u.col(k) * svd.u.col(k).transpose();
    }
    Vector3d first = free * along[i];
    std::vector<std::pair<Vector3d, bool>> ways;
    if (first.norm() > 0.3) {
      first.normalize();
      ways.emplace_back(first, true);
      free -= first * first.transpose();
    }
    const mesh::SingularValues rest = mesh::singular_values(free);
    for (int k = 0; k < 3; ++k) {
      if (rest.values[k] > 0.5) ways.emplace_back(rest.u.col(k), false);
    }
    for (const auto& [way, is_along] : ways) {
      freedom_.push_back({i, way, (is_along ? kAlong : kAcross) / limits_.distance});
    }
  }
}

}  // namespace

double warp_of(const RuledRow& row, const Points& control) {
  double most = 0.0;
  for (int k = 0; k < row.span_count(); ++k) {
    most = std::max(most,
                    largest_warp(row.curve(k, false, control), row.curve(k, true, control)).bound);
  }
  return most;
}

DevelopedRow developed_row(const surface::LimitSurface& surface, const RuledRow& row,
                           const Points& control, const RowLimits& limits) {
  if (!(limits.warp > 0.0 && std::isfinite(limits.warp))) {
    throw std::invalid_argument("The limit of warp must be an angle per length above 0.");
  }
  if (!(limits.distance > 0.0 && std::isfinite(limits.distance))) {
    throw std::invalid_argument("How far knuckles may move must be a length above 0 m.");
  }
  if (static_cast<int>(control.size()) != surface.mesh().topology().vertex_count()) {
    throw std::invalid_argument("There must be a place for each of the mesh's points.");
  }
  return Development(surface, row, control, limits).run();
}

}  // namespace hull::production
