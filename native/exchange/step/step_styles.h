// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <map>
#include <optional>
#include <vector>

#include "exchange/cad_options.h"
#include "exchange/step/text_holders.h"

namespace hull::exchange {

// Puts items on a layer (PRESENTATION_LAYER_ASSIGNMENT).
void add_step_layer(const Handle(StepData_StepModel) & model, TextHolders& texts,
                    const std::string& name,
                    const std::vector<Handle(StepRepr_RepresentationItem)>& items);

// Colours of faces, gathered in one MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION, which
// is where other programs look for them.
class StepColours {
 public:
  void add(const Handle(StepRepr_RepresentationItem) & item, const analysis::Colour& colour);
  void put_into(const Handle(StepData_StepModel) & model) const;

 private:
  Handle(Standard_Transient) style_of(const analysis::Colour& colour);

  std::map<analysis::Colour, Handle(Standard_Transient)> styles_;
  std::vector<Handle(StepRepr_RepresentationItem)> styled_;
};

struct StepLayer {
  std::string name;
  std::vector<Handle(StepRepr_RepresentationItem)> items;
};

// The layers of a model, and the colours of items that have one.
std::vector<StepLayer> step_layers(const Handle(StepData_StepModel) & model);
std::map<Standard_Transient*, analysis::Colour> step_colours(const Handle(StepData_StepModel) &
                                                             model);

}  // namespace hull::exchange
