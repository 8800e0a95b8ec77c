// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/occt_session.h"

#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <stdexcept>

namespace hull::exchange {
namespace {

std::mutex& occt_mutex() {
  static std::mutex mutex;
  return mutex;
}

const char* unit_setting(CadUnit unit) {
  switch (unit) {
    case CadUnit::kMetre:
      return "M";
    case CadUnit::kCentimetre:
      return "CM";
    case CadUnit::kMillimetre:
      return "MM";
    case CadUnit::kFoot:
      return "FT";
    case CadUnit::kInch:
      break;
  }
  return "INCH";
}

void set(const char* name, const char* value) {
  if (!Interface_Static::SetCVal(name, value)) {
    throw std::runtime_error(std::string("this Open CASCADE refuses the setting ") + name);
  }
}

void set(const char* name, int value) {
  if (!Interface_Static::SetIVal(name, value)) {
    throw std::runtime_error(std::string("this Open CASCADE refuses the setting ") + name);
  }
}

}  // namespace

OcctSession::OcctSession(const CadOptions& options) : lock_(occt_mutex()) {
  STEPControl_Controller::Init();  // these declare the settings below
  IGESControl_Controller::Init();
  set("xstep.cascade.unit", "MM");
  set("write.step.unit", unit_setting(options.unit));
  set("write.step.schema", options.schema == StepSchema::kAp242 ? "AP242DIS" : "AP214IS");
  // Several bodies in one product, not an assembly of products at places of their own.
  set("write.step.assembly", 0);
  // No lines in (u, v): readers find them again, on borders of patches at once, which is twice as
  // fast as reading and checking them.
  set("write.surfacecurve.mode", 0);
  set("write.iges.unit", unit_setting(options.unit));
  set("write.iges.brep.mode", 1);  // shells whose faces share edges, and no bare trimmed surfaces
  set("read.iges.bspline.continuity", 0);  // curves are not cut at their kinks
  auto& active = Message::DefaultMessenger()->ChangePrinters();
  // Else Open CASCADE's messages would go to the standard output.
  printers_ = active;
  active.Clear();
}

OcctSession::~OcctSession() { Message::DefaultMessenger()->ChangePrinters() = printers_; }

std::string describe(const Standard_Failure& failure) {
  const char* message = failure.GetMessageString();
  const std::string type = failure.DynamicType()->Name();
  return message != nullptr && *message != '\0' ? type + ": " + message : type;
}

}  // namespace hull::exchange
