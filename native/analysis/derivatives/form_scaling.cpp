// SPDX-License-Identifier: GPL-3.0-or-later
#include <cassert>

#include "analysis/derivatives/form_numbers.h"

namespace hull::analysis {

// ∑ ∂q/∂P (P - from), axis by axis: what scaling the hull from there does.
Vector3d FormNumbers::arm_products(const Gradient& gradient, const Vector3d& from) const {
  const std::vector<Vector3d>& points = derivatives_->body().surface().mesh().points();
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += gradient.row(static_cast<Eigen::Index>(i)).transpose().cwiseProduct(points[i] - from);
  }
  return sum;
}

// False where a number is zero because there is none, at any scale.
bool FormNumbers::is_defined(FormNumber number) {
  using N = FormNumber;
  if (!(immersion().volume > 0.0)) return false;
  const bool by_waterplane =
      number == N::kKmTransverse || number == N::kKmLongitudinal || number == N::kLcfPercent;
  return !by_waterplane || immersion().waterplane_area > 0.0;
}

// With the hull scaled from the water's surface, the water may stay. What is then different is that
// heights are counted from the base line, which is at z = 0 before and after.
Vector3d FormNumbers::scaling(FormNumber number, const Gradient& gradient) {
  using N = FormNumber;
  require_current();
  assert(position_.trim == 0.0);
  const Vector3d waters(0.0, 0.0, position_.draft);
  if (!is_defined(number)) return Vector3d::Zero();
  if (number >= N::kProjectBlock) {
    Vector3d sum = Vector3d::Zero();
    const double whole = value(number);
    if (whole == 0.0) return sum;
    for (const auto& [term, power] : coefficient(number).terms) {
      // d log(∏ term^power) = ∑ power · d log term.
      sum += power * whole / value(term) * scaling(term, this->gradient(term));
    }
    if (number >= N::kImmersedBlock) return sum;
    // Dimensions that a coefficient is divided by are scaled, too.
    const bool by_length = number == N::kProjectBlock || number == N::kProjectPrismatic ||
                           number == N::kProjectWaterplane;
    const bool by_beam = number == N::kProjectBlock || number == N::kProjectMidship ||
                         number == N::kProjectWaterplane;
    const bool by_draft = number == N::kProjectBlock || number == N::kProjectMidship ||
                          number == N::kProjectVerticalPrismatic;
    return sum - whole * Vector3d(by_length, by_beam, by_draft);
  }
  switch (number) {
    case N::kMidshipSectionArea:
      return section_area_scaling(0.5 * project_.length_pp, gradient);
    case N::kLargestSectionArea:
      return largest().area > 0.0 ? section_area_scaling(largest().position, gradient)
                                  : Vector3d::Zero();
    case N::kKb:
    case N::kKmTransverse:
    case N::kKmLongitudinal:
      return arm_products(gradient, waters) + position_.draft * Vector3d::UnitZ();
    case N::kLcbPercent:
    case N::kLcfPercent: {
      // Of a length that is scaled itself.
      if (!(project_.length_pp > 0.0)) return Vector3d::Zero();
      const double percent = value(number) + 50.0;
      return arm_products(gradient, waters) - percent * Vector3d::UnitX();
    }
    default:
      return arm_products(gradient, waters);
  }
}

Vector3d FormNumbers::section_area_scaling(double position, const Gradient& gradient) const {
  require_current();
  return arm_products(gradient, {position, 0.0, position_.draft});
}

}  // namespace hull::analysis
