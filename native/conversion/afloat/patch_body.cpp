// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/afloat/patch_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "analysis/arithmetic/gauss.h"
#include "analysis/immersion/body_rules.h"
#include "analysis/immersion/cut_moments.h"
#include "mesh/tolerances.h"

namespace hull::conversion {
namespace {

using analysis::ShellMoments;
using analysis::SpanRule;

constexpr double kOpenArea = 1e-9;  // of size²: what a closed border's projection may have

Vector3d on_centre_plane(const Vector3d& point) { return {point.x(), 0.0, point.z()}; }

// From an edge of the border, which the shell has to its left, to the centre plane.
surface::BicubicPoints cap_of(const BSplineCurve& edge) {
  std::array<Vector3d, 16> bezier;
  for (std::size_t i = 0; i < 4; ++i) {
    // Against the border, which the cap has on its other side: so its normal points outwards.
    const Vector3d &start = edge.points[3 - i], end = on_centre_plane(start);
    for (std::size_t j = 0; j < 4; ++j) {
      const double share = static_cast<double>(j) / 3.0;
      bezier[4 * i + j] = (1.0 - share) * start + share * end;
    }
  }
  return uniform_points(bezier);
}

// ∮ z dx of a border: what its projection on the centre plane has of area.
double projected_area(const std::vector<BSplineCurve>& loop) {
  double area = 0.0;
  const auto& [count, nodes, weights] = analysis::kThreeNodes;  // exact to degree five
  for (const BSplineCurve& curve : loop) {
    for (int g = 0; g < count; ++g) {
      const double t = nodes[g];
      const BasisValues values = basis_values(curve.knots, curve.degree, t);
      double height = 0.0, slope = 0.0;
      for (int i = 0; i <= curve.degree; ++i) {
        const Vector3d& point = curve.points[static_cast<std::size_t>(values.first + i)];
        height += values.rows(0, i) * point.z();
        slope += values.rows(1, i) * point.x();
      }
      area += weights[g] * height * slope;
    }
  }
  return area;
}

std::string told_opening(const Vector3d& at) {
  std::ostringstream words;
  words << std::fixed << std::setprecision(3) << "The surface is open at (" << at.x() << ", "
        << at.y() << ", " << at.z()
        << ") m, where lines athwartships do not close it: fill the gap with patches, or lead its "
           "border to the centre plane.";
  return words.str();
}

analysis::Plane image_of(const analysis::Plane& plane) {
  return {plane.normal.cwiseProduct(Vector3d(1.0, -1.0, 1.0)), plane.offset};
}

}  // namespace

PatchBody::PatchBody(const PatchPieces& pieces, bool mirrored)
    : pieces_(pieces), mirrored_(mirrored), centre_(Vector3d::Zero()), size_(pieces.size()) {
  Eigen::AlignedBox3d box;
  for (const auto& piece : pieces.set().patches) {
    for (const Vector3d& point : piece.control_points) box.extend(point);
  }
  // Moments are taken about it: near the hull for rounding, and in the plane so that those of the
  // other half differ by signs alone.
  if (!box.isEmpty()) centre_ = on_centre_plane(box.center());
  for (const PatchPieces::Piece& piece : pieces.pieces()) add(piece.points, false);
  for (const auto& loop : border_loops(pieces.uses(), pieces.set().edge_count)) close(loop);
  double volume = 0.0, area = 0.0;  // from ∫ z n_z, the same for both halves
  for (const Part& part : parts_) {
    volume += part.moments.first(2, 2);
    area += part.moments.area;
  }
  if (volume < -analysis::kNoVolume * size_ * area) {
    throw std::invalid_argument(
        "The displaced volume is negative: patches are turned inwards. Turn them outwards, into "
        "the water.");
  }
}

void PatchBody::add(const surface::BicubicPoints& points, bool is_cap) {
  Part part{
      points, is_cap,
      analysis::span_moments({points, centre_}, SpanRule::kExact, analysis::exact_cuts(size_).area),
      Vector3d::Zero(), Vector3d::Zero()};
  // Closings count for volumes, not for the wetted surface.
  if (is_cap) part.moments.area = part.moments.area_error = 0.0;
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : points) box.extend(Vector3d(point - centre_));
  part.middle = box.center();
  part.half = 0.5 * box.sizes();
  parts_.push_back(std::move(part));
}

void PatchBody::close(const std::vector<EdgeUse>& loop) {
  std::vector<BSplineCurve> curves;
  bool is_at_centre = false;
  for (const EdgeUse& use : loop) {
    curves.push_back(pieces_.uses().curve(use));
    is_at_centre =
        is_at_centre || std::abs(curves.back().points.front().y()) <= kOnCentrePlane * size_;
  }
  // Borders of a whole hull are closed to the centre plane from both sides, which leaves nothing
  // over where the projections cancel.
  const bool is_closed =
      (mirrored_ && is_at_centre) || std::abs(projected_area(curves)) <= kOpenArea * size_ * size_;
  if (!is_closed) throw std::invalid_argument(told_opening(curves.front().points.front()));
  for (const BSplineCurve& curve : curves) {
    // A border in the plane needs no cap; its own would have no area.
    const bool is_needed =
        std::ranges::any_of(curve.points, [](const Vector3d& point) { return point.y() != 0.0; });
    if (is_needed) add(cap_of(curve), true);
  }
}

ShellMoments PatchBody::wet(const analysis::Plane& water) const {
  const analysis::CutRules rules = analysis::exact_cuts(size_);
  ShellMoments sum;
  for (const Part& part : parts_) {
    const double height = water.normal.dot(part.middle) + water.height(centre_);
    // The box's reach along the normal: most parts are wholly in or out of the water.
    const double half = water.normal.cwiseAbs().dot(part.half) + rules.zero;
    if (height >= half) continue;
    if (height < -half) {
      sum += part.moments;
      continue;
    }
    ShellMoments cut = analysis::wet_moments(part.points, centre_, water, rules);
    if (part.is_cap) cut.area = cut.area_error = 0.0;
    sum += cut;
  }
  return sum;
}

analysis::Immersion PatchBody::immersion(const analysis::Plane& water) const {
  if (!water.normal.allFinite() || !std::isfinite(water.offset)) {
    throw std::invalid_argument("The water's surface must be given by finite numbers.");
  }
  ShellMoments all = wet(water);
  if (mirrored_) {
    // Heeled, the other half is this one in the mirrored water.
    all += analysis::mirrored(water.normal.y() == 0.0 ? all : wet(image_of(water)));
  }
  // About a point in the water's surface, where heights do not cancel.
  const double level = std::clamp(-water.height(centre_), -size_, size_);
  const Vector3d origin = centre_ + level * water.normal;
  analysis::Immersion result =
      analysis::immersion_of(analysis::moved(all, centre_ - origin), {water.normal, 0.0});
  result.water = water;
  if (result.volume > 0.0) result.centre_of_buoyancy += origin;
  if (result.waterplane_area > 0.0) result.centre_of_flotation += origin;
  return result;
}

}  // namespace hull::conversion
