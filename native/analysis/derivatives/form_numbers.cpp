// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/derivatives/form_numbers.h"

#include <cmath>
#include <stdexcept>

#include "analysis/hydrostatics/hydrostatics_check.h"
#include "analysis/stations/largest_section.h"
#include "analysis/stations/station_cutter.h"

namespace hull::analysis {
FormNumbers::FormNumbers(const BodyDerivatives& derivatives, const FloatingPosition& position,
                         const ProjectDimensions& project, double water_density)
    : derivatives_(&derivatives),
      stamp_(derivatives.body()),
      position_(position),
      project_(project),
      density_(water_density),
      water_(water_plane(position)) {
  check_hydrostatics(position, project, water_density);
  if (position.heel != 0.0) {
    throw std::invalid_argument("Derivatives of a hull's numbers are had without heel only.");
  }
}

const Immersion& FormNumbers::immersion() {
  if (!immersion_) immersion_ = derivatives_->body().immersion(water_);
  return *immersion_;
}

const SectionArea& FormNumbers::largest() {
  if (!largest_) largest_ = largest_section(StationCutter(derivatives_->body()), water_);
  return *largest_;
}

double FormNumbers::section_area(double position) {
  require_current();
  return section_areas(derivatives_->body(), {position}, water_).front().area;
}

// Level along the ship (0), or across it (1). Athwartships both sides of a half hull reach equally
// far.
const FormNumbers::Extent& FormNumbers::extent(int axis, Part part) {
  std::optional<Extent>& known = extents_[axis][static_cast<int>(part)];
  if (known) return *known;
  const HullBody& body = derivatives_->body();
  // One search for all extents: which cells reach into the water is found once.
  if (!search_) search_.emplace(body.surface(), body.boxes(), water_);
  Extent extent;
  const Vector3d direction = axis == 0 ? forward_direction(position_.trim, 0.0) : Vector3d::UnitY();
  extent.high = search_->farthest(direction, part);
  if (extent.high.found) {
    if (axis == 1 && body.mirrored()) {
      extent.value = 2.0 * extent.high.value;
    } else {
      extent.low = search_->farthest(-direction, part);
      extent.value = extent.high.value + extent.low.value;
    }
  }
  known = extent;
  return *known;
}

double FormNumbers::immersed_draft() {
  std::optional<Extent>& known = extents_[2][0];
  if (!known) {
    const HullBody& body = derivatives_->body();
    if (!search_) search_.emplace(body.surface(), body.boxes(), water_);
    Extent extent;
    extent.low = search_->farthest(-water_.normal, Part::kImmersed);
    // How far the lowest point lies along -normal is less its height over the origin.
    if (extent.low.found) extent.value = extent.low.value + water_.offset;
    known = extent;
  }
  return known->value;
}

double FormNumbers::inertia(const Vector3d& direction) {
  // About the axis that is across the direction: along y it is the transverse one.
  return direction.dot(immersion().waterplane_second * direction);
}

FormNumbers::Product FormNumbers::coefficient(FormNumber number) {
  using N = FormNumber;
  // The immersed coefficients are the last of all.
  const bool immersed = number >= N::kImmersedBlock;
  const double draft = project_.draft > 0.0 ? project_.draft : position_.draft;
  Product product;
  // A project's dimension is a factor; one that is measured is a term with a derivative of its own.
  const auto divide = [&](double fixed, FormNumber free) {
    if (immersed) {
      product.terms.emplace_back(free, -1);
    } else {
      product.factor *= fixed > 0.0 ? 1.0 / fixed : 0.0;
    }
  };
  const auto by_length = [&] { divide(project_.length_pp, N::kImmersedLength); };
  const auto by_beam = [&] { divide(project_.beam, N::kImmersedBeam); };
  const auto by_draft = [&] { divide(draft, N::kImmersedDraft); };
  const N section = immersed ? N::kLargestSectionArea : N::kMidshipSectionArea;
  switch (number) {
    case N::kProjectBlock:
    case N::kImmersedBlock:
      product.terms.emplace_back(N::kDisplacedVolume, 1);
      by_length(), by_beam(), by_draft();
      break;
    case N::kProjectPrismatic:
    case N::kImmersedPrismatic:
      product.terms = {{N::kDisplacedVolume, 1}, {section, -1}};
      by_length();
      break;
    case N::kProjectMidship:
    case N::kImmersedMidship:
      product.terms.emplace_back(section, 1);
      by_beam(), by_draft();
      break;
    case N::kProjectWaterplane:
    case N::kImmersedWaterplane:
      product.terms.emplace_back(N::kWaterplaneArea, 1);
      by_length(), by_beam();
      break;
    default:
      product.terms = {{N::kDisplacedVolume, 1}, {N::kWaterplaneArea, -1}};
      by_draft();
  }
  return product;
}

double FormNumbers::value(FormNumber number) {
  using N = FormNumber;
  require_current();
  const Immersion& now = immersion();
  const bool afloat = now.volume > 0.0, has_plane = now.waterplane_area > 0.0;
  const Vector3d ahead = forward_direction(position_.trim, 0.0);
  const double length = project_.length_pp;
  const auto percent = [&](double x) { return 100.0 * (x / length - 0.5); };
  switch (number) {
    case N::kDisplacedVolume:
      return now.volume;
    case N::kDisplacement:
      return now.volume * density_;
    case N::kLcb:
      return now.centre_of_buoyancy.x();
    case N::kLcbPercent:
      return length > 0.0 && afloat ? percent(now.centre_of_buoyancy.x()) : 0.0;
    case N::kTcb:
      return now.centre_of_buoyancy.y();
    case N::kKb:
      return now.centre_of_buoyancy.z();
    case N::kWettedSurface:
      return now.wetted_surface;
    case N::kWaterplaneArea:
      return now.waterplane_area;
    case N::kLcf:
      return now.centre_of_flotation.x();
    case N::kLcfPercent:
      return length > 0.0 && has_plane ? percent(now.centre_of_flotation.x()) : 0.0;
    case N::kTcf:
      return now.centre_of_flotation.y();
    case N::kWaterplaneInertiaTransverse:
      return has_plane ? inertia(Vector3d::UnitY()) : 0.0;
    case N::kWaterplaneInertiaLongitudinal:
      return has_plane ? inertia(ahead) : 0.0;
    case N::kBmTransverse:
      return afloat && has_plane ? inertia(Vector3d::UnitY()) / now.volume : 0.0;
    case N::kBmLongitudinal:
      return afloat && has_plane ? inertia(ahead) / now.volume : 0.0;
    case N::kKmTransverse:
    case N::kKmLongitudinal: {
      if (!afloat || !has_plane) return 0.0;
      const N bm = number == N::kKmTransverse ? N::kBmTransverse : N::kBmLongitudinal;
      // The radius is square to the water, KM is told along the ship's own z.
      return value(N::kKb) + value(bm) * water_.normal.z();
    }
    case N::kWaterlineLength:
      return extent(0, Part::kWaterline).value;
    case N::kWaterlineBeam:
      return extent(1, Part::kWaterline).value;
    case N::kImmersedLength:
      return extent(0, Part::kImmersed).value;
    case N::kImmersedBeam:
      return extent(1, Part::kImmersed).value;
    case N::kImmersedDraft:
      return immersed_draft();
    case N::kMidshipSectionArea:
      return length > 0.0 ? section_area(0.5 * length) : 0.0;
    case N::kLargestSectionArea:
      return largest().area;
    default:
      break;
  }
  const Product product = coefficient(number);
  double result = product.factor;
  for (const auto& [term, power] : product.terms) {
    const double of_term = value(term);
    if (power < 0 && !(of_term > 0.0)) return 0.0;  // what is undefined is 0
    result *= power < 0 ? 1.0 / of_term : of_term;
  }
  return result;
}

}  // namespace hull::analysis
