// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/shared_points.h"

#include <gtest/gtest.h>

#include <string>

namespace hull::exchange {
namespace {

TEST(SharedPoints, EqualPointsAreTheFirst) {
  const std::string text =
      "#1=A(#3,#2,(#4,#30));\n#2=CARTESIAN_POINT('',(1.,2.,3.));\n"
      "#3=CARTESIAN_POINT('',(1.,2.,3.5));\n#4=CARTESIAN_POINT('',(1.,2.,3.));\n"
      "#30=CARTESIAN_POINT('',(1.,2.,\n3.));\nENDSEC;\n";
  EXPECT_EQ(with_shared_points(text),
            "#1=A(#3,#2,(#2,#2));\n#2=CARTESIAN_POINT('',(1.,2.,3.));\n"
            "#3=CARTESIAN_POINT('',(1.,2.,3.5));\nENDSEC;\n");
}

TEST(SharedPoints, OnlyPointsAndOnlyEqualBits) {
  const std::string text =
      "#1=DIRECTION('',(1.,0.,0.));\n#2=DIRECTION('',(1.,0.,0.));\n"
      "#3=CARTESIAN_POINT('',(0.,0.));\n#4=CARTESIAN_POINT('',(-0.,0.));\n"
      "#5=CARTESIAN_POINT('a',(0.,0.));\n";
  EXPECT_EQ(with_shared_points(text), text);
}

TEST(SharedPoints, StringsStay) {
  const std::string text =
      "#1=CARTESIAN_POINT('',(1.,2.));\n#2=CARTESIAN_POINT('',(1.,2.));\n"
      "#3=NAME('it''s #2;',#2,'#2');\n#4=CARTESIAN_POINT('#2;',(1.,2.));\n";
  EXPECT_EQ(with_shared_points(text),
            "#1=CARTESIAN_POINT('',(1.,2.));\n#3=NAME('it''s #2;',#1,'#2');\n"
            "#4=CARTESIAN_POINT('#2;',(1.,2.));\n");
  for (const char* cut : {"", "'", "#", "#1=CARTESIAN_POINT('open", "A('x'';"}) {
    EXPECT_EQ(with_shared_points(cut), cut);
  }
}

}  // namespace
}  // namespace hull::exchange
