// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/solids/face_integrals.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <optional>

#include "analysis/arithmetic/gauss.h"
#include "exchange/occt_geometry.h"
#include "exchange/solids/trimmed_face.h"

namespace hull::exchange {
namespace {

constexpr double kFaceTolerance = 1e-8;
// Eight nodes integrate polynomials up to degree 15 exactly; (p - origin) x dp of a spline of
// degree d has 2 d - 1.
constexpr int kNodes = 8, kParts = 8;

bool covers_whole_surface(const TopoDS_Face& face, const Geom_Surface& surface) {
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
  surface.Bounds(u0, u1, v0, v1);
  const double near_u = 1e-6 * (u1 - u0), near_v = 1e-6 * (v1 - v0);
  const auto is_on_border = [&](const gp_Pnt2d& p) {
    return std::abs(p.X() - u0) <= near_u || std::abs(p.X() - u1) <= near_u ||
           std::abs(p.Y() - v0) <= near_v || std::abs(p.Y() - v1) <= near_v;
  };
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    double begin = 0.0, end = 0.0;
    const Handle(Geom2d_Curve) line =
        BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Current()), face, begin, end);
    if (line.IsNull()) return false;
    // The ends alone would not tell a border's line from one across the surface, from border to
    // border.
    for (double share : {0.0, 0.37, 1.0}) {
      if (!is_on_border(line->Value(begin + share * (end - begin)))) return false;
    }
  }
  return true;
}

std::optional<conversion::SurfaceIntegrals> of_whole_patch(const TopoDS_Face& face) {
  TopLoc_Location location;
  const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(face, location));
  // What a BSplinePatch can't hold.
  if (surface.IsNull() || !location.IsIdentity() || surface->IsURational() ||
      surface->IsVRational() || surface->IsUPeriodic() || surface->IsVPeriodic() ||
      !covers_whole_surface(face, *surface)) {
    return std::nullopt;
  }
  return integrals_of(patch_of(*surface));
}

// Half the sum of ∫ (p - origin) x dp along an edge, by Gauss' rule in every span: exact for
// splines up to degree eight, and where curves are none to rounding for parts of a circle.
Vector3d area_along(const TopoDS_Edge& edge, const Vector3d& origin) {
  static const analysis::GaussRule rule = analysis::gauss_rule(kNodes);
  const BRepAdaptor_Curve curve(edge);
  // Within these the curve is smooth without end, as Gauss' rule needs it.
  const int count = curve.NbIntervals(GeomAbs_CN);
  TColStd_Array1OfReal knots(1, count + 1);
  curve.Intervals(knots, GeomAbs_CN);
  // What is no polynomial, as an arc, is made short enough for the rule.
  const int parts = curve.GetType() == GeomAbs_BSplineCurve ? 1 : kParts;
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < count * parts; ++i) {
    const double span = knots(i / parts + 2) - knots(i / parts + 1), width = span / parts;
    const double begin = knots(i / parts + 1) + width * (i % parts);
    for (int k = 0; k < kNodes; ++k) {
      gp_Pnt point;
      gp_Vec slope;
      curve.D1(begin + width * rule.nodes[k], point, slope);
      const Vector3d away = in_metres(point) - origin;
      sum += 0.5 * width * rule.weights[k] * away.cross(in_metres(gp_Pnt(slope.XYZ())));
    }
  }
  return edge.Orientation() == TopAbs_REVERSED ? Vector3d(-sum) : sum;
}

// As oriented FORWARD.
std::optional<conversion::SurfaceIntegrals> of_plane(const TopoDS_Face& face) {
  const auto plane = Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(face));
  if (plane.IsNull()) return std::nullopt;
  const Vector3d origin = in_metres(plane->Location());
  const gp_Ax3 axes = plane->Position();
  // Not the axis itself, which of a left-handed plane points the other way.
  const gp_Vec up = gp_Vec(axes.XDirection()).Crossed(gp_Vec(axes.YDirection()));
  const Vector3d normal(up.X(), up.Y(), up.Z());
  double area = 0.0;
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    area += area_along(TopoDS::Edge(edge.Current()), origin).dot(normal);
  }
  // The divergence theorem, with p / 3 as the field: over a plane p times its normal is the same
  // everywhere.
  return conversion::SurfaceIntegrals{area, area * origin.dot(normal) / 3.0};
}

conversion::SurfaceIntegrals by_open_cascade(const TopoDS_Face& face) {
  GProp_GProps area, volume;
  BRepGProp::SurfaceProperties(face, area, kFaceTolerance);
  BRepGProp::VolumeProperties(face, volume, kFaceTolerance);
  return {area.Mass() / std::pow(kMillimetresPerMetre, 2),
          volume.Mass() / std::pow(kMillimetresPerMetre, 3)};
}

}  // namespace

conversion::SurfaceIntegrals integrals_of_face(const TopoDS_Face& face) {
  const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
  // From the most exact to what always answers.
  std::optional<conversion::SurfaceIntegrals> found = of_whole_patch(forward);
  if (!found) found = of_plane(forward);
  if (!found) found = of_trimmed_face(forward);
  if (!found) found = by_open_cascade(forward);
  // An area has no side, a volume has.
  if (face.Orientation() == TopAbs_REVERSED) found->volume = -found->volume;
  return *found;
}

conversion::SurfaceIntegrals integrals_of(const TopoDS_Shape& shape) {
  conversion::SurfaceIntegrals sum;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    sum += integrals_of_face(TopoDS::Face(face.Current()));
  }
  return sum;
}

}  // namespace hull::exchange
