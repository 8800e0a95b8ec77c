// SPDX-License-Identifier: GPL-3.0-or-later
#include <APIHeaderSection_MakeHeader.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Reader.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>

#include "exchange/occt_progress.h"
#include "exchange/reading/cad_reading.h"
#include "exchange/step/step_styles.h"
#include "exchange/step/step_text.h"
#include "files/atomic_file.h"

namespace hull::exchange {
namespace {

std::string product_name(const Handle(StepData_StepModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (!product.IsNull() && !product->Name().IsNull()) {
      return decode_step_string(product->Name()->ToCString());
    }
  }
  return "";
}

std::string unit_name(STEPControl_Reader& reader) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  if (lengths.IsEmpty()) return "";
  const std::string name = lengths.First().ToCString();
  // Units that are not SI have the name that the file gives them; Open CASCADE writes capitals.
  static const std::map<std::string, std::string> kNames = {
      {"metre", "m"}, {"centimetre", "cm"}, {"millimetre", "mm"}, {"FOOT", "ft"}, {"INCH", "in"}};
  const auto found = kNames.find(name);
  return found != kNames.end() ? found->second : "";
}

std::string format_name(const Handle(StepData_StepModel) & model) {
  const APIHeaderSection_MakeHeader header(model);
  if (!header.HasFs() || header.NbSchemaIdentifiers() < 1) return "STEP";
  const std::string schema = header.SchemaIdentifiersValue(1)->ToCString();
  // The name of AP214's schema.
  if (schema.starts_with("AUTOMOTIVE_DESIGN")) return "STEP AP214";
  return schema.starts_with("AP242") ? "STEP AP242" : "STEP";
}

void find_layers(STEPControl_Reader& reader, CadContent& content) {
  const std::map<Standard_Transient*, analysis::Colour> colours = step_colours(reader.StepModel());
  const Handle(Transfer_TransientProcess) process =
      reader.WS()->TransferReader()->TransientProcess();
  for (const StepLayer& found : step_layers(reader.StepModel())) {
    CadLayer& layer = content.layers.emplace_back();
    layer.name = found.name;
    for (const auto& item : found.items) {
      const TopoDS_Shape shape = STEPConstruct::FindShape(process, item);
      if (shape.IsNull()) continue;
      const auto colour = colours.find(item.get());
      layer.members.push_back(
          {shape, colour == colours.end() ? std::nullopt : std::optional(colour->second)});
    }
  }
}

void find_names(STEPControl_Reader& reader, CadContent& content) {
  const Handle(StepData_StepModel) model = reader.StepModel();
  const Handle(Transfer_TransientProcess) process =
      reader.WS()->TransferReader()->TransientProcess();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(model->Value(i));
    // Most items of a file have no name.
    if (item.IsNull() || item->Name().IsNull() || item->Name()->IsEmpty()) continue;
    const TopoDS_Shape shape = STEPConstruct::FindShape(process, item);
    if (!shape.IsNull()) {
      content.names.push_back({decode_step_string(item->Name()->ToCString()), shape});
    }
  }
}

}  // namespace

CadContent read_step(const std::string& path, const std::string& refusal,
                     const surface::Progress& progress) {
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
    throw files::FileError(refusal + "it is not a STEP file");
  }
  surface::tell(progress, 0.5, 1.0);
  Handle(OcctProgress) indicator = new OcctProgress(progress, 0.5, 1.0);
  reader.TransferRoots(indicator->Start());
  indicator->rethrow();
  CadContent content;
  content.shape = reader.OneShape();
  content.format = format_name(reader.StepModel());
  content.unit = unit_name(reader);
  content.product = product_name(reader.StepModel());
  find_layers(reader, content);
  find_names(reader, content);
  return content;
}

}  // namespace hull::exchange
