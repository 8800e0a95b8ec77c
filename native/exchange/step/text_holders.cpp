// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/text_holders.h"

#include <cstdio>
#include <cstdlib>

#include "exchange/step/step_text.h"

namespace hull::exchange {
namespace {

constexpr char kPrefix[] = "HULL-TEXT-";
constexpr std::size_t kPrefixLength = sizeof kPrefix - 1, kNumberLength = 6;

}  // namespace

Handle(TCollection_HAsciiString) TextHolders::holder(const std::string& utf8) {
  char name[40];
  std::snprintf(name, sizeof name, "%s%06d", kPrefix, static_cast<int>(texts_.size()) % 1000000);
  // Encoded already: filled() puts it into the text as it is.
  texts_.push_back(encode_step_string(utf8));
  return new TCollection_HAsciiString(name);
}

std::string TextHolders::filled(const std::string& text) const {
  std::string result;
  result.reserve(text.size());
  std::size_t done = 0;
  for (std::size_t at = text.find(kPrefix); at != text.npos; at = text.find(kPrefix, done)) {
    result.append(text, done, at - done);
    const std::string digits = text.substr(at + kPrefixLength, kNumberLength);
    result += texts_[static_cast<std::size_t>(std::atoi(digits.c_str()))];
    done = at + kPrefixLength + kNumberLength;
  }
  return result.append(text, done, text.npos);
}

}  // namespace hull::exchange
