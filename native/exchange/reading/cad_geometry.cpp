// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/reading/cad_geometry.h"

#include <BRepBndLib.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomConvert.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <NCollection_DataMap.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "exchange/occt_geometry.h"
#include "exchange/occt_session.h"
#include "exchange/reading/cad_reading.h"
#include "exchange/reading/face_triangles.h"
#include "files/atomic_file.h"

namespace hull::exchange {
namespace {

constexpr double kFileRead = 0.6, kMeshed = 0.9;  // shares of the time
// Radians between neighbouring triangles: only so much that round faces are no polygons.
constexpr double kMeshAngle = 0.5;

// Texts of shapes without orientation.
using Texts = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

// The text for the faces in a shape, and for its edges that are in none, where they have none yet.
void give(const std::string& text, const TopoDS_Shape& shape, Texts& texts) {
  const auto give_all = [&](TopExp_Explorer part) {
    for (; part.More(); part.Next()) {
      if (!texts.IsBound(part.Current())) texts.Bind(part.Current(), text);
    }
  };
  give_all(TopExp_Explorer(shape, TopAbs_FACE));
  // Edges outside faces alone: those within have the text of none.
  give_all(TopExp_Explorer(shape, TopAbs_EDGE, TopAbs_FACE));
}

std::string text_for(const TopoDS_Shape& shape, const Texts& texts) {
  const std::string* text = texts.Seek(shape);
  return text != nullptr ? *text : "";
}

Handle(Geom_BSplineCurve) spline_of(const TopoDS_Edge& edge) {
  double begin = 0.0, end = 0.0;
  Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end);
  // The edge has only a line in a surface's (u, v): its curve in space is made of that.
  if (curve.IsNull()) {
    BRepLib::BuildCurve3d(edge);
    curve = BRep_Tool::Curve(edge, begin, end);
  }
  // A whole line or parabola, while B-splines have ends.
  if (curve.IsNull() || Precision::IsInfinite(begin) || Precision::IsInfinite(end)) return nullptr;
  const Handle(Geom_BSplineCurve) spline =
      GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(curve, begin, end));
  // A periodic one has fewer points than its knots tell.
  if (!spline.IsNull() && spline->IsPeriodic()) spline->SetNotPeriodic();
  return spline;
}

CadSpline values_of(const Geom_BSplineCurve& spline) {
  CadSpline values;
  values.degree = spline.Degree();
  for (int i = 1; i <= spline.NbKnots(); ++i) {
    // Repeated, while Open CASCADE has each once with its multiplicity.
    values.knots.insert(values.knots.end(), spline.Multiplicity(i), spline.Knot(i));
  }
  for (int i = 1; i <= spline.NbPoles(); ++i) values.points.push_back(in_metres(spline.Pole(i)));
  if (spline.IsRational()) {
    for (int i = 1; i <= spline.NbPoles(); ++i) values.weights.push_back(spline.Weight(i));
  }
  return values;
}

class GeometryReader {
 public:
  explicit GeometryReader(const CadContent& content) : shape_(content.shape) {
    for (const CadName& named : content.names) give(named.name, named.shape, names_);
    for (const CadLayer& layer : content.layers) {
      for (const CadLayer::Member& member : layer.members) give(layer.name, member.shape, layers_);
    }
  }

  void add_curves(CadGeometry& geometry) const {
    TopTools_IndexedDataMapOfShapeListOfShape faces;
    TopExp::MapShapesAndAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) {
      const TopoDS_Edge& edge = TopoDS::Edge(faces.FindKey(i));
      if (BRep_Tool::Degenerated(edge)) continue;
      const Handle(Geom_BSplineCurve) spline = made(edge);
      if (spline.IsNull()) {
        ++geometry.curves_left_out;
        continue;
      }
      CadSpline values = values_of(*spline);
      values.name = text_for(edge, names_);
      values.layer = text_for(edge, layers_);
      // Counted once for each use: a seam within one face has two.
      values.faces = faces(i).Extent();
      geometry.curves.push_back(std::move(values));
    }
  }

  void add_faces(CadGeometry& geometry, double chord) const {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape_, TopAbs_FACE, faces);
    for (int i = 1; i <= faces.Extent(); ++i) {
      const TopoDS_Face& face = TopoDS::Face(faces(i));
      TopLoc_Location location;
      const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
      if (mesh.IsNull() || mesh->NbTriangles() == 0) {
        // Counted, and told to the user: nothing is missing in silence.
        ++geometry.faces_left_out;
        continue;
      }
      geometry.faces.push_back(face_triangles(face, *mesh, location, chord));
      geometry.faces.back().name = text_for(face, names_);
      geometry.faces.back().layer = text_for(face, layers_);
    }
  }

  void add_points(CadGeometry& geometry) const {
    TopTools_IndexedDataMapOfShapeListOfShape edges;
    TopExp::MapShapesAndAncestors(shape_, TopAbs_VERTEX, TopAbs_EDGE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
      // Ends of edges are told by their curves.
      if (!edges(i).IsEmpty()) continue;
      geometry.points.push_back(in_metres(BRep_Tool::Pnt(TopoDS::Vertex(edges.FindKey(i)))));
    }
  }

 private:
  // What Open CASCADE refuses of a single edge is left out, not the whole file.
  static Handle(Geom_BSplineCurve) made(const TopoDS_Edge& edge) {
    try {
      return spline_of(edge);
    } catch (const Standard_Failure&) {
      return nullptr;
    }
  }

  const TopoDS_Shape& shape_;
  Texts names_, layers_;
};

// Of the box around the shape, mm.
double diagonal_of(const TopoDS_Shape& shape, const std::string& refusal) {
  Bnd_Box box;
  // By curves and surfaces: there are no triangles yet.
  BRepBndLib::Add(shape, box, Standard_False);
  // Empty, or without end in some direction, as a plane without borders.
  if (box.IsVoid() || box.IsOpen()) {
    throw files::FileError(refusal + "it holds nothing that has ends");
  }
  return std::sqrt(box.SquareExtent());
}

}  // namespace

CadGeometry read_cad_geometry(const std::string& path, double chord_share,
                              const surface::Progress& progress) {
  const std::string refusal = "Cannot read \"" + path + "\": ";
  try {
    const OcctSession session;
    const CadContent content =
        read_cad_content(path, refusal, surface::part_of(progress, 0.0, kFileRead));
    const double diagonal = diagonal_of(content.shape, refusal);
    const double chord = chord_share * diagonal;
    // A single point has no extent and nothing to be meshed.
    if (chord > 0.0) BRepMesh_IncrementalMesh(content.shape, chord, Standard_False, kMeshAngle);
    surface::tell(progress, kMeshed, 1.0);
    CadGeometry geometry;
    geometry.format = content.format;
    geometry.unit = content.unit;
    geometry.product = content.product;
    const GeometryReader reader(content);
    reader.add_curves(geometry);
    reader.add_faces(geometry, chord);
    reader.add_points(geometry);
    surface::tell(progress, 1.0, 1.0);
    return geometry;
  } catch (const Standard_Failure& failure) {
    throw files::FileError(refusal + describe(failure));
  }
}

}  // namespace hull::exchange
