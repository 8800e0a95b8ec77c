// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/solids/joined_solids.h"

#include <BRepAlgoAPI_BooleanOperation.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <stdexcept>
#include <utility>

#include "exchange/occt_progress.h"
#include "exchange/solids/appendage_solids.h"

namespace hull::exchange {
namespace {

using FaceNames = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

void name_faces(const TopoDS_Shape& shape, const std::string& name, FaceNames& names) {
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    names.Bind(face.Current(), name);
  }
}

TopoDS_Shape mirror_image(const TopoDS_Shape& shape) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 1.0, 0.0)));
  return BRepBuilderAPI_Transform(shape, mirror, true).Shape();
}

// What becomes of faces by an operation keeps their names.
FaceNames names_after(BRepAlgoAPI_BooleanOperation& operation, const FaceNames& before) {
  FaceNames after;
  for (FaceNames::Iterator it(before); it.More(); it.Next()) {
    // Faces wholly within the other body are gone.
    if (operation.IsDeleted(it.Key())) continue;
    const TopTools_ListOfShape& parts = operation.Modified(it.Key());
    // Not touched by the operation: it is the same face still.
    if (parts.IsEmpty()) after.Bind(it.Key(), it.Value());
    for (const TopoDS_Shape& part : parts) after.Bind(part, it.Value());
  }
  return after;
}

void run(BRepAlgoAPI_BooleanOperation& operation, const TopTools_ListOfShape& arguments,
         const TopTools_ListOfShape& tools, const std::string& names,
         const surface::Progress& progress) {
  operation.SetArguments(arguments);
  operation.SetTools(tools);
  // Else tolerances of the arguments' own edges would grow, of the caller's hull too.
  operation.SetNonDestructive(true);
  Handle(OcctProgress) told = new OcctProgress(progress, 0.0, 1.0);
  operation.Build(told->Start());
  told->rethrow();
  if (operation.IsDone() && !operation.HasErrors()) return;
  throw std::invalid_argument("Open CASCADE could not join " + names +
                              " and the hull: let their surfaces cross at an angle, and none of "
                              "their edges lie in one another.");
}

}  // namespace

void join_appendages(BRepShape& hull, std::vector<std::string>& regions,
                     const std::vector<analysis::Appendage>& appendages,
                     const surface::Progress& progress) {
  if (hull.solids != hull.parts || hull.free_edges > 0) {
    throw std::invalid_argument(
        "appendages can be joined to a closed solid only: write the hull as a solid");
  }
  FaceNames names;
  // By shape, without orientation: the operations tell by the shape what becomes of a face.
  for (std::size_t f = 0; f < hull.faces.size(); ++f) names.Bind(hull.faces[f], regions[f]);
  TopTools_ListOfShape added, cut;
  std::string added_names, cut_names;
  for (const analysis::Appendage& appendage : appendages) {
    const TopoDS_Shape solid = solid_of(appendage.shape);
    TopTools_ListOfShape& list = appendage.is_cut ? cut : added;
    std::string& all = appendage.is_cut ? cut_names : added_names;
    all += (all.empty() ? "" : ", ") + appendage.name;
    list.Append(solid);
    name_faces(solid, appendage.name, names);
    if (!appendage.mirrored) continue;
    list.Append(mirror_image(solid));
    name_faces(list.Last(), appendage.name, names);
  }
  TopTools_ListOfShape current;
  for (TopExp_Explorer solid(hull.shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    current.Append(solid.Current());
  }
  if (!added.IsEmpty()) {
    BRepAlgoAPI_Fuse fuse;
    run(fuse, current, added, added_names, surface::part_of(progress, 0.0, 0.5));
    names = names_after(fuse, names);
    current.Clear();
    current.Append(fuse.Shape());
  }
  // Last, so that a tunnel goes through what was joined as well.
  if (!cut.IsEmpty()) {
    BRepAlgoAPI_Cut cutting;
    run(cutting, current, cut, cut_names, surface::part_of(progress, 0.5, 1.0));
    names = names_after(cutting, names);
    current.Clear();
    current.Append(cutting.Shape());
  }
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  hull.faces.clear();
  hull.solids = 0;
  regions.clear();
  for (TopExp_Explorer solid(current.First(), TopAbs_SOLID); solid.More(); solid.Next()) {
    builder.Add(compound, solid.Current());
    ++hull.solids;
    // Of a single solid that is the shape; of several the compound takes its place below.
    hull.shape = solid.Current();
    for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next()) {
      hull.faces.push_back(TopoDS::Face(face.Current()));
      const std::string* name = names.Seek(face.Current());
      regions.push_back(name ? *name : "shell");
    }
  }
  if (hull.solids == 0) {
    throw std::invalid_argument("nothing is left of the hull after cutting " + cut_names);
  }
  if (hull.solids > 1) hull.shape = compound;
  hull.parts = hull.solids;
  // An operation may end without errors, and with a result that is not valid.
  if (BRepCheck_Analyzer(hull.shape).IsValid()) return;
  throw std::invalid_argument(
      "the solid of the hull and its appendages is not valid: let their surfaces cross at an "
      "angle");
}

}  // namespace hull::exchange
