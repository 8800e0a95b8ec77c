// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/afloat/plane_edges.h"

#include <cmath>

#include "analysis/sections/arc_sampling.h"

namespace hull::conversion {
namespace {

using analysis::SectionArc;

// A side of a piece, by its own parameter.
class PieceSide {
 public:
  PieceSide(const PatchPieces& pieces, const EdgeUse& use, const Vector3d& normal)
      : points_(pieces.pieces()[static_cast<std::size_t>(use.patch)].points),
        piece_(use.patch),
        side_(use.side),
        normal_(normal) {}

  Eigen::Vector2d place(double t) const {
    const Eigen::Vector2d places[] = {{t, 0.0}, {1.0, t}, {1.0 - t, 1.0}, {0.0, 1.0 - t}};
    return places[side_];
  }

  surface::SurfaceJet jet(double t) const {
    const Eigen::Vector2d at = place(t);
    return surface::evaluate_bicubic(points_, at.x(), at.y(), 2);
  }

  analysis::ArcSample at(double t) const {
    const surface::SurfaceJet here = jet(t);
    const bool is_along_v = side_ % 2 == 1;
    analysis::ArcSample sample{};
    sample.p.point = here.point;
    sample.p.cell = piece_;
    sample.p.uv = place(t);
    // Sides 2 and 3 run against u and v; second derivatives have no direction.
    sample.d1 = (side_ < 2 ? 1.0 : -1.0) * (is_along_v ? here.dv : here.du);
    const Vector3d& d2 = is_along_v ? here.dvv : here.duu;
    // The edge is in the plane but for rounding; d2's part across it drops out of the product.
    const Vector3d d1 = sample.d1 - normal_.dot(sample.d1) * normal_;
    const double speed = d1.norm();
    if (speed > 0.0) {
      sample.p.tangent = d1 / speed;
      sample.p.curvature = normal_.dot(d1.cross(d2)) / (speed * speed * speed);
    }
    return sample;
  }

 private:
  const surface::BicubicPoints& points_;
  int piece_, side_;
  const Vector3d& normal_;
};

}  // namespace

void PlaneEdges::claim(const EdgeUse& use, State state) {
  const int edge = pieces_.uses().part(use).edge;
  if (pieces_.uses().is_collapsed(edge)) return;
  auto& states = states_.try_emplace(edge, std::array{State::kNone, State::kNone}).first->second;
  states[pieces_.uses().of(edge)[0] == use ? 0 : 1] = state;
}

void PlaneEdges::add_flat(int piece) {
  for (int k = 0; k < 4; ++k) {
    const auto& side =
        pieces_.set().sides[static_cast<std::size_t>(piece)][static_cast<std::size_t>(k)];
    for (int i = 0; i < std::ssize(side); ++i) claim({piece, k, i}, State::kFlat);
  }
}

void PlaneEdges::add_sides(int piece, const analysis::HeightNet& height) {
  for (int k = 0; k < 4; ++k) {
    if (!height.in_plane[static_cast<std::size_t>(k)]) continue;
    const auto& side =
        pieces_.set().sides[static_cast<std::size_t>(piece)][static_cast<std::size_t>(k)];
    const analysis::BezierCubic beside = height.along(k);
    for (int i = 0; i < std::ssize(side); ++i) {
      const SideEdge& part = side[static_cast<std::size_t>(i)];
      const double middle = 0.5 * (part.begin + part.end);
      // height.along() goes by rising u or v.
      const double rising = k < 2 ? middle : 1.0 - middle;
      claim({piece, k, i},
            analysis::evaluate(beside, rising) >= 0.0 ? State::kAbove : State::kBelow);
    }
  }
}

void PlaneEdges::add_arcs(double chord_tolerance, analysis::SectionParts& parts) const {
  for (const auto& [edge, states] : states_) {
    add_edge(edge, states[0], states[1], chord_tolerance, parts);
  }
}

// A patch is to the left of its sides: the first use's state is the left one.
void PlaneEdges::add_edge(int edge, State left, State right, double chord_tolerance,
                          analysis::SectionParts& parts) const {
  // Within a flat nothing is drawn.
  if (left == State::kFlat && right == State::kFlat) return;
  const auto& uses = pieces_.uses().of(edge);
  const bool is_first = left != State::kNone;
  const EdgeUse& use = is_first ? uses[0] : uses[1];
  const SideEdge& part = pieces_.uses().part(use);
  const PieceSide side(pieces_, use, plane_.normal);
  bool is_forward = true;  // along the first use
  SectionArc::Sense sense = SectionArc::Sense::kDirected;
  const auto is_off = [](State state) { return state == State::kAbove || state == State::kBelow; };
  if (is_off(left) || is_off(right)) {
    // What is above the plane is to be on the left.
    is_forward = left == State::kAbove || right == State::kBelow;
    // The surface touches the plane from one side: neither direction is right.
    if (left == right) sense = SectionArc::Sense::kEither;
  } else {
    const surface::SurfaceJet jet = side.jet(0.5 * (part.begin + part.end));
    is_forward = (jet.du.cross(jet.dv).dot(plane_.normal) >= 0.0) == is_first;
    sense = SectionArc::Sense::kFollowing;
  }
  const std::size_t first = parts.points.size();
  analysis::sample_arc(side, part.begin, side.at(part.begin), part.end, side.at(part.end),
                       chord_tolerance, parts.points);
  if (is_forward != is_first) analysis::reverse_points(parts.points, first);
  parts.arcs.push_back(
      {static_cast<int>(first), static_cast<int>(parts.points.size()), sense, true});
}

}  // namespace hull::conversion
