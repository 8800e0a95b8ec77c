// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>
#include <vector>

#include "conversion/patches/bspline_patch.h"

namespace hull::exchange {

// Open CASCADE works in millimetres.
constexpr double kMillimetresPerMetre = 1000.0;

// Parameters in files run from 0 to this, and not to 1: CAD systems take knots closer together than
// 1e-9 for one, whatever the range. A power of two, so that no knot is rounded.
constexpr double kParameterRange = 1024.0;

gp_Pnt in_millimetres(const Vector3d& point);
Vector3d in_metres(const gp_Pnt& point);

// Curves and patches have parameters from 0 to 1.
Handle(Geom_BSplineSurface) make_surface(const conversion::BSplinePatch& patch);
Handle(Geom_BSplineCurve) make_curve(const conversion::BSplineCurve& curve);

// A curve in a surface's parameters, from 0 to 1 as well.
struct ParameterCurve {
  int degree = 1;
  std::vector<double> knots = {0.0, 0.0, 1.0, 1.0};
  std::vector<gp_Pnt2d> points;
};
Handle(Geom2d_BSplineCurve) make_curve(const ParameterCurve& curve);

// The surface as a patch over [0, 1] x [0, 1]. REQUIRES: it is neither rational nor periodic.
conversion::BSplinePatch patch_of(const Geom_BSplineSurface& surface);

// A point in the middle of an edge that has a curve, m; and one of a face, on its border unless the
// whole of it is a B-spline surface.
Vector3d middle_of(const TopoDS_Edge& edge);
Vector3d middle_of(const TopoDS_Face& face);

}  // namespace hull::exchange
