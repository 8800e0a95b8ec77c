// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/quad_star.h"

#include <algorithm>

namespace hull::network {
namespace {

constexpr int kFoldSteps = 4;  // each way, of a quad

QuadSide part_of(const SideSpline& side, double begin, double end, const Vector3d& from,
                 const Vector3d& to) {
  QuadSide part{side.curve().part(begin, end),
                [&side, begin, end](double t) { return side.normal(begin + t * (end - begin)); }};
  // But for rounding they are: neighbours have these places bit for bit.
  part.curve.points.front() = from;
  part.curve.points.back() = to;
  return part;
}

}  // namespace

QuadStar::QuadStar(const RegionInput& input, const std::vector<SideSpline>& sides,
                   StarTarget target, bool has_normals)
    : input_(input), sides_(sides), target_(std::move(target)), has_normals_(has_normals) {
  for (const SideSpline& side : sides_) middles_.push_back(side.parts().middle());
}

bool QuadStar::is_regular() const {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    for (int a = 0; a < kFoldSteps; ++a) {
      for (int b = 0; b < kFoldSteps; ++b) {
        constexpr double kStep = 1.0 / kFoldSteps;
        const double u = a * kStep, v = b * kStep;
        // By small parallelograms all over the quad.
        const Vector2d at = place(i, u, v), by_u = place(i, u + kStep, v) - at,
                       by_v = place(i, u, v + kStep) - at;
        if (!(cross(by_u, by_v) > 0.0)) return false;
      }
    }
  }
  return true;
}

std::vector<Vector2d> QuadStar::inner_places() const {
  std::vector<Vector2d> places{target_.centre};
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    for (double u : {0.25, 0.75}) {
      for (double v : {0.25, 0.75}) places.push_back(place(i, u, v));
    }
  }
  return places;
}

RegionQuads QuadStar::quads() {
  RegionQuads made;
  made.has_normals = has_normals_;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    spokes_.push_back(spoke(i));
    made.spoke_error = std::max(made.spoke_error, spokes_.back().error);
  }
  // After all spokes, of which a quad has two, and refers to them.
  for (std::size_t i = 0; i < sides_.size(); ++i) add_quad(made, i);
  return made;
}

// Of the quad at the beginning of side i, u along that: Coons' in the plane.
Vector2d QuadStar::place(std::size_t i, double u, double v) const {
  const std::size_t last = before(i);
  const auto on_last = [&](double t) {
    // From the corner backwards, to the middle of the side before.
    return target_.border(last, 1.0 - t * (1.0 - middles_[last]));
  };
  const Vector2d corner = target_.border(i, 0.0), middle = target_.border(i, middles_[i]),
                 other = on_last(1.0), &centre = target_.centre;
  const Vector2d low = target_.border(i, u * middles_[i]), high = (1.0 - u) * other + u * centre,
                 left = on_last(v), right = (1.0 - v) * middle + v * centre;
  return (1.0 - v) * low + v * high + (1.0 - u) * left + u * right -
         (1.0 - u) * ((1.0 - v) * corner + v * other) - u * ((1.0 - v) * middle + v * centre);
}

Vector2d QuadStar::on_spoke(std::size_t i, double t) const {
  return (1.0 - t) * target_.border(i, middles_[i]) + t * target_.centre;
}

// Where the middle of a side is.
Vector3d QuadStar::middle_place(std::size_t i) const {
  // Of the edge, not of the side's spline: the region beyond it has the same place bit for bit.
  const EdgePiece piece = sides_[i].parts().pieces(0.0, middles_[i]).back();
  return input_.edges.place(*input_.frame, piece.edge, piece.to);
}

// It begins in its side's tangent plane.
FittedSpline QuadStar::spoke(std::size_t i) const {
  // Spokes are straight in the plane: the slope is the target's derivative along them.
  const Vector2d way = on_spoke(i, 1.0) - on_spoke(i, 0.0);
  const Vector3d start = middle_place(i), normal = sides_[i].normal(middles_[i]);
  const auto target = [&](double t) {
    const PatchPoint point = target_.at(on_spoke(i, t));
    Points3 rows(2, 3);
    rows.row(0) = point.point;
    rows.row(1) = way.x() * point.by_first + way.y() * point.by_second;
    return rows;
  };
  // What the target is off there fades out towards the centre.
  const Points3 found = target(0.0);
  const Vector3d slope = found.row(1), shift = start - Vector3d(found.row(0));
  const Vector3d tilt = -slope.dot(normal) * normal;
  const auto jet = [&](double t) {
    const double w = 1.0 - t;
    Points3 rows = target(t);
    // Hermite's cubics of a value and of a slope at 0.
    rows.row(0) += (w * w * ((1.0 + 2.0 * t) * shift + t * tilt)).transpose();
    rows.row(1) += (w * (-6.0 * t * shift + (1.0 - 3.0 * t) * tilt)).transpose();
    return rows;
  };
  FittedSpline fitted = fitted_spline(jet, input_.tolerance);
  fitted.curve.points.front() = start;  // but for rounding it is
  return fitted;
}

QuadSide QuadStar::spoke_side(std::size_t i, bool is_inwards) const {
  const BSplineCurve& curve = spokes_[i].curve;
  return {is_inwards ? curve : curve.reversed(), [this, i, &curve, is_inwards](double given) {
            // Quads on both sides of the spoke have the same normals at the same places.
            const double t = is_inwards ? given : 1.0 - given;
            const Vector3d normal = target_.at(on_spoke(i, t)).normal();
            const Vector3d along = Vector3d(spline_jet(curve, t).row(1)).normalized();
            return Vector3d((normal - normal.dot(along) * along).normalized());
          }};
}

void QuadStar::add_quad(RegionQuads& made, std::size_t i) const {
  const std::size_t last = before(i);
  const Vector3d corner = sides_[i].curve().points.front(), middle = middle_place(i),
                 other = middle_place(last);
  const QuadTarget target = [this, i](double u, double v) {
    return target_.at(place(i, u, v)).point;
  };
  // Counterclockwise from the corner: along the side, inwards, outwards, along the side before.
  std::array<QuadSide, 4> around{part_of(sides_[i], 0.0, middles_[i], corner, middle),
                                 spoke_side(i, true), spoke_side(last, false),
                                 part_of(sides_[last], middles_[last], 1.0, other, corner)};
  // Spokes keep the target's: they are smooth all the same.
  if (!has_normals_) around[0].normal = around[3].normal = nullptr;
  made.add(fitted_quad(around, target, input_.spans));
}

}  // namespace hull::network
