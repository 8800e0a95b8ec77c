// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TCollection_HAsciiString.hxx>
#include <string>
#include <vector>

namespace hull::exchange {

// Stand-ins for text until a file's text is there: Open CASCADE writes bytes above 127 as they are,
// which STEP forbids, and would double the backslashes of the directives for them.
class TextHolders {
 public:
  Handle(TCollection_HAsciiString) holder(const std::string& utf8);
  // The file's text with what the holders stand for, encoded for STEP, in their places.
  std::string filled(const std::string& text) const;

 private:
  std::vector<std::string> texts_;  // encoded
};

}  // namespace hull::exchange
