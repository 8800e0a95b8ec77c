// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf/dxf_text.h"

#include <cstdio>

namespace hull::dxf {
namespace {

// The letter at the text's beginning, taken off it; -1 where there is none.
int take_letter(std::string_view& text) {
  const auto byte = [&text](size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  // The first byte tells how many there are: 0xxxxxxx one, 110xxxxx two, 1110xxxx three, 11110xxx
  // four; 10xxxxxx only goes on.
  const int length = first < 0x80 ? 1 : first < 0xC0 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  int letter = length == 1 ? first : first & (0xFF >> (length + 1));
  bool sound = length > 0 && text.size() >= static_cast<size_t>(length);
  for (int i = 1; sound && i < length; ++i) {
    sound = (byte(i) & 0xC0) == 0x80;
    letter = letter << 6 | (byte(i) & 0x3F);
  }
  // Of what is no UTF-8 one byte is taken, so that what follows it is read afresh.
  text.remove_prefix(sound ? length : 1);
  return sound ? letter : -1;
}

}  // namespace

std::string encode_dxf_text(std::string_view text) {
  std::string encoded;
  while (!text.empty()) {
    const int letter = take_letter(text);
    if (letter < 0 || letter > 0xFFFF) {
      encoded += '?';
    } else if (letter < 0x20 || letter == 0x7F) {
      encoded += ' ';
    } else if (letter == '^') {
      encoded += "^ ";
    } else if (letter == '%' && !encoded.empty() && encoded.back() == '%') {
      // Looks at what was written: of "%%%" each sign is parted from the one before.
      encoded += " %";
    } else if (letter < 0x80) {
      encoded += static_cast<char>(letter);
    } else {
      char code[16];
      std::snprintf(code, sizeof code, "\\U+%04X", letter);
      encoded += code;
    }
  }
  return encoded;
}

}  // namespace hull::dxf
