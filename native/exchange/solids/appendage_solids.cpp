// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/solids/appendage_solids.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <array>
#include <cmath>
#include <gp_Ax2.hxx>
#include <numbers>
#include <stdexcept>

#include "exchange/occt_geometry.h"

namespace hull::exchange {
namespace {

using Outline = std::vector<std::array<Eigen::Vector2d, 4>>;

constexpr double kSewing = 1e-6;      // mm
constexpr double kSameRadius = 1e-9;  // of the larger one: no cone
constexpr int kQuarterParts = 8;      // as a bulb's shell_of() has

gp_Dir direction_of(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

TopoDS_Shape cylinder_solid(const analysis::CylinderShape& c) {
  const Vector3d along = c.end - c.start;
  const gp_Ax2 axes(in_millimetres(c.start), direction_of(along));
  const double height = kMillimetresPerMetre * along.norm();
  const double r0 = kMillimetresPerMetre * c.start_radius, r1 = kMillimetresPerMetre * c.end_radius;
  // A cone of no angle is refused by Open CASCADE.
  if (std::abs(r1 - r0) <= kSameRadius * r0) {
    return BRepPrimAPI_MakeCylinder(axes, r0, height).Solid();
  }
  return BRepPrimAPI_MakeCone(axes, r0, r1, height).Solid();
}

// Cubics from first to last, which meet with one tangent, over [0, 1].
template <class At>
conversion::BSplineCurve spline_of(const Outline& outline, std::size_t first, std::size_t last,
                                   const std::vector<double>& knots, const At& at) {
  conversion::BSplineCurve curve;
  curve.degree = 3;
  curve.points.push_back(at(outline[first][0]));
  for (std::size_t i = first; i < last; ++i) {
    // Where cubics meet with one derivative the joint is no control point: the double knot gives
    // it.
    curve.points.push_back(at(outline[i][1]));
    curve.points.push_back(at(outline[i][2]));
  }
  curve.points.push_back(at(outline[last - 1][3]));
  for (std::size_t i = 0; i < knots.size(); ++i) {
    // Once continuously differentiable, as the double knots of a cubic are.
    const int times = i == 0 || i + 1 == knots.size() ? 4 : 2;
    for (int k = 0; k < times; ++k) curve.knots.push_back(knots[i]);
  }
  return curve;
}

// Straight lines between two curves with the same knots.
TopoDS_Face ruled_face(const conversion::BSplineCurve& from, const conversion::BSplineCurve& to) {
  conversion::BSplinePatch patch;
  patch.degree_u = from.degree;
  // u along the curves, v along the rulings.
  patch.knots_u = from.knots;
  patch.count_u = static_cast<int>(from.points.size());
  patch.degree_v = 1;
  patch.knots_v = {0.0, 0.0, 1.0, 1.0};
  patch.count_v = 2;
  for (int i = 0; i < patch.count_u; ++i) {
    // v runs fastest, as in every patch.
    patch.control_points.push_back(from.points[i]);
    patch.control_points.push_back(to.points[i]);
  }
  return BRepBuilderAPI_MakeFace(make_surface(patch), kSewing).Face();
}

conversion::BSplineCurve line_of(const Vector3d& a, const Vector3d& b) {
  return {1, {0.0, 0.0, 1.0, 1.0}, {a, b}};
}

TopoDS_Face plane_face(const std::vector<conversion::BSplineCurve>& border) {
  BRepBuilderAPI_MakeWire wire;
  for (const conversion::BSplineCurve& curve : border) {
    // A sharp trailing edge has no line to close.
    if ((curve.points.front() - curve.points.back()).norm() == 0.0 && curve.degree == 1) continue;
    // Edges of its own: sewing joins them to those of the sides.
    wire.Add(BRepBuilderAPI_MakeEdge(make_curve(curve)).Edge());
  }
  return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
}

std::vector<double> backwards(const std::vector<double>& knots) {
  std::vector<double> result;
  for (auto it = knots.rbegin(); it != knots.rend(); ++it) result.push_back(1.0 - *it);
  return result;
}

TopoDS_Shape sewn_solid(BRepBuilderAPI_Sewing& sewing) {
  // Sewing makes one edge of those that two faces have in common; faces that find no neighbour do
  // not come out as one shell.
  sewing.Perform();
  if (sewing.SewedShape().IsNull() || sewing.SewedShape().ShapeType() != TopAbs_SHELL) {
    throw std::invalid_argument("The section's outline and its ends do not make a solid.");
  }
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape())).Solid();
}

// A quarter of the unit circle, from -45° on, by the cubics that shell_of() has.
struct Quarter {
  std::vector<double> knots;
  std::vector<Eigen::Vector2d> points;

  explicit Quarter(int number) {
    const double step = 0.5 * std::numbers::pi / kQuarterParts;
    // The handles of the cubic that meets an arc of this angle in its ends and middle.
    const double reach = 4.0 / 3.0 * std::tan(step / 4.0);
    for (int i = 0; i <= kQuarterParts; ++i) {
      const double angle = (number - 0.5) * 0.5 * std::numbers::pi + i * step;
      const Eigen::Vector2d at(std::cos(angle), std::sin(angle)), onward(-at.y(), at.x());
      // Joints within are left out, as in spline_of().
      if (i > 0) points.push_back(at - reach * onward);
      if (i == 0 || i == kQuarterParts) points.push_back(at);
      if (i < kQuarterParts) points.push_back(at + reach * onward);
      const int times = i == 0 || i == kQuarterParts ? 4 : 2;
      knots.insert(knots.end(), times, static_cast<double>(i) / kQuarterParts);
    }
  }
};

TopoDS_Shape foil_solid(const analysis::FoilShape& foil) {
  const analysis::SectionForm form(foil.section);
  // Knots run from the leading edge to the trailing one, as the lower side does; the upper side
  // comes back.
  const std::vector<double> down = form.knots(), up = backwards(down);
  const Vector3d along = foil.chord_direction.normalized();
  // Square to the chord, whatever was given.
  const Vector3d across =
      (foil.thickness_direction - foil.thickness_direction.dot(along) * along).normalized();
  struct End {
    conversion::BSplineCurve upper, lower, trailing;
  };
  const auto end_of = [&](const Vector3d& origin, double chord, double thickness) {
    const Outline outline =
        analysis::outline_of(form, thickness > 0.0 ? thickness : form.thickness(), false);
    const auto at = [&](const Eigen::Vector2d& p) -> Vector3d {
      return origin + chord * (p.x() * along + p.y() * across);
    };
    // The nose, where the sides meet.
    const std::size_t half = outline.size() / 2;
    return End{spline_of(outline, 0, half, up, at),
               spline_of(outline, half, outline.size(), down, at),
               line_of(at(outline.back()[3]), at(outline.front()[0]))};
  };
  const End root = end_of(foil.root, foil.root_chord, foil.root_thickness);
  const End tip = end_of(foil.tip, foil.tip_chord, foil.tip_thickness);
  BRepBuilderAPI_Sewing sewing(kSewing);
  sewing.Add(ruled_face(root.upper, tip.upper));
  sewing.Add(ruled_face(root.lower, tip.lower));
  if ((root.trailing.points[0] - root.trailing.points[1]).norm() > 0.0) {
    sewing.Add(ruled_face(root.trailing, tip.trailing));
  }
  sewing.Add(plane_face({root.upper, root.lower, root.trailing}));
  sewing.Add(plane_face({tip.upper, tip.lower, tip.trailing}));
  return sewn_solid(sewing);
}

// The quarters of a body of revolution, four faces that meet at 45° to the vertical and the level
// direction across it: a seam, and one where other bodies cross, files do not keep well.
TopoDS_Shape bulb_solid(const analysis::BulbShape& bulb) {
  const analysis::SectionForm form(bulb.section);
  const Vector3d way = bulb.tail - bulb.nose, along = way.normalized();
  const double length = way.norm();
  const Vector3d level = along.cross(Vector3d::UnitZ());
  // An upright body has no level direction of its own.
  const Vector3d first = level.norm() > kSameRadius ? level.normalized() : along.unitOrthogonal();
  const Vector3d second = along.cross(first);
  const Outline outline = analysis::outline_of(form, bulb.diameter / length, true);
  const std::vector<double> knots = backwards(form.knots());
  BRepBuilderAPI_Sewing sewing(kSewing);
  BRepBuilderAPI_MakeWire rim;
  const bool is_blunt = outline.front()[0].y() > 0.0;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Quarter arc(quarter);
    const auto at = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& around) -> Vector3d {
      return bulb.nose +
             length * (p.x() * along + p.y() * (around.x() * first + around.y() * second));
    };
    conversion::BSplinePatch patch;
    patch.degree_u = patch.degree_v = 3;
    patch.knots_v = arc.knots;
    patch.count_v = static_cast<int>(arc.points.size());
    const conversion::BSplineCurve meridian =
        spline_of(outline, 0, outline.size(), knots,
                  [](const Eigen::Vector2d& p) { return Vector3d(p.x(), p.y(), 0.0); });
    patch.knots_u = meridian.knots;
    patch.count_u = static_cast<int>(meridian.points.size());
    for (const Vector3d& p : meridian.points) {
      for (const Eigen::Vector2d& around : arc.points) {
        patch.control_points.push_back(at(p.head<2>(), around));
      }
    }
    // At the nose a whole side of the patch is one point, which sewing makes a degenerated edge.
    sewing.Add(BRepBuilderAPI_MakeFace(make_surface(patch), kSewing).Face());
    if (!is_blunt) continue;
    conversion::BSplineCurve edge{3, arc.knots, {}};
    for (const Eigen::Vector2d& around : arc.points) {
      edge.points.push_back(at(outline.front()[0], around));
    }
    rim.Add(BRepBuilderAPI_MakeEdge(make_curve(edge)).Edge());
  }
  if (is_blunt) sewing.Add(BRepBuilderAPI_MakeFace(rim.Wire(), true).Face());
  return sewn_solid(sewing);
}

}  // namespace

TopoDS_Shape solid_of(const analysis::AppendageShape& shape) {
  // For what it refuses alone.
  analysis::shell_of(shape);
  TopoDS_Shape made;
  if (const auto* cylinder = std::get_if<analysis::CylinderShape>(&shape)) {
    made = cylinder_solid(*cylinder);
  } else if (const auto* foil = std::get_if<analysis::FoilShape>(&shape)) {
    made = foil_solid(*foil);
  } else {
    made = bulb_solid(std::get<analysis::BulbShape>(shape));
  }
  // All three are made as solids, by whatever way.
  TopoDS_Solid solid = TopoDS::Solid(made);
  // Sewn faces may all point inwards.
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

}  // namespace hull::exchange
