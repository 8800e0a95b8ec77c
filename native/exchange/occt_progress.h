// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <exception>

#include "surface/progress.h"

namespace hull::exchange {

// Open CASCADE's progress as part of a task's: shares from `begin` to `end`. What the task's
// progress throws stops Open CASCADE in order, and is thrown by rethrow() afterwards.
class OcctProgress : public Message_ProgressIndicator {
 public:
  OcctProgress(const surface::Progress& progress, double begin, double end)
      : progress_(progress), begin_(begin), end_(end) {}

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 protected:
  Standard_Boolean UserBreak() override { return error_ != nullptr; }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {
    if (error_ || !progress_) return;
    try {
      progress_(begin_ + (end_ - begin_) * GetPosition());
    } catch (...) {
      error_ = std::current_exception();
    }
  }

 private:
  surface::Progress progress_;
  double begin_, end_;
  std::exception_ptr error_;
};

}  // namespace hull::exchange
