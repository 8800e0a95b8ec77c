// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/region_quads.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "network/splines/border_plate.h"
#include "network/splines/quad_star.h"
#include "network/splines/reference_fit.h"
#include "network/splines/reference_places.h"

namespace hull::network {
namespace {

constexpr int kPlateSamples = 8;    // of a side, but of short ones
constexpr int kTurnSamples = 5;     // each way, of a patch whose normals are looked at
constexpr int kFoldSamples = 4;     // each way, of a patch of four sides
constexpr double kAtBorder = 1e-9;  // of a side: a knot that near to a node is there

QuadSide whole(const SideSpline& side) {
  return {side.curve(), [&side](double t) { return side.normal(t); }};
}

// Whether normals within are nowhere turned away from those at all corners.
bool is_folded(const TransfinitePatch& patch) {
  Vector3d mean = Vector3d::Zero();
  // At corners normals are what the network tells.
  for (const Vector2d& corner : patch.domain()) mean += patch.at(corner).normal();
  for (int i = 1; i < kFoldSamples; ++i) {
    for (int k = 1; k < kFoldSamples; ++k) {
      constexpr double kStep = 1.0 / kFoldSamples;
      if (!(patch.at({i * kStep, k * kStep}).normal().dot(mean) > 0.0)) return true;
    }
  }
  return false;
}

RegionQuads single_quad(const RegionInput& input, const std::vector<SideSpline>& sides,
                        const TransfinitePatch& patch) {
  RegionQuads quads;
  const QuadTarget target = [&](double u, double v) { return patch.at({u, v}).point; };
  quads.add(fitted_quad({whole(sides[0]), whole(sides[1]), whole(sides[2]), whole(sides[3])},
                        target, input.spans));
  return quads;
}

// What reference curves tell of the tangent planes along the network's border is all there is. A
// side may be border in part alone, as of a sheer that goes on as a knuckle.
void free_border(const RegionInput& input, const SideSpline& side, QuadSide& quad_side) {
  const RegionFaces& faces = input.frame->faces;
  quad_side.has_normal = [&faces, &side](double t) {
    const SideParts& parts = side.parts();
    const std::vector<double>& ends = parts.ends();
    for (std::size_t i = 0; i < parts.edges().size(); ++i) {
      if (faces.is_border(parts.edges()[i].edge)) continue;
      // Also at its nodes, where the border begins: the region beyond it has its plane there.
      if (t > ends[i] - kAtBorder && t < ends[i + 1] + kAtBorder) return true;
    }
    return false;
  };
}

RegionQuads quad_with_references(const RegionInput& input, const std::vector<SideSpline>& sides,
                                 const std::vector<RegionSide>& given,
                                 const std::vector<int>& references) {
  std::array<QuadSide, 4> around{whole(sides[0]), whole(sides[1]), whole(sides[2]),
                                 whole(sides[3])};
  for (std::size_t k = 0; k < 4; ++k) free_border(input, sides[k], around[k]);
  const ReferencePlaces places(*input.frame, given, references);
  std::vector<Reference> curves;
  for (std::size_t i = 0; i < references.size(); ++i) {
    const EdgeShape& shape = input.frame->shapes[static_cast<std::size_t>(references[i])];
    curves.push_back({[&shape](double t) { return Vector3d(shape.evaluate(t, 0).row(0)); },
                      [&places, i](double t) { return places.at(i, t); }});
  }
  // Curves inside tell more than normals at corners: the bilinear Coons patch.
  const auto on = [&](std::size_t k, double t) { return around[k].curve.position(t); };
  const QuadTarget start = [&](double u, double v) {
    const Vector3d low = on(0, u), right = on(1, v), high = on(2, 1.0 - u), left = on(3, 1.0 - v);
    return Vector3d((1.0 - v) * low + v * high + (1.0 - u) * left + u * right -
                    (1.0 - u) * ((1.0 - v) * on(0, 0.0) + v * on(3, 0.0)) -
                    u * ((1.0 - v) * on(1, 0.0) + v * on(2, 0.0)));
  };
  ReferenceFit fit = fitted_to_curves(around, start, curves, {input.tolerance, input.spans});
  RegionQuads quads;
  quads.reference_errors = fit.errors;
  quads.add(std::move(fit.quad));
  return quads;
}

std::optional<BorderPlate> plate_of(const std::vector<SideSpline>& sides, bool has_normals) {
  double longest = 0.0;
  for (const SideSpline& side : sides) longest = std::max(longest, side.curve().polygon_length());
  std::vector<PlateSample> samples;
  for (const SideSpline& side : sides) {
    // Samples that crowd along a short side would magnify all that it is off.
    const double share = side.curve().polygon_length() / longest;
    const int count =
        std::clamp(static_cast<int>(std::ceil(4.0 * share * kPlateSamples)), 1, kPlateSamples);
    for (int i = 0; i < count; ++i) {
      // Without the side's end, where the next one begins.
      const double t = static_cast<double>(i) / count;
      const Points3 jet = spline_jet(side.curve(), t);
      samples.push_back({jet.row(0), jet.row(1), side.normal(t), i > 0});
    }
  }
  return BorderPlate::within(samples, has_normals);
}

// Refers to both, which are there as long as the star is used.
StarTarget plate_target(const BorderPlate& plate, const std::vector<SideSpline>& sides) {
  return {[&plate](const Vector2d& place) { return plate.at(place); },
          [&plate, &sides](std::size_t side, double t) {
            return plate.place(sides[side].curve().position(t));
          },
          plate.centre()};
}

StarTarget blend_target(const TransfinitePatch& patch) {
  Vector2d centre = Vector2d::Zero();
  for (const Vector2d& corner : patch.domain()) {
    centre += corner / static_cast<double>(patch.domain().size());
  }
  return {[&patch](const Vector2d& place) { return patch.at(place); },
          [&patch](std::size_t side, double t) -> Vector2d {
            const auto& polygon = patch.domain();
            return (1.0 - t) * polygon[side] + t * polygon[(side + 1) % polygon.size()];
          },
          centre};
}

// Whether normals of patches are anywhere turned away from their mean.
bool is_folded(const RegionQuads& quads) {
  std::vector<Vector3d> normals;
  Vector3d mean = Vector3d::Zero();
  for (const conversion::BSplinePatch& patch : quads.patches) {
    for (int i = 0; i < kTurnSamples; ++i) {
      for (int k = 0; k < kTurnSamples; ++k) {
        const auto jet = patch.evaluate((i + 0.5) / kTurnSamples, (k + 0.5) / kTurnSamples);
        // Not of unit length: slivers count for little in the mean.
        normals.push_back(jet.du.cross(jet.dv));
        mean += normals.back();
      }
    }
  }
  return !std::ranges::all_of(normals, [&](const Vector3d& one) { return one.dot(mean) > 0.0; });
}

std::vector<SideSpline> splines_of(const RegionInput& input, const std::vector<RegionSide>& sides) {
  std::vector<SideSpline> splines;
  for (const RegionSide& side : sides) splines.emplace_back(input.frame, input.edges, side);
  return splines;
}

// Around the centre of a plate, if one is unfolded; with the network's normals, if that is.
std::optional<RegionQuads> plate_quads(const RegionInput& input,
                                       const std::vector<SideSpline>& splines) {
  for (bool has_normals : {true, false}) {
    const auto plate = plate_of(splines, has_normals);
    if (!plate) continue;
    QuadStar star(input, splines, plate_target(*plate, splines), has_normals);
    if (!star.is_regular() || !plate->is_gentle(star.inner_places())) continue;
    RegionQuads quads = star.quads();
    if (!is_folded(quads)) return quads;
  }
  return std::nullopt;
}

}  // namespace

void RegionQuads::add(FittedQuad fitted) {
  patches.push_back(std::move(fitted.patch));
  has_normals = has_normals && fitted.has_normals;
}

std::vector<std::array<QuadBorder, 4>> quad_borders(const NetworkFrame& frame,
                                                    const std::vector<RegionSide>& sides,
                                                    bool is_single) {
  std::vector<SideParts> parts;
  for (const RegionSide& side : sides) parts.emplace_back(frame, side);
  std::vector<std::array<QuadBorder, 4>> borders;
  if (is_single) {
    auto& around = borders.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) around[k].pieces = parts[k].pieces(0.0, 1.0);
    return borders;
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t last = (i + parts.size() - 1) % parts.size();
    // As QuadStar has its quads, and their sides.
    borders.push_back({QuadBorder{parts[i].pieces(0.0, parts[i].middle()), -1, true},
                       QuadBorder{{}, static_cast<int>(i), true},
                       QuadBorder{{}, static_cast<int>(last), false},
                       QuadBorder{parts[last].pieces(parts[last].middle(), 1.0), -1, true}});
  }
  return borders;
}

RegionQuads region_quads(const RegionInput& input, const MergedRegion& region) {
  const std::vector<RegionSide>& given = region.sides;
  const std::vector<RegionSide> sides = sides_of_one_curve(*input.frame, given);
  const std::vector<SideSpline> splines = splines_of(input, sides);
  if (!region.references.empty()) {
    return quad_with_references(input, splines, sides, region.references);
  }
  if (given.size() == 4 && sides.size() == 4) {
    const TransfinitePatch patch(ribboned_sides(input.frame, sides));
    // Where it is folded, quads around a centre need not be.
    if (!is_folded(patch)) return single_quad(input, splines, patch);
  }
  // First without short sides, beside which quads are slivers; with them where nothing comes of
  // that.
  const std::vector<RegionSide> joined = with_short_sides_joined(*input.frame, sides);
  if (joined.size() < sides.size()) {
    if (auto quads = plate_quads(input, splines_of(input, joined))) {
      quads->has_short_sides = false;
      return std::move(*quads);
    }
  }
  if (auto quads = plate_quads(input, splines)) return std::move(*quads);
  // A TransfinitePatch of two sides has a domain of three, which are not the region's.
  if (sides.size() == 2) {
    throw std::invalid_argument(
        "Its border is no graph over a plane, or turns back: divide it by a curve.");
  }
  const TransfinitePatch patch(ribboned_sides(input.frame, sides));
  return QuadStar(input, splines, blend_target(patch), true).quads();
}

}  // namespace hull::network
