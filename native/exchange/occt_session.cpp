// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/occt_session.h"

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <stdexcept>

namespace hull {
namespace {

std::mutex& occt_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

OcctSession::OcctSession() : lock_(occt_mutex()) {
  STEPControl_Controller::Init();  // declares the settings below
  const bool set = Interface_Static::SetCVal("xstep.cascade.unit", "MM") &&
                   Interface_Static::SetCVal("write.step.unit", "M") &&
                   Interface_Static::SetCVal("write.step.schema", "AP214IS") &&
                   Interface_Static::SetIVal("write.surfacecurve.mode", 1);
  if (!set) throw std::runtime_error("this Open CASCADE refuses the settings of STEP files");
  auto& active = Message::DefaultMessenger()->ChangePrinters();
  printers_ = active;
  active.Clear();
}

OcctSession::~OcctSession() { Message::DefaultMessenger()->ChangePrinters() = printers_; }

std::string describe(const Standard_Failure& failure) {
  const char* message = failure.GetMessageString();
  const std::string type = failure.DynamicType()->Name();
  return message != nullptr && *message != '\0' ? type + ": " + message : type;
}

}  // namespace hull
