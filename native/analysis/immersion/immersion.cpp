// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/immersion.h"

namespace hull::analysis {

Immersion immersion_of(const ShellMoments& wet, const Plane& water) {
  const Vector3d& e = water.normal;
  const double d = water.offset;
  // Divergence theorem: a field that vanishes in the water's surface has its whole flux through the
  // wet shell. With div(h e) = 1 that of h e is the volume; those of p h e and h² e are the
  // integrals of p + h e and of 2 h.
  const double area = wet.normal.dot(e);                          // ∫ e·n
  const Vector3d first = wet.first * e;                           // ∫ p e·n
  const Eigen::Matrix3d second = wet.second_along(e);             // ∫ p pᵀ e·n
  const double height = e.dot(first) - d * area;                  // ∫ h e·n
  const Vector3d height_first = second * e - d * first;           // ∫ p h e·n
  const double height_square = e.dot(height_first) - d * height;  // ∫ h² e·n

  Immersion result;
  result.water = water;
  result.volume = height;
  if (height > 0.0) {
    result.centre_of_buoyancy = (height_first - 0.5 * height_square * e) / height;
  }
  result.wetted_surface = wet.area;
  result.waterplane_area = -area;
  // A field f(q) e does not change along e, and has no flux through a closed surface: the
  // waterplane's integral of f is that of the wet shell, negative.
  if (area < 0.0) {
    // Of the waterplane's points q = p - h e.
    const Vector3d moment = e * height - first;
    const Eigen::Matrix3d about_origin = height_first * e.transpose() +
                                         e * height_first.transpose() - second -
                                         e * e.transpose() * height_square;
    result.centre_of_flotation = moment / -area;
    result.waterplane_second = about_origin - moment * result.centre_of_flotation.transpose();
  }
  result.volume_error = wet.volume_error;
  result.wetted_surface_error = wet.area_error;
  return result;
}

}  // namespace hull::analysis
