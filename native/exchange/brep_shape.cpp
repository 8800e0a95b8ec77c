// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/brep_shape.h"

#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <cassert>
#include <map>
#include <utility>

#include "conversion/groups.h"

namespace hull {
namespace {

constexpr double kCollapsed = 1e-9;  // of the size: shorter sides have no length
constexpr double kTolerance = 1e-7;  // millimetres, Open CASCADE's smallest

gp_Pnt in_millimetres(const Vector3d& point) {
  const Vector3d p = point * kMillimetresPerMetre;
  return {p.x(), p.y(), p.z()};
}

// Knots as Open CASCADE wants them: each once, with how often it is repeated.
struct Knots {
  explicit Knots(const std::vector<double>& repeated) {
    for (double knot : repeated) {
      if (values.empty() || knot != values.back()) {
        values.push_back(knot);
        counts.push_back(0);
      }
      ++counts.back();
    }
  }
  TColStd_Array1OfReal array() const {
    return TColStd_Array1OfReal(values.front(), 1, static_cast<int>(values.size()));
  }
  TColStd_Array1OfInteger multiplicities() const {
    return TColStd_Array1OfInteger(counts.front(), 1, static_cast<int>(counts.size()));
  }
  std::vector<double> values;
  std::vector<int> counts;
};

Handle(Geom_BSplineSurface) make_surface(const BSplinePatch& patch) {
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

Handle(Geom_BSplineCurve) make_curve(const BSplineCurve& curve) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(curve.points.size()));
  for (size_t i = 0; i < curve.points.size(); ++i)
    poles(static_cast<int>(i) + 1) = in_millimetres(curve.points[i]);
  const Knots knots(curve.knots);
  return new Geom_BSplineCurve(poles, knots.array(), knots.multiplicities(), curve.degree);
}

// The straight line in (u, v) along a part of a side, over [0, 1] from its begin to its end; or
// from end to begin. It has a pole at each of the patch's knots: Open CASCADE integrates over faces
// by a Gauss rule for each interval of these lines, which is exact only within one polynomial.
Handle(Geom2d_BSplineCurve)
    side_line(const BSplinePatch& patch, int side, const SideEdge& part, bool backwards) {
  static const gp_Pnt2d kCorners[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const gp_XY from = kCorners[side].XY(), along = kCorners[(side + 1) % 4].XY() - from;
  constexpr double kNear = 1e-12;
  std::vector<double> shares{0.0};
  for (double knot : patch.side_knots(side)) {
    const double share = (knot - part.begin) / (part.end - part.begin);
    if (share > shares.back() + kNear && share < 1.0 - kNear) shares.push_back(share);
  }
  shares.push_back(1.0);
  const int count = static_cast<int>(shares.size());
  TColgp_Array1OfPnt2d poles(1, count);
  TColStd_Array1OfReal knots(1, count);
  TColStd_Array1OfInteger multiplicities(1, count);
  multiplicities.Init(1);
  multiplicities(1) = multiplicities(count) = 2;
  for (int i = 0; i < count; ++i) {
    const double share = shares[i];
    const int place = backwards ? count - i : i + 1;
    poles(place) = from + along * ((1.0 - share) * part.begin + share * part.end);
    knots(place) = backwards ? 1.0 - share : share;
  }
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, 1);
}

class ShapeMaker {
 public:
  explicit ShapeMaker(const PatchSet& set)
      : set_(set),
        size_(set.size()),
        vertex_groups_(set.vertex_count),
        parts_(static_cast<int>(set.patches.size())) {
    find_collapsed_sides_and_parts();
  }

  BRepShape make() {
    BRepShape result;
    std::map<int, TopoDS_Shell> shells;  // by part
    for (int p = 0; p < static_cast<int>(set_.patches.size()); ++p) {
      TopoDS_Shell& shell = shells[parts_.find(p)];
      if (shell.IsNull()) builder_.MakeShell(shell);
      result.faces.push_back(make_face(p));
      builder_.Add(shell, result.faces.back());
    }
    for (int e = 0; e < set_.edge_count; ++e) {
      if (uses_[e] == 1 && !collapsed_[e]) ++result.free_edges;
    }
    if (shells.size() == 1) {
      result.shape = finished(shells.begin()->second);
    } else {
      TopoDS_Compound compound;
      builder_.MakeCompound(compound);
      for (auto& [part, shell] : shells) builder_.Add(compound, finished(shell));
      result.shape = compound;
    }
    return result;
  }

 private:
  void find_collapsed_sides_and_parts() {
    collapsed_.assign(set_.edge_count, false);
    uses_.assign(set_.edge_count, 0);
    std::vector<int> first(set_.edge_count, -1);
    for (int p = 0; p < static_cast<int>(set_.patches.size()); ++p) {
      for (int k = 0; k < 4; ++k) {
        for (const SideEdge& part : set_.sides[p][k]) {
          ++uses_[part.edge];
          if (set_.curve(p, k, part).polygon_length() <= kCollapsed * size_) {
            collapsed_[part.edge] = true;
            vertex_groups_.join(part.from, part.to);
          } else if (first[part.edge] < 0) {
            first[part.edge] = p;
          } else {
            parts_.join(first[part.edge], p);
          }
        }
      }
    }
    vertices_.resize(set_.vertex_count);
    edges_.resize(set_.edge_count);
  }

  TopoDS_Vertex vertex(int number, const Vector3d& position) {
    TopoDS_Vertex& vertex = vertices_[vertex_groups_.find(number)];
    if (vertex.IsNull()) {
      // Ends of a collapsed side may lie apart by as much as such a side is long.
      const double tolerance = kTolerance + kCollapsed * size_ * kMillimetresPerMetre;
      builder_.MakeVertex(vertex, in_millimetres(position), tolerance);
    }
    return vertex;
  }

  TopoDS_Face make_face(int p) {
    const BSplinePatch& patch = set_.patches[p];
    TopoDS_Face face;
    builder_.MakeFace(face, make_surface(patch), kTolerance);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (int k = 0; k < 4; ++k) {
      for (const SideEdge& part : set_.sides[p][k]) {
        builder_.Add(wire, side_edge(p, k, part, face));
      }
    }
    wire.Closed(true);
    builder_.Add(face, wire);
    return face;
  }

  // The edge along a part of a patch's side, turned so that it runs in the side's direction.
  TopoDS_Edge side_edge(int p, int k, const SideEdge& part, const TopoDS_Face& face) {
    const int number = part.edge;
    const bool first = edges_[number].edge.IsNull();
    if (first) {
      const BSplineCurve curve = set_.curve(p, k, part);
      const TopoDS_Vertex begin = vertex(part.from, curve.points.front());
      const TopoDS_Vertex end = vertex(part.to, curve.points.back());
      if (collapsed_[number])
        return degenerated_edge(side_line(set_.patches[p], k, part, false), begin, face);
      edges_[number].side = side_line(set_.patches[p], k, part, false);
      edges_[number].face = face;
      TopoDS_Edge edge;
      builder_.MakeEdge(edge, make_curve(curve), kTolerance);
      add_ends(edge, begin, end);
      builder_.Range(edge, 0.0, 1.0);
      edges_[number].edge = edge;
    }
    const TopoDS_Edge& edge = edges_[number].edge;
    if (!first && edges_[number].face.IsSame(face)) {
      // Both sides of one patch: a seam has two lines on the same surface.
      builder_.UpdateEdge(edge, edges_[number].side, side_line(set_.patches[p], k, part, true),
                          face, kTolerance);
    } else {
      builder_.UpdateEdge(edge, side_line(set_.patches[p], k, part, !first), face, kTolerance);
    }
    return TopoDS::Edge(edge.Oriented(first ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  TopoDS_Edge degenerated_edge(const Handle(Geom2d_BSplineCurve) & side,
                               const TopoDS_Vertex& vertex, const TopoDS_Face& face) {
    TopoDS_Edge edge;
    builder_.MakeEdge(edge);
    builder_.UpdateEdge(edge, side, face, kTolerance);
    add_ends(edge, vertex, vertex);
    builder_.Range(edge, face, 0.0, 1.0);
    builder_.Degenerated(edge, true);
    return edge;
  }

  void add_ends(TopoDS_Edge& edge, const TopoDS_Vertex& begin, const TopoDS_Vertex& end) {
    builder_.Add(edge, begin.Oriented(TopAbs_FORWARD));
    builder_.Add(edge, end.Oriented(TopAbs_REVERSED));
  }

  TopoDS_Shape finished(TopoDS_Shell& shell) {
    shell.Closed(BRep_Tool::IsClosed(shell));
    if (!shell.Closed()) return shell;
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shell, properties);
    if (properties.Mass() <= 0.0) return shell;
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    builder_.Add(solid, shell);
    return solid;
  }

  struct MadeEdge {
    TopoDS_Edge edge;
    TopoDS_Face face;                  // the first face that has it
    Handle(Geom2d_BSplineCurve) side;  // and its line there
  };

  const PatchSet& set_;
  BRep_Builder builder_;
  double size_;
  Groups vertex_groups_, parts_;
  std::vector<bool> collapsed_;
  std::vector<int> uses_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<MadeEdge> edges_;
};

}  // namespace

BRepShape make_brep_shape(const PatchSet& set) {
  set.check();
  assert(!set.patches.empty());
  return ShapeMaker(set).make();
}

}  // namespace hull
