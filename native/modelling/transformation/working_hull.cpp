// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/working_hull.h"

#include <stdexcept>

#include "analysis/hydrostatics/extents.h"
#include "mesh/tolerances.h"

namespace hull::modelling {
namespace {

analysis::Plane checked_water(const analysis::FloatingPosition& position) {
  if (position.heel != 0.0) {
    throw std::invalid_argument("The hull is transformed upright: set the heel to zero.");
  }
  return analysis::water_plane(position);
}

}  // namespace

WorkingHull::WorkingHull(const analysis::HullBody& body, const analysis::FloatingPosition& position)
    : surface_(body.surface()),
      water_(checked_water(position)),
      body_(body, surface_, water_),
      points_(surface_.mesh().points()),
      moves_(points_.size(), Vector3d::Zero()),
      volume_(immersion().volume) {
  if (!(volume_ > 0.0)) {
    throw std::invalid_argument("Nothing of the hull is immersed: give a draft within it.");
  }
  const analysis::ExtentSearch extents(surface_, body_.boxes(), water_);
  using Part = analysis::ExtentSearch::Part;
  // As given: shifts are functions of where sections were.
  immersed_range_ = {-extents.farthest(-Vector3d::UnitX(), Part::kImmersed).value,
                     extents.farthest(Vector3d::UnitX(), Part::kImmersed).value};
  // Its volume is rounding, which may be more than zero, and places along it mean nothing.
  if (!(immersed_range_.second - immersed_range_.first > kInPlane * surface_.mesh().size())) {
    throw std::invalid_argument(
        "What is immersed of the hull has no length: all of it is at one x. Check the axes, or "
        "move "
        "its points apart.");
  }
}

void WorkingHull::move(const std::vector<Vector3d>& moves) {
  if (moves == moves_) return;
  moves_ = moves;
  std::vector<Vector3d> points = points_;
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += moves[i];
  surface_.set_points(std::move(points));
  body_.update();
  immersion_.reset();
}

const analysis::Immersion& WorkingHull::immersion() const {
  if (!immersion_) immersion_ = body_.immersion(water_);
  return *immersion_;
}

double WorkingHull::section_area(double x) const { return sections({x}).front().area; }

std::vector<analysis::SectionArea> WorkingHull::sections(
    const std::vector<double>& positions) const {
  return analysis::section_areas(body_, positions, water_);
}

}  // namespace hull::modelling
