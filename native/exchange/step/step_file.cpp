// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/step_file.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "exchange/cad_file.h"
#include "exchange/cad_model.h"
#include "exchange/occt_geometry.h"
#include "exchange/occt_progress.h"
#include "exchange/regions.h"
#include "exchange/step/shared_points.h"
#include "exchange/step/short_step.h"
#include "exchange/step/step_styles.h"
#include "exchange/step/text_holders.h"

namespace hull::exchange {
namespace {

using Item = Handle(StepRepr_RepresentationItem);

Handle(TCollection_HAsciiString) text_of(const char* value) {
  return new TCollection_HAsciiString(value);
}

class StepText {
 public:
  StepText(const CadModel& model, const CadOptions& options, const surface::Progress& progress)
      : model_(model), options_(options), progress_(progress) {
    // Millimetres come in, others go out. Release 7.8 heeds this and not the global setting for the
    // numbers, but that setting for the unit it declares.
    writer_.Model()->SetLocalLengthUnit(1.0);
    writer_.Model()->SetWriteLengthUnit(millimetres_in(options.unit));
  }

  std::string make() {
    transfer(model_.brep.shape, STEPControl_AsIs, 0.0, 0.5);
    add_regions();
    add_curves();
    set_names();
    surface::tell(progress_, 0.6, 1.0);
    // Points are compared last: as text, without spaces, and with their names in it.
    return with_shared_points(short_step(texts_.filled(printed())));
  }

 private:
  void transfer(const TopoDS_Shape& shape, STEPControl_StepModelType type, double begin,
                double end) {
    Handle(OcctProgress) indicator = new OcctProgress(progress_, begin, end);
    // Without the graph of the whole model: every curve would make it anew, and nobody asks.
    const IFSelect_ReturnStatus status =
        writer_.Transfer(shape, type, Standard_False, indicator->Start());
    indicator->rethrow();
    if (status != IFSelect_RetDone) {
      throw NoCadText("the patches were not translated to STEP");
    }
  }

  Item item_of(const TopoDS_Shape& shape) const {
    return STEPConstruct::FindEntity(writer_.WS()->TransferWriter()->FinderProcess(), shape);
  }

  void add_regions() {
    std::map<std::string, std::vector<Item>> regions;
    StepColours colours;
    for (std::size_t f = 0; f < model_.brep.faces.size(); ++f) {
      // The entity that the transfer made of this very face object.
      const Item item = item_of(model_.brep.faces[f]);
      if (item.IsNull()) continue;  // the file read back will show it
      const std::string& region = model_.regions[f];
      colours.add(item, colour_of(region, options_));
      regions[region].push_back(item);
    }
    colours.put_into(writer_.Model());
    for (const auto& [name, items] : regions) {
      add_step_layer(writer_.Model(), texts_, name, items);
    }
  }

  // Each a product of its own.
  void add_curves() {
    std::map<std::string, std::vector<Item>> layers;
    for (const CadCurve& curve : model_.curves) {
      const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(make_curve(curve.curve)).Edge();
      transfer(edge, STEPControl_GeometricCurveSet, 0.5, 0.5);
      // In the order of transfers, as set_names() counts on.
      products_.push_back(curve.name);
      const Item item = item_of(edge);
      if (item.IsNull()) continue;  // the file read back will show it
      item->SetName(texts_.holder(curve.name));
      layers[curve.layer].push_back(item);
    }
    for (const auto& [name, items] : layers) {
      add_step_layer(writer_.Model(), texts_, name, items);
    }
  }

  // Products come in the order of transfers.
  void set_names() {
    APIHeaderSection_MakeHeader header(writer_.Model());
    header.SetName(texts_.holder(options_.name));
    header.SetAuthorValue(1, text_of(""));
    header.SetOrganizationValue(1, text_of(""));
    header.SetOriginatingSystem(text_of("Hull Tools"));
    std::size_t next = 0;
    for (int i = 1; i <= writer_.Model()->NbEntities(); ++i) {
      const auto product = Handle(StepBasic_Product)::DownCast(writer_.Model()->Value(i));
      if (product.IsNull()) continue;
      // The hull's own product comes first.
      const std::string& name =
          next == 0 || next > products_.size() ? options_.name : products_[next - 1];
      ++next;
      product->SetId(texts_.holder(name));
      product->SetName(texts_.holder(name));
    }
  }

  std::string printed() {
    StepData_StepWriter text(writer_.Model());
    // 17 digits: doubles come back as they were. Open CASCADE's own way of cutting off trailing
    // zeros loses the exponent; short_step() does it.
    text.FloatWriter().SetFormat("%.16E");
    text.SendModel(Handle(StepData_Protocol)::DownCast(writer_.WS()->Protocol()));
    std::ostringstream stream;
    if (!text.Print(stream)) throw NoCadText("the STEP file was not printed");
    return stream.str();
  }

  const CadModel& model_;
  const CadOptions& options_;
  const surface::Progress& progress_;
  STEPControl_Writer writer_;
  TextHolders texts_;
  std::vector<std::string> products_;  // after the hull
};

std::string step_text(const CadModel& model, const CadOptions& options,
                      const surface::Progress& progress) {
  return StepText(model, options, progress).make();
}

}  // namespace

CadReport write_step(const conversion::PatchSet& patches, const std::string& path,
                     const CadOptions& options) {
  return write_cad_file(patches, path, options, step_text);
}

}  // namespace hull::exchange
