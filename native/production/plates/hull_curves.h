// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "production/plates/cylinder_curves.h"
#include "production/plates/surface_curve.h"
#include "surface/surface_stamp.h"

namespace hull::production {

// Makes curves on a surface: seams, butts, marks. Once the surface's points were set, whatever is
// asked throws std::invalid_argument.
class HullCurves {
 public:
  // `chord_tolerance`: points of curves are so near to one another that no chord is further than
  // this from the curve, m. Throws std::invalid_argument unless it is positive. `surface` must
  // outlive this.
  HullCurves(const surface::LimitSurface& surface, double chord_tolerance);

  const surface::LimitSurface& surface() const {
    stamp_.require_current("The HullCurves object", "Make it anew.");
    return stamp_.surface();
  }

  // In a plane, branch by branch. Throws std::invalid_argument for a plane that misses the surface,
  // and as analysis::section().
  std::vector<SurfaceCurve> in_plane(const analysis::Plane& plane, const std::string& name) const;

  // Where a cylinder cuts the surface, a bow thruster's tunnel or a stern tube: branch by branch as
  // cylinder_curves(), points on the cylinder to rounding. The direction need not be of unit
  // length. Throws std::invalid_argument for a cylinder that misses the surface, for one that
  // touches it, for a radius that is not positive, and a direction without length.
  std::vector<SurfaceCurve> on_cylinder(const Cylinder& cylinder, const std::string& name) const;

  // At a girth from a curve: `girth` metres along the surface, from each point of the base in the
  // plane through it across the direction `across`, towards the side of `towards`. One curve for
  // each part of the base from which the surface reaches so far, to what does not lie in such a
  // plane, as a transom; the ends are on its border, or the latter's.
  //
  // Throws std::invalid_argument where no part does, for a girth that is not positive, for a base
  // that runs in such a plane, and as require_on() of the base.
  std::vector<SurfaceCurve> at_girth(const SurfaceCurve& base, double girth,
                                     const Vector3d& towards, const Vector3d& across,
                                     const std::string& name) const;

  // A polyline projected onto the surface along a direction, or from a centre: the first point that
  // each ray meets, from the polyline's point on, or from the centre. Throws std::invalid_argument
  // where no point meets it.
  std::vector<SurfaceCurve> projected(const std::vector<Vector3d>& points,
                                      const Vector3d& direction, const std::string& name) const;
  std::vector<SurfaceCurve> projected_from(const std::vector<Vector3d>& points,
                                           const Vector3d& centre, const std::string& name) const;

  // The surface's borders, from corner to corner.
  std::vector<SurfaceCurve> borders() const;

  // Knuckles whose angle exceeds `least_angle` (rad) anywhere, from corner to corner. Throws
  // std::invalid_argument for one that is negative or not finite.
  std::vector<SurfaceCurve> knuckles(double least_angle) const;

 private:
  using Place = std::optional<CellPlace>;
  using Rule = std::function<Place(double)>;
  std::vector<SurfaceCurve> sampled(const Rule& rule, const std::vector<double>& parameters,
                                    const std::string& name) const;
  std::vector<SurfaceCurve> along_rays(const std::vector<Vector3d>& points, const std::string& name,
                                       const std::function<Vector3d(const Vector3d&)>& origin,
                                       const std::function<Vector3d(const Vector3d&)>& way) const;

  std::vector<SurfaceCurve> followed(const std::vector<analysis::SectionCurve>& sections,
                                     const std::string& name) const;
  SurfaceCurve along(const surface::CreaseCurve& crease, const std::string& name) const;

  surface::SurfaceStamp stamp_;
  double chord_tolerance_;
  surface::SurfaceTree tree_;
};

}  // namespace hull::production
