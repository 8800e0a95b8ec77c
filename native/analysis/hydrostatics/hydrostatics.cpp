// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/hydrostatics/hydrostatics.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "analysis/hydrostatics/extents.h"
#include "analysis/hydrostatics/hydrostatics_check.h"
#include "analysis/stations/largest_section.h"
#include "analysis/stations/lateral_profile.h"
#include "analysis/stations/station_cutter.h"
#include "surface/parallel_for.h"

namespace hull::analysis {
namespace {

using Part = ExtentSearch::Part;

constexpr double kChordAbaft = 0.05;  // of Lwl

const Vector3d kMirror(1.0, -1.0, 1.0);

// Extremes of both sides: those of the port half and of its mirror image, where half is modelled.
class BothSides {
 public:
  BothSides(const StationCutter& cutter, const Plane& water)
      : mirrored_(cutter.body().mirrored()),
        port_(cutter.body().surface(), cutter.body().boxes(), water),
        upright_(water.normal.y() == 0.0) {
    if (!mirrored_ || upright_) return;
    const Plane image{water.normal.cwiseProduct(kMirror), water.offset};
    starboard_.emplace(cutter.body().surface(), cutter.body().boxes(), image);
  }

  FarthestPoint farthest(const Vector3d& direction, Part part) const {
    const FarthestPoint port = port_.farthest(direction, part);
    if (!mirrored_ || (upright_ && direction.y() == 0.0)) return port;
    // What is farthest to starboard is the image of what is farthest to port along the direction's
    // image.
    const ExtentSearch& other = upright_ ? port_ : *starboard_;
    FarthestPoint starboard = other.farthest(direction.cwiseProduct(kMirror), part);
    if (!(starboard.value > port.value)) return port;
    starboard.point = starboard.point.cwiseProduct(kMirror);
    return starboard;
  }

  // Extent of a part along a direction.
  double extent(const Vector3d& direction, Part part) const {
    // Upright athwartships both halves reach equally far: one search instead of two.
    if (mirrored_ && upright_ && direction.x() == 0.0 && direction.z() == 0.0) {
      const FarthestPoint port = port_.farthest(Vector3d::UnitY(), part);
      return port.found ? 2.0 * port.value * std::abs(direction.y()) : 0.0;
    }
    const FarthestPoint ahead = farthest(direction, part);
    return ahead.found ? ahead.value + farthest(-direction, part).value : 0.0;
  }

 private:
  bool mirrored_;
  ExtentSearch port_;
  bool upright_;
  std::optional<ExtentSearch> starboard_;  // in the mirrored water, where that is another
};

double ratio(double above, double below) { return below > 0.0 ? above / below : 0.0; }

FormCoefficients coefficients(const Hydrostatics& p, double length, double beam, double draft,
                              double section_area) {
  FormCoefficients c;
  c.block = ratio(p.displaced_volume, length * beam * draft);
  c.prismatic = ratio(p.displaced_volume, section_area * length);
  c.midship = ratio(section_area, beam * draft);
  c.waterplane = ratio(p.waterplane_area, length * beam);
  c.vertical_prismatic = ratio(p.displaced_volume, p.waterplane_area * draft);
  return c;
}

void take_buoyancy(const Immersion& immersion, double water_density, Hydrostatics& p) {
  p.displaced_volume = immersion.volume;
  p.displacement_t = immersion.volume * water_density;
  p.volume_error = immersion.volume_error;
  // The same volume by another flux: equal for a closed body only, which makes it a check.
  p.volume_from_breadths = immersion.flux_forms.y();
  p.wetted_surface = immersion.wetted_surface;
  p.wetted_surface_error = immersion.wetted_surface_error;
  if (immersion.volume > 0.0) {
    p.lcb = immersion.centre_of_buoyancy.x();
    p.tcb = immersion.centre_of_buoyancy.y();
    p.kb = immersion.centre_of_buoyancy.z();
  }
}

void take_waterplane(const Immersion& immersion, const FloatingPosition& position,
                     double water_density, Hydrostatics& p) {
  p.waterplane_area = immersion.waterplane_area;
  p.tpc = immersion.waterplane_area * water_density / 100.0;
  if (!(immersion.waterplane_area > 0.0)) return;
  p.lcf = immersion.centre_of_flotation.x();
  p.tcf = immersion.centre_of_flotation.y();
  const Vector3d ahead = forward_direction(position.trim, position.heel);
  const Vector3d port = -starboard_direction(position.trim, position.heel);
  const Eigen::Matrix3d& second = immersion.waterplane_second;
  // Second moments about F: the part along a horizontal axis is that about the axis square to it.
  p.waterplane_inertia_transverse = port.dot(second * port);
  p.waterplane_inertia_longitudinal = ahead.dot(second * ahead);
  p.waterplane_inertia_product = ahead.dot(second * port);
  if (!(immersion.volume > 0.0)) return;
  p.bm_transverse = p.waterplane_inertia_transverse / immersion.volume;
  p.bm_longitudinal = p.waterplane_inertia_longitudinal / immersion.volume;
  // BM is along the water's normal, KB and KM along the ship's own vertical.
  p.km_transverse = p.kb + p.bm_transverse * immersion.water.normal.z();
  p.km_longitudinal = p.kb + p.bm_longitudinal * immersion.water.normal.z();
}

// Between the waterline's tangent at its forward end and the way ahead.
double entrance_angle(const surface::LimitSurface& surface, const FarthestPoint& end,
                      const Vector3d& up, const Vector3d& ahead) {
  const Vector3d normal = surface.normal(end.cell, end.uv.x(), end.uv.y());
  const Vector3d across = up.cross(ahead);
  // The tangent is square to the normal's level part.
  return std::atan2(std::abs(normal.dot(ahead)), std::abs(normal.dot(across)));
}

void take_extents(const StationCutter& cutter, const Plane& water, Hydrostatics& p) {
  const BothSides sides(cutter, water);
  const Vector3d ahead = forward_direction(p.position.trim, p.position.heel);
  const Vector3d starboard = starboard_direction(p.position.trim, p.position.heel);
  const FarthestPoint lowest = sides.farthest(-water.normal, Part::kImmersed);
  if (!lowest.found) return;
  // Its depth below the surface, as the value is along the downward normal.
  p.immersed_draft = lowest.value + water.offset;
  p.immersed_length = sides.extent(ahead, Part::kImmersed);
  p.immersed_beam = sides.extent(starboard, Part::kImmersed);

  const FarthestPoint bow = sides.farthest(ahead, Part::kWaterline);
  if (!bow.found) return;
  const FarthestPoint stern = sides.farthest(-ahead, Part::kWaterline);
  p.waterline_length = bow.value + stern.value;
  p.waterline_beam = sides.extent(starboard, Part::kWaterline);
  p.waterline_aft = stern.point.x();
  p.waterline_forward = bow.point.x();
  if (p.position.heel != 0.0) return;  // each side has an angle of its own
  p.half_angle_of_entrance = entrance_angle(cutter.body().surface(), bow, water.normal, ahead);
  const double setback = kChordAbaft * p.waterline_length;
  const SectionArea abaft = immersed_station(cutter, p.waterline_forward - setback, water);
  // Half the breadth, which is that of both sides.
  p.entrance_chord_angle = std::atan2(0.5 * abaft.breadth, setback);
}

void take_profile(const StationCutter& cutter, const Plane& water, Hydrostatics& p) {
  const LateralProfile profile = lateral_profile(cutter, water);
  p.lateral_area = profile.below.area;
  p.lateral_x = profile.below.centre.x();
  p.lateral_z = profile.below.centre.z();
  p.wind_area = profile.above.area;
  p.wind_x = profile.above.centre.x();
  p.wind_z = profile.above.centre.z();
}

// Extents, stations and profile. None of them reads what another one writes.
void take_geometry(const StationCutter& cutter, const Plane& water, double length,
                   KeptStations* kept, Hydrostatics& p) {
  // The one station at midship goes with the profile.
  const std::array<std::function<void()>, 3> parts{
      [&] { p.largest_section = largest_section(cutter, water, kept); },
      [&] { take_extents(cutter, water, p); },
      [&] {
        if (length > 0.0) p.midship_section = immersed_station(cutter, 0.5 * length, water);
        take_profile(cutter, water, p);
      }};
  surface::parallel_for(
      parts.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) parts[i]();
      },
      1);
}

}  // namespace

void check_hydrostatics(const FloatingPosition& position, const ProjectDimensions& project,
                        double water_density) {
  const auto finite = [](double value, const char* name) {
    if (!std::isfinite(value)) {
      throw std::invalid_argument(std::string("The ") + name + " must be a finite number.");
    }
  };
  finite(position.draft, "draft");
  finite(position.trim, "trim");
  finite(position.heel, "heel");
  finite(position.draft_at, "place where the draft is measured");
  if (!(std::abs(position.trim) < 0.5 * std::numbers::pi)) {
    throw std::invalid_argument("The trim must be less than 90 degrees (pi / 2 rad), not " +
                                std::to_string(position.trim) + " rad.");
  }
  for (double length : {project.length_pp, project.beam, project.draft}) {
    // Zero is "not given".
    if (!(length >= 0.0) || !std::isfinite(length)) {
      throw std::invalid_argument("Length, beam and design draft must be positive, not " +
                                  std::to_string(length) + " m; leave out what is not known.");
    }
  }
  if (!(water_density > 0.0) || !std::isfinite(water_density)) {
    throw std::invalid_argument("The water's density must be positive, not " +
                                std::to_string(water_density) + " t/m3.");
  }
}

Hydrostatics hydrostatics(const HullBody& body, const FloatingPosition& position,
                          const ProjectDimensions& project, double water_density,
                          KeptStations* kept) {
  check_hydrostatics(position, project, water_density);
  if (kept && &kept->body() != &body) {
    throw std::invalid_argument("The stations that are kept are those of another body.");
  }
  Hydrostatics p;
  p.position = position;
  p.draft = position.draft;
  const Plane water = water_plane(position);
  const Immersion immersion = body.immersion(water);
  take_buoyancy(immersion, water_density, p);
  // Nothing is under water: what is undefined stays zero.
  if (immersion.wetted_surface == 0.0) return p;
  take_waterplane(immersion, position, water_density, p);

  const StationCutter cutter(body);
  const double length = project.length_pp;
  take_geometry(cutter, water, length, kept, p);
  if (length > 0.0) {
    if (p.displaced_volume > 0.0) p.lcb_percent = 100.0 * (p.lcb / length - 0.5);
    if (p.waterplane_area > 0.0) p.lcf_percent = 100.0 * (p.lcf / length - 0.5);
    // BMl for GMl, as hydrostatic tables have it: the load is not known here.
    p.mtc = p.displacement_t * p.bm_longitudinal / (100.0 * length);
  }
  const double draft = project.draft > 0.0 ? project.draft : position.draft;
  p.project = coefficients(p, length, project.beam, draft, p.midship_section.area);
  p.immersed =
      coefficients(p, p.immersed_length, p.immersed_beam, p.immersed_draft, p.largest_section.area);
  return p;
}

std::vector<Hydrostatics> hydrostatic_table(const HullBody& body, const std::vector<double>& drafts,
                                            const std::vector<double>& trims,
                                            const ProjectDimensions& project,
                                            double water_density) {
  std::vector<Hydrostatics> rows;
  for (double trim : trims) {
    for (double draft : drafts) {
      rows.push_back(
          hydrostatics(body, {draft, trim, 0.0, 0.5 * project.length_pp}, project, water_density));
    }
  }
  return rows;
}

Hydrostatics upright_hydrostatics(const surface::LimitSurface& surface, double draft,
                                  bool mirrored) {
  return hydrostatics(HullBody(surface, mirrored), {draft, 0.0, 0.0, 0.0}, {});
}

}  // namespace hull::analysis
