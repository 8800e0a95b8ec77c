// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step_report.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "exchange/brep_shape.h"
#include "exchange/occt_session.h"
#include "exchange/step_text.h"
#include "files/atomic_file.h"

namespace hull {
namespace {

// Relative, of each face's integrals. Without one Open CASCADE takes a single Gauss rule a face,
// which is off by 1e-4 on faces of many spans.
constexpr double kIntegralTolerance = 1e-8;

Eigen::Vector3d in_metres(const gp_Pnt& point) {
  return Eigen::Vector3d(point.X(), point.Y(), point.Z()) / kMillimetresPerMetre;
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, type, found);
  return found.Extent();
}

void count_edges(const TopoDS_Shape& shape, StepReport& report) {
  // The faces are listed once for each time they use the edge, so a seam within one face counts
  // two.
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(faces.FindKey(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    ++report.edges;
    if (faces(i).Extent() != 1) continue;
    ++report.free_edges;
    GProp_GProps properties;
    BRepGProp::LinearProperties(edge, properties);
    report.free_edge_length += properties.Mass() / kMillimetresPerMetre;
  }
}

void measure(const TopoDS_Shape& shape, StepReport& report) {
  GProp_GProps surface;
  BRepGProp::SurfaceProperties(shape, surface, kIntegralTolerance);
  report.area = surface.Mass() / (kMillimetresPerMetre * kMillimetresPerMetre);
  if (report.free_edges > 0 || report.faces == 0) return;
  GProp_GProps volume;
  BRepGProp::VolumeProperties(shape, volume, kIntegralTolerance);
  report.volume = volume.Mass() / std::pow(kMillimetresPerMetre, 3);
}

void find_box(const TopoDS_Shape& shape, StepReport& report) {
  Eigen::AlignedBox3d box;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int f = 1; f <= faces.Extent(); ++f) {
    const BRepAdaptor_Surface surface(TopoDS::Face(faces(f)));
    const double u0 = surface.FirstUParameter(), u1 = surface.LastUParameter();
    const double v0 = surface.FirstVParameter(), v1 = surface.LastVParameter();
    for (int i = 0; i <= kBoxSteps; ++i) {
      for (int j = 0; j <= kBoxSteps; ++j) {
        const double u = u0 + (u1 - u0) * i / kBoxSteps, v = v0 + (v1 - v0) * j / kBoxSteps;
        box.extend(in_metres(surface.Value(u, v)));
      }
    }
  }
  if (box.isEmpty()) return;
  report.box_min = box.min();
  report.box_max = box.max();
}

std::string product_name(const Handle(StepData_StepModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (!product.IsNull() && !product->Name().IsNull())
      return decode_step_string(product->Name()->ToCString());
  }
  return "";
}

}  // namespace

StepReport read_step_report(std::istream& text, const std::string& name) {
  const std::string refusal = "Cannot read \"" + name + "\": ";
  try {
    const OcctSession session;
    STEPControl_Reader reader;
    if (reader.ReadStream(name.c_str(), text) != IFSelect_RetDone) {
      throw FileError(refusal + "it is not a STEP file");
    }
    reader.TransferRoots();
    const TopoDS_Shape shape = reader.OneShape();
    if (shape.IsNull()) throw FileError(refusal + "it holds no shape");
    StepReport report;
    report.valid = BRepCheck_Analyzer(shape).IsValid();
    report.solids = count(shape, TopAbs_SOLID);
    report.shells = count(shape, TopAbs_SHELL);
    report.faces = count(shape, TopAbs_FACE);
    count_edges(shape, report);
    measure(shape, report);
    find_box(shape, report);
    report.product = product_name(reader.StepModel());
    return report;
  } catch (const Standard_Failure& failure) {
    throw FileError(refusal + describe(failure));
  }
}

StepReport read_step_report(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError("Cannot read \"" + path + "\": " + std::strerror(errno));
  return read_step_report(file, path);
}

}  // namespace hull
