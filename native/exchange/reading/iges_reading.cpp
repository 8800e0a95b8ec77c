// SPDX-License-Identifier: GPL-3.0-or-later
#include <IGESAppli_LevelFunction.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESGraph_Color.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>

#include "exchange/occt_progress.h"
#include "exchange/reading/cad_reading.h"
#include "exchange/step/step_text.h"
#include "files/atomic_file.h"

namespace hull::exchange {
namespace {

std::string text_of(const Handle(TCollection_HAsciiString) & text) {
  return text.IsNull() ? "" : decode_step_string(text->ToCString());
}

std::string unit_name(int flag) {
  // The flags of the global section.
  static const std::map<int, std::string> kNames = {
      {1, "in"}, {2, "mm"}, {4, "ft"}, {6, "m"}, {10, "cm"}};
  const auto found = kNames.find(flag);
  return found != kNames.end() ? found->second : "";
}

std::optional<analysis::Colour> colour_of(const Handle(IGESData_IGESEntity) & entity) {
  const auto colour = Handle(IGESGraph_Color)::DownCast(entity->Color());
  if (colour.IsNull()) return std::nullopt;
  analysis::Colour percent{};
  colour->RGBIntensity(percent[0], percent[1], percent[2]);
  return analysis::Colour{percent[0] / 100.0, percent[1] / 100.0, percent[2] / 100.0};
}

void find_layers_and_names(IGESControl_Reader& reader, CadContent& content) {
  const Handle(IGESData_IGESModel) model = reader.IGESModel();
  const Handle(Transfer_TransientProcess) process =
      reader.WS()->TransferReader()->TransientProcess();
  // The entity with the name may come before or after the members.
  std::map<int, CadLayer> layers;  // by level
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(IGESData_IGESEntity) entity = model->Entity(i);
    // Open CASCADE forgets the level of the entities that name levels, not their code.
    const auto function = Handle(IGESAppli_LevelFunction)::DownCast(entity);
    if (!function.IsNull()) {
      layers[function->FuncDescriptionCode()].name = text_of(function->FuncDescription());
      continue;
    }
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
    const std::string name = text_of(entity->NameValue());
    if (!shape.IsNull() && !name.empty()) content.names.push_back({name, shape});
    // Level 0 is that of entities that are on none; lists of levels are left out.
    if (entity->DefLevel() != IGESData_DefOne || entity->Level() <= 0) continue;
    CadLayer& layer = layers[entity->Level()];
    if (!shape.IsNull()) layer.members.push_back({shape, colour_of(entity)});
  }
  for (auto& [level, layer] : layers) {
    // Files of others seldom name their levels.
    if (layer.name.empty()) layer.name = std::to_string(level);
    content.layers.push_back(std::move(layer));
  }
}

}  // namespace

CadContent read_iges(const std::string& path, const std::string& refusal,
                     const surface::Progress& progress) {
  IGESControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
    throw files::FileError(refusal + "it is not an IGES file");
  }
  surface::tell(progress, 0.5, 1.0);
  Handle(OcctProgress) indicator = new OcctProgress(progress, 0.5, 1.0);
  reader.TransferRoots(indicator->Start());
  indicator->rethrow();
  const IGESData_GlobalSection& header = reader.IGESModel()->GlobalSection();
  CadContent content;
  content.shape = reader.OneShape();
  // 11 is the version flag of 5.3.
  content.format = header.IGESVersion() == 11 ? "IGES 5.3" : "IGES";
  content.unit = unit_name(header.UnitFlag());
  content.product = text_of(header.SendName());
  find_layers_and_names(reader, content);
  return content;
}

}  // namespace hull::exchange
