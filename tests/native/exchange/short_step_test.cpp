// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/short_step.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <sstream>
#include <string>

namespace hull::exchange {
namespace {

TEST(ShortStep, WritesNumbersWithAPointAndACapitalE) {
  EXPECT_EQ(short_step("5.0000000000000000E-01"), "0.5");
  EXPECT_EQ(short_step("0.0000000000000000E+00"), "0.");
  EXPECT_EQ(short_step("-1.2000000000000000E+01"), "-12.");
  EXPECT_EQ(short_step("1.0000000000000000E-07"), "1.E-07");
  EXPECT_EQ(short_step("1.3877787807814457E-17"), "1.3877787807814457E-17");
}

TEST(ShortStep, LeavesWhatIsNoReal) {
  for (const char* text :
       {"#12=A(#3,$,*,.F.,.UNSPECIFIED.,42,-7);\n", "#1=(A()B(*)C($,.METRE.));\n"}) {
    EXPECT_EQ(short_step(text), text);
  }
}

TEST(ShortStep, LeavesStrings) {
  const std::string text = "A('it''s  1.0000000000000000E+00;','','a b');\n";
  EXPECT_EQ(short_step(text), text);
  EXPECT_EQ(short_step("A('open"), "A('open");
  EXPECT_EQ(short_step("'"), "'");
}

TEST(ShortStep, NeverBreaksAStringAndKeepsLinesShort) {
  std::string text = "#1 = POLYLINE('" + std::string(60, 'x') + "''" + std::string(60, 'y') + "',(";
  for (int i = 0; i < 50; ++i) text += "#1000" + std::to_string(i) + ", \n    ";
  const std::string result = short_step(text + "#1));");
  EXPECT_NE(result.find(std::string(60, 'x') + "''" + std::string(60, 'y')), result.npos);
  std::istringstream lines(result);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(line.size() <= 100 || line.find('x') != line.npos) << line;
  }
}

TEST(ShortStep, KeepsEveryBitOfANumber) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (!std::isfinite(value)) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.16E", value);
    const std::string result = short_step(text);
    EXPECT_EQ(std::strtod(result.c_str(), nullptr), value) << text;
    EXPECT_NE(result.find('.'), result.npos) << result;
    EXPECT_LE(result.size(), std::string(text).size() + 1) << result;  // an added point
  }
}

}  // namespace
}  // namespace hull::exchange
