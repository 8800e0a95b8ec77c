// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/solids/telling_faces.h"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <vector>

namespace hull::exchange {
namespace {

constexpr double kReadersTolerance = 1e-7;  // that of its readers

TopoDS_Solid solid_of(const std::vector<TopoDS_Shape>& faces) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (const TopoDS_Shape& face : faces) builder.Add(shell, face);
  // All the faces of a closed shell, in another order only.
  shell.Closed(true);
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

TopoDS_Shape with_telling_first_face(const TopoDS_Shape& solid) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    faces.push_back(face.Current());
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const TopoDS_Solid turned = solid_of(faces);
    BRepClass3d_SolidClassifier classifier(turned);
    // As the readers do: a point at infinity has to be outside.
    classifier.PerformInfinitePoint(kReadersTolerance);
    if (classifier.State() == TopAbs_OUT) return turned;
    // The next one first.
    std::rotate(faces.begin(), faces.begin() + 1, faces.end());
  }
  return solid;
}

}  // namespace

TopoDS_Shape with_telling_first_faces(const TopoDS_Shape& shape) {
  if (shape.ShapeType() == TopAbs_SOLID) return with_telling_first_face(shape);
  // Shells alone are not taken for solids by readers.
  if (shape.ShapeType() != TopAbs_COMPOUND) return shape;
  const BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (TopoDS_Iterator part(shape); part.More(); part.Next()) {
    builder.Add(compound, with_telling_first_faces(part.Value()));
  }
  return compound;
}

}  // namespace hull::exchange
