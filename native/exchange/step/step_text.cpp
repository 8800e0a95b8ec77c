// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/step_text.h"

#include <charconv>
#include <cstdint>
#include <cstdio>

namespace hull::exchange {
namespace {

constexpr char32_t kBad = 0xFFFFFFFF;

// Takes one character off the front of `text`; kBad for a byte that begins none.
char32_t take_character(std::string_view& text) {
  const auto lead = static_cast<std::uint8_t>(text.front());
  // The first byte tells the length. 0xC0, 0xC1 and what is above 0xF4 begin nothing, nor do
  // 10xxxxxx, which go on.
  const size_t length = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  char32_t code = length == 1 ? lead : lead & (0x7F >> length);
  bool good = (lead < 0x80 || lead >= 0xC2) && lead < 0xF5 && text.size() >= length;
  for (size_t i = 1; good && i < length; ++i) {
    const auto next = static_cast<std::uint8_t>(text[i]);
    good = (next & 0xC0) == 0x80;
    code = code << 6 | (next & 0x3F);
  }
  // Written with more bytes than it needs, a character is none.
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  // Nor are surrogates, halves of UTF-16's pairs.
  good = good && !overlong && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
  text.remove_prefix(good ? length : 1);
  return good ? code : kBad;
}

void append_utf8(std::string& text, char32_t code) {
  const auto byte = [&](char32_t value) { text.push_back(static_cast<char>(value)); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | code >> 6);
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | code >> 12);
    byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | code >> 18);
    byte(0x80 | (code >> 12 & 0x3F));
    byte(0x80 | (code >> 6 & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

std::string directive(char32_t code) {
  char text[24];
  const bool wide = code > 0xFFFF;
  std::snprintf(text, sizeof text, wide ? "\\X4\\%08X\\X0\\" : "\\X2\\%04X\\X0\\",
                static_cast<unsigned>(code));
  return text;
}

}  // namespace

std::string encode_step_string(std::string_view utf8) {
  std::string text;
  while (!utf8.empty()) {
    const char32_t code = take_character(utf8);
    if (code == kBad) {
      text += '?';
    } else if (code < 0x20 || code == 0x7F) {
      text += ' ';
    } else if (code == '\'' || code == '\\') {
      text.append(2, static_cast<char>(code));
    } else if (code < 0x7F) {
      text += static_cast<char>(code);
    } else {
      text += directive(code);
    }
  }
  return text;
}

std::string decode_step_string(std::string_view text) {
  std::string utf8;
  while (!text.empty()) {
    const bool wide = text.starts_with("\\X4\\");
    // A directive may hold several characters, one after the other.
    const size_t digits = wide ? 8 : 4, end = text.find("\\X0\\");
    if ((wide || text.starts_with("\\X2\\")) && end != text.npos && (end - 4) % digits == 0) {
      for (size_t i = 4; i < end; i += digits) {
        std::uint32_t code = '?';
        std::from_chars(text.data() + i, text.data() + i + digits, code, 16);
        append_utf8(utf8, code);
      }
      text.remove_prefix(end + 4);
      continue;
    }
    const bool doubled = text.starts_with("\\\\") || text.starts_with("''");
    utf8 += text.front();
    text.remove_prefix(doubled ? 2 : 1);
  }
  return utf8;
}

}  // namespace hull::exchange
