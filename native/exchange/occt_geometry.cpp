// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/occt_geometry.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

namespace hull::exchange {
namespace {

// Knots as Open CASCADE wants them: each once, with how often it is repeated.
struct Knots {
  explicit Knots(const std::vector<double>& repeated) {
    for (double unit : repeated) {
      const double knot = kParameterRange * unit;
      // Repeated knots are equal bit for bit: none were computed apart.
      if (values.empty() || knot != values.back()) {
        values.push_back(knot);
        counts.push_back(0);
      }
      ++counts.back();
    }
  }
  TColStd_Array1OfReal array() const {
    // A view of the vector's memory, which these Knots have to outlive.
    return TColStd_Array1OfReal(values.front(), 1, static_cast<int>(values.size()));
  }
  TColStd_Array1OfInteger multiplicities() const {
    return TColStd_Array1OfInteger(counts.front(), 1, static_cast<int>(counts.size()));
  }
  std::vector<double> values;
  std::vector<int> counts;
};

std::vector<double> unit_knots(const TColStd_Array1OfReal& sequence) {
  const double begin = sequence.First(), length = sequence.Last() - begin;
  std::vector<double> knots;
  // Exactly 0 at the begin and 1 at the end.
  for (double knot : sequence) knots.push_back((knot - begin) / length);
  return knots;
}

}  // namespace

gp_Pnt in_millimetres(const Vector3d& point) {
  const Vector3d p = point * kMillimetresPerMetre;
  return {p.x(), p.y(), p.z()};
}

Vector3d in_metres(const gp_Pnt& point) {
  return Vector3d(point.X(), point.Y(), point.Z()) / kMillimetresPerMetre;
}

Handle(Geom_BSplineSurface) make_surface(const conversion::BSplinePatch& patch) {
  TColgp_Array2OfPnt poles(1, patch.count_u, 1, patch.count_v);
  for (int i = 0; i < patch.count_u; ++i) {
    for (int j = 0; j < patch.count_v; ++j) {
      poles(i + 1, j + 1) = in_millimetres(patch.control_point(i, j));
    }
  }
  const Knots u(patch.knots_u), v(patch.knots_v);
  return new Geom_BSplineSurface(poles, u.array(), v.array(), u.multiplicities(),
                                 v.multiplicities(), patch.degree_u, patch.degree_v);
}

Handle(Geom_BSplineCurve) make_curve(const conversion::BSplineCurve& curve) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(curve.points.size()));
  for (size_t i = 0; i < curve.points.size(); ++i) {
    poles(static_cast<int>(i) + 1) = in_millimetres(curve.points[i]);
  }
  const Knots knots(curve.knots);
  return new Geom_BSplineCurve(poles, knots.array(), knots.multiplicities(), curve.degree);
}

Handle(Geom2d_BSplineCurve) make_curve(const ParameterCurve& curve) {
  TColgp_Array1OfPnt2d poles(1, static_cast<int>(curve.points.size()));
  for (size_t i = 0; i < curve.points.size(); ++i) {
    poles(static_cast<int>(i) + 1) = curve.points[i].XY() * kParameterRange;
  }
  const Knots knots(curve.knots);
  return new Geom2d_BSplineCurve(poles, knots.array(), knots.multiplicities(), curve.degree);
}

conversion::BSplinePatch patch_of(const Geom_BSplineSurface& surface) {
  conversion::BSplinePatch patch;
  patch.degree_u = surface.UDegree();
  patch.degree_v = surface.VDegree();
  // With repetitions, as a patch has them.
  patch.knots_u = unit_knots(surface.UKnotSequence());
  patch.knots_v = unit_knots(surface.VKnotSequence());
  patch.count_u = surface.NbUPoles();
  patch.count_v = surface.NbVPoles();
  // v runs fastest, as in the patch's control points.
  for (int i = 1; i <= patch.count_u; ++i) {
    for (int j = 1; j <= patch.count_v; ++j) {
      patch.control_points.push_back(in_metres(surface.Pole(i, j)));
    }
  }
  return patch;
}

Vector3d middle_of(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  return in_metres(curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter())));
}

Vector3d middle_of(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, Standard_False);
  // Other surfaces may be endless, as planes are: an edge has ends.
  if (surface.GetType() == GeomAbs_BSplineSurface) {
    return in_metres(surface.Value(0.5 * (surface.FirstUParameter() + surface.LastUParameter()),
                                   0.5 * (surface.FirstVParameter() + surface.LastVParameter())));
  }
  return middle_of(TopoDS::Edge(TopExp_Explorer(face, TopAbs_EDGE).Current()));
}

}  // namespace hull::exchange
