// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/step_styles.h"

#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_Representation.hxx>
#include <StepShape_AdvancedBrepShapeRepresentation.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepVisual_ColourRgb.hxx>
#include <StepVisual_FillAreaStyle.hxx>
#include <StepVisual_FillAreaStyleColour.hxx>
#include <StepVisual_FillStyleSelect.hxx>
#include <StepVisual_HArray1OfFillStyleSelect.hxx>
#include <StepVisual_HArray1OfLayeredItem.hxx>
#include <StepVisual_HArray1OfPresentationStyleAssignment.hxx>
#include <StepVisual_HArray1OfPresentationStyleSelect.hxx>
#include <StepVisual_HArray1OfSurfaceStyleElementSelect.hxx>
#include <StepVisual_LayeredItem.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_PresentationStyleSelect.hxx>
#include <StepVisual_StyledItem.hxx>
#include <StepVisual_SurfaceSideStyle.hxx>
#include <StepVisual_SurfaceStyleElementSelect.hxx>
#include <StepVisual_SurfaceStyleFillArea.hxx>
#include <StepVisual_SurfaceStyleUsage.hxx>

#include "exchange/step/step_text.h"

namespace hull::exchange {
namespace {

Handle(TCollection_HAsciiString) no_text() { return new TCollection_HAsciiString(""); }

// The only element of one of STEP's arrays of choices.
template <class Array, class Select>
Handle(Array) only(const Handle(Standard_Transient) & value) {
  Select select;
  select.SetValue(value);
  Handle(Array) array = new Array(1, 1);
  array->SetValue(1, select);
  return array;
}

// The first element that is of this class, or none.
template <class Wanted, class Array>
Handle(Wanted) first_of(const Handle(Array) & array) {
  if (array.IsNull()) return {};
  for (int i = array->Lower(); i <= array->Upper(); ++i) {
    const auto found = Handle(Wanted)::DownCast(array->Value(i).Value());
    if (!found.IsNull()) return found;
  }
  return {};
}

std::optional<analysis::Colour> surface_colour(
    const Handle(StepVisual_PresentationStyleAssignment) & style) {
  const auto usage = first_of<StepVisual_SurfaceStyleUsage>(style->Styles());
  if (usage.IsNull() || usage->Style().IsNull()) return std::nullopt;
  const auto area = first_of<StepVisual_SurfaceStyleFillArea>(usage->Style()->Styles());
  if (area.IsNull() || area->FillArea().IsNull()) return std::nullopt;
  const auto fill = first_of<StepVisual_FillAreaStyleColour>(area->FillArea()->FillStyles());
  if (fill.IsNull()) return std::nullopt;
  const auto colour = Handle(StepVisual_ColourRgb)::DownCast(fill->FillColour());
  if (colour.IsNull()) return std::nullopt;
  return analysis::Colour{colour->Red(), colour->Green(), colour->Blue()};
}

}  // namespace

void add_step_layer(const Handle(StepData_StepModel) & model, TextHolders& texts,
                    const std::string& name,
                    const std::vector<Handle(StepRepr_RepresentationItem)>& items) {
  if (items.empty()) return;
  Handle(StepVisual_HArray1OfLayeredItem) array =
      new StepVisual_HArray1OfLayeredItem(1, static_cast<int>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) {
    StepVisual_LayeredItem item;
    item.SetValue(items[i]);
    array->SetValue(static_cast<int>(i) + 1, item);
  }
  Handle(StepVisual_PresentationLayerAssignment) layer = new StepVisual_PresentationLayerAssignment;
  layer->Init(texts.holder(name), no_text(), array);
  model->AddWithRefs(layer);
}

Handle(Standard_Transient) StepColours::style_of(const analysis::Colour& colour) {
  Handle(Standard_Transient)& known = styles_[colour];
  if (!known.IsNull()) return known;
  Handle(StepVisual_ColourRgb) rgb = new StepVisual_ColourRgb;
  rgb->Init(no_text(), colour[0], colour[1], colour[2]);
  Handle(StepVisual_FillAreaStyleColour) fill = new StepVisual_FillAreaStyleColour;
  fill->Init(no_text(), rgb);
  Handle(StepVisual_FillAreaStyle) area = new StepVisual_FillAreaStyle;
  area->Init(no_text(),
             only<StepVisual_HArray1OfFillStyleSelect, StepVisual_FillStyleSelect>(fill));
  Handle(StepVisual_SurfaceStyleFillArea) filled = new StepVisual_SurfaceStyleFillArea;
  filled->Init(area);
  Handle(StepVisual_SurfaceSideStyle) side = new StepVisual_SurfaceSideStyle;
  // The nesting is the schema's: a style of usage, of a side, of a filled area, of a colour.
  side->Init(
      no_text(),
      only<StepVisual_HArray1OfSurfaceStyleElementSelect, StepVisual_SurfaceStyleElementSelect>(
          filled));
  Handle(StepVisual_SurfaceStyleUsage) usage = new StepVisual_SurfaceStyleUsage;
  // Seen from both sides in the same colour.
  usage->Init(StepVisual_ssBoth, side);
  Handle(StepVisual_PresentationStyleAssignment) style = new StepVisual_PresentationStyleAssignment;
  style->Init(
      only<StepVisual_HArray1OfPresentationStyleSelect, StepVisual_PresentationStyleSelect>(usage));
  known = style;
  return known;
}

void StepColours::add(const Handle(StepRepr_RepresentationItem) & item,
                      const analysis::Colour& colour) {
  Handle(StepVisual_HArray1OfPresentationStyleAssignment) styles =
      new StepVisual_HArray1OfPresentationStyleAssignment(1, 1);
  styles->SetValue(1, Handle(StepVisual_PresentationStyleAssignment)::DownCast(style_of(colour)));
  Handle(StepVisual_StyledItem) styled = new StepVisual_StyledItem;
  // Styles are shared by all items of a colour, which keeps files short.
  styled->Init(new TCollection_HAsciiString("color"), styles, item);
  styled_.push_back(styled);
}

void StepColours::put_into(const Handle(StepData_StepModel) & model) const {
  if (styled_.empty()) return;
  Handle(StepRepr_RepresentationContext) context;
  // The context of the shape itself, with its units: readers look for colours in the same one.
  for (int i = 1; i <= model->NbEntities() && context.IsNull(); ++i) {
    const auto shape = Handle(StepShape_ShapeRepresentation)::DownCast(model->Value(i));
    if (!shape.IsNull()) context = shape->ContextOfItems();
  }
  Handle(StepRepr_HArray1OfRepresentationItem) items =
      new StepRepr_HArray1OfRepresentationItem(1, static_cast<int>(styled_.size()));
  for (std::size_t i = 0; i < styled_.size(); ++i) {
    items->SetValue(static_cast<int>(i) + 1, styled_[i]);
  }
  Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) all =
      new StepVisual_MechanicalDesignGeometricPresentationRepresentation;
  all->Init(no_text(), items, context);
  // With all that it refers to: styled items, styles, colours.
  model->AddWithRefs(all);
}

std::vector<StepLayer> step_layers(const Handle(StepData_StepModel) & model) {
  std::vector<StepLayer> layers;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto found = Handle(StepVisual_PresentationLayerAssignment)::DownCast(model->Value(i));
    if (found.IsNull() || found->Name().IsNull()) continue;
    StepLayer& layer = layers.emplace_back();
    layer.name = decode_step_string(found->Name()->ToCString());
    const auto items = found->AssignedItems();
    for (int k = 1; !items.IsNull() && k <= items->Length(); ++k) {
      const auto item = Handle(StepRepr_RepresentationItem)::DownCast(items->Value(k).Value());
      if (!item.IsNull()) layer.items.push_back(item);
    }
  }
  return layers;
}

std::map<Standard_Transient*, analysis::Colour> step_colours(const Handle(StepData_StepModel) &
                                                             model) {
  std::map<Standard_Transient*, analysis::Colour> colours;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto styled = Handle(StepVisual_StyledItem)::DownCast(model->Value(i));
    // Files of others may leave out what the schema asks for.
    if (styled.IsNull() || styled->Styles().IsNull() || styled->Item().IsNull()) continue;
    for (int k = 1; k <= styled->NbStyles(); ++k) {
      if (styled->StylesValue(k).IsNull()) continue;
      // Keyed by the entity: items are found again by it when shapes are.
      if (const auto colour = surface_colour(styled->StylesValue(k))) {
        colours[styled->Item().get()] = *colour;
      }
    }
  }
  return colours;
}

}  // namespace hull::exchange
