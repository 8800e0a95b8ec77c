// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/derivatives/body_derivatives.h"
#include "analysis/hydrostatics/extents.h"
#include "analysis/hydrostatics/hydrostatics.h"
#include "analysis/immersion/body_stamp.h"

namespace hull::analysis {

// Numbers of Hydrostatics that have derivatives by the control points, by the names that they have
// there: what a hull's form can be asked for.
enum class FormNumber {
  kDisplacedVolume,
  kDisplacement,
  kLcb,
  kLcbPercent,
  kTcb,
  kKb,
  kWettedSurface,
  kWaterplaneArea,
  kLcf,
  kLcfPercent,
  kTcf,
  kWaterplaneInertiaTransverse,
  kWaterplaneInertiaLongitudinal,
  kBmTransverse,
  kBmLongitudinal,
  kKmTransverse,
  kKmLongitudinal,
  kWaterlineLength,
  kWaterlineBeam,
  kImmersedLength,
  kImmersedBeam,
  kImmersedDraft,
  kMidshipSectionArea,
  kLargestSectionArea,
  kProjectBlock,
  kProjectPrismatic,
  kProjectMidship,
  kProjectWaterplane,
  kProjectVerticalPrismatic,
  kImmersedBlock,
  kImmersedPrismatic,
  kImmersedMidship,
  kImmersedWaterplane,
  kImmersedVerticalPrismatic,
  kCount
};

// As in Hydrostatics, with dots: "lcb", "project.block", "midship_section.area".
const char* name_of(FormNumber number);
// Throws std::invalid_argument, naming all that there are.
FormNumber form_number_named(const std::string& name);
const std::vector<std::string>& form_number_names();

// Numbers of a body in a floating position without heel, and their derivatives by the control
// points, the water and the project's dimensions staying as they are. Only what is asked for is
// computed, and what several numbers need once. Values are those of hydrostatics(); undefined ones
// are zero, as are their derivatives.
//
// Extents have the derivatives of the point that is farthest: where the surface is as far along a
// line or a flat, as at a flat side, it is that of one of these points, and moving another one
// outwards changes them as well. Not for several threads at once.
//
// They are of the body as it is when they are made: once its surface's points were set, or it was
// updated or joined to others, all that asks for numbers throws std::invalid_argument.
class FormNumbers {
 public:
  // `derivatives` must outlive them. Throws std::invalid_argument for a heel that is not zero, a
  // body that is out of date, and as hydrostatics() does.
  FormNumbers(const BodyDerivatives& derivatives, const FloatingPosition& position,
              const ProjectDimensions& project, double water_density = kSeaWaterDensity);

  const Plane& water() const { return water_; }

  double value(FormNumber number);
  // Throws std::invalid_argument for the area of a largest section that is a transom, or another
  // place where areas jump, and for coefficients by it.
  Gradient gradient(FormNumber number);

  // By the logarithms of factors by which hull, water and project dimensions are scaled together
  // along x, y and z, from the origin: the draft grows as the depth does, and Cb stays. `gradient`:
  // gradient(number). REQUIRES: no trim.
  Vector3d scaling(FormNumber number, const Gradient& gradient);
  // The same of a station's area, whose place is scaled, too.
  Vector3d section_area_scaling(double position, const Gradient& gradient) const;

  // Of a station anywhere: SectionArea::area.
  double section_area(double position);
  Gradient section_area_gradient(double position);

 private:
  using Part = ExtentSearch::Part;
  struct Extent {
    double value = 0.0;
    FarthestPoint low, high;
  };

  void require_current() const { stamp_.require_current("The FormNumbers object"); }
  const Immersion& immersion();
  const ImmersionDerivatives& by_points();
  const SectionArea& largest();
  const Extent& extent(int axis, Part part);
  double immersed_draft();
  Gradient extent_gradient(int axis, Part part);
  Gradient farthest_gradient(const FarthestPoint& point, const Vector3d& direction, Part part);
  Gradient largest_section_gradient();
  Gradient inertia_gradient(const Vector3d& direction);
  double inertia(const Vector3d& direction);
  bool is_defined(FormNumber number);
  Gradient zero() const;
  Vector3d arm_products(const Gradient& gradient, const Vector3d& from) const;
  double length_of(int axis, bool immersed);
  // factor · ∏ value^power, of numbers that can be asked for themselves.
  struct Product {
    double factor = 1.0;
    std::vector<std::pair<FormNumber, int>> terms;
  };
  Product coefficient(FormNumber number);

  const BodyDerivatives* derivatives_;
  BodyStamp stamp_;
  FloatingPosition position_;
  ProjectDimensions project_;
  double density_;
  Plane water_;
  std::optional<Immersion> immersion_;
  std::optional<ImmersionDerivatives> by_points_;
  std::optional<SectionArea> largest_;
  std::optional<ExtentSearch> search_;
  std::optional<Extent> extents_[3][2];
};

}  // namespace hull::analysis
