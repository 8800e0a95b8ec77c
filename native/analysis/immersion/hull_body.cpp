// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/hull_body.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace hull {
namespace {

// Of the mesh's size, or of its powers.
constexpr double kZeroHeight = 1e-13;
constexpr double kCornerFirst = 1e-15;    // per irregular corner
constexpr double kCutVolume = 1e-15;      // per part of a cut
constexpr double kAreaTolerance = 1e-12;  // per span
constexpr double kCornerArea = 1e-11;     // per irregular corner
constexpr double kNoMatter = 1e300;       // a tolerance for areas that are not asked for
constexpr double kNoVolume = 1e-9;        // times the area: what an open sheet may have
constexpr double kAtEdge = 1e-9;          // water at an opening's edge does not flow in
constexpr double kSmallestCorner = 1e-9;  // beyond it a corner cut by the water is left out

// Closings are no part of the wetted surface.
ShellMoments without_area(ShellMoments moments) {
  moments.area = moments.area_error = 0.0;
  return moments;
}

struct Box {
  Vector3d low, high;
};

Box box_of(const Vector3d* points, std::size_t count) {
  Box box{points[0], points[0]};
  for (std::size_t i = 1; i < count; ++i) {
    box = {box.low.cwiseMin(points[i]), box.high.cwiseMax(points[i])};
  }
  return box;
}

Plane mirror_image(const Plane& plane) {
  return {plane.normal.cwiseProduct(Vector3d(1.0, -1.0, 1.0)), plane.offset};
}

}  // namespace

HullBody::HullBody(const LimitSurface& surface, bool mirrored, Openings openings)
    : surface_(&surface), mirrored_(mirrored), openings_(openings), bodies_(bodies_of(surface)) {
  const SurfaceLayout& layout = surface.layout();
  for (int i = 0; i < layout.corner_count(); ++i) {
    const CornerBasis& basis = layout.basis(i);
    if (!series_.contains(&basis)) series_.emplace(&basis, CornerSeries(basis));
  }
  leaves_.resize(layout.leaf_count());
  corners_.resize(layout.corner_count());
  update();
}

const CornerSeries& HullBody::series(int corner) const {
  return series_.at(&surface_->layout().basis(corner));
}

void HullBody::place(Part& part, const Vector3d* points, std::size_t count) const {
  const Box box = box_of(points, count);
  part.middle = 0.5 * (box.low + box.high) - centre_;
  part.half = 0.5 * (box.high - box.low);
}

void HullBody::update() {
  const LimitSurface& surface = *surface_;
  const double size = surface.mesh().size();
  const Box all = box_of(surface.mesh().points().data(), surface.mesh().points().size());
  centre_ = 0.5 * (all.low + all.high);
  if (mirrored_) centre_.y() = 0.0;
  corner_tolerance_ = {kCornerFirst * size * size * size, kCornerArea * size * size};
  cut_tolerance_ = {kZeroHeight * size, kCutVolume * size * size * size,
                    kAreaTolerance * size * size};

  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    const BicubicPoints& points = surface.leaf(static_cast<int>(i));
    place(leaves_[i], points.data(), points.size());
    leaves_[i].moments = span_moments({points, centre_}, SpanRule::kExact, cut_tolerance_.area);
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const int corner = static_cast<int>(i);
    const CornerBasis& basis = surface.layout().basis(corner);
    const std::vector<Vector3d>& points = surface.corner(corner).outer;
    place(corners_[i], points.data(), points.size());
    CornerRing ring(basis, surface.corner(corner));
    corners_[i].moments = corner_moments(ring, basis, series(corner), centre_, corner_tolerance_);
  }
  closings_ = closing_spans(surface, mirrored_);
  caps_.resize(closings_.size());
  for (std::size_t i = 0; i < caps_.size(); ++i) {
    const BicubicPoints& points = closings_[i].cap;
    place(caps_[i], points.data(), points.size());
    caps_[i].moments = span_moments({points, centre_}, SpanRule::kExact, kNoMatter);
  }
  inversion_ = inversion();
}

std::string HullBody::inversion() const {
  std::vector<ShellMoments> sums(bodies_.first_cell.size());
  for (std::size_t i = 0; i < leaves_.size(); ++i) sums[bodies_.of_leaf[i]] += leaves_[i].moments;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    sums[bodies_.of_corner[i]] += corners_[i].moments;
  }
  for (std::size_t i = 0; i < caps_.size(); ++i) {
    sums[bodies_.of_cell[closings_[i].cell]] += caps_[i].moments;
  }
  for (std::size_t b = 0; b < sums.size(); ++b) {
    // ∫ z n_z, the same for both halves.
    const double volume = sums[b].first(2, 2);
    if (volume >= -kNoVolume * surface_->mesh().size() * sums[b].area) continue;
    const int face = surface_->mesh().topology().face(bodies_.first_cell[b]);
    return "The displaced volume is negative: the faces of the body with face " +
           std::to_string(face) + " are turned inwards. Turn them outwards, into the water.";
  }
  return {};
}

// The part of a corner's square below the water, which crosses the hull of its control points.
ShellMoments HullBody::wet_corner(int corner, const Plane& water) const {
  const CornerBasis& basis = surface_->layout().basis(corner);
  const double smallest = kSmallestCorner * surface_->mesh().size();
  ShellMoments sum;
  for (CornerRing ring(basis, surface_->corner(corner));; ring.advance()) {
    const std::vector<Vector3d> points = ring.points();
    double lowest = water.height(points[0]), highest = lowest;
    for (const Vector3d& p : points) {
      lowest = std::min(lowest, water.height(p));
      highest = std::max(highest, water.height(p));
    }
    if (lowest > -cut_tolerance_.zero) return sum;
    if (highest < -cut_tolerance_.zero) {
      sum += corner_moments(ring, basis, series(corner), centre_, corner_tolerance_);
      return sum;
    }
    const Box box = box_of(points.data(), points.size());
    if ((box.high - box.low).norm() < smallest) return sum;
    for (int s = 0; s < basis.segment_count(); ++s) {
      sum += wet_moments(ring.segment_points(s), centre_, water, cut_tolerance_);
    }
  }
}

template <class Cut>
void HullBody::add_wet(const std::vector<Part>& parts, const Plane& water, const Cut& cut,
                       ShellMoments& sum) const {
  const double level = -water.height(centre_);
  const Vector3d extent = water.normal.cwiseAbs();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double height = water.normal.dot(parts[i].middle) - level;
    const double half = extent.dot(parts[i].half) + cut_tolerance_.zero;
    if (height >= half) continue;
    if (height < -half) {
      sum += parts[i].moments;
    } else {
      sum += cut(static_cast<int>(i));
    }
  }
}

HullBody::Wet HullBody::wet_part(const Plane& water) const {
  const auto wet_span = [&](const BicubicPoints& points) {
    return wet_moments(points, centre_, water, cut_tolerance_);
  };
  Wet wet;
  add_wet(
      leaves_, water, [&](int i) { return wet_span(surface_->leaf(i)); }, wet.shell);
  add_wet(
      corners_, water, [&](int i) { return wet_corner(i, water); }, wet.shell);
  add_wet(
      caps_, water, [&](int i) { return wet_span(closings_[i].cap); }, wet.caps);
  return wet;
}

ShellMoments HullBody::shell_moments() const {
  ShellMoments sum;
  for (const Part& leaf : leaves_) sum += leaf.moments;
  for (const Part& corner : corners_) sum += corner.moments;
  sum = moved(sum, centre_);
  if (mirrored_) sum += hull::mirrored(sum);
  return sum;
}

FloodingPoint HullBody::flooding_point(const Vector3d& up) const {
  FloodingPoint lowest{std::numeric_limits<double>::infinity(), Vector3d::Zero()};
  if (openings_ == Openings::kClosed) return lowest;
  for (const Vector3d& mirror : {Vector3d(1.0, 1.0, 1.0), Vector3d(1.0, -1.0, 1.0)}) {
    if (mirror.y() < 0.0 && !mirrored_) break;
    for (const ClosingSpan& span : closings_) {
      if (!span.open) continue;
      const FloodingPoint point = lowest_point(span.border, up.cwiseProduct(mirror));
      if (point.height < lowest.height) {
        lowest = {point.height, point.point.cwiseProduct(mirror)};
      }
    }
  }
  return lowest;
}

void HullBody::refuse_flooding(const Plane& water) const {
  const FloodingPoint lowest = flooding_point(water.normal);
  if (lowest.height >= water.offset - kAtEdge * surface_->mesh().size()) return;
  std::ostringstream words;
  words
      << std::fixed << std::setprecision(3) << "The hull floods at (" << lowest.point.x() << ", "
      << lowest.point.y() << ", " << lowest.point.z() << ") m, which is "
      << water.offset - lowest.height
      << " m under water. Lower the draft, close the shell there, or declare its openings closed.";
  throw std::invalid_argument(words.str());
}

Immersion HullBody::immersion(const Plane& water) const {
  if (!water.normal.allFinite() || !std::isfinite(water.offset)) {
    throw std::invalid_argument("The water's surface must be given by finite numbers.");
  }
  if (!inversion_.empty()) throw std::invalid_argument(inversion_);
  refuse_flooding(water);
  Wet wet = wet_part(water);
  if (mirrored_) {
    const Wet other = water.normal.y() == 0.0 ? wet : wet_part(mirror_image(water));
    wet.shell += hull::mirrored(other.shell);
    wet.caps += hull::mirrored(other.caps);
  }
  ShellMoments all = wet.shell;
  all += without_area(wet.caps);
  // About a point in the water's surface, where heights do not cancel, or, where the water is far
  // off, in a plane that is just as far beyond the body.
  const double size = surface_->mesh().size();
  const double level = std::clamp(-water.height(centre_), -size, size);
  const Vector3d origin = centre_ + level * water.normal;
  Immersion result = immersion_of(moved(all, centre_ - origin), {water.normal, 0.0});
  result.water = water;
  if (result.volume > 0.0) result.centre_of_buoyancy += origin;
  if (result.waterplane_area > 0.0) result.centre_of_flotation += origin;
  result.flux_forms = moved(wet.shell, centre_).first.diagonal();
  return result;
}

}  // namespace hull
