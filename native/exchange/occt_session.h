// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Message_SequenceOfPrinters.hxx>
#include <Standard_Failure.hxx>
#include <mutex>
#include <string>

#include "exchange/cad_options.h"

namespace hull::exchange {

// Sole use of Open CASCADE's data exchange, whose settings and messages are global to the process
// and not safe to share between threads. While a session lives, nothing is printed; the printers
// come back at its end. A session must not be opened inside another.
class OcctSession {
 public:
  // The settings of files written in this session. Reading heeds only that shapes come in
  // millimetres.
  explicit OcctSession(const CadOptions& options = {});
  ~OcctSession();
  OcctSession(const OcctSession&) = delete;
  OcctSession& operator=(const OcctSession&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
  Message_SequenceOfPrinters printers_;
};

// What an Open CASCADE exception says; they do not derive from std::exception.
std::string describe(const Standard_Failure& failure);

}  // namespace hull::exchange
