// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/plane_sides.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "analysis/sections/arc_sampling.h"

namespace hull::analysis {
namespace {

using State = PlaneSides::State;

constexpr double kSameParameter = 1e-13;
// How far from an irregular knot the course is taken instead of at the knot.
constexpr double kBesideKnot = 0x1p-20;

State state_of(const BezierCubic& beside, double t) {
  return evaluate(beside, t) >= 0.0 ? State::kAbove : State::kBelow;
}

}  // namespace

// The course of the surface along a line, as a cell has it.
class PlaneSides::SideCurve {
 public:
  SideCurve(const surface::LimitSurface& surface, const Plane& plane, const Claim& claim)
      : surface_(surface), normal_(plane.normal), cell_(claim.cell) {
    const Line& line = claim.line;
    if (line.kind != Line::Kind::kEdge) {
      along_v_ = line.kind == Line::Kind::kU;
      falls_ = false;
      at_ = line.at;
      return;
    }
    const int side = (claim.left ? line.id : surface.cells().twin(line.id)) % 4;
    along_v_ = side % 2 == 1;
    // The cell on the right has the twin, which runs against the line.
    falls_ = (side >= 2) == claim.left;
    at_ = side == 1 || side == 2 ? 1.0 : 0.0;
  }

  Eigen::Vector2d place(double t) const {
    const double s = falls_ ? 1.0 - t : t;
    return along_v_ ? Eigen::Vector2d(at_, s) : Eigen::Vector2d(s, at_);
  }

  ArcSample at(double t) const {
    ArcSample sample{};
    SectionPoint& p = sample.p;
    p.cell = cell_;
    p.uv = place(t);
    surface::SurfaceJet jet = surface_.evaluate(cell_, p.uv.x(), p.uv.y(), 2);
    p.point = jet.point;
    if (surface_.is_irregular_knot(cell_, p.uv.x(), p.uv.y())) {
      const Eigen::Vector2d near = place(t < 0.5 ? t + kBesideKnot : t - kBesideKnot);
      jet = surface_.evaluate(cell_, near.x(), near.y(), 2);
    }
    sample.d1 = (falls_ ? -1.0 : 1.0) * (along_v_ ? jet.dv : jet.du);
    // Whichever way it is run through.
    const Vector3d& d2 = along_v_ ? jet.dvv : jet.duu;
    const Vector3d d1 = sample.d1 - normal_.dot(sample.d1) * normal_;
    const double speed = d1.norm();
    if (speed > 0.0) {
      p.tangent = d1 / speed;
      p.curvature = normal_.dot(d1.cross(d2)) / (speed * speed * speed);
    }
    return sample;
  }

 private:
  const surface::LimitSurface& surface_;
  const Vector3d& normal_;
  int cell_;
  bool along_v_, falls_;
  double at_;
};

void PlaneSides::add_flat(int cell, const surface::DomainSquare& square) {
  for (int side = 0; side < 4; ++side) add(cell, square, side, 0.0, 1.0, State::kFlat);
}

void PlaneSides::add_side(int cell, const surface::DomainSquare& square, int side,
                          const BezierCubic& beside) {
  double from = 0.0;
  for (const double root : sign_changes(beside)) {
    // A stretch of no length would be an arc of no length.
    if (root - from < kSameParameter) continue;
    if (1.0 - root < kSameParameter) break;
    add(cell, square, side, from, root, state_of(beside, 0.5 * (from + root)));
    from = root;
  }
  add(cell, square, side, from, 1.0, state_of(beside, 0.5 * (from + 1.0)));
}

void PlaneSides::add(int cell, const surface::DomainSquare& square, int side, double from,
                     double to, State state) {
  const bool along_v = side % 2 == 1;
  const double begin = along_v ? square.v : square.u;
  const double t0 = begin + square.size * from, t1 = begin + square.size * to;
  const double at = side == 0   ? square.v
                    : side == 1 ? square.u + square.size
                    : side == 2 ? square.v + square.size
                                : square.u;
  if (at > 0.0 && at < 1.0) {
    // Of a line with rising v, smaller u is on the left; of one with rising u, larger v.
    claims_.push_back({{along_v ? Line::Kind::kU : Line::Kind::kV, cell, at},
                       t0,
                       t1,
                       side == 0 || side == 1,
                       state,
                       cell});
    return;
  }
  // Sides 2 and 3 run with falling u and v.
  const int h = 4 * cell + side;
  const bool front = surface_->cells().is_edge_front(h);
  const bool falls = (side >= 2) == front;
  // Both cells of an edge claim the line of its front half-edge, where their claims meet.
  const Line line{Line::Kind::kEdge, front ? h : surface_->cells().twin(h), 0.0};
  claims_.push_back({line, falls ? 1.0 - t1 : t0, falls ? 1.0 - t0 : t1, front, state, cell});
}

void PlaneSides::add_arcs(double chord_tolerance, SectionParts& parts) {
  std::sort(claims_.begin(), claims_.end(), [](const Claim& x, const Claim& y) {
    return std::tie(x.line, x.t0, x.left) < std::tie(y.line, y.t0, y.left);
  });
  for (std::size_t i = 0; i < claims_.size();) {
    std::size_t j = i;
    while (j < claims_.size() && claims_[j].line == claims_[i].line) ++j;
    add_line(claims_.data() + i, claims_.data() + j, chord_tolerance, parts);
    i = j;
  }
}

void PlaneSides::add_line(const Claim* begin, const Claim* end, double chord_tolerance,
                          SectionParts& parts) {
  std::vector<double> ts;
  for (const Claim* c = begin; c != end; ++c) ts.insert(ts.end(), {c->t0, c->t1});
  std::sort(ts.begin(), ts.end());
  const bool border =
      begin->line.kind == Line::Kind::kEdge && surface_->cells().twin(begin->line.id) < 0;
  for (std::size_t k = 0; k + 1 < ts.size(); ++k) {
    // Squares on both sides may be of different sizes: the line is taken in parts that all agree
    // on.
    if (ts[k + 1] - ts[k] < kSameParameter) continue;
    const double middle = 0.5 * (ts[k] + ts[k + 1]);
    const Claim *left = nullptr, *right = nullptr;
    for (const Claim* c = begin; c != end; ++c) {
      // Squares of one side do not overlap: there is one of either side, or none.
      if (c->t0 <= middle && middle < c->t1) (c->left ? left : right) = c;
    }
    if (!left && !right) continue;
    const State l = left ? left->state : State::kNone, r = right ? right->state : State::kNone;
    if (l == State::kFlat && r == State::kFlat) continue;
    const Claim& claim = left ? *left : *right;
    bool forward = true;
    SectionArc::Sense sense = SectionArc::Sense::kDirected;
    if (l == State::kAbove || r == State::kAbove || l == State::kBelow || r == State::kBelow) {
      forward = l == State::kAbove || r == State::kBelow;
      // Inside the surface one side does not tell whether the other is beyond the plane.
      if (l == r || !(border || (left && right))) sense = SectionArc::Sense::kEither;
    } else {
      // A flat alone, at a border.
      const Eigen::Vector2d uv = SideCurve(*surface_, *plane_, claim).place(middle);
      const bool up = surface_->normal(claim.cell, uv.x(), uv.y()).dot(plane_->normal) >= 0.0;
      forward = up == (left != nullptr);
      sense = SectionArc::Sense::kFollowing;
    }
    add_arc(claim, ts[k], ts[k + 1], !forward, sense, chord_tolerance, parts);
  }
}

void PlaneSides::add_arc(const Claim& claim, double t0, double t1, bool backward,
                         SectionArc::Sense sense, double chord_tolerance,
                         SectionParts& parts) const {
  const SideCurve curve(*surface_, *plane_, claim);
  const std::size_t first = parts.points.size();
  sample_arc(curve, t0, curve.at(t0), t1, curve.at(t1), chord_tolerance, parts.points);
  if (backward) reverse_points(parts.points, first);
  parts.arcs.push_back(
      {static_cast<int>(first), static_cast<int>(parts.points.size()), sense, true});
}

}  // namespace hull::analysis
