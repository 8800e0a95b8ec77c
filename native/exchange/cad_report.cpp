// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/cad_report.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "exchange/occt_geometry.h"
#include "exchange/occt_session.h"
#include "exchange/reading/cad_reading.h"
#include "exchange/solids/face_integrals.h"
#include "files/atomic_file.h"

namespace hull::exchange {
namespace {

// Share of the time that reading takes; checks take the rest.
constexpr double kRead = 0.8;

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  // Each once, though several shapes may share it.
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, type, found);
  return found.Extent();
}

void count_edges(const TopoDS_Shape& shape, CadReport& report) {
  // The faces are listed once for each time they use the edge, so a seam within one face counts
  // two.
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(faces.FindKey(i));
    // Edges without a curve, at collapsed sides: they border on nothing.
    if (BRep_Tool::Degenerated(edge)) continue;
    if (faces(i).IsEmpty()) {
      ++report.curves;
      continue;
    }
    ++report.edges;
    if (faces(i).Extent() != 1) continue;
    ++report.free_edges;
    report.at_free_edge = middle_of(edge);
    GProp_GProps properties;
    BRepGProp::LinearProperties(edge, properties);
    report.free_edge_length += properties.Mass() / kMillimetresPerMetre;
  }
}

void check(const TopoDS_Shape& shape, CadReport& report) {
  const BRepCheck_Analyzer analyzer(shape);
  report.valid = analyzer.IsValid();
  if (report.valid) return;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    if (analyzer.IsValid(face.Current())) continue;
    report.at_fault = middle_of(TopoDS::Face(face.Current()));
    return;
  }
}

// Areas of faces, by shape without orientation.
using Areas = NCollection_DataMap<TopoDS_Shape, double, TopTools_ShapeMapHasher>;

Areas measure(const TopoDS_Shape& shape, CadReport& report) {
  Areas areas;
  conversion::SurfaceIntegrals sum;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const conversion::SurfaceIntegrals own = integrals_of_face(TopoDS::Face(face.Current()));
    // Layers are told per face, so that each is integrated once.
    areas.Bind(face.Current(), own.area);
    sum += own;
  }
  report.area = sum.area;
  // Both were counted before.
  report.closed = report.faces > 0 && report.free_edges == 0;
  if (report.closed) report.volume = sum.volume;
  return areas;
}

}  // namespace

Eigen::AlignedBox3d box_of(const TopoDS_Shape& shape) {
  Eigen::AlignedBox3d box;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int f = 1; f <= faces.Extent(); ++f) {
    // By the surface's own range, not the face's borders: of whole patches they are the same.
    const BRepAdaptor_Surface surface(TopoDS::Face(faces(f)), Standard_False);
    if (surface.GetType() != GeomAbs_BSplineSurface) continue;
    const double u0 = surface.FirstUParameter(), u1 = surface.LastUParameter();
    const double v0 = surface.FirstVParameter(), v1 = surface.LastVParameter();
    for (int i = 0; i <= kBoxSteps; ++i) {
      for (int j = 0; j <= kBoxSteps; ++j) {
        const double u = u0 + (u1 - u0) * i / kBoxSteps, v = v0 + (v1 - v0) * j / kBoxSteps;
        box.extend(in_metres(surface.Value(u, v)));
      }
    }
  }
  return box;
}

namespace {

void find_box(const TopoDS_Shape& shape, CadReport& report) {
  const Eigen::AlignedBox3d box = box_of(shape);
  if (box.isEmpty()) return;
  report.box_min = box.min();
  report.box_max = box.max();
}

void find_layers(const std::vector<CadLayer>& layers, const Areas& areas, CadReport& report) {
  std::map<std::string, CadRegion> regions;
  for (const CadLayer& layer : layers) {
    if (!std::ranges::count(report.layers, layer.name)) report.layers.push_back(layer.name);
    for (const CadLayer::Member& member : layer.members) {
      // Curves have layers too, but make no region.
      if (member.shape.ShapeType() != TopAbs_FACE) continue;
      CadRegion& region = regions[layer.name];
      if (region.faces == 0) region.colour = member.colour;
      ++region.faces;
      // None of a face that is in a layer, but not in the shape.
      if (const double* area = areas.Seek(member.shape)) region.area += *area;
    }
  }
  std::ranges::sort(report.layers);
  for (auto& [name, region] : regions) {
    region.name = name;
    report.regions.push_back(std::move(region));
  }
}

}  // namespace

CadReport read_cad_report(const std::string& path, const std::string& name,
                          const surface::Progress& progress) {
  const std::string refusal = "Cannot read \"" + name + "\": ";
  try {
    const OcctSession session;
    const CadContent content =
        read_cad_content(path, refusal, surface::part_of(progress, 0.0, kRead));
    CadReport report;
    report.format = content.format;
    report.unit = content.unit;
    report.product = content.product;
    std::error_code gone;
    report.bytes = std::filesystem::file_size(path, gone);
    if (gone) throw files::FileError(refusal + gone.message());
    check(content.shape, report);
    surface::tell(progress, 0.95, 1.0);
    report.solids = count(content.shape, TopAbs_SOLID);
    report.shells = count(content.shape, TopAbs_SHELL);
    // Before measure(), which asks for it.
    report.faces = count(content.shape, TopAbs_FACE);
    count_edges(content.shape, report);
    const Areas areas = measure(content.shape, report);
    find_box(content.shape, report);
    find_layers(content.layers, areas, report);
    surface::tell(progress, 1.0, 1.0);
    return report;
    // Open CASCADE's exceptions derive from nothing that others catch.
  } catch (const Standard_Failure& failure) {
    throw files::FileError(refusal + describe(failure));
  }
}

}  // namespace hull::exchange
