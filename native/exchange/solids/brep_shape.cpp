// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/solids/brep_shape.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "conversion/patches/edge_uses.h"
#include "exchange/occt_geometry.h"
#include "exchange/solids/face_integrals.h"
#include "mesh/groups.h"
#include "mesh/tolerances.h"

namespace hull::exchange {
namespace {

constexpr double kTolerance = 1e-7;  // millimetres, Open CASCADE's smallest

constexpr std::array<std::array<double, 2>, 4> kCorners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

gp_Pnt2d on_side(int side, double share) {
  const auto &from = kCorners[side], &to = kCorners[(side + 1) % 4];
  return {(1.0 - share) * from[0] + share * to[0], (1.0 - share) * from[1] + share * to[1]};
}

// The straight line in (u, v) along a part of a side, over [0, 1] from its begin to its end; or
// from end to begin.
ParameterCurve side_line(int side, const conversion::SideEdge& part, bool backwards) {
  const gp_Pnt2d begin = on_side(side, part.begin), end = on_side(side, part.end);
  ParameterCurve line;
  line.points = backwards ? std::vector{end, begin} : std::vector{begin, end};
  return line;
}

class ShapeMaker {
 public:
  ShapeMaker(const conversion::PatchSet& set, const conversion::Closing& closing)
      : set_(set),
        closing_(closing),
        uses_(set),
        size_(set.size()),
        vertex_groups_(set.vertex_count + static_cast<int>(closing.vertices.size())),
        parts_(static_cast<int>(set.patches.size() + closing.caps.size())),
        vertices_(set.vertex_count + closing.vertices.size()),
        edges_(set.edge_count + closing.edges.size()),
        first_(edges_.size(), -1),
        faces_of_(edges_.size(), 0) {
    // The ends of a side of no length are one vertex.
    for (int v = 0; v < set.vertex_count; ++v) vertex_groups_.join(v, uses_.vertex(v));
    for (const conversion::CapEdge& edge : closing.edges) {
      // It is left out of the wires, whose other edges then have to meet in one vertex.
      if (is_collapsed(edge)) vertex_groups_.join(edge.from, edge.to);
    }
  }

  BRepShape make() {
    BRepShape result;
    for (int p = 0; p < static_cast<int>(set_.patches.size()); ++p) {
      result.faces.push_back(make_face(p));
    }
    for (int c = 0; c < static_cast<int>(closing_.caps.size()); ++c) {
      const conversion::Cap& cap = closing_.caps[c];
      number_ = static_cast<int>(set_.patches.size()) + c;
      result.faces.push_back(cap.patch ? make_ruled_face(cap) : make_plane_face(cap));
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      // Without an object are edges that no face uses, and those of no length.
      if (edges_[e].edge.IsNull() || faces_of_[e] != 1) continue;
      ++result.free_edges;
      result.at_free_edge = middle_of(edges_[e].edge);
    }
    std::map<int, TopoDS_Shell> shells;  // by part
    // Caps come first: readers find out by a line from the first face which side of a shell is
    // outside, and lines meet plane faces most safely.
    for (std::size_t i = 0; i < result.faces.size(); ++i) {
      const std::size_t f = (i + set_.patches.size()) % result.faces.size();
      TopoDS_Shell& shell = shells[parts_.find(static_cast<int>(f))];
      if (shell.IsNull()) builder_.MakeShell(shell);
      builder_.Add(shell, result.faces[f]);
    }
    result.parts = static_cast<int>(shells.size());
    TopoDS_Compound compound;
    builder_.MakeCompound(compound);
    for (auto& [part, shell] : shells) {
      result.shape = finished(shell);
      if (result.shape.ShapeType() == TopAbs_SOLID) {
        ++result.solids;
      } else {
        result.at_no_solid = middle_of(TopoDS::Face(TopExp_Explorer(shell, TopAbs_FACE).Current()));
      }
      builder_.Add(compound, result.shape);
    }
    // A single part is no compound, so that readers find a solid.
    if (shells.size() > 1) result.shape = compound;
    return result;
  }

 private:
  struct MadeEdge {
    TopoDS_Edge edge;
    TopoDS_Face face;                  // the first face that has it
    Handle(Geom2d_BSplineCurve) side;  // and its line there
  };

  bool is_collapsed(const conversion::CapEdge& edge) const {
    return edge.curve.polygon_length() <= kNoLength * size_;
  }
  bool is_collapsed(int edge) const {
    return edge < set_.edge_count ? uses_.is_collapsed(edge)
                                  : is_collapsed(closing_.edges[edge - set_.edge_count]);
  }

  TopoDS_Vertex vertex(int number, const Vector3d& position) {
    TopoDS_Vertex& vertex = vertices_[vertex_groups_.find(number)];
    if (vertex.IsNull()) {
      // Ends of a collapsed side may lie apart by as much as such a side is long.
      const double tolerance = kTolerance + kNoLength * size_ * kMillimetresPerMetre;
      builder_.MakeVertex(vertex, in_millimetres(position), tolerance);
    }
    return vertex;
  }

  // The edge as an object, made from the curve where it is first met. One face more has it.
  MadeEdge& made(int number, const conversion::BSplineCurve& curve, int from, int to) {
    MadeEdge& result = edges_[number];
    // The second face takes the curve of the first: what little they differ by is within the
    // tolerance.
    if (result.edge.IsNull()) {
      builder_.MakeEdge(result.edge, make_curve(curve), kTolerance);
      add_ends(result.edge, vertex(from, curve.points.front()), vertex(to, curve.points.back()));
      // Also of its lines in (u, v), which have the curve's parameter.
      builder_.Range(result.edge, 0.0, kParameterRange);
    }
    ++faces_of_[number];
    if (first_[number] < 0) {
      first_[number] = number_;
    } else {
      parts_.join(first_[number], number_);
    }
    return result;
  }

  // An edge of a cap.
  MadeEdge& made(int number) {
    if (number >= set_.edge_count) {
      const conversion::CapEdge& own = closing_.edges[number - set_.edge_count];
      return made(number, own.curve, own.from, own.to);
    }
    const conversion::EdgeUse& use = uses_.of(number)[0];
    const conversion::SideEdge& part = uses_.part(use);
    return made(number, uses_.curve(use), part.from, part.to);
  }

  TopoDS_Face make_face(int p) {
    number_ = p;
    TopoDS_Face face;
    builder_.MakeFace(face, make_surface(set_.patches[p]), kTolerance);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (int k = 0; k < 4; ++k) {
      for (const conversion::SideEdge& part : set_.sides[p][k]) {
        builder_.Add(wire, side_edge(p, k, part, face));
      }
    }
    // The builder does not find that out itself.
    wire.Closed(true);
    builder_.Add(face, wire);
    return face;
  }

  // The edge along a part of a patch's side, turned so that it runs in the side's direction.
  TopoDS_Edge side_edge(int p, int k, const conversion::SideEdge& part, const TopoDS_Face& face) {
    if (is_collapsed(part.edge)) {
      const conversion::BSplineCurve curve = set_.curve(p, k, part);
      return degenerated_edge(make_curve(side_line(k, part, false)),
                              vertex(part.from, curve.points.front()), face);
    }
    const bool first = edges_[part.edge].edge.IsNull();
    MadeEdge& edge = made(part.edge, set_.curve(p, k, part), part.from, part.to);
    // Neighbours run along their edge in opposite directions: the second one's line is turned, to
    // go as the curve does.
    const Handle(Geom2d_BSplineCurve) line = make_curve(side_line(k, part, !first));
    if (first) {
      edge.side = line;
      edge.face = face;
    }
    if (!first && edge.face.IsSame(face)) {
      // Both sides of one patch: a seam has two lines on the same surface.
      builder_.UpdateEdge(edge.edge, edge.side, line, face, kTolerance);
    } else {
      builder_.UpdateEdge(edge.edge, line, face, kTolerance);
    }
    return TopoDS::Edge(edge.edge.Oriented(first ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  TopoDS_Edge degenerated_edge(const Handle(Geom2d_BSplineCurve) & side,
                               const TopoDS_Vertex& vertex, const TopoDS_Face& face) {
    TopoDS_Edge edge;
    // Without a curve in space: its line in (u, v) alone closes the wire there.
    builder_.MakeEdge(edge);
    builder_.UpdateEdge(edge, side, face, kTolerance);
    add_ends(edge, vertex, vertex);
    builder_.Range(edge, face, 0.0, kParameterRange);
    builder_.Degenerated(edge, true);
    return edge;
  }

  void add_ends(TopoDS_Edge& edge, const TopoDS_Vertex& begin, const TopoDS_Vertex& end) {
    builder_.Add(edge, begin.Oriented(TopAbs_FORWARD));
    builder_.Add(edge, end.Oriented(TopAbs_REVERSED));
  }

  static TopoDS_Edge directed(const TopoDS_Edge& edge, bool reversed) {
    return TopoDS::Edge(edge.Oriented(reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
  }

  TopoDS_Face make_plane_face(const conversion::Cap& cap) {
    const gp_Dir normal(cap.normal.x(), cap.normal.y(), cap.normal.z());
    TopoDS_Face face;
    builder_.MakeFace(face, new Geom_Plane(in_millimetres(cap.origin), normal), kTolerance);
    for (const conversion::EdgePath& loop : cap.loops) {
      TopoDS_Wire wire;
      builder_.MakeWire(wire);
      for (const conversion::DirectedEdge& part : loop) {
        if (is_collapsed(part.edge)) continue;
        const TopoDS_Edge edge = made(part.edge).edge;
        allow_distance(edge, part.edge, cap);
        builder_.Add(wire, directed(edge, part.reversed));
      }
      wire.Closed(true);
      builder_.Add(face, wire);
    }
    return face;
  }

  void allow_distance(const TopoDS_Edge& edge, int number, const conversion::Cap& cap) {
    const conversion::BSplineCurve curve = number < set_.edge_count
                                               ? uses_.curve(uses_.of(number)[0])
                                               : closing_.edges[number - set_.edge_count].curve;
    // The curve is within the hull of its control points.
    double largest = 0.0;
    for (const Vector3d& point : curve.points) {
      largest = std::max(largest, std::abs(cap.normal.dot(point - cap.origin)));
    }
    const double tolerance = kTolerance + largest * kMillimetresPerMetre;
    builder_.UpdateEdge(edge, tolerance);
    for (TopoDS_Iterator end(edge); end.More(); end.Next()) {
      builder_.UpdateVertex(TopoDS::Vertex(end.Value()), tolerance);
    }
  }

  TopoDS_Face make_ruled_face(const conversion::Cap& cap) {
    TopoDS_Face face;
    builder_.MakeFace(face, make_surface(*cap.patch), kTolerance);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (int k = 0; k < 4; ++k) {
      bool any = false;
      for (const conversion::DirectedEdge& part : cap.loops[k]) {
        if (is_collapsed(part.edge)) continue;
        const TopoDS_Edge edge = made(part.edge).edge;
        builder_.UpdateEdge(edge, cap_line(cap, k, part), face, kTolerance);
        builder_.Add(wire, directed(edge, part.reversed));
        any = true;
      }
      if (any) continue;
      const TopoDS_Vertex at = vertex_at(cap, k);
      builder_.Add(wire, degenerated_edge(make_curve(side_line(k, {}, false)), at, face));
    }
    wire.Closed(true);
    builder_.Add(face, wire);
    return face;
  }

  // Where a side of no length is, 0 or 2: at the begin or end of side 1.
  TopoDS_Vertex vertex_at(const conversion::Cap& cap, int side) {
    const conversion::DirectedEdge border = cap.loops[1].front();
    // Side 1 leads from side 0 to side 2.
    const bool at_begin = (side == 0) != border.reversed;
    const TopAbs_Orientation wanted = at_begin ? TopAbs_FORWARD : TopAbs_REVERSED;
    for (TopoDS_Iterator end(edges_[border.edge].edge); end.More(); end.Next()) {
      if (end.Value().Orientation() == wanted) {
        return TopoDS::Vertex(end.Value().Oriented(TopAbs_FORWARD));
      }
    }
    assert(false);
    return {};
  }

  // An edge of a ruled cap in its (u, v), in the direction of the edge's curve. Sides 1 and 3 are
  // one edge each, with the patch's own parameter; on the others u is as far athwart as the curve.
  Handle(Geom2d_BSplineCurve)
      cap_line(const conversion::Cap& cap, int side, const conversion::DirectedEdge& part) {
    const conversion::BSplinePatch& patch = *cap.patch;
    if (side % 2 == 1) return make_curve(side_line(side, {}, part.reversed));
    const int last = side == 2 ? patch.count_v - 1 : 0;
    const double far = patch.control_point(0, last).y(), near = patch.control_point(1, last).y();
    const conversion::BSplineCurve curve = part.edge < set_.edge_count
                                               ? uses_.curve(uses_.of(part.edge)[0])
                                               : closing_.edges[part.edge - set_.edge_count].curve;
    ParameterCurve line{curve.degree, curve.knots, {}};
    for (const Vector3d& point : curve.points) {
      line.points.emplace_back(std::clamp((point.y() - far) / (near - far), 0.0, 1.0),
                               side == 2 ? 1.0 : 0.0);
    }
    return make_curve(line);
  }

  TopoDS_Shape finished(TopoDS_Shell& shell) {
    shell.Closed(BRep_Tool::IsClosed(shell));
    // Turned inwards it would be the solid of all space outside.
    if (!shell.Closed() || integrals_of(shell).volume <= 0.0) return shell;
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    builder_.Add(solid, shell);
    return solid;
  }

  const conversion::PatchSet& set_;
  const conversion::Closing& closing_;
  conversion::EdgeUses uses_;
  BRep_Builder builder_;
  double size_;
  mesh::Groups vertex_groups_, parts_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<MadeEdge> edges_;
  std::vector<int> first_, faces_of_;  // of each edge
  int number_ = 0;                     // of the face being made
};

}  // namespace

BRepShape make_brep_shape(const conversion::PatchSet& set, const conversion::Closing& closing) {
  set.check();
  assert(!set.patches.empty());
  return ShapeMaker(set, closing).make();
}

}  // namespace hull::exchange
