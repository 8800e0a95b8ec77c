// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/hull_body.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "analysis/appendages/appendage.h"
#include "analysis/appendages/hull_members.h"
#include "analysis/immersion/inverted_body.h"
#include "analysis/immersion/wedge_moments.h"
#include "analysis/sections/port_side.h"
#include "analysis/stations/profile_plane.h"
#include "mesh/tolerances.h"

namespace hull::analysis {
namespace {

// Of the mesh's size: water at an opening's edge does not flow in.
constexpr double kAtEdge = 1e-9;

// Closings are no part of the wetted surface.
ShellMoments without_area(ShellMoments moments) {
  moments.area = moments.area_error = 0.0;
  return moments;
}

double checked(double tolerance) {
  if (tolerance > 0.0 && tolerance < 1e-2) return tolerance;
  throw std::invalid_argument("The tolerance of a body's integrals must be between 0 and 0.01.");
}

Plane mirror_image(const Plane& plane) {
  return {plane.normal.cwiseProduct(Vector3d(1.0, -1.0, 1.0)), plane.offset};
}

}  // namespace

HullBody::HullBody(const surface::LimitSurface& surface, bool mirrored, Openings openings,
                   double tolerance)
    : stamp_(surface),
      mirrored_(mirrored),
      openings_(openings),
      tolerance_(checked(tolerance)),
      bodies_(bodies_of(surface)),
      parts_(surface, mirrored, tolerance),
      boxes_(surface) {
  close();
}

HullBody::HullBody(const HullBody& body, const surface::LimitSurface& copy)
    : HullBody(body, copy, std::optional<Plane>()) {}

HullBody::HullBody(const HullBody& body, const surface::LimitSurface& copy, const Plane& water)
    : HullBody(body, copy, std::optional<Plane>(water)) {
  assert(water.normal.y() == 0.0);
}

HullBody::HullBody(const HullBody& body, const surface::LimitSurface& copy,
                   const std::optional<Plane>& water)
    : stamp_(copy),
      mirrored_(body.mirrored_),
      openings_(body.openings_),
      tolerance_(body.tolerance_),
      water_(water),
      bodies_(body.bodies_),
      parts_(body.parts_, copy, water),
      boxes_(body.boxes()),
      border_(body.border_),
      closings_(body.closings_),
      caps_(body.caps_),
      // The hull alone: what is joined would be joined anew at each update().
      appendages_(water ? nullptr : body.appendages_),
      joined_(water ? nullptr : body.joined_),
      profile_(water ? nullptr : body.profile_),
      inversion_(body.inversion_) {}

void HullBody::update() {
  if (!stamp_.is_current() || appendages_) ++version_;
  parts_.update();
  boxes_.update(surface());
  close();
  stamp_.renew();
  // Of the old points; null, so that where take() throws the hull alone is left.
  joined_ = nullptr;
  profile_ = nullptr;
  if (appendages_) take(*appendages_);
}

void HullBody::take(const std::vector<Appendage>& appendages) {
  std::shared_ptr<const JoinedShells> joined = joined_shells(*this, appendages);
  // Kept last: both may throw, and are kept together or not at all.
  profile_ = analysis::joined_profile(*this, appendages);
  joined_ = std::move(joined);
}

void HullBody::join(std::vector<Appendage> appendages) {
  current();
  if (water_) {
    throw std::invalid_argument(
        "Nothing can be joined to a body for one water alone: join it to one for all waters.");
  }
  take(appendages);
  ++version_;
  appendages_ = std::make_shared<const std::vector<Appendage>>(std::move(appendages));
}

void HullBody::close() {
  const Vector3d& centre = parts_.rules().centre;
  border_ = border_edges(surface());
  closings_ = closing_patches(surface(), border_, mirrored_);
  caps_.resize(closings_.size());
  for (std::size_t i = 0; i < caps_.size(); ++i) {
    const surface::BicubicPoints& points = closings_[i].cap;
    place(caps_[i], points.data(), points.size(), centre);
    caps_[i].moments = span_moments({points, centre}, parts_.rules().span);
  }
  if (!water_) inversion_ = inversion();
}

std::string HullBody::inversion() const {
  struct Sum {
    double volume = 0.0, area = 0.0;  // volume from ∫ z n_z, the same for both halves
    void add(const ShellMoments& moments) {
      // About the rules' centre: the flux through a closed surface is the same from any origin.
      volume += moments.first(2, 2);
      area += moments.area;
    }
  };
  std::vector<Sum> sums(bodies_.first_cell.size());
  for (std::size_t i = 0; i < parts_.leaves().size(); ++i) {
    sums[bodies_.of_leaf[i]].add(parts_.leaves()[i].moments);
  }
  for (std::size_t i = 0; i < parts_.corners().size(); ++i) {
    sums[bodies_.of_corner[i]].add(parts_.corners()[i].moments);
  }
  for (std::size_t i = 0; i < caps_.size(); ++i) {
    sums[bodies_.of_cell[closings_[i].cell]].add(caps_[i].moments);
  }
  for (std::size_t b = 0; b < sums.size(); ++b) {
    if (sums[b].volume >= -kNoVolume * surface().mesh().size() * sums[b].area) continue;
    return inverted_body_text(surface(), bodies_, static_cast<int>(b));
  }
  return {};
}

// The part of a corner's square below the planes, which cross the hull of its control points.
ShellMoments HullBody::wet_corner(int corner, Planes planes) const {
  const surface::CornerBasis& basis = surface().layout().basis(corner);
  const surface::CornerPoints& kept = surface().corner(corner);
  const BodyRules& rules = parts_.rules();
  const double smallest = kSmallestCorner * surface().mesh().size();
  ShellMoments sum;
  for (surface::CornerRing ring(basis, kept);; ring.advance()) {
    const std::vector<Vector3d>& points = ring.points();
    bool is_below = true;
    for (const Plane& plane : planes) {
      double lowest = plane.height(points[0]), highest = lowest;
      for (const Vector3d& p : points) {
        lowest = std::min(lowest, plane.height(p));
        highest = std::max(highest, plane.height(p));
      }
      // The hull of a ring's points holds all that is left, down to the corner.
      if (lowest > -rules.cut.zero) return sum;
      is_below = is_below && highest < -rules.cut.zero;
    }
    if (is_below) {
      // From here inwards nothing is cut: the series sums the rings that are left.
      sum += corner_moments(ring, basis, kept, parts_.series(corner), rules.centre, rules.corner);
      return sum;
    }
    double farthest = 0.0;
    for (const Vector3d& p : points) farthest = std::max(farthest, (p - points[0]).squaredNorm());
    // The water goes through the corner itself: rings shrink towards it without end.
    if (farthest < smallest * smallest) return sum;
    for (int s = 0; s < basis.segment_count(); ++s) {
      sum += wedge_moments(ring.segment_points(s), rules.centre, planes, rules.cut);
    }
  }
}

template <class Cut>
void HullBody::add_wet(const std::vector<ShellPart>& parts, Planes planes, const Cut& cut,
                       ShellMoments& sum) const {
  const BodyRules& rules = parts_.rules();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    bool is_above = false, is_below = true;
    for (const Plane& plane : planes) {
      const WaterSide side = parts[i].side(plane, rules);
      is_above = is_above || side == WaterSide::kAbove;
      is_below = is_below && side == WaterSide::kBelow;
    }
    if (is_above) continue;
    if (is_below) {
      sum += parts[i].moments;
    } else {
      sum += cut(static_cast<int>(i));
    }
  }
}

HullBody::Wet HullBody::wet_part(Planes planes) const {
  const BodyRules& rules = parts_.rules();
  const auto wet_span = [&](const surface::BicubicPoints& points) {
    return wedge_moments(points, rules.centre, planes, rules.cut);
  };
  Wet wet;
  add_wet(
      parts_.leaves(), planes, [&](int i) { return wet_span(surface().leaf(i)); }, wet.shell);
  add_wet(
      parts_.corners(), planes, [&](int i) { return wet_corner(i, planes); }, wet.shell);
  add_wet(
      caps_, planes, [&](int i) { return wet_span(closings_[i].cap); }, wet.caps);
  return wet;
}

ShellMoments HullBody::shell_moments() const {
  current();
  assert(!water_);
  ShellMoments sum;
  for (const ShellPart& leaf : parts_.leaves()) sum += leaf.moments;
  for (const ShellPart& corner : parts_.corners()) sum += corner.moments;
  sum = moved(sum, parts_.rules().centre);
  if (mirrored_) sum += analysis::mirrored(sum);
  return sum;
}

HullBody HullBody::closed() const {
  HullBody twin = current();
  twin.openings_ = Openings::kClosed;
  return twin;
}

DownfloodingPoint HullBody::downflooding_point(const Vector3d& up) const {
  current();
  DownfloodingPoint lowest{std::numeric_limits<double>::infinity(), Vector3d::Zero()};
  if (openings_ == Openings::kClosed) return lowest;
  for (const Vector3d& mirror : {Vector3d(1.0, 1.0, 1.0), Vector3d(1.0, -1.0, 1.0)}) {
    if (mirror.y() < 0.0 && !mirrored_) break;
    for (const ClosingPatch& patch : closings_) {
      if (!patch.open) continue;
      // Along `up` the image of a curve is what the curve is along the image of `up`.
      const DownfloodingPoint point = lowest_point(patch.border, up.cwiseProduct(mirror));
      if (point.height < lowest.height) {
        lowest = {point.height, point.point.cwiseProduct(mirror)};
      }
    }
  }
  return lowest;
}

void HullBody::refuse_flooding(const Plane& water) const {
  const DownfloodingPoint lowest = downflooding_point(water.normal);
  if (lowest.height >= water.offset - kAtEdge * surface().mesh().size()) return;
  std::ostringstream words;
  words
      << std::fixed << std::setprecision(3) << "The hull floods at (" << lowest.point.x() << ", "
      << lowest.point.y() << ", " << lowest.point.z() << ") m, which is "
      << water.offset - lowest.height
      << " m under water. Lower the draft, close the shell there, or declare its openings closed.";
  throw std::invalid_argument(words.str());
}

void HullBody::check_immersed(const Plane& water) const {
  current();
  assert(!water_ || (water.normal == water_->normal && water.offset == water_->offset));
  if (!water.normal.allFinite() || !std::isfinite(water.offset)) {
    throw std::invalid_argument("The water's surface must be given by finite numbers.");
  }
  const std::string missing = mirrored_ ? missing_port_side(surface(), true) : "";
  if (!missing.empty()) throw std::invalid_argument(missing);
  if (!inversion_.empty()) throw std::invalid_argument(inversion_);
  refuse_flooding(water);
}

// By the flux of (0, y, 0), of which nothing goes through the water's surface or the station.
double HullBody::volume_abaft(const Plane& water, double x) const {
  check_immersed(water);
  if (water.normal.y() != 0.0) {
    throw std::invalid_argument("The body is divided by a station upright: set the heel to zero.");
  }
  if (!std::isfinite(x)) throw std::invalid_argument("The station's x must be a finite number.");
  if (joined_) {
    throw std::invalid_argument(
        "A body to which others are joined is not divided by a station: ask one of the hull "
        "alone.");
  }
  const std::array<Plane, 2> planes{water, Plane{Vector3d::UnitX(), x}};
  const Wet wet = wet_part(planes);
  return (mirrored_ ? 2.0 : 1.0) * (wet.shell.first(1, 1) + wet.caps.first(1, 1));
}

Immersion HullBody::immersion(const Plane& water) const {
  check_immersed(water);
  const Vector3d& centre = parts_.rules().centre;
  Wet wet = wet_part({&water, 1});
  if (mirrored_) {
    const Plane image = mirror_image(water);
    // What the water covers of the other side is the image of what its own image covers of this.
    // Upright that image is the water itself.
    const Wet other = water.normal.y() == 0.0 ? wet : wet_part({&image, 1});
    wet.shell += analysis::mirrored(other.shell);
    wet.caps += analysis::mirrored(other.caps);
  }
  if (joined_) wet.shell += joined_->change(water);
  ShellMoments all = wet.shell;
  all += without_area(wet.caps);
  // About a point in the water's surface, where heights do not cancel, or, where the water is far
  // off, in a plane that is just as far beyond the body.
  const double size = surface().mesh().size();
  const double level = std::clamp(-water.height(centre), -size, size);
  const Vector3d origin = centre + level * water.normal;
  Immersion result = immersion_of(moved(all, centre - origin), {water.normal, 0.0});
  result.water = water;
  // Not measured: no number rather than zero.
  if (water_) result.wetted_surface = std::numeric_limits<double>::quiet_NaN();
  if (result.volume > 0.0) result.centre_of_buoyancy += origin;
  if (result.waterplane_area > 0.0) result.centre_of_flotation += origin;
  result.flux_forms = moved(wet.shell, centre).first.diagonal();
  return result;
}

}  // namespace hull::analysis
