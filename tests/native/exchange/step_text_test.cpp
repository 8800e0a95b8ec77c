// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/step_text.h"

#include <gtest/gtest.h>

#include <string>

namespace hull::exchange {
namespace {

TEST(EncodeStepString, DoublesQuotesAndBackslashes) {
  EXPECT_EQ(encode_step_string("Captain's C:\\ship"), "Captain''s C:\\\\ship");
}

TEST(EncodeStepString, WritesOtherCharactersAsDirectives) {
  EXPECT_EQ(encode_step_string("Fähre"), "F\\X2\\00E4\\X0\\hre");
  EXPECT_EQ(encode_step_string("船"), "\\X2\\8239\\X0\\");
  EXPECT_EQ(encode_step_string("⛵🚢"), "\\X2\\26F5\\X0\\\\X4\\0001F6A2\\X0\\");
}

TEST(EncodeStepString, MakesControlCharactersSpaces) {
  EXPECT_EQ(encode_step_string(std::string("a\nb\tc\0d\x7f", 8)), "a b c d ");
}

TEST(EncodeStepString, MarksBytesThatAreNotUtf8) {
  EXPECT_EQ(encode_step_string("a\xff"), "a?");
  EXPECT_EQ(encode_step_string("\xc3"), "?");            // cut off
  EXPECT_EQ(encode_step_string("\xc0\xaf"), "??");       // overlong
  EXPECT_EQ(encode_step_string("\xed\xa0\x80"), "???");  // half of a surrogate pair
  EXPECT_EQ(encode_step_string("\xf5\x80\x80\x80"), "????");
}

TEST(DecodeStepString, IsTheInverse) {
  for (const char* text : {"", "plain", "Captain's \\X2\\ ''", "Fähre 漢字 ⛵🚢 \\", "\\\\X0\\\\"}) {
    EXPECT_EQ(decode_step_string(encode_step_string(text)), text);
  }
}

TEST(DecodeStepString, LeavesWhatItDoesNotKnow) {
  EXPECT_EQ(decode_step_string("\\S\\a"), "\\S\\a");
  EXPECT_EQ(decode_step_string("\\X2\\00E4"), "\\X2\\00E4");
  EXPECT_EQ(decode_step_string("\\X2\\00E48239\\X0\\"), "ä船");
}

}  // namespace
}  // namespace hull::exchange
