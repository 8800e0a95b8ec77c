// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/iges_file.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <IGESAppli_LevelFunction.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESData_IGESWriter.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESGraph_Color.hxx>
#include <IGESSelect_WorkLibrary.hxx>
#include <Interface_Static.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <map>
#include <sstream>
#include <utility>

#include "exchange/cad_file.h"
#include "exchange/cad_model.h"
#include "exchange/occt_geometry.h"
#include "exchange/occt_progress.h"
#include "exchange/regions.h"
#include "exchange/step/step_text.h"

namespace hull::exchange {
namespace {

using Entity = Handle(IGESData_IGESEntity);

Handle(TCollection_HAsciiString) text_of(const std::string& utf8) {
  // IGES is ASCII. With STEP's directives one reading serves for both formats.
  return new TCollection_HAsciiString(encode_step_string(utf8).c_str());
}

class IgesText {
 public:
  IgesText(const CadModel& model, const CadOptions& options, const surface::Progress& progress)
      : model_(model),
        options_(options),
        progress_(progress),
        // The second argument is the mode: B-rep entities (186, 514), no trimmed surfaces by
        // themselves.
        writer_(Interface_Static::CVal("write.iges.unit"), 1) {}

  std::string make() {
    add(model_.brep.shape, 0.0, 0.5);
    for (std::size_t f = 0; f < model_.brep.faces.size(); ++f) {
      const Entity entity = entity_of(model_.brep.faces[f]);
      if (entity.IsNull()) continue;  // the file read back will show it
      // Levels are numbered as they are first met, from 1: on level 0 is what has none.
      put_on_level(entity, model_.regions[f]);
      entity->InitColor(colour_of(model_.regions[f]));
    }
    if (const Entity whole = entity_of(model_.brep.shape); !whole.IsNull()) {
      set_name(whole, options_.name);
    }
    for (const CadCurve& curve : model_.curves) add_curve(curve);
    name_levels();
    // After everything was added: it makes the model ready to be written.
    writer_.ComputeModel();
    set_header();
    surface::tell(progress_, 0.6, 1.0);
    return printed();
  }

 private:
  void add(const TopoDS_Shape& shape, double begin, double end) {
    Handle(OcctProgress) indicator = new OcctProgress(progress_, begin, end);
    const bool done = writer_.AddShape(shape, indicator->Start());
    indicator->rethrow();
    if (!done) throw NoCadText("the patches were not translated to IGES");
  }

  Entity entity_of(const TopoDS_Shape& shape) const {
    const Handle(Transfer_FinderProcess) process = writer_.TransferProcess();
    Handle(Standard_Transient) found;
    process->FindTypedTransient(TransferBRep::ShapeMapper(process, shape),
                                STANDARD_TYPE(IGESData_IGESEntity), found);
    return Entity::DownCast(found);
  }

  void put_on_level(const Entity& entity, const std::string& layer) {
    const int next = static_cast<int>(levels_.size()) + 1;
    entity->InitLevel({}, levels_.try_emplace(layer, next).first->second);
  }

  Handle(IGESData_ColorEntity) colour_of(const std::string& region) {
    // One entity for all faces of a region.
    Handle(IGESGraph_Color)& known = colours_[region];
    if (known.IsNull()) {
      const analysis::Colour rgb = exchange::colour_of(region, options_);
      known = new IGESGraph_Color;
      // Per cent.
      known->Init(100.0 * rgb[0], 100.0 * rgb[1], 100.0 * rgb[2], text_of(region));
      writer_.AddEntity(known);
    }
    return known;
  }

  void add_curve(const CadCurve& curve) {
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(make_curve(curve.curve)).Edge();
    // Curves take no time to speak of.
    add(edge, 0.5, 0.5);
    const Entity entity = entity_of(edge);
    if (entity.IsNull()) return;
    // A level without a name would be read by its number; on level 0 is what has none.
    if (!curve.layer.empty()) put_on_level(entity, curve.layer);
    set_name(entity, curve.name);
  }

  // In full; the label of eight characters has the begin, where it is ASCII.
  void set_name(const Entity& entity, const std::string& name) {
    const Handle(TCollection_HAsciiString) text = text_of(name);
    // As long as before: nothing in it was encoded.
    if (text->Length() == static_cast<int>(name.size())) {
      entity->SetLabel(text_of(name.substr(0, 8)));
    }
    Handle(IGESBasic_Name) property = new IGESBasic_Name;
    property->Init(1, text);
    entity->AddProperty(property);
    writer_.AddEntity(property);
  }

  void name_levels() {
    for (const auto& [name, level] : levels_) {
      Handle(IGESAppli_LevelFunction) function = new IGESAppli_LevelFunction;
      function->Init(2, level, text_of(name));
      // The entity that names a level is on it itself.
      function->InitLevel({}, level);
      writer_.AddEntity(function);
    }
  }

  void set_header() {
    IGESData_GlobalSection header = writer_.Model()->GlobalSection();
    // The product's name, which the reader takes from here.
    header.SetSendName(text_of(options_.name));
    header.SetFileName(text_of(options_.name));
    header.SetReceiveName(text_of(options_.name));
    header.SetSystemId(text_of("Hull Tools"));
    header.SetAuthorName(text_of(""));
    header.SetCompanyName(text_of(""));
    writer_.Model()->SetGlobalSection(header);
  }

  std::string printed() {
    IGESData_IGESWriter text(writer_.Model());
    // 17 significant digits: doubles come back as they were.
    text.FloatWriter().SetFormat("%.16E");
    text.SendModel(IGESSelect_WorkLibrary::DefineProtocol());
    std::ostringstream stream;
    if (!text.Print(stream)) throw NoCadText("the IGES file was not printed");
    return stream.str();
  }

  const CadModel& model_;
  const CadOptions& options_;
  const surface::Progress& progress_;
  IGESControl_Writer writer_;
  std::map<std::string, int> levels_;
  std::map<std::string, Handle(IGESGraph_Color)> colours_;
};

std::string iges_text(const CadModel& model, const CadOptions& options,
                      const surface::Progress& progress) {
  return IgesText(model, options, progress).make();
}

}  // namespace

CadReport write_iges(const conversion::PatchSet& patches, const std::string& path,
                     const CadOptions& options) {
  return write_cad_file(patches, path, options, iges_text);
}

}  // namespace hull::exchange
